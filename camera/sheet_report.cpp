#include "camera/sheet_report.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "camera/text.h"
#include "core/base/bounds.h"

namespace lentray::camera {
namespace {

using core::Vec3;

struct DepthRange {
  double nearest = core::Bounds::kInf, farthest = -core::Bounds::kInf;
  bool open = false;  ///< some rays meet nothing
};

/// Depths behind the sheet of what a coarse grid of the sheet's own rays meets.
DepthRange visible_depths(const Lenticular& sheet, const SceneProbe& probe) {
  constexpr int kAcross = 48, kDown = 36;
  DepthRange range;
  for (int down = 0; down < kDown; ++down) {
    for (int across = 0; across < kAcross; ++across) {
      core::Ray ray;
      const double column = std::floor((across + 0.5) * sheet.width() / kAcross) + 0.5;
      const double row = std::floor((down + 0.5) * sheet.height() / kDown) + 0.5;
      if (!sheet.ray(column, row, ray)) continue;
      const auto hit = probe(ray, core::Bounds::kInf);
      if (!hit) {
        range.open = true;
        continue;
      }
      const Vec3 from_sheet = ray.at(hit->distance) - sheet.placement().centre;
      const double depth = core::dot(from_sheet, sheet.placement().normal);
      range.nearest = std::min(range.nearest, depth);
      range.farthest = std::max(range.farthest, depth);
    }
  }
  return range;
}

std::string parallax_line(const Lenticular& sheet, const char* which, double depth) {
  const double step = parallax(sheet, depth);
  const double sweep = step * (sheet.sheet().lens().pixels - 1.0);
  return std::string(which) + " visible point " + format(std::fabs(depth)) +
         (depth < 0.0 ? " before" : " behind") + " the sheet: parallax " + format(step) +
         " pixels a view, " + format(sweep) + " over all views";
}

/// Objects that a segment meets.
void collect(const SceneProbe& probe, const Vec3& from, const Vec3& to, std::set<std::string>& out) {
  const core::Ray ray{from, to - from};
  if (const auto hit = probe(ray, 1.0)) out.insert(hit->object);
}

std::string listed(const std::set<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

}  // namespace

double parallax(const Lenticular& sheet, double depth) {
  const LensParameters& lens = sheet.sheet().lens();
  const double step = lens.ior * lens.pixel_size() / lens.focal_length;  // slope a view
  const double behind = depth / sheet.scale();                          // mm
  return step * behind / (1.0 + behind / lens.view_distance) / lens.pitch;
}

std::vector<std::string> report_of(const Lenticular& sheet, const SceneProbe& probe) {
  const LensParameters& lens = sheet.sheet().lens();
  std::vector<std::string> out;
  out.push_back("Lens sheet " + format(sheet.sheet().sheet_width()) + " x " +
                format(sheet.placement().height / sheet.scale()) + " mm, " +
                format(sheet.sheet().lenses()) + " lenses, " + format(lens.lenses_per_inch()) +
                " lpi, " + format(lens.pixels) + " pixels a lens");
  out.push_back("Print " + format(sheet.print_width()) + " x " + format(sheet.print_height()) +
                " mm, " + format(sheet.print_dpi_x()) + " x " + format(sheet.print_dpi_y()) +
                " pixels an inch, pitch " + format(lens.print_pitch()) + " mm");
  out.push_back("Lens pitch " + format(lens.pitch) + " mm, focal length " +
                format(lens.focal_length) + " mm, index " + format(lens.ior) + ", model " +
                name_of(lens.model) + ", viewing distance " +
                (lens.is_finite() ? format(lens.view_distance) + " mm" : "infinite"));
  if (lens.is_finite() && lens.model == LensModel::kPinhole) {
    out.push_back("Rays miss the eyes of their views by at most " +
                  format(sheet.sheet().largest_eye_miss()) + " pixels (Snell's law)");
  }
  if (!probe) return out;
  const DepthRange range = visible_depths(sheet, probe);
  if (range.nearest <= range.farthest) {
    out.push_back(parallax_line(sheet, "Nearest", range.nearest));
    out.push_back(parallax_line(sheet, "Farthest", range.farthest));
  }
  return out;
}

std::vector<std::string> collisions_of(const Lenticular& sheet, const SceneProbe& probe) {
  std::vector<std::string> out;
  if (!probe) return out;
  const SheetPlacement& place = sheet.placement();
  const LensParameters& lens = sheet.sheet().lens();

  constexpr int kLines = 24;
  const Vec3 across = place.right * place.width, down = place.up * place.height;
  std::set<std::string> cut;
  for (int i = 0; i < kLines; ++i) {
    const double at = (i + 0.5) / kLines - 0.5;
    collect(probe, place.centre - across * 0.5 + down * at, place.centre + across * 0.5 + down * at,
            cut);
    collect(probe, place.centre + across * at - down * 0.5, place.centre + across * at + down * 0.5,
            cut);
  }
  if (!cut.empty()) {
    out.push_back("the lens sheet cuts an object (" + listed(cut) +
                  "): it will show partly before and partly behind the sheet");
  }

  if (!lens.is_finite()) return out;
  const double distance = lens.view_distance * sheet.scale();
  const Vec3 eye = place.centre - (place.normal + place.right * place.eye_slope_x +
                                   place.up * place.eye_slope_y) * distance;
  const double reach = lens.ior * lens.print_pitch() / (2.0 * lens.focal_length) *
                       (1.0 - 1.0 / lens.pixels) * distance;
  std::set<std::string> met;
  collect(probe, eye - place.right * reach, eye + place.right * reach, met);
  collect(probe, eye + place.right * reach, eye - place.right * reach, met);
  if (!met.empty()) {
    out.push_back("the eyes of the views, " + format(reach) +
                  " scene units to either side of the camera, run into an object (" + listed(met) +
                  ")");
  }
  return out;
}

}  // namespace lentray::camera
