// How much light a medium scatters into a direction. Pure functions.
// The mean over all directions is 1 for isotropic and Henyey-Greenstein, 1.066 for Rayleigh, 1.153 for hazy and
// 1.247 for murky.
// Source: reference manual 3.7, "Scattering".
#pragma once

namespace lentray::core {

struct PhaseFunction {
  /// Numbers are those of `scattering { TYPE ... }`.
  enum class Kind {
    kIsotropic = 1,
    kMieHazy = 2,
    kMieMurky = 3,
    kRayleigh = 4,
    kHenyeyGreenstein = 5
  };
  Kind kind = Kind::kIsotropic;
  double eccentricity = 0.0;  ///< of Henyey-Greenstein, -1..1: above 0 light goes on as it came
  /// `cosine`: between the ray that is traced and the direction to the light.
  double operator()(double cosine) const;
};

}  // namespace lentray::core
