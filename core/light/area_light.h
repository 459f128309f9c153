// Area lights: a grid of point lights, sampled adaptively from its corners inwards. World space.
// The grid is halved while the colours at the corners of a part differ, and at least
// `adaptive` times; every split averages its four quarters.
// Source: reference manual 3.7, "Area Lights"; threshold and the circular mapping as in stock.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/light/light.h"

namespace lentray::core {

/// Reused by the tracer from point to point; grows to the largest light once.
struct AreaScratch {
  std::vector<Rgb> colours;
  std::vector<std::uint8_t> known;
};

/// The axes to use for a point: the light's own, or turned to face it (`orient`).
struct AreaAxes {
  Vec3 first, second;
};
AreaAxes area_axes(const AreaLight& area, const Vec3& towards_light);

/// Where on the light a sample lies, from its position; u and v in steps of the grid, with the
/// jitter in them.
Vec3 area_offset(const AreaLight& area, const AreaAxes& axes, double u, double v);

/// The same of a whole step, with the light's jitter; random() -> double in [0, 1), u first.
template <class Random>
Vec3 jittered_area_offset(const AreaLight& area, const AreaAxes& axes, int u, int v,
                          Random&& random) {
  double fine_u = u, fine_v = v;
  if (area.jitter) {
    fine_u += random() - 0.5;
    fine_v += random() - 0.5;
  }
  return area_offset(area, axes, fine_u, fine_v);
}

/// Asks `probe(offset, sample_index) -> Rgb` for the light's colour at samples of the grid and
/// `random() -> double` in [0, 1) for the jitter (u first).
template <class Probe, class Random>
class AreaSampler {
 public:
  AreaSampler(const AreaLight& area, const AreaAxes& axes, AreaScratch& scratch, Probe& probe,
              Random& random)
      : m_area(area), m_axes(axes), m_scratch(scratch), m_probe(probe), m_random(random) {
    const std::size_t samples = static_cast<std::size_t>(area.size1) * area.size2;
    if (scratch.colours.size() < samples) scratch.colours.resize(samples);
    scratch.known.assign(samples, 0);
  }

  Rgb colour() { return part({0, 0, m_area.size1 - 1, m_area.size2 - 1}, 0); }

 private:
  struct Part {
    int u1, v1, u2, v2;
  };
  static constexpr double kSame = 0.1;  ///< corners that differ by more split their part

  const Rgb& sample(int u, int v) {
    const std::size_t index = static_cast<std::size_t>(u) * m_area.size2 + v;
    if (!m_scratch.known[index]) {
      m_scratch.colours[index] = m_probe(jittered_area_offset(m_area, m_axes, u, v, m_random),
                                         static_cast<std::uint32_t>(index));
      m_scratch.known[index] = 1;
    }
    return m_scratch.colours[index];
  }

  Rgb part(const Part& p, int level) {
    std::array<Rgb, 4> c{sample(p.u1, p.v1), sample(p.u2, p.v1), sample(p.u1, p.v2),
                         sample(p.u2, p.v2)};
    const bool divisible = p.u2 - p.u1 > 1 || p.v2 - p.v1 > 1;
    if (divisible && (m_area.adaptive < 0 || level < m_area.adaptive ||
                      difference(c[0], c[1]) > kSame || difference(c[1], c[3]) > kSame ||
                      difference(c[3], c[2]) > kSame || difference(c[2], c[0]) > kSame)) {
      // Halves of an odd span leave the middle step out, of an even one they share it.
      const int u_low = (p.u1 + p.u2) / 2, u_high = (p.u1 + p.u2 + 1) / 2;
      const int v_low = (p.v1 + p.v2) / 2, v_high = (p.v1 + p.v2 + 1) / 2;
      c[0] = part({p.u1, p.v1, u_low, v_low}, level + 1);
      c[1] = part({u_high, p.v1, p.u2, v_low}, level + 1);
      c[2] = part({p.u1, v_high, u_low, p.v2}, level + 1);
      c[3] = part({u_high, v_high, p.u2, p.v2}, level + 1);
    }
    return (c[0] + c[1] + c[2] + c[3]) * 0.25f;
  }

  const AreaLight& m_area;
  const AreaAxes& m_axes;
  AreaScratch& m_scratch;
  Probe& m_probe;
  Random& m_random;
};

}  // namespace lentray::core
