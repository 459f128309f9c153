// Exponential, sine and cosine of two numbers side by side, in less time than the system's take for one.
// Off by less than one unit in the last place; the same bits on every processor. Any thread. Source:
// Taylor's series, after the argument is reduced by multiples of ln 2 or pi/2 in parts (Cody and Waite 1980).
#pragma once

#include <cmath>

#include "core/base/simd.h"

namespace lentray::core {

/// Two doubles, handled as one.
using Pair = Double2;
/// What a comparison of Pairs gives, a lane -1 or 0, and the bits of Pairs.
using PairBits = Long2;

namespace pair_math {

/// Added, leaves the nearest whole number in the last bits.
inline constexpr double kRounding = 0x1.8p52;

inline bool is_any(PairBits mask) { return (mask[0] | mask[1]) != 0; }
inline Pair size_of(Pair x) { return Pair(PairBits(x) & 0x7FFFFFFFFFFFFFFF); }
inline Pair chosen(PairBits mask, Pair yes, Pair no) {
  return Pair((PairBits(yes) & mask) | (PairBits(no) & ~mask));
}

/// `value` where |x| <= most, else what the system's function gives.
template <class System>
[[gnu::noinline, gnu::cold]] Pair mended(Pair x, double most, Pair value, System system) {
  for (int i = 0; i < 2; ++i) {
    if (!(std::fabs(x[i]) <= most)) value[i] = system(x[i]);
  }
  return value;
}

}  // namespace pair_math

inline Pair sqrt(Pair x) { return simd::sqrt(x); }

inline Pair exp(Pair x) {
  constexpr double kMost = 700.0;  // beyond, powers of two are no normal numbers
  constexpr double kLn2 = 0x1.62e42fefa38p-1, kLn2Rest = 0x1.ef35793c7673p-45;
  const Pair shifted = x * 0x1.71547652b82fep+0 + pair_math::kRounding,
             times = shifted - pair_math::kRounding;
  const Pair r = (x - times * kLn2) - times * kLn2Rest, z = r * r, z2 = z * z;
  const Pair a = (1.0 / 2 + r * (1.0 / 6)) + z * (1.0 / 24 + r * (1.0 / 120));
  const Pair b = (1.0 / 720 + r * (1.0 / 5040)) + z * (1.0 / 40320 + r * (1.0 / 362880));
  const Pair c =
      (1.0 / 3628800 + r * (1.0 / 39916800)) + z * (1.0 / 479001600 + r * (1.0 / 6227020800));
  const Pair scale = Pair((PairBits(shifted) + 1023) << 52);
  const Pair value = (1.0 + (r + z * (a + z2 * (b + z2 * c)))) * scale;
  if (!pair_math::is_any(~(pair_math::size_of(x) <= kMost))) [[likely]]
    return value;
  return pair_math::mended(x, kMost, value, [](double one) { return std::exp(one); });
}

struct CosSin {
  Pair cos, sin;
};

inline CosSin cos_sin(Pair x) {
  constexpr double kMost = 1e5;  // beyond, multiples of the parts are rounded
  constexpr double kQuarter = 0x1.921fb544p+0, kNext = 0x1.0b4611a6p-34,
                   kLast = 0x1.3198a2e037073p-69;
  const Pair shifted = x * 0x1.45f306dc9c883p-1 + pair_math::kRounding,
             times = shifted - pair_math::kRounding;
  const Pair most = x - times * kQuarter, next = times * kNext;
  const Pair r = most - next, rest = ((most - r) - next) - times * kLast;
  const Pair z = r * r, z2 = z * z, half = 0.5 * z, about = 1.0 - half;
  const Pair s = (-1.0 / 6 + z * (1.0 / 120)) + z2 * (-1.0 / 5040 + z * (1.0 / 362880));
  const Pair s_high = (-1.0 / 39916800 + z * (1.0 / 6227020800)) +
                      z2 * (-1.0 / 1307674368000 + z * (1.0 / 355687428096000));
  const Pair c = (1.0 / 24 + z * (-1.0 / 720)) + z2 * (1.0 / 40320 + z * (-1.0 / 3628800));
  const Pair c_high = (1.0 / 479001600 + z * (-1.0 / 87178291200)) + z2 * (1.0 / 20922789888000);
  const Pair sine = r + (r * (z * (s + (z2 * z2) * s_high)) + rest * about);
  const Pair cosine = about + (((1.0 - about) - half) + (z2 * (c + (z2 * z2) * c_high) - r * rest));
  // Each quarter turn changes the two about, and a sign.
  const PairBits quarters = PairBits(shifted), are_changed = -(quarters & 1);
  const PairBits sin_sign = quarters << 62, cos_sign = (quarters + 1) << 62;
  constexpr long long kSign = static_cast<long long>(1ULL << 63);
  CosSin result{Pair(PairBits(pair_math::chosen(are_changed, sine, cosine)) ^ (cos_sign & kSign)),
                Pair(PairBits(pair_math::chosen(are_changed, cosine, sine)) ^ (sin_sign & kSign))};
  if (!pair_math::is_any(~(pair_math::size_of(x) <= kMost))) [[likely]]
    return result;
  result.cos = pair_math::mended(x, kMost, result.cos, [](double one) { return std::cos(one); });
  result.sin = pair_math::mended(x, kMost, result.sin, [](double one) { return std::sin(one); });
  return result;
}

}  // namespace lentray::core
