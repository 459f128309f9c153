#include "tools/session/depth_plan.h"

#include <algorithm>
#include <cmath>

#include "camera/parallax.h"
#include "camera/sheet_report.h"

namespace lentray::tool {

using camera::PlanPoint;

ViewingPlan viewing_plan(const camera::Lenticular& sheet) {
  camera::LensParameters lens = sheet.sheet().lens();
  ViewingPlan out;
  const double distance = sheet.eye_distance();
  out.depth = -distance;
  out.middle = -sheet.placement().eye_slope_x * distance;
  out.eyes_apart = camera::kEyesApart * sheet.eye_scale();
  const double cosine = lens.slant_cosine();  // eyes lie on a level line, slanted lenses do not
  const std::uint32_t views = camera::usual_views(sheet.sheet());
  const std::int64_t lens_number = sheet.sheet().lens_count() / 2;
  for (std::uint32_t j = 0; j < views; ++j) {
    const std::int64_t k = camera::view_column(lens.pixels, j, views, lens_number);
    if (k >= sheet.sheet().width()) continue;
    const camera::LensColumn& column = sheet.sheet().column(static_cast<std::uint32_t>(k));
    if (!column.dark) {
      const double slope = sheet.scene_slope(column);
      out.viewpoints.push_back((column.axis * sheet.scale() - distance * slope) / cosine);
    }
  }
  lens.model = camera::LensModel::kPinhole;  // what real lenses do
  double edge = 0.0;
  if (camera::slope_of(lens, 0.5 * lens.print_pitch(), edge)) {
    const auto& eye = sheet.placement().eye;
    out.zone = 2.0 * distance * edge / cosine * (eye ? eye->factor : 1.0);
  }
  return out;
}

DepthPlan::DepthPlan(const camera::Lenticular& sheet, const camera::DepthSurvey& seen) {
  choose_depths(sheet, seen);
  const double half = 0.5 * sheet.placement().width;
  m_x0 = -half;
  m_x1 = half;
  const auto include = [this](double at) {
    m_x0 = std::min(m_x0, at);
    m_x1 = std::max(m_x1, at);
  };
  for (const camera::SeenObject& object : seen.objects) {
    for (const PlanPoint& p : cut(object.outline)) include(p.x);
  }
  if (m_has_eyes) {
    const ViewingPlan viewing = viewing_plan(sheet);
    for (const double side : {-0.5, 0.5}) {
      include(viewing.middle + side * viewing.zone);
      include(viewing.middle + side * viewing.eyes_apart);
    }
    for (const double at : viewing.viewpoints) include(at);
  }
  const double margin = 0.03 * (m_x1 - m_x0);
  m_x0 -= margin;
  m_x1 += margin;
  m_scale_x = kWidth / (m_x1 - m_x0);
  constexpr double kLowest = 300.0, kHighest = 760.0;
  const double range = m_far - m_near;
  m_scale_z = std::clamp(m_scale_x * range, kLowest, kHighest) / range;
}

void DepthPlan::choose_depths(const camera::Lenticular& sheet, const camera::DepthSurvey& seen) {
  const camera::SheetPlacement& place = sheet.placement();
  const camera::DepthInterval sharp = camera::depths_within(sheet, camera::kSharpParallax);
  const double size = std::max(place.width, place.height), most = 1.5 * size;
  m_near = std::max(sharp.nearest, -0.5 * size);
  m_far = std::min(sharp.farthest, 0.5 * size);
  if (seen.has_points()) {
    m_near = std::min(m_near, std::max(seen.nearest, -most));
    m_far = std::max(m_far, std::min(seen.farthest, most));
  }
  m_has_eyes = sheet.has_near_eye() && sheet.eye_distance() <= 3.0 * size;
  if (m_has_eyes) m_near = std::min(m_near, -sheet.eye_distance());
  const double margin = 0.05 * (m_far - m_near);
  m_near -= margin;
  m_far += margin;
}

std::vector<PlanPoint> DepthPlan::cut(const std::vector<PlanPoint>& outline) const {
  std::vector<PlanPoint> out;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanPoint &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if (a.depth <= m_far) out.push_back(a);
    if ((a.depth <= m_far) == (b.depth <= m_far)) continue;
    const double part = (m_far - a.depth) / (b.depth - a.depth);
    out.push_back({a.x + part * (b.x - a.x), m_far});
  }
  return out;
}

std::vector<double> round_ticks(double from, double to) {
  const double rough = (to - from) / 5.0;
  const double ten = std::pow(10.0, std::floor(std::log10(rough)));
  const double step = ten * (rough < 2.0 * ten ? 2.0 : rough < 5.0 * ten ? 5.0 : 10.0);
  std::vector<double> out;
  for (double i = std::ceil(from / step); i * step <= to; i += 1.0)
    out.push_back(i * step + 0.0);  // no -0
  return out;
}

}  // namespace lentray::tool
