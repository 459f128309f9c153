// The question a camera asks of a scene before there is a picture: what does a ray meet first?
// World space; distances in multiples of the ray's direction. Called on one thread.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/base/bounds.h"
#include "core/base/ray.h"

namespace lentray::core {
class Scene;
}

namespace lentray::camera {

struct ProbeHit {
  double distance = 0.0;
  std::string object;                                ///< SDL's word for what was hit ("sphere")
  const void* id = nullptr;                          ///< tells objects of the same kind apart
  core::Bounds bounds = core::Bounds::everything();  ///< of the object; infinite for planes
};

/// First hit with 0 < distance < the given one, or nothing. An empty function: no scene.
using SceneProbe = std::function<std::optional<ProbeHit>(const core::Ray&, double)>;

/// Asks a compiled scene, which must outlive the probe. Sees what camera rays see.
SceneProbe probe_of(const core::Scene& scene);

}  // namespace lentray::camera
