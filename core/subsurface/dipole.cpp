#include "core/subsurface/dipole.h"

#include <numbers>

namespace lentray::core {

Dipole::Dipole(double scattered, double lost, double boundary_factor)
    : m_share(scattered / lost / (4.0 * std::numbers::pi)),
      m_decay(std::sqrt(3.0 * (lost - scattered) * lost)), m_inside(1.0 / lost),
      m_outside(m_inside * (1.0 + 4.0 / 3.0 * boundary_factor)) {}

}  // namespace lentray::core
