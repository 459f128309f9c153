// What antialiasing is asked for, and when two colours differ.
// Source: reference manual 3.7, "Antialiasing Options"; the sum over the channels, "at least the
// threshold" and the two gammas measured on stock by tests/image/antialiasing_test.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/color.h"
#include "core/trace/radiance.h"

namespace lentray::core {

enum class AntialiasingMethod : std::uint8_t {
  kPlain,    ///< one sample a pixel
  kCentres,  ///< stock's method 1: adaptive, not recursive
  kCorners,  ///< stock's method 2: adaptive and recursive
  kSpread,   ///< for prints: samples of neighbouring pixels are spread, for an eye blends them
  kGrid,     ///< every pixel has depth x depth samples, at the middles of its cells
};

struct Antialiasing {
  AntialiasingMethod method = AntialiasingMethod::kPlain;
  double threshold = 0.3;  ///< 0..1, of the sum over red, green, blue and transparency
  /// kCentres, kGrid: depth x depth samples; kCorners: halvings of a pixel; kSpread: further samples
  int depth = 3;
  double jitter = 1.0;  ///< 0: none
  double gamma = 2.5;   ///< in which colours are compared; 0: as they are

  bool blends_light =
      false;          ///< kGrid: samples are spread, means of linear light, as those of kSpread
  float most = 1.0f;  ///< linear light that the picture's file can hold; infinite: any

  /// Pixels are compared with one another.
  bool compares() const {
    return method == AntialiasingMethod::kCentres || method == AntialiasingMethod::kCorners ||
           method == AntialiasingMethod::kSpread;
  }
  /// Of a pixel that is refined.
  int more_samples() const { return method == AntialiasingMethod::kSpread ? depth : depth * depth; }
};

/// A colour as it is compared.
struct Compared {
  Rgb rgb;
  float transmit = 0.0f;
  /// The sum of the differences of the channels.
  float distance(const Compared& o) const {
    return std::fabs(rgb.r - o.rgb.r) + std::fabs(rgb.g - o.rgb.g) + std::fabs(rgb.b - o.rgb.b) +
           std::fabs(transmit - o.transmit);
  }
};

/// From the scene's working space to where colours are compared: brightness as the eye has it.
class ComparedSpace {
 public:
  /// `working_gamma` 0: the working space is sRGB. Scenes that say none have 1 here.
  ComparedSpace(double gamma, double working_gamma)
      : m_is_srgb(working_gamma == 0.0),
        m_power(static_cast<float>(gamma > 0.0 ? (m_is_srgb ? 1.0 : working_gamma) / gamma : 1.0)),
        m_is_root(m_power == 0.5f), m_is_plain(!(gamma > 0.0)) {}
  Compared of(const Radiance& seen) const {
    if (m_is_plain) return {seen.rgb, seen.transmit};
    return {{encoded(seen.rgb.r), encoded(seen.rgb.g), encoded(seen.rgb.b)}, seen.transmit};
  }

 private:
  float encoded(float value) const {
    if (m_is_srgb) {
      value = value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
    }
    value = std::max(value, 0.0f);
    return m_is_root ? std::sqrt(value) : std::pow(value, m_power);
  }
  bool m_is_srgb;
  float m_power;
  bool m_is_root, m_is_plain;
};

/// Between the scene's working space and linear light, in which an eye blends.
class LinearLight {
 public:
  /// `working_gamma` as ComparedSpace has it; `most`: more is clipped.
  LinearLight(double working_gamma, float most)
      : m_is_srgb(working_gamma == 0.0), m_power(static_cast<float>(working_gamma)), m_most(most) {}
  Radiance of(const Radiance& seen) const {
    return {each(seen.rgb, [this](float v) { return std::min(light(std::max(v, 0.0f)), m_most); }),
            seen.transmit};
  }
  Radiance back(const Radiance& light) const {
    return {each(light.rgb, [this](float v) { return working(v); }), light.transmit};
  }

 private:
  template <class Work>
  static Rgb each(const Rgb& rgb, Work work) {
    return {work(rgb.r), work(rgb.g), work(rgb.b)};
  }
  float light(float v) const {
    if (!m_is_srgb) return m_power == 1.0f ? v : std::pow(v, m_power);
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
  }
  float working(float v) const {
    if (!m_is_srgb) return m_power == 1.0f ? v : std::pow(v, 1.0f / m_power);
    return v <= 0.0031308f ? v * 12.92f : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
  }
  bool m_is_srgb;
  float m_power, m_most;
};

}  // namespace lentray::core
