// From where a scene is seen through a lens sheet, apart from where its viewer is.
//
// The viewer stands V before the sheet: that decides the pitch of the print and which column is seen from
// where. The scene's eye stands D before it: that decides the perspective. Light that leaves the sheet at x with
// the slope T passes the viewer's plane at x - V T. It is that of a scene's eye m (D/V) (x - V T) beside the
// scene's own, with V infinite -m D T. So the middle view is the scene's own picture, and m is the part of the true depth
// that the print shows of what lies near its plane.
//
// Units: x, V and D in mm on the sheet; slopes against the sheet's normal. Immutable.
// Source: docs/lens/formulae.md, "Two distances".
#pragma once

#include "camera/lens_sheet.h"

namespace lentray::camera {

struct SceneEye {
  double distance = LensParameters::kInfinity;  ///< D, scene units; infinite: parallel rays
  double factor = 1.0;                          ///< m, above 0
};

/// What light leaves a sheet with, as slopes along a row, and the slopes of the scene's rays.
class SceneSlopes {
 public:
  /// The viewer's own eye sees the scene: slopes stay, to the bit.
  SceneSlopes() = default;
  /// `distance`: D in mm; infinite as it may be.
  SceneSlopes(double view_distance, double distance, double factor)
      : m_is_viewers(false), m_inverse_v(1.0 / view_distance), m_turn(1.0 / distance - m_inverse_v),
        m_held(1.0 - factor) {}

  /// Of light that leaves at x with the slope T. `middle_x`, `middle`: the same of the light through the
  /// lens's vertex, which alone the factor holds back, so that the blur of a thick lens stays.
  double of(double x, double slope, double middle_x, double middle) const {
    if (m_is_viewers) return slope;
    return slope + m_turn * x + m_held * (middle_x * m_inverse_v - middle);
  }
  double of(double x, double slope) const { return of(x, slope, x, slope); }

 private:
  bool m_is_viewers = true;
  double m_inverse_v = 0.0, m_turn = 0.0, m_held = 0.0;
};

}  // namespace lentray::camera
