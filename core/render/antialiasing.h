// What antialiasing is asked for, and when two colours differ.
// Source: reference manual 3.7, "Antialiasing Options"; the sum over the channels, "at least the
// threshold" and the two gammas measured on stock by tests/image/antialiasing_test.cpp.
#pragma once

#include <cmath>

#include "core/base/color.h"
#include "core/trace/radiance.h"

namespace lentray::core {

struct Antialiasing {
  /// 0: off, 1: adaptive and not recursive, 2: adaptive and recursive; 3, our own: every pixel has
  /// depth x depth samples, at the middles of its cells
  int method = 0;
  double threshold = 0.3;  ///< 0..1, of the sum over red, green, blue and transparency
  int depth = 3;        ///< methods 1 and 3: depth x depth samples; method 2: halvings of a pixel
  double jitter = 1.0;  ///< 0: none
  double gamma = 2.5;   ///< in which colours are compared; 0: as they are

  /// Pixels are compared with one another.
  bool compares() const { return method == 1 || method == 2; }
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
        m_is_plain(!(gamma > 0.0)) {}
  Compared of(const Radiance& seen) const {
    if (m_is_plain) return {seen.rgb, seen.transmit};
    return {{encoded(seen.rgb.r), encoded(seen.rgb.g), encoded(seen.rgb.b)}, seen.transmit};
  }

 private:
  float encoded(float value) const {
    if (m_is_srgb) {
      value = value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
    }
    return std::pow(std::max(value, 0.0f), m_power);
  }
  bool m_is_srgb;
  float m_power;
  bool m_is_plain;
};

}  // namespace lentray::core
