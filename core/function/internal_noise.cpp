#include <array>

#include "core/function/internal_formulas.h"
#include "core/noise/noise.h"

namespace lentray::core {
namespace {

/// Of an absurd number of octaves the first do: the others cannot be distinguished.
constexpr double kMostOctaves = 1000.0;

/// A whole number within +-1000.
int whole(double parameter) {
  return static_cast<int>(
      std::isnan(parameter) ? 0.0 : std::clamp(parameter, -kMostOctaves, kMostOctaves));
}

/// Parameters choose a noise generator by their last two bits.
int generator_of(double parameter) { return whole(parameter) & 3; }

// Formulas are of one point (double) or of two (Pair), whose parameters are the same then.
double first(double a) { return a; }
double first(Pair a) { return a[0]; }
double size_of(double a) { return std::fabs(a); }
Pair size_of(Pair a) { return pair_math::size_of(a); }
double within_unit(double a) { return std::clamp(a, 0.0, 1.0); }
Pair within_unit(Pair a) {
  const Pair above = pair_math::chosen(a < 0.0, Pair{}, a);
  return pair_math::chosen(1.0 < above, Pair{1.0, 1.0}, above);
}

template <class Number>
struct NoisePoint {
  Number x, y, z;
  explicit NoisePoint(const Number* a) : x(a[0]), y(a[1]), z(a[2]) {}
  NoisePoint(Number px, Number py, Number pz) : x(px), y(py), z(pz) {}
  NoisePoint operator*(double s) const { return {x * s, y * s, z * s}; }
};

/// Noise between -1 and 1.
template <class Number>
Number signed_noise(const NoisePoint<Number>& p, int generator) {
  return noise(p.x, p.y, p.z, generator) * 2.0 - 1.0;
}

template <class Number>
Number noise3d(const Number* a) {
  return noise(a[0], a[1], a[2], 2);
}

template <class Number>
Number noise_generator(const Number* a) {
  return noise(a[0], a[1], a[2], generator_of(first(a[3])));
}

// Heterogeneous multifractal: P0 exponent, P1 lacunarity, P2 octaves, P3 offset, P4 how often the
// sum so far weighs an octave, P5 generator.
template <class Number>
Number hetero_mf(const Number* a) {
  const double lacunarity = first(a[4]), offset = first(a[6]);
  const int generator = generator_of(first(a[8])), weighings = whole(first(a[7]));
  const double octaves = std::min(first(a[5]), kMostOctaves);
  NoisePoint<Number> point(a);
  Number sum = signed_noise(point, generator) + offset;
  const double damping = std::pow(lacunarity, -first(a[3]));
  double strength = damping;
  const auto octave = [&] { return (signed_noise(point, generator) + offset) * strength; };
  point = point * lacunarity;
  for (int i = 1; i < octaves; ++i) {
    Number more = octave();
    for (int n = 0; n < weighings; ++n) more *= sum;
    sum += more;
    point = point * lacunarity;
    strength *= damping;
  }
  const double rest = octaves - whole(octaves);
  if (rest != 0.0) sum += rest * octave() * sum;
  return sum;
}

// Folded noise: P0 lacunarity, P1 octaves, P2 gain, P3 offset, P4 where the fold is, P5 generator.
template <class Number>
Number ridge(const Number* a) {
  const double lacunarity = first(a[3]), gain = first(a[5]), offset = first(a[6]),
               fold = first(a[7]);
  const int generator = generator_of(first(a[8])), octaves = whole(first(a[4]));
  const double fold_scale = 1.0 / std::max(fold, 1.0 - fold);
  const double rest = std::min(first(a[4]), kMostOctaves) - octaves;
  const NoisePoint<Number> point(a);
  const auto folded = [&](double frequency) {
    const NoisePoint<Number> at = point * frequency;
    return size_of(noise(at.x, at.y, at.z, generator) - fold) * fold_scale - offset;
  };
  Number sum = folded(1.0);
  double weights = 1.0, frequency = lacunarity, weight = gain;
  for (int i = 2; i <= octaves; ++i) {
    sum += weight * folded(frequency);
    weights += weight;
    frequency *= lacunarity;
    weight *= gain;
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
  OctaveWeights(double lacunarity, double exponent)
      : m_lacunarity(lacunarity), m_exponent(exponent) {}
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
template <class Number>
Number ridged_mf(const Number* a) {
  const double lacunarity = first(a[4]), octaves = std::min(first(a[5]), kMostOctaves),
               offset = first(a[6]);
  const double gain = first(a[7]);
  const int generator = generator_of(first(a[8]));
  NoisePoint<Number> point(a);
  const auto crest = [&] { return squared(offset - size_of(signed_noise(point, generator))); };
  Number signal = crest(), sum = signal;
  double frequency = 1.0;
  OctaveWeights& weights = octave_weights(lacunarity, first(a[3]));
  for (int i = 1; i < octaves; ++i) {
    point = point * lacunarity;
    frequency *= lacunarity;
    const Number weight = within_unit(signal * gain);
    signal = crest() * weight;
    sum += signal * weights.at(i, frequency);
  }
  return sum;
}

/// Both points at once, where their parameters are the same.
template <Pair (*kFormula)(const Pair*), double (*kOfOne)(const double*), int kParameters>
Pair of_both(const Pair* a) {
  bool are_same = true;
  for (int i = 3; i < 3 + kParameters; ++i) are_same = are_same && a[i][0] == a[i][1];
  if (are_same) return kFormula(a);
  double one[3 + kParameters], other[3 + kParameters];
  for (int i = 0; i < 3 + kParameters; ++i) {
    one[i] = a[i][0];
    other[i] = a[i][1];
  }
  const double value = kOfOne(one);
  return Pair{value, kOfOne(other)};
}

constexpr InternalFormula kFormulas[] = {
    {"f_hetero_mf", 29, 6, hetero_mf, of_both<hetero_mf, hetero_mf, 6>},
    {"f_noise3d", 76, 0, noise3d, of_both<noise3d, noise3d, 0>},
    {"f_noise_generator", 78, 1, noise_generator, of_both<noise_generator, noise_generator, 1>},
    // Called by itself it has no pattern.
    {"f_pattern", 77, 0, [](const double*) { return 0.0; }},
    {"f_ridge", 58, 6, ridge, of_both<ridge, ridge, 6>},
    {"f_ridged_mf", 59, 6, ridged_mf, of_both<ridged_mf, ridged_mf, 6>}};

}  // namespace

std::span<const InternalFormula> noise_formulas() { return kFormulas; }

}  // namespace lentray::core
