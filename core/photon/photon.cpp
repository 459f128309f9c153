#include "core/photon/photon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lentray::core {
namespace {

constexpr int kBias = 250, kMantissaBits = 8;
constexpr float kBlack = 1e-32f;
constexpr int kHalfTurn = 127;  ///< bytes of pi

std::uint8_t mantissa(float channel) {
  // A channel below 0 wraps around.
  return static_cast<std::uint8_t>(static_cast<int>(std::max(channel, -1e6f)));
}

/// Of the angle that has this cosine, below 0 if it turns to a side below 0.
std::int8_t angle_byte(double cosine, double side) {
  const double angle = std::acos(cosine);
  if (std::isnan(angle)) return 0;  // straight up or down: it has no longitude
  return static_cast<std::int8_t>((side < 0.0 ? -angle : angle) * kHalfTurn / std::numbers::pi);
}

/// Sines and cosines of all bytes.
struct AngleTable {
  AngleTable() {
    for (int byte = -128; byte < 128; ++byte) {
      const double angle = byte * std::numbers::pi / kHalfTurn;
      sines[static_cast<std::size_t>(byte + 128)] = std::sin(angle);
      cosines[static_cast<std::size_t>(byte + 128)] = std::cos(angle);
    }
  }
  double sine(std::int8_t byte) const { return sines[static_cast<std::size_t>(byte + 128)]; }
  double cosine(std::int8_t byte) const { return cosines[static_cast<std::size_t>(byte + 128)]; }
  std::array<double, 256> sines, cosines;
};
const AngleTable kAngles;

/// What a mantissa of 1 stands for, by the exponent's byte.
struct ScaleTable {
  ScaleTable() {
    for (int byte = 1; byte < 256; ++byte) {
      scales[static_cast<std::size_t>(byte)] =
          static_cast<float>(std::ldexp(1.0, byte - kBias - kMantissaBits));
    }
  }
  std::array<float, 256> scales{};  ///< 0 is black
};
const ScaleTable kScales;

}  // namespace

std::array<std::uint8_t, 4> packed(const Rgb& power) {
  const float most = std::max({power.r, power.g, power.b});
  if (!(most >= kBlack)) return {};
  int exponent = 0;
  std::frexp(most, &exponent);
  const auto scale = static_cast<float>(std::ldexp(1.0, kMantissaBits - exponent));
  return {mantissa(power.r * scale), mantissa(power.g * scale), mantissa(power.b * scale),
          static_cast<std::uint8_t>(exponent + kBias)};
}

Rgb unpacked(const std::array<std::uint8_t, 4>& rgbe) {
  const float scale = kScales.scales[rgbe[3]];
  return {rgbe[0] * scale, rgbe[1] * scale, rgbe[2] * scale};
}

Photon make_photon(const Vec3& place, const Vec3& origin, const Rgb& power) {
  const Vec3 back = normalized(origin - place);
  const double level = std::sqrt(back.x * back.x + back.z * back.z);
  return {{static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z)},
          packed(power),
          0,
          angle_byte(level, back.y),
          angle_byte(back.x / level, back.z)};
}

Vec3 way_back(const Photon& photon) {
  const double level = kAngles.cosine(photon.latitude);
  return {level * kAngles.cosine(photon.longitude), kAngles.sine(photon.latitude),
          level * kAngles.sine(photon.longitude)};
}

}  // namespace lentray::core
