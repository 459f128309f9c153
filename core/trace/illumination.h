// What passes leave for shading (core/pass): light that was gathered before the picture. Const,
// shared by all threads and by all pictures of a scene; a member that is null: the scene has none
// of it.
#pragma once

#include <memory>

namespace lentray::core {

class IndirectLight;
class IrradianceCache;
class PhotonMap;
class ShadowTester;
struct PhotonLight;
struct ThreadContext;

struct Illumination {
  std::shared_ptr<const IrradianceCache> irradiance{};  ///< of radiosity
  std::shared_ptr<const PhotonLight> photons{};
};

/// What the context's illumination gives to surfaces; null: nothing. It becomes the context's `indirect`,
/// which surfaces ask, and lives as long as rays are traced.
std::unique_ptr<IndirectLight> make_indirect_light(ThreadContext& context, ShadowTester& shadows);

/// The photons that light surfaces and media; null: there are none.
const PhotonMap* surface_photons(const ThreadContext& context);
const PhotonMap* media_photons(const ThreadContext& context);

}  // namespace lentray::core
