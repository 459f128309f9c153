// The drawing area of --depth-view: scene units to SVG's. One thread.
#pragma once

#include <string>
#include <vector>

#include "camera/depth_survey.h"
#include "camera/lenticular.h"

namespace lentray::tool {

/// Where eyes look from, of a sheet with a finite V. Scene units.
struct ViewingPlan {
  double depth = 0.0;              ///< -V
  double middle = 0.0;             ///< x of the eye
  double zone = 0.0;               ///< width of the zone that the sheet is viewed from
  std::vector<double> viewpoints;  ///< x of the views' eyes, view 0 first
  double eyes_apart = 0.0;         ///< of a viewer
};
ViewingPlan viewing_plan(const camera::Lenticular& sheet);

class DepthPlan {
 public:
  /// Holds the sheet, where it is viewed from unless that is far away, and what is seen up to
  /// far().
  DepthPlan(const camera::Lenticular& sheet, const camera::DepthSurvey& seen);

  /// The eyes are near enough to be drawn.
  bool has_eyes() const { return m_has_eyes; }
  double x(double scene) const { return kLeft + (scene - m_x0) * m_scale_x; }
  double y(double depth) const { return kTop + (m_far - depth) * m_scale_z; }
  double near() const { return m_near; }
  double far() const { return m_far; }
  double left() const { return m_x0; }
  double right() const { return m_x1; }
  double height() const { return (m_far - m_near) * m_scale_z; }
  double width() const { return (m_x1 - m_x0) * m_scale_x; }
  /// What of an outline is nearer than far().
  std::vector<camera::PlanPoint> cut(const std::vector<camera::PlanPoint>& outline) const;
  /// How much longer a unit of depth is drawn than one across.
  double stretch() const { return m_scale_z / m_scale_x; }

  static constexpr double kLeft = 70.0, kTop = 60.0, kWidth = 800.0;

 private:
  void choose_depths(const camera::Lenticular& sheet, const camera::DepthSurvey& seen);

  bool m_has_eyes = false;
  double m_x0 = 0.0, m_x1 = 1.0, m_near = -1.0, m_far = 1.0;
  double m_scale_x = 1.0, m_scale_z = 1.0;
};

/// Round numbers from one end to the other, some five of them.
std::vector<double> round_ticks(double from, double to);

}  // namespace lentray::tool
