#include "core/trace/illumination.h"

#include "core/photon/photon_map.h"
#include "core/trace/radiosity_light.h"
#include "core/trace/thread_context.h"

namespace lentray::core {
namespace {

const PhotonMap* photons(const ThreadContext& context, PhotonMap PhotonLight::*map) {
  if (!context.illumination || !context.illumination->photons) return nullptr;
  const PhotonMap& all = (*context.illumination->photons).*map;
  return all.is_empty() ? nullptr : &all;
}

}  // namespace

std::unique_ptr<IndirectLight> make_indirect_light(ThreadContext& context, ShadowTester& shadows) {
  if (!context.illumination || !context.illumination->irradiance) return nullptr;
  auto light =
      std::make_unique<RadiosityLight>(context, shadows, *context.illumination->irradiance);
  context.indirect = light.get();
  return light;
}

const PhotonMap* surface_photons(const ThreadContext& context) {
  return photons(context, &PhotonLight::surface);
}

const PhotonMap* media_photons(const ThreadContext& context) {
  return photons(context, &PhotonLight::media);
}

}  // namespace lentray::core
