// What a ray has met: the light that a surface, or the sky, sends along it by itself, and the rays
// that go on from the surface with how what they see adds to it. Whoever follows these, in whatever
// order, gets the same bits. A buffer that is used from ray to ray; world space, colours linear.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/object/attributes.h"
#include "core/trace/radiance.h"
#include "core/trace/ray_state.h"
#include "core/trace/reflectance.h"

namespace lentray::core {

/// A ray that goes on from a surface, and what becomes of the light that it brings.
struct OnwardRay {
  enum class Way : std::uint8_t {
    kMirror,
    kThrough,
    kTotalReflection,  ///< instead of kThrough
    kBand,             ///< through, one of the bands of dispersed light
    kLastBand,
  };
  OnwardRay() {}  // not defaulted: that would clear all
  RayState state;
  Rgb share;  ///< factor: of the mirror; of what the interior before the surface left
  Way way;
  bool tinted;      ///< a mirror image in a thin film
  Rgb tint;         ///< factor of the film, if so
  Rgb filter;       ///< factor of what comes through: the layers
  Rgb hue;          ///< factor of a band
  float band_part;  ///< of a band, of all light
  double exponent;  ///< of a mirror image
  double clear;     ///< the part of the background that the layers let through
};

/// Adds what the rays that go on from a texture brought, in their order.
class LightSum {
 public:
  explicit LightSum(const Radiance& own) : m_sum(own) {}
  [[gnu::always_inline]] void add(const OnwardRay& from, const Radiance& seen) {
    switch (from.way) {
      case OnwardRay::Way::kMirror: return add_image(from, seen.rgb);
      case OnwardRay::Way::kThrough:
        m_sum.rgb += from.share * seen.rgb * from.filter;
        m_sum.transmit = static_cast<float>(grey(from.share) * seen.transmit * from.clear);
        return;
      default: return add_rare(from, seen.rgb);
    }
  }
  const Radiance& total() const { return m_sum; }

 private:
  [[gnu::always_inline]] void add_image(const OnwardRay& from, Rgb image) {
    if (from.tinted) image *= from.tint;
    if (from.exponent != 1.0) {
      for (int c = 0; c < 3; ++c) {
        image[c] = static_cast<float>(std::pow(image[c], from.exponent));
      }
    }
    m_sum.rgb += from.share * image;
  }
  [[gnu::noinline]] void add_rare(const OnwardRay& from, Rgb seen) {
    if (from.tinted) seen *= from.tint;
    if (from.way == OnwardRay::Way::kTotalReflection) {
      m_sum.rgb += from.share * seen;
      return;
    }
    m_bands += seen * from.hue;
    if (from.way == OnwardRay::Way::kLastBand) {
      m_sum.rgb += from.share * (m_bands * from.band_part) * from.filter;
    }
  }

  Radiance m_sum;
  Rgb m_bands;
};

struct RayRecord {
  /// One of several textures of a place.
  struct Part {
    Radiance own;
    double weight;
    std::size_t rays;  ///< of those that go on, in their order
  };
  const Attributes* attributes;  ///< of the surface; null: the sky
  double length;                 ///< of the ray
  int level;                     ///< trace level, 1: camera ray
  Radiance own;                  ///< without those that go on
  std::vector<Part> parts;       ///< empty: one texture, whose light is `own`
  std::vector<OnwardRay> onward;

  /// What arrives at the ray's end, where `see(OnwardRay) -> Radiance` is what arrives at the start
  /// of one that goes on; called for each, in order.
  template <class See>
  [[gnu::always_inline]] Radiance gather(See&& see) const {
    return parts.empty() ? gather(own, onward, see) : gather_parts(see);
  }

 private:
  template <class See>
  [[gnu::noinline]] Radiance gather_parts(See& see) const {
    const std::span<const OnwardRay> all = onward;
    Radiance sum;
    std::size_t first = 0;
    for (const Part& part : parts) {
      const Radiance light = gather(part.own, all.subspan(first, part.rays), see);
      first += part.rays;
      sum.rgb += times(light.rgb, part.weight);
      sum.transmit += static_cast<float>(light.transmit * part.weight);
    }
    return sum;
  }
  template <class See>
  [[gnu::always_inline]] static Radiance gather(const Radiance& own,
                                                std::span<const OnwardRay> rays, See& see) {
    LightSum sum(own);
    for (const OnwardRay& ray : rays) sum.add(ray, see(ray));
    return sum.total();
  }
};

}  // namespace lentray::core
