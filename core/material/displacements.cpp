#include <array>
#include <cmath>

#include "core/base/tiny.h"
#include "core/base/whole.h"
#include "core/material/normals.h"
#include "core/noise/noise.h"
#include "core/pattern/shapes.h"

namespace lentray::core {
namespace {

class Bumps final : public Displacement {
 public:
  explicit Bumps(double amount) : m_amount(amount) {}
  Vec3 displaced(const Vec3& p, const Vec3& n) const override {
    return n + vector_noise(p) * m_amount;
  }

 private:
  double m_amount;
};

class Dents final : public Displacement {
 public:
  Dents(double amount, int generator) : m_amount(amount), m_generator(generator) {}
  Vec3 displaced(const Vec3& p, const Vec3& n) const override {
    const double depth = noise(p, m_generator);
    return n + vector_noise(p) * (depth * depth * depth * m_amount);
  }

 private:
  double m_amount;
  int m_generator;
};

class Wrinkles final : public Displacement {
 public:
  explicit Wrinkles(double amount) : m_amount(amount) {}
  Vec3 displaced(const Vec3& p, const Vec3& n) const override {
    Vec3 sum;
    double scale = 1.0;
    for (int octave = 0; octave < 10; ++octave, scale *= 2.0) {
      const Vec3 one = vector_noise(p * scale);
      sum += Vec3(std::fabs(one.x / scale), std::fabs(one.y / scale), std::fabs(one.z / scale));
    }
    return n + sum * m_amount;
  }

 private:
  double m_amount;
};

/// Ripples and waves: rings about the sources, all of one frequency or each of its own.
class Rings final : public Displacement {
 public:
  Rings(double amount, int sources, double frequency, double phase, bool own_frequencies)
      : m_sources(wave_sources(sources)), m_amount(amount), m_frequency(frequency), m_phase(phase) {
    if (own_frequencies) return;
    for (WaveSource& source : m_sources) source.frequency = 1.0;
  }
  Vec3 displaced(const Vec3& p, const Vec3& n) const override {
    Vec3 result = n;
    const auto count = static_cast<double>(m_sources.size());
    for (const WaveSource& source : m_sources) {
      const Vec3 away = p - source.position;
      const double distance = length(away) == 0.0 ? 1.0 : length(away);
      const double height = cycloidal(distance * m_frequency * source.frequency + m_phase) *
                            m_amount / source.frequency;
      result += away * (height / (distance * count));
    }
    return result;
  }

 private:
  std::vector<WaveSource> m_sources;
  double m_amount, m_frequency, m_phase;
};

class Quilted final : public Displacement {
 public:
  Quilted(double amount, double control0, double control1)
      : m_amount(amount), m_control0(control0), m_control1(control1) {}
  Vec3 displaced(const Vec3& p, const Vec3& n) const override {
    return n + quilt_offset(p, m_control0, m_control1) * m_amount;
  }

 private:
  double m_amount, m_control0, m_control1;
};

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
    const std::size_t seed = lattice_hash(whole_of(cell.x), whole_of(cell.y), whole_of(cell.z));
    return cell + Vec3(lattice_random(seed), lattice_random(seed + 1), lattice_random(seed + 2));
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

DisplacementPtr make_bumps_displacement(double amount) { return std::make_unique<Bumps>(amount); }
DisplacementPtr make_dents_displacement(double amount, int generator) {
  return std::make_unique<Dents>(amount, generator);
}
DisplacementPtr make_wrinkles_displacement(double amount) {
  return std::make_unique<Wrinkles>(amount);
}
DisplacementPtr make_ripples_displacement(double amount, int sources, double frequency,
                                          double phase) {
  return std::make_unique<Rings>(amount, sources, frequency, phase, false);
}
DisplacementPtr make_waves_displacement(double amount, int sources, double frequency,
                                        double phase) {
  return std::make_unique<Rings>(amount, sources, frequency, phase, true);
}
DisplacementPtr make_quilted_displacement(double amount, double control0, double control1) {
  return std::make_unique<Quilted>(amount, control0, control1);
}
DisplacementPtr make_facets_displacement(double size, double coords, double metric) {
  return std::make_unique<Facets>(size, coords, metric);
}

}  // namespace lentray::core
