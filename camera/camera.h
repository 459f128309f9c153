// A camera: rays for the places of an image, and what a user may want to know about it.
// World space; directions unit. Immutable, any number of threads.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/vec3.h"
#include "core/render/ray_source.h"

namespace lentray::camera {

/// One thing to know about a camera, for file metadata, statistics and `--explain`.
/// Keys are dotted names such as "lens.pitch_mm"; docs/statistics.md lists them.
using Property = std::pair<std::string, std::variant<double, std::string, core::Vec3>>;
using Properties = std::vector<Property>;

class Camera : public core::RaySource {
 public:
  /// The ray at a place with the length that its direction has before it is made unit: at equal
  /// multiples of such directions an aperture is in focus (camera/thin_lens.h).
  virtual bool sight(const core::PixelPlace& place, core::Ray& out) const {
    return ray_at(place, out);
  }
  /// SDL's word for the kind ("perspective", "orthographic", "lenticular").
  virtual std::string_view name() const = 0;
  /// The image size the camera was made for, in pixels.
  virtual std::uint32_t width() const = 0;
  virtual std::uint32_t height() const = 0;
  virtual Properties describe() const = 0;
};

}  // namespace lentray::camera
