#include "core/render/focal_blur.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <numbers>

#include "core/numeric/radical_inverse.h"

namespace lentray::core {
namespace {

/// Points of a hexagonal lattice about the origin, `rings` rings of it, and how many they are.
constexpr int lattice_size(int rings) { return 1 + 3 * rings * (rings + 1); }

/// The most rings whose points are all used; 0: too few rays for a lattice.
int rings_for(int rays) {
  int rings = 3;
  while (rings > 0 && lattice_size(rings) > rays) --rings;
  return rings;
}

/// Rays after which the variances are looked at, for the first ones; then after every four.
std::vector<int> first_batches(int rings) {
  switch (rings) {
    case 0: return {};
    case 1: return {7};
    case 2: return {7, 6, 6};
    default: return {7, 6, 6, 4, 4, 4, 4, 2};
  }
}

/// From few points that cover the disc to many: the origin and the corners of the outermost ring,
/// the corners of the others from outside in, then what lies between corners, in the same order.
std::vector<Vec2> hexagons(int rings) {
  const double step = 1.0 / (std::numbers::sqrt3 * (rings + 1));
  std::vector<Vec2> points{{0.0, 0.0}};
  const auto corner = [&](int ring, int i) {
    const double angle = (i % 6) * std::numbers::pi / 3.0;
    return Vec2{ring * step * std::cos(angle), ring * step * std::sin(angle)};
  };
  const auto opposite_first = [](int i) { return i / 2 + i % 2 * 3; };
  for (int ring = rings; ring > 0; --ring) {
    for (int i = 0; i < 6; ++i) points.push_back(corner(ring, opposite_first(i)));
  }
  for (int ring = rings; ring > 1; --ring) {
    for (int part = 1; part < ring; ++part) {
      for (int i = 0; i < 6; ++i) {
        const int at = opposite_first(i);
        const Vec2 a = corner(ring, at), b = corner(ring, at + 1);
        const double share = static_cast<double>(part) / ring;
        points.push_back({a.u + (b.u - a.u) * share, a.v + (b.v - a.v) * share});
      }
    }
  }
  return points;
}

/// Halton's sequence on (0..1)^2.
class Places {
 public:
  Vec2 next() {
    ++m_index;
    return {radical_inverse(m_index, 2), radical_inverse(m_index, 3)};
  }

 private:
  std::uint64_t m_index = 0;
};

/// The square's place on the disc, areas kept in proportion.
Vec2 on_disc(const Vec2& p) {
  const double radius = 0.5 * std::sqrt(p.u), angle = 2.0 * std::numbers::pi * p.v;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Which cells of the square have a point.
class Cells {
 public:
  explicit Cells(int points)
      : m_side(2 * static_cast<int>(std::ceil(std::sqrt(points / std::numbers::pi))) + 1),
        m_taken(static_cast<std::size_t>(m_side) * static_cast<std::size_t>(m_side)) {}
  bool is_taken(const Vec2& p) const { return m_taken[cell(p)] != 0; }
  void take(const Vec2& p) { m_taken[cell(p)] = 1; }

 private:
  std::size_t cell(const Vec2& p) const {
    const auto along = [&](double x) {
      return static_cast<std::size_t>(
          std::clamp(static_cast<int>((x + 0.5) * m_side), 0, m_side - 1));
    };
    return along(p.v) * static_cast<std::size_t>(m_side) + along(p.u);
  }
  int m_side;
  std::vector<std::uint8_t> m_taken;
};

/// Further points of the disc, in cells that have none while there are such.
void fill_disc(int count, std::vector<Vec2>& points) {
  Cells cells(count);
  for (const Vec2& p : points) cells.take(p);
  Places places;
  long left = 10L * count;  // places that are tried
  while (static_cast<int>(points.size()) < count) {
    const Vec2 p = on_disc(places.next());
    if (cells.is_taken(p) && --left > 0) continue;
    cells.take(p);
    points.push_back(p);
  }
}

/// Points of the square, as likely as `weight` says. Where it is nearly black everywhere, any.
std::vector<Vec2> weighted(int count, const std::function<double(double, double)>& weight) {
  constexpr std::uint64_t kBokeh = 0x626f6b6568;
  RandomSequence random(kBokeh, RandomSequence::Use::kAperture);
  std::vector<Vec2> points;
  Places places;
  long left = 256L * count;
  while (static_cast<int>(points.size()) < count) {
    const Vec2 p = places.next();
    if (--left > 0 && random.next() > weight(p.u, p.v)) continue;
    points.push_back({p.u - 0.5, p.v - 0.5});
  }
  return points;
}

std::vector<Vec2> disc(int count, int rings) {
  std::vector<Vec2> points;
  if (rings > 0) {
    points = hexagons(rings);
  } else {
    points = {{-0.25, 0.25}, {0.25, 0.25}, {-0.25, -0.25}, {0.25, -0.25}};
    points.resize(std::min(points.size(), static_cast<std::size_t>(count)));
  }
  fill_disc(count, points);
  return points;
}

/// The jitter that fills the plane between the points of a lattice, or of as many squares.
double jitter_of(int count, bool is_lattice, int rings) {
  if (is_lattice) return 0.5 / (std::numbers::sqrt3 * (rings + 1));
  return 0.5 / std::sqrt(count);
}

/// The value that chi-squared of so many degrees of freedom exceeds with that probability.
double exceeded(int freedom, double probability) {
  using boost::math::chi_squared;
  return boost::math::quantile(boost::math::complement(chi_squared(freedom), probability));
}

std::vector<FocalBlur::Stop> stops_of(int most, const FocalBlurOptions& options,
                                      const std::vector<int>& batches) {
  const double unit = most > 1 ? options.variance / exceeded(most - 1, options.confidence) : 0.0;
  std::vector<FocalBlur::Stop> stops;
  std::size_t batch = 0;
  for (int rays = 0; rays < most;) {
    rays = std::min(most, rays + (batch < batches.size() ? batches[batch++] : 4));
    stops.push_back({rays, unit > 0.0 ? unit * exceeded(rays, options.confidence) : 0.0});
  }
  return stops;
}

}  // namespace

FocalBlur::FocalBlur(const FocalBlurOptions& options) : m_least(options.least) {
  const int most = std::clamp(options.most, 1, kMostRays);
  const int rings = options.weight ? 0 : rings_for(most);
  m_points = options.weight ? weighted(most, options.weight) : disc(most, rings);
  m_jitter = jitter_of(most, rings > 0 && most == lattice_size(rings), rings);
  m_stops = stops_of(most, options, first_batches(rings));
}

BlurEstimate::BlurEstimate(const FocalBlur& blur, std::uint64_t key) : m_blur(&blur) {
  RandomSequence random(key, RandomSequence::Use::kPixelPlace);
  m_across = random.next();
  m_down = random.next();
}

std::uint32_t BlurEstimate::more() {
  const std::vector<FocalBlur::Stop>& stops = m_blur->stops();
  if (m_rays == stops[m_stop].rays) {
    if (m_stop + 1 == stops.size()) return 0;
    const double threshold = stops[m_stop++].threshold;
    const auto varies = [&](std::size_t i) {
      const double mean = m_sum[i] / m_rays;
      const double variance = std::max(0.0, m_squares[i] / m_rays - mean * mean) / m_rays;
      return !(variance < threshold);
    };
    if (m_rays >= m_blur->least() && !(varies(0) || varies(1) || varies(2) || varies(3))) return 0;
  }
  return static_cast<std::uint32_t>(stops[m_stop].rays - m_rays);
}

BlurRay BlurEstimate::ray(std::uint32_t number, std::uint64_t key) const {
  // Steps of Roberts's sequence in two dimensions: inverse powers of the root of x^3 = x + 1.
  constexpr double kStepAcross = 0.7548776662466927, kStepDown = 0.5698402909980532;
  const Vec2& point = m_blur->points()[number];
  RandomSequence random(key, RandomSequence::Use::kAperture);
  const auto place = [&](double start, double step) {
    const double x = start + number * step;
    return x - std::floor(x) - 0.5;
  };
  BlurRay ray;
  ray.across = place(m_across, kStepAcross);
  ray.down = place(m_down, kStepDown);
  ray.x = point.u + (2.0 * random.next() - 1.0) * m_blur->jitter();
  ray.y = point.v + (2.0 * random.next() - 1.0) * m_blur->jitter();
  return ray;
}

void BlurEstimate::add(const Radiance& light) {
  const std::array<double, 4> channels{light.rgb.r, light.rgb.g, light.rgb.b, light.transmit};
  for (std::size_t i = 0; i < channels.size(); ++i) {
    m_sum[i] += channels[i];
    m_squares[i] += channels[i] * channels[i];
  }
  ++m_rays;
}

Radiance BlurEstimate::mean() const {
  const auto share = [&](std::size_t i) { return static_cast<float>(m_sum[i] / m_rays); };
  return {{share(0), share(1), share(2)}, share(3)};
}

}  // namespace lentray::core
