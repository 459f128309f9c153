// Transfer curves: how stored values, colours of the scene and linear light become each other.
// Single precision throughout, as stock. Threads: any number.
// Source: reference manual 3.7, "Gamma", IEC 61966-2-1; compared with stock by tests/image/picture_gamma_test.cpp and
// tests/compat/language_expressions_test.cpp.
#pragma once

namespace lentray::parser {

/// A power, or sRGB's curve.
class Gamma {
 public:
  explicit Gamma(double power) : m_power(power) {}
  static Gamma linear() { return Gamma(1.0); }
  static Gamma srgb() { return Gamma(kSrgb); }
  /// As descriptions have it: less than 0 is sRGB.
  static Gamma of(double number) { return number < 0.0 ? srgb() : Gamma(number); }

  /// Values of this curve as values of another; those of one that is alike stay as they are.
  float recoded(float value, const Gamma& to) const;

 private:
  static constexpr double kSrgb = -1.0;
  bool is_srgb() const { return m_power < 0.0; }
  /// Powers less than a hundredth apart are one.
  bool is_alike(const Gamma& other) const;

  double m_power;
};

}  // namespace lentray::parser
