// A photon: a share of a light's power that came to rest at a place. World space; power linear. Plain
// values: three floats, a colour of four bytes, a direction of two. Light is gathered from these short numbers.
// Source: reference manual 3.7, "Photons"; Ward, "Real Pixels", Graphics Gems II (the colour); bytes and
// their rounding are those of a file that `save_file` writes (tests/unit/photon/photon_test.cpp).
#pragma once

#include <array>
#include <cstdint>

#include "core/base/color.h"
#include "core/base/vec3.h"

namespace lentray::core {

struct Photon {
  std::array<float, 3> place;
  std::array<std::uint8_t, 4> rgbe;  ///< see packed()
  std::uint8_t axis = 0;             ///< 0..2: of the map's tree, which splits there
  std::int8_t latitude = 0;          ///< of the way back, towards y; 127: pi
  std::int8_t longitude = 0;         ///< about y, from x towards z; 127: pi
  /// Of the map's tree: how far behind it the photon is listed that splits, on whose wrong side it lies.
  std::int8_t hidden_by = 0;

  friend bool operator==(const Photon&, const Photon&) = default;
};
static_assert(sizeof(Photon) == 20);

/// Mantissas of the channels, cut off, and the exponent they share, biased by 250. The greatest channel lies
/// in 1e-32 .. 32: less is black, more wraps around.
std::array<std::uint8_t, 4> packed(const Rgb& power);
Rgb unpacked(const std::array<std::uint8_t, 4>& rgbe);

/// Comes from `origin`.
Photon make_photon(const Vec3& place, const Vec3& origin, const Rgb& power);
inline Rgb power_of(const Photon& photon) { return unpacked(photon.rgbe); }
/// Back to where it came from; unit.
Vec3 way_back(const Photon& photon);

}  // namespace lentray::core
