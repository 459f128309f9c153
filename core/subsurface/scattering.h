// How a translucent solid scatters light, found from what it looks like in bulk. Lengths in mm. Pure
// functions; immutable values.
// Source: Jensen, Marschner, Levoy, Hanrahan: "A Practical Model for Subsurface Light Transport", SIGGRAPH
// 2001, for the diffuse reflectance of a solid by its reduced albedo; what inside reflects of diffuse light,
// the steps of the table and the meaning of translucency are those that give stock's pictures
// (tests/image/subsurface_test.cpp).
#pragma once

#include <array>

#include "core/base/color.h"

namespace lentray::core {

/// The part of diffuse light that the surface throws back into the solid; 0..1, below 1.
double diffuse_fresnel_reflectance(double relative_ior);

/// How much farther than the depth of the first scattering the dipole's second source lies outside: A.
double boundary_factor(double relative_ior);

/// What an endless flat solid throws back of even light, by its reduced albedo.
double diffuse_reflectance(double boundary_factor, double reduced_albedo);

/// The inverse of diffuse_reflectance(), for one ior: exact at whole hundredths, linear between them.
class ReducedAlbedo {
 public:
  explicit ReducedAlbedo(double ior);
  double ior() const { return m_ior; }
  /// Reflectances beyond 0..1 are taken for those ends.
  double at(double reflectance) const;

 private:
  static constexpr int kSteps = 100;
  double m_ior;
  std::array<double, kSteps + 1> m_albedo;
};

/// Of each channel, per mm.
struct Scattering {
  std::array<double, 3> scattered;  ///< reduced scattering coefficient
  std::array<double, 3> lost;       ///< the same with what is absorbed; 0: the channel is black
  double mean_lost;  ///< of the channels that are not black, by their part in grey; 0: all are
};
/// `colour`: what the solid throws back in bulk. `translucency`: positive.
Scattering scattering_of(const ReducedAlbedo& albedo, const Rgb& colour, const Rgb& translucency);

}  // namespace lentray::core
