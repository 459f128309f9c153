// The light that enters a flat translucent solid at one place, is scattered many times, and leaves it at
// another: that of a source in the solid and of one outside that makes up for the surface. Lengths in mm, one
// channel. Immutable.
// Source: Jensen, Marschner, Levoy, Hanrahan: "A Practical Model for Subsurface Light Transport", SIGGRAPH
// 2001, equation 4. Without its division by pi: lights are as much brighter.
#pragma once

#include <cmath>

namespace lentray::core {

class Dipole {
 public:
  /// Gives no light.
  Dipole() = default;
  /// `scattered`, `lost`: reduced coefficients per mm, 0 < scattered <= lost. `boundary_factor`: A.
  Dipole(double scattered, double lost, double boundary_factor);
  /// What leaves per mm2 of what enters, so far away; Fresnel's factors come on top.
  double at(double distance_squared) const {
    return m_share * (source(m_inside, distance_squared) + source(m_outside, distance_squared));
  }

 private:
  double source(double depth, double distance_squared) const {
    const double squared = depth * depth + distance_squared;
    const double distance = std::sqrt(squared);
    return depth * (m_decay + 1.0 / distance) * std::exp(-m_decay * distance) / squared;
  }
  double m_share = 0.0;                    ///< reduced albedo over 4 pi
  double m_decay = 0.0;                    ///< effective transport coefficient
  double m_inside = 1.0, m_outside = 1.0;  ///< of the sources below and above the surface
};

}  // namespace lentray::core
