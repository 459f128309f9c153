// A pattern: a number for each point of space, 0..1 or a whole number (0, 1, 2 for checker and its
// kin). Space: the pattern's own, unit cells. Immutable, any number of threads.
// Source: reference manual 3.7, "Patterns"; values compared with stock by tests/image/patterns_test.cpp.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

#include "core/base/simd.h"
#include "core/base/vec3.h"
#include "core/pattern/surface_context.h"

namespace lentray::core {

class Pattern {
 public:
  virtual ~Pattern() = default;
  /// Before frequency, phase and wave form; may lie outside 0..1.
  virtual double value(const Vec3& point) const = 0;
  /// The same on a surface: patterns that follow it answer otherwise.
  virtual double value_on(const Vec3& point, const SurfaceContext& surface) const {
    (void)surface;
    return value(point);
  }
};

/// The whole number at or below: std::floor is a call where the processor need not have it. Beyond 2^63,
/// where functions may ask, and of nan some whole number.
inline std::int64_t whole_below(double v) {
  const std::int64_t i = simd::truncated(v);
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(i) -
                                   (v < static_cast<double>(i) ? 1 : 0));
}

using PatternPtr = std::unique_ptr<const Pattern>;

/// The pattern whose value at a point is formula(point), or formula(point, surface).
template <class Formula>
PatternPtr pattern_of(Formula formula) {
  class Made final : public Pattern {
   public:
    explicit Made(Formula f) : m_formula(std::move(f)) {}
    double value(const Vec3& point) const override { return value_on(point, kNoSurface); }
    double value_on(const Vec3& point, const SurfaceContext& surface) const override {
      if constexpr (std::is_invocable_v<const Formula&, const Vec3&>) {
        return m_formula(point);
      } else {
        return m_formula(point, surface);
      }
    }

   private:
    Formula m_formula;
  };
  return std::make_unique<Made>(std::move(formula));
}

/// frequency, phase and the wave forms.
class Wave {
 public:
  enum class Form { kRamp, kTriangle, kSine, kScallop, kCubic, kPoly };
  double frequency = 1.0, phase = 0.0;
  Form form = Form::kRamp;
  double exponent = 1.0;

  double apply(double value) const {
    if (frequency != 0.0) {
      // It wraps a little above 1, so that a pattern that ends at 1 keeps its last colour.
      constexpr double kWrap = 1.00001;
      value = value * frequency + phase;
      if (!(std::fabs(value) < kWrap)) value = wrapped(value, kWrap);
    }
    if (value < 0.0) value -= std::floor(value);
    return form == Form::kRamp ? value : shaped(value);
  }

 private:
  /// std::fmod(). Of a number below twice another one the difference is exact: a few of them are the same bits.
  static double wrapped(double value, double period) {
    constexpr double kMost = 32.0;
    double size = std::fabs(value);
    if (!(size < 2.0 * kMost * period)) return std::fmod(value, period);
    for (double part = kMost * period; part >= period; part *= 0.5) {
      size -= size >= part ? part : 0.0;
    }
    return std::copysign(size, value);
  }
  double shaped(double value) const;  ///< by the other forms
};

}  // namespace lentray::core
