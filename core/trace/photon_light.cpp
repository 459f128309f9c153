#include "core/trace/photon_light.h"

#include <algorithm>
#include <numbers>

#include "core/base/tiny.h"
#include "core/trace/random_key.h"
#include "core/trace/reflectance.h"

namespace lentray::core {
namespace {

constexpr double kFlattest =
    0.1;  ///< photons that come flatter count as if they came at this cosine
constexpr std::uint64_t kPhotonsBranch = ~std::uint64_t{0};  ///< of a layer's random numbers

}  // namespace

Rgb light_of_photons(const PhotonTree& tree, const FoundPhotons& found, const Layer& layer,
                     const Surface& at, const SceneSettings& settings) {
  if (found.is_empty() || !(found.radius() > 0.0)) return {};
  const Finish& finish = *layer.finish;
  const bool one_sided = !at.attributes.double_illuminate;
  const double thickness =
      finish.irid > 0.0 ? film_thickness(finish, at.point(), settings.noise_generator) : 0.0;
  RandomSequence grain(branch_key(branch_key(at.state.key, at.layer), kPhotonsBranch),
                       RandomSequence::Use::kCrand);
  Rgb sum;
  for (const FoundPhotons::One& one : found) {
    const Photon& photon = tree[one.number];
    const Vec3 back = way_back(photon);
    const double cosine = dot(layer.normal, back);
    const bool behind = one_sided && cosine < kTiny;
    if (behind && finish.diffuse_back == 0.0) continue;
    // A photon stands for a share of a beam: the flatter it comes, the more of the surface has that.
    const Rgb light =
        times(power_of(photon), 1.0 / std::clamp(dot(at.normal, back), kFlattest, 1.0));
    Rgb share = diffuse_light(finish, cosine, light, layer.pigment,
                              behind ? finish.diffuse_back : finish.diffuse, layer.opacity,
                              finish.crand > 0.0 ? grain.next() : 0.0);
    if (layer.shines && !behind) {
      share += highlights(finish, {back, at.ray().direction, layer.normal, light, layer.pigment});
    }
    if (finish.irid > 0.0) {
      share *= film_tint(finish, thickness, settings.irid_wavelength, layer.normal, back,
                         at.ray().direction);
    }
    sum += share;
  }
  return times(sum, 1.0 / (std::numbers::pi * found.radius() * found.radius()));
}

}  // namespace lentray::core
