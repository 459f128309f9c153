#include "core/trace/sky.h"

#include <algorithm>
#include <cmath>

#include "core/trace/reflectance.h"

namespace lentray::core {
namespace {

constexpr int kLayeredSkySince = 370;

// As layers of a texture, the background the last of them: each filters what is behind it.
Radiance layered_sky(const SkySphere* sky, const Colour& background, const Vec3& direction) {
  Rgb sum, filter(1.0f);
  const auto add = [&](const Colour& c, const Rgb& emission) {
    sum += c.rgb * (1.0f - c.filter - c.transmit) * filter * emission;
    filter *= passed(c);
  };
  if (sky) {
    for (auto layer = sky->pigments.rbegin(); layer != sky->pigments.rend(); ++layer) {
      add((*layer)->colour(direction), sky->emission);
    }
  }
  add(background, Rgb(1.0f));
  return {sum, std::min(1.0f, std::fabs(grey(filter)))};
}

// Before 3.7 filter and transmit of the layers were multiplied each on their own.
Radiance legacy_sky(const SkySphere& sky, const Rgb& background, const Vec3& direction) {
  Rgb sum;
  Colour filter{Rgb(1.0f), 1.0f, 1.0f};
  float left = 1.0f;
  for (auto layer = sky.pigments.rbegin(); layer != sky.pigments.rend(); ++layer) {
    const Colour c = (*layer)->colour(direction);
    sum += c.rgb * (left * (1.0f - c.filter - c.transmit));
    filter.rgb *= c.rgb;
    filter.filter *= c.filter;
    filter.transmit *= c.transmit;
    left = std::fabs(filter.filter) + std::fabs(filter.transmit);
  }
  sum *= sky.emission;
  return {sum + background * passed(filter), 0.0f};
}

}  // namespace

Radiance sky_radiance(const Scene& scene, const Vec3& direction, bool mirrored) {
  const SceneSettings& settings = scene.settings();
  const bool opaque = mirrored || !settings.alpha;
  const Colour& background = settings.background;
  const SkySphere* sky = scene.sky_sphere();
  if (settings.language_version >= kLayeredSkySince) {
    return layered_sky(sky, opaque ? Colour{background.rgb} : background, direction);
  }
  if (!opaque) return {Rgb(), 1.0f};
  if (!sky || sky->pigments.empty()) return {background.rgb, 0.0f};
  return legacy_sky(*sky, background.rgb, direction);
}

}  // namespace lentray::core
