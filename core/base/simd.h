// A few numbers handled as one: the only text that knows the processor's instructions for that. The types
// are the compiler's own: arithmetic, comparisons and bits are the language's operators, a lane at a time,
// never fused. Operations without an operator stand here twice, by instructions of x86 and plainly, for all
// other processors, with the same bits (tests/unit/base/base_simd_test.cpp).
// Types of 32 bytes, Double4, Long4, Float8 and Int8, are for functions marked LENTRAY_AVX2. What a
// comparison gives has all bits of a lane set, or none. Any thread.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "core/base/processor.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace lentray::core {

using Double2 [[gnu::vector_size(16)]] = double;
using Double4 [[gnu::vector_size(32)]] = double;
using Long2 [[gnu::vector_size(16)]] = long long;
using Long4 [[gnu::vector_size(32)]] = long long;
using Float4 [[gnu::vector_size(16)]] = float;
using Float8 [[gnu::vector_size(32)]] = float;
using Int4 [[gnu::vector_size(16)]] = int;
using Int8 [[gnu::vector_size(32)]] = int;

#define LENTRAY_SIMD [[gnu::always_inline]] inline
#define LENTRAY_SIMD32 [[gnu::always_inline]] LENTRAY_AVX2 inline

namespace simd {

template <class V>
concept Half = sizeof(V) <= 16;
template <class V>
concept Whole = sizeof(V) == 32;
template <class V>
inline constexpr int kLanes = static_cast<int>(sizeof(V) / sizeof(V{}[0]));

/// As they lie in memory.
namespace raw {
using Double2 [[gnu::vector_size(16), gnu::may_alias, gnu::aligned(8)]] = double;
using Double4 [[gnu::vector_size(32), gnu::may_alias, gnu::aligned(8)]] = double;
using Float4 [[gnu::vector_size(16), gnu::may_alias]] = float;
using Float8 [[gnu::vector_size(32), gnu::may_alias]] = float;
using Int4 [[gnu::vector_size(16), gnu::may_alias]] = int;
using Int8 [[gnu::vector_size(32), gnu::may_alias]] = int;
}  // namespace raw

/// The numbers in memory from `from` on. Floats and ints must lie at multiples of the vector's size.
LENTRAY_SIMD Double2 double2_at(const double* from) {
  return *reinterpret_cast<const raw::Double2*>(from);
}
LENTRAY_SIMD Float4 float4_at(const float* from) {
  return *reinterpret_cast<const raw::Float4*>(from);
}
LENTRAY_SIMD Int4 int4_at(const int* from) { return *reinterpret_cast<const raw::Int4*>(from); }
LENTRAY_SIMD32 Double4 double4_at(const double* from) {
  return *reinterpret_cast<const raw::Double4*>(from);
}
LENTRAY_SIMD32 Float8 float8_at(const float* from) {
  return *reinterpret_cast<const raw::Float8*>(from);
}
LENTRAY_SIMD32 Int8 int8_at(const int* from) { return *reinterpret_cast<const raw::Int8*>(from); }

LENTRAY_SIMD void store(float* to, Float4 v) { *reinterpret_cast<raw::Float4*>(to) = v; }
LENTRAY_SIMD void store(int* to, Int4 v) { *reinterpret_cast<raw::Int4*>(to) = v; }
LENTRAY_SIMD32 void store(double* to, Double4 v) { *reinterpret_cast<raw::Double4*>(to) = v; }
LENTRAY_SIMD32 void store(float* to, Float8 v) { *reinterpret_cast<raw::Float8*>(to) = v; }

/// The lanes of a and then b that are named, counted from 0.
template <int... kNamed, Half V>
LENTRAY_SIMD auto shuffled(V a, V b) {
  return __builtin_shufflevector(a, b, kNamed...);
}
template <int... kNamed, Whole V>
LENTRAY_SIMD32 auto shuffled(V a, V b) {
  return __builtin_shufflevector(a, b, kNamed...);
}
template <int... kNamed, Half V>
LENTRAY_SIMD auto shuffled(V a) {
  return __builtin_shufflevector(a, a, kNamed...);
}
template <int... kNamed, Whole V>
LENTRAY_SIMD32 auto shuffled(V a) {
  return __builtin_shufflevector(a, a, kNamed...);
}

/// The same number in all lanes.
LENTRAY_SIMD Double2 double2(double x) { return Double2{x, x}; }
LENTRAY_SIMD Float4 float4(float x) { return Float4{x, x, x, x}; }
LENTRAY_SIMD Int4 int4(int x) { return Int4{x, x, x, x}; }
LENTRAY_SIMD32 Double4 double4(double x) { return Double4{x, x, x, x}; }
LENTRAY_SIMD32 Float8 float8(float x) { return Float8{x, x, x, x, x, x, x, x}; }

/// To the nearest floats.
LENTRAY_SIMD32 Float4 narrowed(Double4 v) { return __builtin_convertvector(v, Float4); }

/// By the language alone.
namespace plain {

/// The sign bits of the lanes, the first lowest.
template <Half V>
LENTRAY_SIMD unsigned signs(V v) {
  using Bits = std::conditional_t<sizeof(V{}[0]) == 8, Long2, Int4>;
  const auto bits = Bits(v);
  unsigned result = 0;
  for (int i = 0; i < kLanes<V>; ++i) result += bits[i] < 0 ? 1u << i : 0u;
  return result;
}
template <Whole V>
LENTRAY_SIMD32 unsigned signs(V v) {
  using Bits = std::conditional_t<sizeof(V{}[0]) == 8, Long4, Int8>;
  const auto bits = Bits(v);
  unsigned result = 0;
  for (int i = 0; i < kLanes<V>; ++i) result += bits[i] < 0 ? 1u << i : 0u;
  return result;
}
/// Without their signs.
LENTRAY_SIMD Double2 abs(Double2 v) { return Double2(Long2(v) & 0x7FFFFFFFFFFFFFFF); }
LENTRAY_SIMD Float4 abs(Float4 v) { return Float4(Int4(v) & 0x7FFFFFFF); }
LENTRAY_SIMD32 Double4 abs(Double4 v) { return Double4(Long4(v) & 0x7FFFFFFFFFFFFFFF); }
LENTRAY_SIMD32 Float8 abs(Float8 v) { return Float8(Int8(v) & 0x7FFFFFFF); }
/// Numbers of no sign, with the signs of others.
LENTRAY_SIMD32 Double4 with_signs(Double4 v, Double4 of) {
  return Double4(Long4(v) | (Long4(of) & Long4(double4(-0.0))));
}
/// `yes` in the lanes where `sign` has its sign bit set, as comparisons that hold have, else `no`.
template <Whole V>
LENTRAY_SIMD32 Double4 chosen(V sign, Double4 yes, Double4 no) {
  const auto bits = Long4(sign);
  Double4 result = no;
  for (int i = 0; i < 4; ++i) result[i] = bits[i] < 0 ? yes[i] : no[i];
  return result;
}

LENTRAY_SIMD bool are_same(Int4 a, Int4 b) {
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2] && a[3] == b[3];
}

/// The smaller and the larger; b where they are equal or one is no number.
template <Half V>
LENTRAY_SIMD V min(V a, V b) {
  for (int i = 0; i < kLanes<V>; ++i) a[i] = a[i] < b[i] ? a[i] : b[i];
  return a;
}
template <Whole V>
LENTRAY_SIMD32 V min(V a, V b) {
  for (int i = 0; i < kLanes<V>; ++i) a[i] = a[i] < b[i] ? a[i] : b[i];
  return a;
}
template <Half V>
LENTRAY_SIMD V max(V a, V b) {
  for (int i = 0; i < kLanes<V>; ++i) a[i] = a[i] > b[i] ? a[i] : b[i];
  return a;
}
template <Whole V>
LENTRAY_SIMD32 V max(V a, V b) {
  for (int i = 0; i < kLanes<V>; ++i) a[i] = a[i] > b[i] ? a[i] : b[i];
  return a;
}

LENTRAY_SIMD Double2 sqrt(Double2 v) { return Double2{std::sqrt(v[0]), std::sqrt(v[1])}; }
LENTRAY_SIMD32 Double4 sqrt(Double4 v) {
  return Double4{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
}
LENTRAY_SIMD32 Double4 floor(Double4 v) {
  return Double4{std::floor(v[0]), std::floor(v[1]), std::floor(v[2]), std::floor(v[3])};
}

/// Fused, that is rounded once: a b + c, a b - c, c - a b.
template <class V>
LENTRAY_SIMD32 V fma(V a, V b, V c) {
  for (int i = 0; i < kLanes<V>; ++i) a[i] = std::fma(a[i], b[i], c[i]);
  return a;
}
template <class V>
LENTRAY_SIMD32 V fms(V a, V b, V c) {
  return fma(a, b, -c);
}
template <class V>
LENTRAY_SIMD32 V fnma(V a, V b, V c) {
  return fma(-a, b, c);
}

/// Without their fractions; the least whole number of the type where that is none of it.
LENTRAY_SIMD std::int64_t truncated(double v) {
  return std::fabs(v) < 0x1p63 ? static_cast<std::int64_t>(v)
                               : std::numeric_limits<std::int64_t>::min();
}
LENTRAY_SIMD int truncated_int(double v) {
  return v > -0x1p31 - 1.0 && v < 0x1p31 ? static_cast<int>(v) : std::numeric_limits<int>::min();
}
LENTRAY_SIMD Int4 truncated(Float4 v) {
  return Int4{truncated_int(v[0]), truncated_int(v[1]), truncated_int(v[2]), truncated_int(v[3])};
}
LENTRAY_SIMD32 Int4 truncated(Double4 v) {
  return Int4{truncated_int(v[0]), truncated_int(v[1]), truncated_int(v[2]), truncated_int(v[3])};
}
/// To memory, as the nearest floats.
LENTRAY_SIMD void store_narrowed(float* to, Double2 v) {
  to[0] = static_cast<float>(v[0]);
  to[1] = static_cast<float>(v[1]);
}
/// As doubles.
LENTRAY_SIMD32 Double4 widened(Int4 v) { return __builtin_convertvector(v, Double4); }
LENTRAY_SIMD32 Double4 widened(Float4 v) { return __builtin_convertvector(v, Double4); }

/// The first and the last two lanes, and four of those.
LENTRAY_SIMD32 Double2 first_half(Double4 v) { return Double2{v[0], v[1]}; }
LENTRAY_SIMD32 Double2 last_half(Double4 v) { return Double2{v[2], v[3]}; }
LENTRAY_SIMD32 Double4 joined(Double2 first, Double2 last) {
  return Double4{first[0], first[1], last[0], last[1]};
}

/// A number of memory in all lanes: read as often as it is written, not shuffled from a vector just stored.
LENTRAY_SIMD32 Double4 spread(const double* from) { return double4(*from); }

/// The lanes of `v` that `places` name; of these the last three bits count.
LENTRAY_SIMD32 Int8 picked(Int8 v, Int8 places) {
  Int8 result = v;
  for (int i = 0; i < 8; ++i) result[i] = v[places[i] & 7];
  return result;
}

/// The last 16 bits of the first three lanes, with a sign: x + 8 y, and 64 z in the upper half of the result.
LENTRAY_SIMD32 std::uint64_t packed_sums(Int4 v) {
  const auto low = [&](int i) { return static_cast<int>(static_cast<std::int16_t>(v[i])); };
  const auto sum = static_cast<std::uint32_t>(low(0) + 8 * low(1)),
             last = static_cast<std::uint32_t>(64 * low(2));
  return sum | static_cast<std::uint64_t>(last) << 32;
}

}  // namespace plain

#if defined(__x86_64__)
/// By an instruction each.
namespace x86 {

template <Half V>
LENTRAY_SIMD unsigned signs(V v) {
  if constexpr (sizeof(V{}[0]) == 8)
    return static_cast<unsigned>(_mm_movemask_pd(__m128d(v)));
  else
    return static_cast<unsigned>(_mm_movemask_ps(__m128(v)));
}
template <Whole V>
LENTRAY_SIMD32 unsigned signs(V v) {
  if constexpr (sizeof(V{}[0]) == 8)
    return static_cast<unsigned>(_mm256_movemask_pd(__m256d(v)));
  else
    return static_cast<unsigned>(_mm256_movemask_ps(__m256(v)));
}
LENTRAY_SIMD Double2 abs(Double2 v) { return _mm_andnot_pd(_mm_set1_pd(-0.0), v); }
LENTRAY_SIMD Float4 abs(Float4 v) { return _mm_andnot_ps(_mm_set1_ps(-0.0f), v); }
LENTRAY_SIMD32 Double4 abs(Double4 v) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), v); }
LENTRAY_SIMD32 Float8 abs(Float8 v) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), v); }
LENTRAY_SIMD32 Double4 with_signs(Double4 v, Double4 of) {
  return _mm256_or_pd(v, _mm256_and_pd(_mm256_set1_pd(-0.0), of));
}
template <Whole V>
LENTRAY_SIMD32 Double4 chosen(V sign, Double4 yes, Double4 no) {
  return _mm256_blendv_pd(no, yes, __m256d(sign));
}

LENTRAY_SIMD bool are_same(Int4 a, Int4 b) {
  return _mm_movemask_epi8(_mm_cmpeq_epi32(__m128i(a), __m128i(b))) == 0xFFFF;
}

LENTRAY_SIMD Float4 min(Float4 a, Float4 b) { return _mm_min_ps(a, b); }
LENTRAY_SIMD Float4 max(Float4 a, Float4 b) { return _mm_max_ps(a, b); }
LENTRAY_SIMD Double2 min(Double2 a, Double2 b) { return _mm_min_pd(a, b); }
LENTRAY_SIMD Double2 max(Double2 a, Double2 b) { return _mm_max_pd(a, b); }
LENTRAY_SIMD32 Float8 min(Float8 a, Float8 b) { return _mm256_min_ps(a, b); }
LENTRAY_SIMD32 Float8 max(Float8 a, Float8 b) { return _mm256_max_ps(a, b); }
LENTRAY_SIMD32 Double4 min(Double4 a, Double4 b) { return _mm256_min_pd(a, b); }
LENTRAY_SIMD32 Double4 max(Double4 a, Double4 b) { return _mm256_max_pd(a, b); }

LENTRAY_SIMD Double2 sqrt(Double2 v) { return _mm_sqrt_pd(v); }
LENTRAY_SIMD32 Double4 sqrt(Double4 v) { return _mm256_sqrt_pd(v); }
LENTRAY_SIMD32 Double4 floor(Double4 v) { return _mm256_floor_pd(v); }

LENTRAY_SIMD32 Float4 fma(Float4 a, Float4 b, Float4 c) { return _mm_fmadd_ps(a, b, c); }
LENTRAY_SIMD32 Float4 fnma(Float4 a, Float4 b, Float4 c) { return _mm_fnmadd_ps(a, b, c); }
LENTRAY_SIMD32 Float8 fma(Float8 a, Float8 b, Float8 c) { return _mm256_fmadd_ps(a, b, c); }
LENTRAY_SIMD32 Float8 fms(Float8 a, Float8 b, Float8 c) { return _mm256_fmsub_ps(a, b, c); }

LENTRAY_SIMD std::int64_t truncated(double v) { return _mm_cvttsd_si64(_mm_set_sd(v)); }
LENTRAY_SIMD Int4 truncated(Float4 v) { return Int4(_mm_cvttps_epi32(v)); }
LENTRAY_SIMD32 Int4 truncated(Double4 v) { return Int4(_mm256_cvttpd_epi32(v)); }
LENTRAY_SIMD void store_narrowed(float* to, Double2 v) {
  _mm_storel_pi(reinterpret_cast<__m64*>(to), _mm_cvtpd_ps(v));
}
LENTRAY_SIMD32 Double4 widened(Int4 v) { return _mm256_cvtepi32_pd(__m128i(v)); }
LENTRAY_SIMD32 Double4 widened(Float4 v) { return _mm256_cvtps_pd(v); }

LENTRAY_SIMD32 Double2 first_half(Double4 v) { return _mm256_castpd256_pd128(v); }
LENTRAY_SIMD32 Double2 last_half(Double4 v) { return _mm256_extractf128_pd(v, 1); }
LENTRAY_SIMD32 Double4 joined(Double2 first, Double2 last) { return _mm256_set_m128d(last, first); }
LENTRAY_SIMD32 Double4 spread(const double* from) { return _mm256_broadcast_sd(from); }
LENTRAY_SIMD32 Int8 picked(Int8 v, Int8 places) {
  return Int8(_mm256_permutevar8x32_epi32(__m256i(v), __m256i(places)));
}
LENTRAY_SIMD32 std::uint64_t packed_sums(Int4 v) {
  const __m128i low_halves = _mm_set_epi8(-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 9, 8, 5, 4, 1, 0);
  const __m128i halves = _mm_shuffle_epi8(__m128i(v), low_halves);
  return static_cast<std::uint64_t>(
      _mm_cvtsi128_si64(_mm_madd_epi16(halves, _mm_set_epi16(0, 0, 0, 0, 0, 64, 8, 1))));
}

}  // namespace x86
using namespace x86;
#else
using namespace plain;
#endif

}  // namespace simd
}  // namespace lentray::core
