#include "core/photon/photon_map.h"

#include <utility>

#include "core/photon/gather_radius.h"

namespace lentray::core {
namespace {

constexpr double kFarther = 3.0;      ///< radii, if too few were found
constexpr double kNoDensity = 1e-16;  ///< stands for that of no photons

double density(const FoundPhotons& found) {
  return static_cast<double>(found.size()) / (found.radius() * found.radius());
}

}  // namespace

PhotonMap::PhotonMap(PhotonTree tree, Place place, const PhotonSettings& settings, CRandom& random)
    : m_tree(std::move(tree)), m_settings(settings) {
  if (is_empty()) return;
  const bool in_media = place == Place::kMedia;
  m_radius = in_media ? settings.media_radius : settings.radius;
  if (!(m_radius > 0.0)) {
    m_radius = in_media ? media_gather_radius(m_tree, settings.gather_max, random)
                        : surface_gather_radius(m_tree, settings.gather_max, random);
  }
  m_radius *= in_media ? 2.0 * settings.media_radius_multiplier : settings.radius_multiplier;
}

void PhotonMap::gather(const Vec3& point, const Vec3* normal, FoundPhotons& found,
                       FoundPhotons& spare) const {
  PhotonSearch search{point, normal, m_radius, static_cast<std::size_t>(m_settings.gather_max)};
  m_tree.find(search, found);
  if (found.size() >= static_cast<std::size_t>(m_settings.gather_min)) return;
  search.radius *= kFarther;
  m_tree.find(search, spare);
  const double near = found.is_empty() ? kNoDensity : density(found);
  const bool as_dense = (density(spare) - near) / near < m_settings.expand_increase;
  const bool are_few =
      !spare.is_empty() && spare.size() < static_cast<std::size_t>(m_settings.expand_min);
  if (as_dense || are_few) std::swap(found, spare);
}

std::shared_ptr<const PhotonLight> make_photon_light(PhotonMaps maps,
                                                     const PhotonSettings& settings) {
  CRandom random;
  const auto order = maps.are_trees ? PhotonTree::Order::kOfTree : PhotonTree::Order::kOfShooting;
  PhotonMap surface({std::move(maps.surface), order}, PhotonMap::Place::kSurface, settings, random);
  PhotonMap media({std::move(maps.media), order}, PhotonMap::Place::kMedia, settings, random);
  return std::make_shared<const PhotonLight>(PhotonLight{std::move(surface), std::move(media)});
}

}  // namespace lentray::core
