// core/base/simd.h: its plain half and its instructions give the same bits, and both what is promised.
#include "core/base/simd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <random>
#include <span>
#include <vector>

namespace lentray::core {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity(),
                 kNan = std::numeric_limits<double>::quiet_NaN();

/// Numbers of every size, and those that are special to an operation.
struct Inputs {
  alignas(32) double doubles[3][4];
  alignas(32) float floats[3][8];
  alignas(32) int ints[2][8];

  explicit Inputs(std::mt19937& random) {
    constexpr double kSpecial[] = {
        0.0,           -0.0,           1.0,    -1.0,    0.5,          -0.5,    kInf,
        -kInf,         kNan,           1e300,  -1e300,  0x1p31,       -0x1p31, 0x1p31 - 0.5,
        -0x1p31 - 0.5, -0x1p31 - 1.0,  0x1p63, -0x1p63, 0x1p52 + 1.0, 1e-310,  5e-324,
        1e-40,         0x1.fffffep127, 4095.0, -4096.0};
    std::uniform_int_distribution<std::size_t> special(0, std::size(kSpecial) - 1);
    std::uniform_int_distribution<int> bits(std::numeric_limits<int>::min(),
                                            std::numeric_limits<int>::max());
    std::uniform_real_distribution<double> near(-10.0, 10.0), exponent(-40.0, 40.0);
    const auto number = [&] {
      switch (random() % 4) {
        case 0: return kSpecial[special(random)];
        case 1: return near(random) * std::exp2(exponent(random));
        default: return near(random);
      }
    };
    for (auto& row : doubles)
      for (double& one : row) one = number();
    for (auto& row : floats)
      for (float& one : row) one = static_cast<float>(number());
    for (auto& row : ints)
      for (int& one : row)
        one = random() % 3 == 0 ? static_cast<int>(random() % 3) - 1 : bits(random);
    if (random() % 2 == 0) std::copy_n(ints[0], 4, ints[1]);
  }
};

#if defined(__x86_64__)

template <class Number>
bool same(Number a, Number b) {
  return a == b;
}
bool same(double a, double b) {
  return std::bit_cast<std::int64_t>(a) == std::bit_cast<std::int64_t>(b) || (a != a && b != b);
}
bool same(float a, float b) {
  return std::bit_cast<std::int32_t>(a) == std::bit_cast<std::int32_t>(b) || (a != a && b != b);
}

/// Asks both for the same.
class Both {
 public:
  explicit Both(const Inputs& inputs) : m_inputs(inputs) {}
  LENTRAY_AVX2 void ask_halves() const;
  LENTRAY_AVX2 void ask_wholes() const;

 private:
  template <class Number>
  static void expect(const char* what, std::span<const Number> a, std::span<const Number> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_TRUE(same(a[i], b[i]))
          << what << ", lane " << i << ": plain " << a[i] << ", x86 " << b[i];
    }
  }
  const Inputs& m_inputs;
};

#define LENTRAY_EXPECT_BOTH(Number, call)                                                    \
  {                                                                                          \
    const auto plain_result = simd::plain::call;                                             \
    const auto x86_result = simd::x86::call;                                                 \
    constexpr std::size_t kCount = sizeof plain_result / sizeof(Number);                     \
    expect<Number>(#call, std::span(reinterpret_cast<const Number*>(&plain_result), kCount), \
                   std::span(reinterpret_cast<const Number*>(&x86_result), kCount));         \
  }

LENTRAY_AVX2 void Both::ask_halves() const {
  const Inputs& in = m_inputs;
  const Double2 a = simd::double2_at(in.doubles[0]), b = simd::double2_at(in.doubles[1]);
  const Float4 x = simd::float4_at(in.floats[0]), y = simd::float4_at(in.floats[1]),
               z = simd::float4_at(in.floats[2]);
  const Int4 i = simd::int4_at(in.ints[0]), j = simd::int4_at(in.ints[1]);
  LENTRAY_EXPECT_BOTH(unsigned, signs(a));
  LENTRAY_EXPECT_BOTH(unsigned, signs(x));
  LENTRAY_EXPECT_BOTH(unsigned, signs(a < b));
  LENTRAY_EXPECT_BOTH(unsigned, signs(x <= y));
  LENTRAY_EXPECT_BOTH(bool, are_same(i, j));
  LENTRAY_EXPECT_BOTH(double, abs(a));
  LENTRAY_EXPECT_BOTH(float, abs(x));
  LENTRAY_EXPECT_BOTH(double, min(a, b));
  LENTRAY_EXPECT_BOTH(double, max(a, b));
  LENTRAY_EXPECT_BOTH(float, min(x, y));
  LENTRAY_EXPECT_BOTH(float, max(x, y));
  LENTRAY_EXPECT_BOTH(double, sqrt(a));
  LENTRAY_EXPECT_BOTH(float, fma(x, y, z));
  LENTRAY_EXPECT_BOTH(float, fnma(x, y, z));
  LENTRAY_EXPECT_BOTH(std::int64_t, truncated(in.doubles[0][0]));
  LENTRAY_EXPECT_BOTH(int, truncated(x));
  LENTRAY_EXPECT_BOTH(double, widened(x));
  LENTRAY_EXPECT_BOTH(double, widened(i));
  LENTRAY_EXPECT_BOTH(double, joined(a, b));
  LENTRAY_EXPECT_BOTH(std::uint64_t, packed_sums(i));
  std::array<float, 2> plain, x86;
  simd::plain::store_narrowed(plain.data(), a);
  simd::x86::store_narrowed(x86.data(), a);
  expect<float>("store_narrowed(a)", plain, x86);
}

LENTRAY_AVX2 void Both::ask_wholes() const {
  const Inputs& in = m_inputs;
  const Double4 a = simd::double4_at(in.doubles[0]), b = simd::double4_at(in.doubles[1]),
                c = simd::double4_at(in.doubles[2]);
  const Float8 x = simd::float8_at(in.floats[0]), y = simd::float8_at(in.floats[1]),
               z = simd::float8_at(in.floats[2]);
  const Int8 i = simd::int8_at(in.ints[0]), j = simd::int8_at(in.ints[1]);
  LENTRAY_EXPECT_BOTH(unsigned, signs(a));
  LENTRAY_EXPECT_BOTH(unsigned, signs(x));
  LENTRAY_EXPECT_BOTH(unsigned, signs(a >= b));
  LENTRAY_EXPECT_BOTH(unsigned, signs(x != y));
  LENTRAY_EXPECT_BOTH(double, abs(a));
  LENTRAY_EXPECT_BOTH(float, abs(x));
  LENTRAY_EXPECT_BOTH(double, with_signs(simd::plain::abs(a), b));
  LENTRAY_EXPECT_BOTH(double, chosen(a, b, c));
  LENTRAY_EXPECT_BOTH(double, chosen(a > b, b, c));
  LENTRAY_EXPECT_BOTH(double, min(a, b));
  LENTRAY_EXPECT_BOTH(double, max(a, b));
  LENTRAY_EXPECT_BOTH(float, min(x, y));
  LENTRAY_EXPECT_BOTH(float, max(x, y));
  LENTRAY_EXPECT_BOTH(double, sqrt(a));
  LENTRAY_EXPECT_BOTH(double, floor(a));
  LENTRAY_EXPECT_BOTH(float, fma(x, y, z));
  LENTRAY_EXPECT_BOTH(float, fms(x, y, z));
  LENTRAY_EXPECT_BOTH(int, truncated(a));
  LENTRAY_EXPECT_BOTH(double, first_half(a));
  LENTRAY_EXPECT_BOTH(double, last_half(a));
  LENTRAY_EXPECT_BOTH(double, spread(in.doubles[0]));
  LENTRAY_EXPECT_BOTH(int, picked(i, j));
}

TEST(BaseSimd, PlainAndInstructionsGiveTheSameBits) {
  if (!has_avx2()) GTEST_SKIP() << "needs AVX2";
  std::mt19937 random(41);
  for (int i = 0; i < 20000 && !::testing::Test::HasFailure(); ++i) {
    const Inputs inputs(random);
    const Both both(inputs);
    both.ask_halves();
    both.ask_wholes();
  }
}

#endif

struct Results {
  alignas(32) double halves[4], chosen[4], shuffled[4], joined[4], signed_[4];
  alignas(16) float narrowed[4];
  alignas(16) int whole[4];
  float fused[8];
  unsigned signs, comparison;
};

/// Numbers that the compiler does not know: what it computes itself is not what instructions do beyond
/// the range of an int.
[[gnu::noipa]] const double* unknown(const double* numbers) { return numbers; }

LENTRAY_AVX2 Results results() {
  Results r;
  const double numbers[4] = {-1.5, kNan, 1e10, -0.0};
  const Double4 a = simd::double4_at(unknown(numbers)), b{10.0, 20.0, 30.0, 40.0};
  simd::store(r.halves, simd::joined(simd::last_half(b), simd::first_half(b)));
  simd::store(r.chosen, simd::chosen(a, b, b * 2.0));
  simd::store(r.shuffled, simd::shuffled<3, 0, 5, 5>(b, b + 1.0));
  simd::store(r.signed_, simd::with_signs(simd::abs(b), a));
  simd::store(r.joined, simd::max(a, b));
  simd::store(r.narrowed, simd::narrowed(b * 0x1.0000008p0));
  simd::store(r.whole, simd::truncated(a));
  // The product's last bits are lost where it is rounded on its own.
  alignas(32) float fused[8];
  const float one = 0x1.000002p0f;
  simd::store(fused, simd::fms(simd::float8(one), simd::float8(one), simd::float8(one * one)));
  std::copy_n(fused, 8, r.fused);
  r.signs = simd::signs(a);
  r.comparison = simd::signs(a < b);
  return r;
}

TEST(BaseSimd, OperationsGiveWhatTheyPromise) {
  if (!can_run_avx2()) GTEST_SKIP() << "needs AVX2";
  const Results r = results();
  const auto list = [](const auto& of) { return std::vector(std::begin(of), std::end(of)); };
  EXPECT_EQ(list(r.halves), (std::vector{30.0, 40.0, 10.0, 20.0}));
  EXPECT_EQ(r.chosen[0], 10.0);
  EXPECT_EQ(r.chosen[2], 60.0);
  EXPECT_EQ(r.chosen[3], 40.0) << "minus zero has a sign";
  EXPECT_EQ(list(r.shuffled), (std::vector{40.0, 10.0, 21.0, 21.0}));
  EXPECT_EQ(r.signed_[0], -10.0);
  EXPECT_EQ(r.signed_[2], 30.0);
  EXPECT_EQ(r.signed_[3], -40.0);
  EXPECT_EQ(list(r.joined), (std::vector{10.0, 20.0, 1e10, 40.0}))
      << "no number yields to the second";
  EXPECT_EQ(list(r.narrowed), (std::vector{10.0f, 20.0f, 30.0f, 40.0f}));
  constexpr int kLeast = std::numeric_limits<int>::min();
  EXPECT_EQ(list(r.whole), (std::vector{-1, kLeast, kLeast, 0}));
  for (const float rest : r.fused) EXPECT_EQ(rest, 0x1p-46f);
  EXPECT_EQ(r.signs & 0b1101u, 0b1001u);
  EXPECT_EQ(r.comparison, 0b1001u);
}

}  // namespace
}  // namespace lentray::core
