#include "parser/values/arithmetic.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <numbers>

#include "core/base/transform.h"

namespace lentray::parser {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

constexpr std::size_t kKeywords = static_cast<std::size_t>(Keyword::kEndOfKeywords);

constexpr std::array<FunctionKind, kKeywords> function_kinds() {
  std::array<FunctionKind, kKeywords> kinds{};
  const auto set = [&kinds](FunctionKind kind, std::initializer_list<Keyword> functions) {
    for (const Keyword f : functions) kinds[static_cast<std::size_t>(f)] = kind;
  };
  set(FunctionKind::kOneFloat,
      {Keyword::kAbs, Keyword::kAcos, Keyword::kAsin, Keyword::kAtan, Keyword::kCos, Keyword::kSin,
       Keyword::kTan, Keyword::kCosh, Keyword::kSinh, Keyword::kTanh, Keyword::kAcosh,
       Keyword::kAsinh, Keyword::kAtanh, Keyword::kCeil, Keyword::kFloor, Keyword::kInt,
       Keyword::kDegrees, Keyword::kRadians, Keyword::kExp, Keyword::kLn, Keyword::kLog,
       Keyword::kSqr, Keyword::kSqrt});
  set(FunctionKind::kTwoFloats, {Keyword::kAtan2, Keyword::kDiv, Keyword::kMod, Keyword::kPow});
  set(FunctionKind::kFold, {Keyword::kMin, Keyword::kMax, Keyword::kBitwiseAnd, Keyword::kBitwiseOr,
                            Keyword::kBitwiseXor});
  set(FunctionKind::kUnitVector,
      {Keyword::kX, Keyword::kY, Keyword::kZ, Keyword::kT, Keyword::kU, Keyword::kV});
  set(FunctionKind::kVector, {Keyword::kVcross, Keyword::kVnormalize, Keyword::kVrotate,
                              Keyword::kVaxisRotate});
  set(FunctionKind::kString,
      {Keyword::kStr, Keyword::kVstr, Keyword::kConcat, Keyword::kChr, Keyword::kDatetime,
       Keyword::kSubstr, Keyword::kStrupr, Keyword::kStrlwr});
  return kinds;
}

constexpr auto kFunctionKinds = function_kinds();

}  // namespace

FunctionKind function_kind(Keyword function) {
  return kFunctionKinds[static_cast<std::size_t>(function)];
}

bool in_domain(Keyword function, double x) {
  switch (function) {
    case Keyword::kAcos: case Keyword::kAsin: return !(std::fabs(x) > 1.0);
    case Keyword::kLn: case Keyword::kLog: return x > 0.0;
    case Keyword::kSqrt: return !(x < 0.0);
    default: return true;
  }
}

double one_float(Keyword function, double x) {
  switch (function) {
    case Keyword::kAbs: return std::fabs(x);
    case Keyword::kAcos: return std::acos(std::clamp(x, -1.0, 1.0));
    case Keyword::kAsin: return std::asin(std::clamp(x, -1.0, 1.0));
    case Keyword::kAtan: return std::atan(x);
    case Keyword::kCos: return std::cos(x);
    case Keyword::kSin: return std::sin(x);
    case Keyword::kTan: return std::tan(x);
    case Keyword::kCosh: return std::cosh(x);
    case Keyword::kSinh: return std::sinh(x);
    case Keyword::kTanh: return std::tanh(x);
    case Keyword::kAcosh: return std::acosh(x);
    case Keyword::kAsinh: return std::asinh(x);
    case Keyword::kAtanh: return std::atanh(x);
    case Keyword::kCeil: return std::ceil(x);
    case Keyword::kFloor: return std::floor(x);
    case Keyword::kInt: return to_int(x);
    case Keyword::kDegrees: return x / kDegree;
    case Keyword::kRadians: return x * kDegree;
    case Keyword::kExp: return std::exp(x);
    case Keyword::kLn: return std::log(x);
    case Keyword::kLog: return std::log10(x);
    case Keyword::kSqr: return x * x;
    default: return std::sqrt(x);
  }
}

bool in_domain(Keyword function, double a, double b) {
  if (function == Keyword::kAtan2) return is_true(a) || is_true(b) || std::isnan(a) || std::isnan(b);
  return function != Keyword::kPow || a != 0.0 || b != 0.0;
}

double two_floats(Keyword function, double a, double b) {
  switch (function) {
    case Keyword::kAtan2: return std::atan2(a, b);
    case Keyword::kDiv: return to_int(a / b);
    case Keyword::kMod: return std::fmod(a, b);
    default: return std::pow(a, b);
  }
}

double fold(Keyword function, double a, double b) {
  switch (function) {
    case Keyword::kMin: return std::min(a, b);
    case Keyword::kMax: return std::max(a, b);
    case Keyword::kBitwiseAnd: return to_int(a) & to_int(b);
    case Keyword::kBitwiseOr: return to_int(a) | to_int(b);
    default: return to_int(a) ^ to_int(b);
  }
}

bool unit_vector(Keyword keyword, Number& value) {
  switch (keyword) {
    case Keyword::kX: value = Number::vector({1, 0, 0}); return true;
    case Keyword::kY: value = Number::vector({0, 1, 0}); return true;
    case Keyword::kZ: value = Number::vector({0, 0, 1}); return true;
    case Keyword::kT: value = Number{{0, 0, 0, 1, 0}, 4}; return true;
    case Keyword::kU: value = Number{{1, 0, 0, 0, 0}, 2}; return true;
    case Keyword::kV: value = Number{{0, 1, 0, 0, 0}, 2}; return true;
    default: return false;
  }
}

core::Vec3 rotated(const core::Vec3& p, const core::Vec3& degrees) {
  return core::Transform::rotation(degrees).point(p);
}

core::Vec3 rotated_about(const core::Vec3& p, const core::Vec3& axis, double degrees) {
  if (core::dot(axis, axis) == 0.0) {
    return core::Vec3(-std::numeric_limits<double>::quiet_NaN());
  }
  return core::Transform::axis_rotation(axis, degrees * kDegree).point(p);
}

core::Vec3 normalised(const core::Vec3& v) {
  const double length = core::length(v);
  const bool too_short = length == 0.0 && v != core::Vec3{};
  return too_short ? core::Vec3(v.x / length, v.y / length, v.z / length) : core::normalized(v);
}

// A linear congruential generator; constants measured by the values stock prints.
double next_random(std::uint32_t& state) {
  state = state * 1812433253u + 12345u;
  return static_cast<double>(state) * (1.0 / 4294967295.0);
}

}  // namespace lentray::parser
