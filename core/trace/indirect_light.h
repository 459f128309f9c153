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
  /// False where the scene's number of bounces is reached.
  virtual bool is_wanted() const = 0;
  /// The indirect light at a place. Call it only while is_wanted().
  virtual IndirectAnswer at(const IndirectQuery& query) = 0;
  /// The first surface that a camera ray meets multiplies the light of answer `number` by `share` in what it sends
  /// to the camera. `is_first` is false where the query came from a surface behind that one.
  virtual void take_share([[maybe_unused]] std::uint32_t number, [[maybe_unused]] const Rgb& share,
                          [[maybe_unused]] bool is_first) {}
};

}  // namespace lentray::core
