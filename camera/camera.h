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
  /// The name has to outlive the camera.
  Camera(std::string_view name, std::uint32_t width, std::uint32_t height)
      : m_name(name), m_width(width), m_height(height) {}
  /// The ray at a place with the length that its direction has before it is made unit: at equal
  /// multiples of such directions an aperture is in focus (camera/thin_lens.h).
  virtual bool sight(const core::PixelPlace& place, core::Ray& out) const {
    return ray_at(place, out);
  }
  /// SDL's word for the kind ("perspective", "orthographic", "lenticular").
  std::string_view name() const { return m_name; }
  /// The image size the camera was made for, in pixels.
  std::uint32_t width() const { return m_width; }
  std::uint32_t height() const { return m_height; }
  virtual Properties describe() const { return {{"camera", std::string(m_name)}}; }

 private:
  std::string_view m_name;
  std::uint32_t m_width, m_height;
};

}  // namespace lentray::camera
