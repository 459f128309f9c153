#include "core/trace/open_air.h"

#include <algorithm>
#include <cmath>

#include "core/base/tiny.h"
#include "core/trace/random_key.h"

namespace lentray::core {
namespace {

// The share of full density along the way between two heights, in units of the altitude: density is
// 1 below 0 and 1 / (1 + y^2) above.
double ground_density(double from, double to) {
  const double low = std::min(from, to), high = std::max(from, to);
  if (high <= 0.0) return 1.0;
  if (low <= 0.0) return (std::atan(high) - low) / (high - low);
  if (high - low <= kTiny) return 1.0 / (low * low + 1.0);
  return (std::atan(high) - std::atan(low)) / (high - low);
}

/// What is left after the fog, 0..1, without regard to its transmit.
double left_by(const Fog& fog, const Ray& ray, double depth) {
  double density = 1.0;
  if (fog.on_ground) {
    const double from = (dot(ray.origin, fog.up) - fog.offset) / fog.altitude;
    const double to = (dot(ray.at(depth), fog.up) - fog.offset) / fog.altitude;
    density = ground_density(from, to);
  }
  if (fog.turbulence) {
    // The longer the way, the less it shows.
    const Vec3 middle = scaled(ray.at(0.5 * depth), fog.turbulence->amount);
    const double stir =
        turbulence(middle, *fog.turbulence, fog.noise_generator) * fog.turbulence_depth;
    depth *= 1.0 - std::exp(-depth / fog.distance) * std::min(1.0, stir);
  }
  return std::exp(-depth * density / fog.distance);
}

/// Where in its band the ray is, 0..1, or less than 0; and how much the arc's end fades it.
double place_in_band(const Rainbow& bow, const Ray& ray, std::uint64_t key, double& fade) {
  const double x = dot(ray.direction, bow.right), y = dot(ray.direction, bow.up);
  const double around = std::sqrt(x * x + y * y);
  const double angle = std::acos(std::clamp(around > 0.0 ? y / around : y, -1.0, 1.0));
  if (!(angle <= bow.arc_angle)) return -1.0;
  const double ahead = dot(ray.direction, bow.antisolar);
  if (!(ahead >= 0.0)) return -1.0;
  double place = (std::acos(std::min(ahead, 1.0)) - bow.angle) / bow.width;
  if (bow.jitter > 0.0) {
    const double random = RandomSequence(key, RandomSequence::Use::kRainbow).next();
    place += (2.0 * random - 1.0) * bow.jitter;
  }
  if (!(place >= 0.0 && place <= 1.0 - kTiny)) return -1.0;
  fade = 0.0;
  const double fading = bow.arc_angle - bow.falloff_angle;
  if (fading > 0.0 && angle > bow.falloff_angle) {
    const double f = (angle - bow.falloff_angle) / fading;
    fade = (3.0 - 2.0 * f) * f * f;
  }
  return place;
}

/// What one fog lets through of each channel, if `share` is left.
Rgb filtered(const Fog& fog, double share) {
  const float filter = fog.colour.filter;
  Rgb left;
  for (int c = 0; c < 3; ++c) {
    left[c] = static_cast<float>(share) * ((1.0f - filter) + filter * fog.colour.rgb[c]);
  }
  return left;
}

double share_left(const Fog& fog, const Segment& segment) {
  return std::max(left_by(fog, segment.ray, segment.length), double(fog.colour.transmit));
}

}  // namespace

void pass_rainbows(const Atmosphere& air, const Segment& segment, std::uint64_t key,
                   Radiance& light) {
  Rgb sum;
  float transmit = 1.0f;
  int met = 0;
  std::uint64_t number = 0;
  for (const Rainbow& bow : air.rainbows) {
    double fade = 0.0;
    const double place = place_in_band(bow, segment.ray, branch_key(key, number++), fade);
    if (place < 0.0) continue;
    const auto entry = bow.colours.find(place);
    const auto mix = [f = static_cast<float>(entry.fraction)](float a, float b) {
      return a + f * (b - a);
    };
    const Colour &a = *entry.before, &b = *entry.after;
    const float c_transmit = mix(a.transmit, b.transmit);
    const double left =
        std::max(std::exp(-segment.length / bow.distance), fade * (1.0 - c_transmit) + c_transmit);
    const double filter = mix(a.filter, b.filter) * (1.0 - left);
    for (int c = 0; c < 3; ++c) {
      const double own = mix(a.rgb[c], b.rgb[c]);
      sum[c] += static_cast<float>(left * light.rgb[c] * ((1.0 - filter) + filter * own) +
                                   (1.0 - left) * own);
    }
    transmit *= static_cast<float>(left * c_transmit);
    ++met;
  }
  if (met == 0) return;
  light.rgb = sum * (1.0f / static_cast<float>(met));
  light.transmit *= transmit;
}

void pass_fogs(const Atmosphere& air, const Segment& segment, Radiance& light) {
  Rgb left(1.0f), own;
  for (const Fog& fog : air.fogs) {
    const double share = share_left(fog, segment);
    left *= filtered(fog, share);
    own += fog.colour.rgb * static_cast<float>(1.0 - share);
  }
  light.rgb = own + left * light.rgb;
  light.transmit *= grey(left);
}

Rgb left_by_fogs(const Atmosphere& air, const Segment& segment) {
  Rgb left(1.0f);
  for (const Fog& fog : air.fogs) left *= filtered(fog, share_left(fog, segment));
  return left;
}

}  // namespace lentray::core
