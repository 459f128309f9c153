#include "core/photon/gather_radius.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lentray::core {
namespace {

constexpr double kEverywhere = 1e7;
constexpr std::size_t kPhotonsAProbe = 20, kLeastProbes = 100, kMostProbes = 1000;
/// A place is thin if its density is between these shares of the mean.
constexpr double kNothing = 0.05, kThin = 0.7;
constexpr double kThinFactor = 20.0;  ///< how much thin places enlarge the radius

/// The density of photons about a place, and the radius that as many have at a density. The order of the
/// operations is fixed: so many photons as make 70 % of the mean are a common case, on which side of it
/// rounding decides.
struct OnSurface {
  static double density(double photons, double radius) {
    return photons / (std::numbers::pi * radius * radius);
  }
  static double radius(double photons, double density) {
    return std::sqrt(photons / (density * std::numbers::pi));
  }
};
struct InMedia {
  static double density(double photons, double radius) {
    return 3.0 * photons / (4.0 * std::numbers::pi * radius * radius * radius);
  }
  static double radius(double photons, double density) {
    constexpr double kAThird = 0.3333;  // measured so, not 1 / 3
    return std::pow(3.0 * photons / (density * std::numbers::pi * 4.0), kAThird);
  }
};

template <class Room>
class Radius {
 public:
  Radius(const PhotonTree& tree, int most, CRandom& random)
      : m_tree(tree), m_most(static_cast<std::size_t>(most)), m_random(random),
        m_probes(std::clamp(tree.size() / kPhotonsAProbe, kLeastProbes, kMostProbes)) {}

  double find() {
    const double mean = mean_density();
    if (!(mean > 0.0)) return 0.0;
    const double radius = Room::radius(static_cast<double>(m_most), mean);
    return radius * (1.0 + kThinFactor * thin_share(radius, mean));
  }

 private:
  /// About a photon; 0: all that were found lie at one place.
  double density(double radius) {
    const Photon& photon = m_tree.photons()[m_random.next() % m_tree.size()];
    const Vec3 place(photon.place[0], photon.place[1], photon.place[2]);
    m_tree.find({place, nullptr, radius, m_most, true}, m_found);
    if (!(m_found.radius() > 0.0)) return 0.0;
    return Room::density(static_cast<double>(m_found.size()), m_found.radius());
  }
  /// A place without a density has the mean of those before.
  double mean_density() {
    double sum = 0.0;
    for (std::size_t i = 0; i < m_probes; ++i) {
      const double here = density(kEverywhere);
      sum += here > 0.0 || i == 0 ? here : sum / static_cast<double>(i);
    }
    return sum / static_cast<double>(m_probes);
  }
  double thin_share(double radius, double mean) {
    std::size_t thin = 0;
    for (std::size_t i = 0; i < m_probes; ++i) {
      const double here = density(radius);
      if (here < mean * kThin && here > mean * kNothing) ++thin;
    }
    return static_cast<double>(thin) / static_cast<double>(m_probes);
  }

  const PhotonTree& m_tree;
  const std::size_t m_most;
  CRandom& m_random;
  const std::size_t m_probes;
  FoundPhotons m_found;
};

}  // namespace

double surface_gather_radius(const PhotonTree& tree, int most, CRandom& random) {
  return Radius<OnSurface>(tree, most, random).find();
}

double media_gather_radius(const PhotonTree& tree, int most, CRandom& random) {
  return Radius<InMedia>(tree, most, random).find();
}

}  // namespace lentray::core
