#include "core/pattern/organic.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lentray::core {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

PatternPtr make_bozo(int generator) {
  return pattern_of([generator](const Vec3& p) { return noise(p, generator); });
}
PatternPtr make_dents(int generator) {
  return pattern_of([generator](const Vec3& p) {
    const double n = noise(p, generator);
    return n * n * n;
  });
}
PatternPtr make_granite(int generator) {
  return pattern_of([generator](const Vec3& p) {
    const Vec3 fine = p * 4.0;
    double sum = 0.0, frequency = 1.0;
    for (int octave = 0; octave < 6; ++octave, frequency *= 2.0) {
      const double n = noise(fine * frequency, generator);
      const double ridge =
          generator == 1 ? std::fabs(0.5 - n) : std::min(std::fabs(1.0 - 2.0 * n), 0.5);
      sum += ridge / frequency;
    }
    return sum;
  });
}
PatternPtr make_wrinkles(int generator) {
  return pattern_of([generator](const Vec3& p) {
    double sum = 0.0, scale = 1.0, weight = 1.0;
    for (int octave = 0; octave < 10; ++octave, scale *= 2.0, weight *= 0.5) {
      const double n = noise(p * scale, generator);
      sum += weight * (generator > 1 ? std::clamp(2.0 * n - 0.5, 0.0, 1.0) : n);
    }
    return sum / 2.0;
  });
}
PatternPtr make_marble(const std::optional<Turbulence>& turbulence, int generator) {
  return pattern_of([turbulence, generator](const Vec3& p) {
    if (!turbulence || turbulence->amount.x == 0.0) return p.x;
    return p.x + turbulence->amount.x * core::turbulence(p, *turbulence, generator);
  });
}
PatternPtr make_wood(const std::optional<Turbulence>& turbulence) {
  return pattern_of([turbulence](const Vec3& p) {
    double x = p.x, y = p.y;
    if (turbulence) {
      const Vec3 shift = vector_turbulence(p, *turbulence);
      x += cycloidal((p.x + shift.x) * turbulence->amount.x);
      y += cycloidal((p.y + shift.y) * turbulence->amount.y);
    }
    return std::sqrt(x * x + y * y);
  });
}
PatternPtr make_agate(const Turbulence& turbulence, double scale, int generator) {
  return pattern_of([turbulence, scale, generator](const Vec3& p) {
    const double bands = scale * core::turbulence(p, turbulence, generator);
    const double wave = 0.5 * (cycloidal(1.3 * bands + 1.1 * p.z) + 1.0);
    return wave < 0.0 ? 0.0 : std::pow(std::min(wave, 1.0), 0.77);
  });
}
PatternPtr make_spiral(int arms, const std::optional<Turbulence>& turbulence, int generator,
                       bool second) {
  return pattern_of([arms, turbulence, generator, second](const Vec3& p) {
    double shift = 0.0;
    if (turbulence && turbulence->amount.x != 0.0)
      shift = turbulence->amount.x * core::turbulence(p, *turbulence, generator);
    const double radius = std::sqrt(p.x * p.x + p.y * p.y);
    double angle = 0.0;
    if (radius != 0.0) {
      const double lift = std::asin(p.y / radius);
      angle = p.x < 0.0 ? 1.5 * kPi - lift : 0.5 * kPi + lift;
    }
    const double turns = p.z + radius + arms * angle / (2.0 * kPi) + shift;
    return second ? triangle_wave(radius) + triangle_wave(turns) : turns;
  });
}
PatternPtr make_ripples(int sources, double frequency, double phase) {
  return pattern_of([all = wave_sources(sources), frequency, phase](const Vec3& p) {
    double sum = 0.0;
    for (const WaveSource& source : all) {
      const double distance = length(p - source.position);
      sum += cycloidal((distance == 0.0 ? 1.0 : distance) * frequency + phase);
    }
    return 0.5 * (1.0 + sum / static_cast<double>(all.size()));
  });
}
PatternPtr make_waves(int sources, double frequency, double phase) {
  return pattern_of([all = wave_sources(sources), frequency, phase](const Vec3& p) {
    double sum = 0.0;
    for (const WaveSource& source : all) {
      const double distance = length(p - source.position);
      const double way = (distance == 0.0 ? 1.0 : distance) * frequency * source.frequency;
      sum += cycloidal(way + phase) / source.frequency;
    }
    return 0.2 * (2.5 + sum / static_cast<double>(all.size()));
  });
}

}  // namespace lentray::core
