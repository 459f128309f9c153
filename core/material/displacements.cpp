#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/tiny.h"
#include "core/base/whole.h"
#include "core/material/normals.h"
#include "core/noise/noise.h"
#include "core/pattern/shapes.h"

namespace lentray::core {
namespace {

/// The displacement of which a normal n at p becomes formula(p, n).
template <class Formula>
DisplacementPtr displacement_of(Formula formula) {
  class Made final : public Displacement {
   public:
    explicit Made(Formula f) : m_formula(std::move(f)) {}
    Vec3 displaced(const Vec3& p, const Vec3& n) const override { return m_formula(p, n); }

   private:
    Formula m_formula;
  };
  return std::make_unique<Made>(std::move(formula));
}

/// Ripples and waves: rings about the sources.
DisplacementPtr make_rings(double amount, std::vector<WaveSource> sources, double frequency,
                           double phase) {
  return displacement_of([amount, frequency, phase, sources = std::move(sources)](const Vec3& p,
                                                                                  const Vec3& n) {
    Vec3 result = n;
    const auto count = static_cast<double>(sources.size());
    for (const WaveSource& source : sources) {
      const Vec3 away = p - source.position;
      const double distance = length(away) == 0.0 ? 1.0 : length(away);
      const double height =
          cycloidal(distance * frequency * source.frequency + phase) * amount / source.frequency;
      result += away * (height / (distance * count));
    }
    return result;
  });
}

/// The nearest of the random points around, of the point itself or of the normal.
class Facets final : public Displacement {
 public:
  Facets(double size, double coords, double metric)
      : m_scale(size < 1e-6 ? 1e6 : 1.0 / size), m_coords(coords), m_metric(metric) {}
  Vec3 displaced(const Vec3& p, const Vec3& n) const override {
    const Vec3 unit = normalized(n);
    const Vec3 facet = nearest((m_coords != 0.0 ? p : unit) * m_scale);
    if (m_coords == 0.0) return facet;
    Vec3 shift = vector_noise(facet);
    shift -= unit * dot(shift, unit);
    return unit + shift * m_coords;
  }

 private:
  Vec3 nearest(const Vec3& at) const {
    double least = 1e300;
    Vec3 best;
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        for (int z = -2; z <= 2; ++z) {
          if ((x * x == 4) + (y * y == 4) + (z * z == 4) > 1) continue;
          const Vec3 point = random_point(at + Vec3(x, y, z));
          const double d = distance(point - at);
          if (d >= least) continue;
          least = d;
          best = point;
        }
      }
    }
    return best;
  }
  static Vec3 random_point(const Vec3& p) {
    const Vec3 cell{std::floor(p.x - kTiny), std::floor(p.y - kTiny), std::floor(p.z - kTiny)};
    return cell + cell_randoms(whole_of(cell.x), whole_of(cell.y), whole_of(cell.z));
  }
  double distance(const Vec3& d) const {
    if (m_metric == 2.0) return length_squared(d);
    if (m_metric == 1.0) return d.x + d.y + d.z;  // signed
    return std::pow(std::fabs(d.x), m_metric) + std::pow(std::fabs(d.y), m_metric) +
           std::pow(std::fabs(d.z), m_metric);
  }
  double m_scale, m_coords, m_metric;
};

}  // namespace

DisplacementPtr make_bumps_displacement(double amount) {
  return displacement_of(
      [amount](const Vec3& p, const Vec3& n) { return n + vector_noise(p) * amount; });
}
DisplacementPtr make_dents_displacement(double amount, int generator) {
  return displacement_of([amount, generator](const Vec3& p, const Vec3& n) {
    const double depth = noise(p, generator);
    return n + vector_noise(p) * (depth * depth * depth * amount);
  });
}
DisplacementPtr make_wrinkles_displacement(double amount) {
  return displacement_of([amount](const Vec3& p, const Vec3& n) {
    Vec3 sum;
    double scale = 1.0;
    for (int octave = 0; octave < 10; ++octave, scale *= 2.0) {
      const Vec3 one = vector_noise(p * scale);
      sum += Vec3(std::fabs(one.x / scale), std::fabs(one.y / scale), std::fabs(one.z / scale));
    }
    return n + sum * amount;
  });
}
DisplacementPtr make_ripples_displacement(double amount, int sources, double frequency,
                                          double phase) {
  std::vector<WaveSource> all = wave_sources(sources);
  for (WaveSource& source : all) source.frequency = 1.0;
  return make_rings(amount, std::move(all), frequency, phase);
}
DisplacementPtr make_waves_displacement(double amount, int sources, double frequency,
                                        double phase) {
  return make_rings(amount, wave_sources(sources), frequency, phase);
}
DisplacementPtr make_quilted_displacement(double amount, double control0, double control1) {
  return displacement_of([amount, control0, control1](const Vec3& p, const Vec3& n) {
    return n + quilt_offset(p, control0, control1) * amount;
  });
}
DisplacementPtr make_facets_displacement(double size, double coords, double metric) {
  return std::make_unique<Facets>(size, coords, metric);
}

}  // namespace lentray::core
