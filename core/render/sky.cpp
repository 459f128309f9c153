#include "core/render/sky.h"

#include <algorithm>
#include <cmath>

#include "core/render/reflectance.h"

namespace lentray::core {
namespace {

constexpr int kLayeredSkySince = 370;

// As layers of a texture: each filters what is behind it.
Radiance layered_sky(const SkySphere& sky, const Rgb& background, const Vec3& direction) {
  Rgb sum, filter(1.0f);
  for (auto layer = sky.pigments.rbegin(); layer != sky.pigments.rend(); ++layer) {
    const Colour c = (*layer)->colour(direction);
    sum += c.rgb * (1.0f - c.filter - c.transmit) * filter * sky.emission;
    filter *= passed(c);
  }
  sum += background * filter;
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
  return {sum + background * passed(filter), std::min(1.0f, filter.transmit)};
}

}  // namespace

Radiance sky_radiance(const Scene& scene, const Vec3& direction) {
  const Rgb& background = scene.settings().background.rgb;
  const SkySphere* sky = scene.sky_sphere();
  if (!sky || sky->pigments.empty()) return {background, 1.0f};
  return scene.settings().language_version < kLayeredSkySince
             ? legacy_sky(*sky, background, direction)
             : layered_sky(*sky, background, direction);
}

}  // namespace lentray::core
