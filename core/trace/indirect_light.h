// What surfaces ask for the light of other surfaces. World space; colours linear. One a thread.
// Source: reference manual 3.7, "Radiosity".
#pragma once

#include <cstdint>

#include "core/base/color.h"
#include "core/base/pixel.h"
#include "core/base/vec3.h"

namespace lentray::core {

/// A place of a surface.
struct IndirectQuery {
  Vec3 point;
  Vec3 surface_normal, layer_normal;  ///< unit, on the side that is lit
  double weight;                      ///< greatest share of the pixel that the light can have
  std::uint8_t scattered = 0;         ///< as RayState's
};

struct IndirectAnswer {
  Rgb light;                 ///< what a white surface there sends on
  std::uint32_t number = 0;  ///< of the query, since the ray began
};

class IndirectLight {
 public:
  virtual ~IndirectLight() = default;
  /// A camera ray begins. `is_centre`: of a pixel; `key`: of its random numbers.
  virtual void begin(Pixel pixel, bool is_centre, std::uint64_t key) = 0;
  /// False: there have been as many bounces as the scene wants.
  virtual bool is_wanted() const = 0;
  /// Only while it is wanted.
  virtual IndirectAnswer at(const IndirectQuery& query) = 0;
  /// So much of an answer's light is in what the first surface of the ray sends on; `is_first`: false: the
  /// surface is another one.
  virtual void take_share([[maybe_unused]] std::uint32_t number, [[maybe_unused]] const Rgb& share,
                          [[maybe_unused]] bool is_first) {}
};

}  // namespace lentray::core
