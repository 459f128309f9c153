// The question a camera asks of a scene before there is a picture: what does a ray meet first?
// World space; distances in multiples of the ray's direction. Threads: any number ask probe_of()'s;
// names are asked for by one at a time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

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
  std::string object;                                ///< SDL's word for what was hit ("sphere")
  const void* id = nullptr;                          ///< tells objects of the same kind apart
  core::Bounds bounds = core::Bounds::everything();  ///< of the object; infinite for planes
  std::uint32_t whole = 0;                           ///< core::Object::whole()
  const ObjectNamer* namer = nullptr;                ///< null: places are not known

  std::string name() const { return namer && *namer ? (*namer)(*this) : object; }
};

/// First hit with 0 < distance < the given one, or nothing. An empty function: no scene.
using SceneProbe = std::function<std::optional<ProbeHit>(const core::Ray&, double)>;

/// Asks a compiled scene, which must outlive the probe, as must what the namer knows. Sees what camera
/// rays see.
SceneProbe probe_of(const core::Scene& scene, ObjectNamer namer = {});

}  // namespace lentray::camera
