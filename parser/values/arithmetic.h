// What the operators and pure functions of SDL do to numbers, apart from how their text is read.
// Source: reference manual 3.7, "Float Expressions", "Vector Expressions"; precision, promotion and
// error cases as measured on stock.
#pragma once

#include <cmath>
#include <limits>

#include "parser/tokens/token.h"
#include "parser/values/value.h"

namespace lentray::parser {

/// Stock's idea of zero when it compares (=, <=, !=, conditions).
inline constexpr double kCompareEpsilon = 1e-10;
inline bool is_true(double x) { return std::fabs(x) > kCompareEpsilon; }

/// To a whole number as stock has them, 32 bits, towards zero; what does not fit, infinities and
/// nan become the smallest.
inline int to_int(double x) {
  constexpr int kSmallest = std::numeric_limits<int>::min();
  return x > kSmallest - 1.0 && x < 2147483648.0 ? static_cast<int>(x) : kSmallest;
}

/// The subscript of an array that x stands for: stock adds this before it cuts off the fraction.
/// Negative if it is none.
inline int subscript_of(double x) { return x > -1e-10 ? to_int(x + 1e-10) : -1; }

/// Grows n to `size` components: a float repeats, a vector gets zeros.
inline void promote(Number& n, int size) {
  if (n.size >= size) return;
  const double fill = n.size == 1 ? n.v[0] : 0.0;
  for (int i = n.size; i < size; ++i) n.v[static_cast<std::size_t>(i)] = fill;
  n.size = size;
}
/// The component i of it (`V.x`) where a float is meant.
inline void take_component(Number& n, int i) {
  n.v[0] = n.v[static_cast<std::size_t>(i)];
  n.size = 1;
  n.is_colour = false;
  n.keeps_rest = true;
}
/// Where a vector is wanted: `V.x` is <V.x, V.y, V.z> there, as stock has it (measured: not in
/// parentheses, nor as a right operand, and arithmetic with floats changes the first alone).
inline core::Vec3 to_vector(Number n) {
  if (!n.keeps_rest) promote(n, 3);
  return {n.v[0], n.v[1], n.v[2]};
}
/// As stock keeps colours (five components): in single precision.
inline Number stored(Number n) {
  n.keeps_rest = false;
  if (n.size != 5) return n;
  n.is_colour = true;
  for (double& x : n.v) x = static_cast<double>(static_cast<float>(x));
  return n;
}

// ---- operators: left = left op right ----------------------------------------------------------

template <typename Op>
void each(Number& left, const Number& right, Op op) {
  if (left.size == 1 && right.size == 1) {
    left.v[0] = op(left.v[0], right.v[0]);
    return;
  }
  const auto components = [&](const Number& by) {
    left.keeps_rest = false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(left.size); ++i) {
      left.v[i] = op(left.v[i], by.v[i]);
    }
  };
  promote(left, right.size);
  if (left.size == right.size) return components(right);
  Number promoted = right;
  promote(promoted, left.size);
  components(promoted);
}

inline void add(Number& left, const Number& right, bool plus) {
  if (plus) each(left, right, [](double a, double b) { return a + b; });
  else each(left, right, [](double a, double b) { return a - b; });
  left.is_colour = false;
}
inline void multiply(Number& left, const Number& right) {
  each(left, right, [](double a, double b) { return a * b; });
  left.is_colour = false;
}
/// By zero it is infinity, whatever the sign, as in stock; false if that was met.
inline bool divide(Number& left, const Number& right) {
  bool defined = true;
  each(left, right, [&](double a, double b) {
    if (b != 0.0) return a / b;
    defined = false;
    return std::numeric_limits<double>::infinity();
  });
  left.is_colour = false;
  return defined;
}
inline void negate(Number& n) {
  for (double& x : n.v) x = -x;
}
inline void logical_not(Number& n) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) n.v[i] = is_true(n.v[i]) ? 0.0 : 1.0;
}
inline double logical(double a, double b, bool both) {
  return both ? is_true(a) && is_true(b) : is_true(a) || is_true(b);
}
inline void logical(Number& left, const Number& right, bool both) {
  each(left, right, [both](double a, double b) { return logical(a, b, both); });
}
inline bool is_comparison(Punct op) {
  return op >= Punct::kLess && op <= Punct::kEqual;
}
inline double compare(double a, double b, Punct op) {
  switch (op) {
    case Punct::kLess: return a < b;
    case Punct::kGreater: return a > b;
    case Punct::kLessEqual: return a <= b || !is_true(a - b);
    case Punct::kGreaterEqual: return a >= b || !is_true(a - b);
    case Punct::kEqual: return !is_true(a - b);
    default: return is_true(a - b);
  }
}
inline void compare(Number& left, const Number& right, Punct op) {
  each(left, right, [op](double a, double b) { return compare(a, b, op); });
}

/// Which component `.name` is; -1 if it is none.
inline int component_of(Keyword name) {
  switch (name) {
    case Keyword::kX: case Keyword::kU: case Keyword::kRed: return 0;
    case Keyword::kY: case Keyword::kV: case Keyword::kGreen: return 1;
    case Keyword::kZ: case Keyword::kBlue: return 2;
    case Keyword::kT: case Keyword::kFilter: return 3;
    case Keyword::kTransmit: return 4;
    default: return -1;
  }
}

// ---- functions ----------------------------------------------------------------------------------

/// What a keyword takes and gives, if a pure function or a constant.
enum class FunctionKind : std::uint8_t {
  kNone,
  kOneFloat,     ///< of one float
  kTwoFloats,    ///< of two: atan2, div, mod, pow
  kFold,         ///< of any number, one after the other: min, max, bitwise_and, bitwise_or, bitwise_xor
  kUnitVector,   ///< x, y, z, t, u, v
  kVector,       ///< the functions whose value is a vector
  kString        ///< those whose value is a string
};
FunctionKind function_kind(Keyword function);

/// Of one float. What is not defined for x (in_domain) must not be asked for.
bool in_domain(Keyword function, double x);
double one_float(Keyword function, double x);

/// Of two floats.
bool in_domain(Keyword function, double a, double b);
double two_floats(Keyword function, double a, double b);

double fold(Keyword function, double a, double b);

/// The vectors x, y, z, t, u and v; false if the keyword is none of them.
bool unit_vector(Keyword keyword, Number& value);
/// vrotate: degrees about x, then y, then z.
core::Vec3 rotated(const core::Vec3& p, const core::Vec3& degrees);
/// vaxis_rotate. About no axis there is no rotation: nan, with the sign that the machine gives it.
core::Vec3 rotated_about(const core::Vec3& p, const core::Vec3& axis, double degrees);
/// vnormalize. A vector too short to be squared is divided by its length 0, as in stock.
core::Vec3 normalised(const core::Vec3& v);

/// One step of a stream of rand(): 0 to 1.
double next_random(std::uint32_t& state);

}  // namespace lentray::parser
