#include <array>

#include "core/function/internal_formulas.h"
#include "core/pattern/noise.h"

namespace lentray::core {
namespace {

/// Of an absurd number of octaves the first do: the others cannot be told apart.
constexpr double kMostOctaves = 1000.0;

/// A whole number within +-1000.
int whole(double parameter) {
  return static_cast<int>(std::isnan(parameter) ? 0.0
                                                : std::clamp(parameter, -kMostOctaves, kMostOctaves));
}

/// Parameters choose a noise generator by their last two bits.
int generator_of(double parameter) { return whole(parameter) & 3; }

/// Noise between -1 and 1.
double signed_noise(const Vec3& point, int generator) { return noise(point, generator) * 2.0 - 1.0; }

double noise3d(const double* a) { return noise(a[0], a[1], a[2], 2); }

double noise_generator(const double* a) { return noise(a[0], a[1], a[2], generator_of(a[3])); }

// Heterogeneous multifractal: P0 exponent, P1 lacunarity, P2 octaves, P3 offset, P4 how often the
// sum so far weighs an octave, P5 generator.
double hetero_mf(const double* a) {
  const FormulaPoint q(a);
  const int generator = generator_of(q.p[5]), weighings = whole(q.p[4]);
  const double octaves = std::min(q.p[2], kMostOctaves);
  Vec3 point(q.x, q.y, q.z);
  double sum = signed_noise(point, generator) + q.p[3];
  const double damping = std::pow(q.p[1], -q.p[0]);
  double strength = damping;
  const auto octave = [&] { return (signed_noise(point, generator) + q.p[3]) * strength; };
  point = point * q.p[1];
  for (int i = 1; i < octaves; ++i) {
    double more = octave();
    for (int n = 0; n < weighings; ++n) more *= sum;
    sum += more;
    point = point * q.p[1];
    strength *= damping;
  }
  const double rest = octaves - whole(octaves);
  if (rest != 0.0) sum += rest * octave() * sum;
  return sum;
}

// Folded noise: P0 lacunarity, P1 octaves, P2 gain, P3 offset, P4 where the fold is, P5 generator.
double ridge(const double* a) {
  const FormulaPoint q(a);
  const int generator = generator_of(q.p[5]), octaves = whole(q.p[1]);
  const double offset = q.p[3], fold = q.p[4];
  const double fold_scale = 1.0 / std::max(fold, 1.0 - fold);
  const double rest = std::min(q.p[1], kMostOctaves) - octaves;
  const Vec3 point(q.x, q.y, q.z);
  const auto folded = [&](double frequency) {
    return std::fabs(noise(point * frequency, generator) - fold) * fold_scale - offset;
  };
  double sum = folded(1.0), weights = 1.0, frequency = q.p[0], weight = q.p[2];
  for (int i = 2; i <= octaves; ++i) {
    sum += weight * folded(frequency);
    weights += weight;
    frequency *= q.p[0];
    weight *= q.p[2];
  }
  if (rest != 0.0) {
    sum += weight * rest * folded(frequency);
    weights += weight * rest;
  }
  return sum / (std::max(offset, 1.0 - offset) * weights);
}

/// frequency^-exponent of octave 1, 2, ... for frequency lacunarity^octave. A function asks with the
/// same numbers again and again: each thread keeps what it last worked out.
class OctaveWeights {
 public:
  OctaveWeights(double lacunarity, double exponent) : m_lacunarity(lacunarity), m_exponent(exponent) {}
  bool are_of(double lacunarity, double exponent) const {
    return m_lacunarity == lacunarity && m_exponent == exponent;
  }
  /// Asked in order from 1 on.
  double at(int octave, double frequency) {
    if (octave <= m_known) return m_weights[static_cast<std::size_t>(octave - 1)];
    const double weight = std::pow(frequency, -m_exponent);
    if (octave <= kKept) m_weights[static_cast<std::size_t>(m_known++)] = weight;
    return weight;
  }

 private:
  static constexpr int kKept = 16;
  double m_lacunarity, m_exponent;
  int m_known = 0;
  std::array<double, kKept> m_weights{};
};

OctaveWeights& octave_weights(double lacunarity, double exponent) {
  thread_local OctaveWeights last(lacunarity, exponent);
  if (!last.are_of(lacunarity, exponent)) last = OctaveWeights(lacunarity, exponent);
  return last;
}

// Ridged multifractal: P0 exponent, P1 lacunarity, P2 octaves, P3 offset, P4 gain, P5 generator.
double ridged_mf(const double* a) {
  const FormulaPoint q(a);
  const int generator = generator_of(q.p[5]);
  Vec3 point(q.x, q.y, q.z);
  const auto crest = [&] { return squared(q.p[3] - std::fabs(signed_noise(point, generator))); };
  double signal = crest(), sum = signal, frequency = 1.0;
  OctaveWeights& weights = octave_weights(q.p[1], q.p[0]);
  for (int i = 1; i < std::min(q.p[2], kMostOctaves); ++i) {
    point = point * q.p[1];
    frequency *= q.p[1];
    const double weight = std::clamp(signal * q.p[4], 0.0, 1.0);
    signal = crest() * weight;
    sum += signal * weights.at(i, frequency);
  }
  return sum;
}

constexpr InternalFormula kFormulas[] = {{"f_hetero_mf", hetero_mf}, {"f_noise3d", noise3d},
                                         {"f_noise_generator", noise_generator},
                                         {"f_ridge", ridge}, {"f_ridged_mf", ridged_mf}};

}  // namespace

std::span<const InternalFormula> noise_formulas() { return kFormulas; }

}  // namespace lentray::core
