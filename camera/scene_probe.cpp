#include "camera/scene_probe.h"

#include <memory>
#include <utility>

#include "core/accel/hierarchy.h"
#include "core/object/leaf.h"
#include "core/scene/scene.h"
#include "core/scene/tolerances.h"

namespace lentray::camera {

SceneProbe probe_of(const core::Scene& scene, ObjectNamer namer, unsigned threads) {
  const auto names = std::make_shared<const ObjectNamer>(std::move(namer));
  const auto ask = [&scene, names](const core::Ray& ray, double limit) -> std::optional<ProbeHit> {
    thread_local core::HitLists lists;
    core::Hit hit;
    if (!scene.hierarchy().nearest(ray, core::kMinHitDistance * scene.tolerance_scale(), limit,
                                   core::RayKind::kCamera, hit, lists, nullptr)) {
      return std::nullopt;
    }
    const core::Object* object = hit.object;
    if (!object) object = hit.leaf;
    return ProbeHit{hit.t,           std::string(object->name()),
                    object,          [object] { return object->bounds(); },
                    object->whole(), names.get()};
  };
  return {ask, threads, scene.deepest()};
}

}  // namespace lentray::camera
