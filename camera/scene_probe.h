// The question a camera asks of a scene before there is a picture: what does a ray meet first?
// World space; distances in multiples of the ray's direction. Threads: as many ask as a probe says, of
// probe_of()'s any number; names are asked for by one at a time.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "core/base/bounds.h"
#include "core/base/ray.h"

namespace lentray::core {
class Scene;
}

namespace lentray::camera {

/// Names an object for people: "sphere at scene.pov:12:1".
struct ProbeHit;
using ObjectNamer = std::function<std::string(const ProbeHit&)>;

struct ProbeHit {
  double distance = 0.0;
  std::string object;        ///< SDL's word for what was hit ("sphere")
  const void* id = nullptr;  ///< distinguishes objects of the same kind
  /// Of the object, found when asked for: large objects may take long. Empty: it is infinite.
  std::function<core::Bounds()> bounds{};
  std::uint32_t whole = 0;             ///< core::Object::whole()
  const ObjectNamer* namer = nullptr;  ///< null: places are not known

  std::string name() const { return namer && *namer ? (*namer)(*this) : object; }
};

/// First hit with 0 < distance < the given one, or nothing.
class SceneProbe {
 public:
  using Ask = std::function<std::optional<ProbeHit>(const core::Ray&, double)>;
  /// No scene.
  SceneProbe() = default;
  /// `threads`: that may ask at once, each with a stack for so many `levels` of a scene
  /// (core/base/deep_threads.h).
  template <std::convertible_to<Ask> F>
  requires(!std::same_as<std::remove_cvref_t<F>, SceneProbe>)
      SceneProbe(F&& ask, unsigned threads = 1, std::size_t levels = 0)
      : m_ask(std::forward<F>(ask)), m_threads(threads), m_levels(levels) {}

  explicit operator bool() const { return static_cast<bool>(m_ask); }
  std::optional<ProbeHit> operator()(const core::Ray& ray, double limit) const {
    return m_ask(ray, limit);
  }
  unsigned threads() const { return m_threads; }
  std::size_t levels() const { return m_levels; }

 private:
  Ask m_ask;
  unsigned m_threads = 1;
  std::size_t m_levels = 0;
};

/// Asks a compiled scene, which must outlive the probe, as must what the namer knows. Sees what camera
/// rays see.
SceneProbe probe_of(const core::Scene& scene, ObjectNamer namer = {}, unsigned threads = 1);

}  // namespace lentray::camera
