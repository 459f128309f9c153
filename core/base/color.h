// Colours: red, green, blue, and two kinds of transparency.
// Linear light; no range is enforced. Source: reference manual 3.7, "Specifying Colors".
#pragma once

#include <cmath>

namespace lentray::core {

struct Rgb {
  float r = 0.0f, g = 0.0f, b = 0.0f;

  constexpr Rgb() = default;
  constexpr Rgb(float r_, float g_, float b_) : r(r_), g(g_), b(b_) {}
  constexpr explicit Rgb(float all) : r(all), g(all), b(all) {}

  constexpr float operator[](int i) const { return i == 0 ? r : i == 1 ? g : b; }
  constexpr float& operator[](int i) { return i == 0 ? r : i == 1 ? g : b; }
  constexpr Rgb& operator+=(const Rgb& o) {
    r += o.r;
    g += o.g;
    b += o.b;
    return *this;
  }
  constexpr Rgb& operator-=(const Rgb& o) {
    r -= o.r;
    g -= o.g;
    b -= o.b;
    return *this;
  }
  constexpr Rgb& operator*=(const Rgb& o) {
    r *= o.r;
    g *= o.g;
    b *= o.b;
    return *this;
  }
  constexpr Rgb& operator*=(float s) {
    r *= s;
    g *= s;
    b *= s;
    return *this;
  }
  friend constexpr Rgb operator+(Rgb a, const Rgb& c) { return a += c; }
  friend constexpr Rgb operator-(Rgb a, const Rgb& c) { return a -= c; }
  friend constexpr Rgb operator*(Rgb a, const Rgb& c) { return a *= c; }
  friend constexpr Rgb operator*(Rgb a, float s) { return a *= s; }
  friend constexpr Rgb operator*(float s, Rgb a) { return a *= s; }
  friend constexpr bool operator==(const Rgb&, const Rgb&) = default;

  constexpr bool is_black() const { return r == 0.0f && g == 0.0f && b == 0.0f; }
};

/// Luminance weights of grey: 0.297, 0.589, 0.114.
constexpr float grey(const Rgb& c) { return 0.297f * c.r + 0.589f * c.g + 0.114f * c.b; }

/// Decides whether samples need another between them.
inline double difference(const Rgb& a, const Rgb& b) {
  return std::fabs(a.r - b.r) + std::fabs(a.g - b.g) + std::fabs(a.b - b.b);
}

/// A pigment's colour: `filter` lets light through tinted, `transmit` untinted.
struct Colour {
  Rgb rgb;
  float filter = 0.0f, transmit = 0.0f;
  friend constexpr bool operator==(const Colour&, const Colour&) = default;
  constexpr bool is_opaque() const { return filter == 0.0f && transmit == 0.0f; }
};

}  // namespace lentray::core
