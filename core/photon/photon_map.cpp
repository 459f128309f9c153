#include "core/photon/photon_map.h"

#include <utility>

#include "core/photon/gather_radius.h"

namespace lentray::core {
namespace {

constexpr double kFarther = 3.0;      ///< radii, if too few were found
constexpr double kNoDensity = 1e-16;  ///< stands for that of no photons

double density(const FoundPhotons& found) {
  return static_cast<double>(found.list.size()) / (found.radius * found.radius);
}

}  // namespace

PhotonMap::PhotonMap(PhotonTree tree, Place place, const GatherRules& rules, CRandom& random)
    : m_tree(std::move(tree)), m_rules(rules) {
  if (is_empty()) return;
  const bool in_media = place == Place::kMedia;
  m_radius = in_media ? rules.media_radius : rules.radius;
  if (!(m_radius > 0.0)) {
    m_radius = in_media ? media_gather_radius(m_tree, rules.most, random)
                        : surface_gather_radius(m_tree, rules.most, random);
  }
  m_radius *= in_media ? 2.0 * rules.media_radius_factor : rules.radius_factor;
}

void PhotonMap::gather(const Vec3& point, const Vec3* normal, FoundPhotons& found,
                       FoundPhotons& spare) const {
  PhotonSearch search{point, normal, m_radius, static_cast<std::size_t>(m_rules.most)};
  m_tree.find(search, found);
  if (found.list.size() >= static_cast<std::size_t>(m_rules.least)) return;
  search.radius *= kFarther;
  m_tree.find(search, spare);
  const double near = found.list.empty() ? kNoDensity : density(found);
  const bool as_dense = (density(spare) - near) / near < m_rules.expand_increase;
  const bool are_few =
      !spare.list.empty() && spare.list.size() < static_cast<std::size_t>(m_rules.expand_below);
  if (as_dense || are_few) std::swap(found, spare);
}

std::shared_ptr<const PhotonLight> make_photon_light(PhotonMaps maps, const GatherRules& rules) {
  CRandom random;
  const auto order = maps.are_trees ? PhotonTree::Order::kOfTree : PhotonTree::Order::kOfShooting;
  PhotonMap surface({std::move(maps.surface), order}, PhotonMap::Place::kSurface, rules, random);
  PhotonMap media({std::move(maps.media), order}, PhotonMap::Place::kMedia, rules, random);
  return std::make_shared<const PhotonLight>(PhotonLight{std::move(surface), std::move(media)});
}

}  // namespace lentray::core
