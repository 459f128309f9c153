// What numbers of SDL are made of and what its pure functions of vectors do to them, apart from how
// their text is read; operators are in operators.h, functions of floats in float_functions.h.
// Source: reference manual 3.7, "Float Expressions", "Vector Expressions"; precision, promotion and
// error cases as measured on stock.
#pragma once

#include <cmath>
#include <limits>

#include "core/function/operation.h"
#include "parser/tokens/token.h"
#include "parser/values/value.h"

namespace lentray::parser {

/// Stock's idea of zero when it compares (=, <=, !=, conditions).
inline constexpr double kCompareEpsilon = 1e-10;
inline bool is_true(double x) { return std::fabs(x) > kCompareEpsilon; }

using core::to_int;

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

// ---- operators of one operand -----------------------------------------------------------------

inline void negate(Number& n) {
  for (double& x : n.v) x = -x;
}
inline void logical_not(Number& n) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i)
    n.v[i] = is_true(n.v[i]) ? 0.0 : 1.0;
}

/// Which component `.name` is; -1 if it is none.
inline int component_of(Keyword name) {
  switch (name) {
    case Keyword::kX:
    case Keyword::kU:
    case Keyword::kRed: return 0;
    case Keyword::kY:
    case Keyword::kV:
    case Keyword::kGreen: return 1;
    case Keyword::kZ:
    case Keyword::kBlue: return 2;
    case Keyword::kT:
    case Keyword::kFilter: return 3;
    case Keyword::kTransmit: return 4;
    default: return -1;
  }
}

// ---- functions ----------------------------------------------------------------------------------

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
