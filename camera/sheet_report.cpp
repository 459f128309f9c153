#include "camera/sheet_report.h"

#include <algorithm>
#include <cmath>

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

std::string parallax_text(const Lenticular& sheet, double step) {
  if (!std::isfinite(step)) return "at the eyes, which is no parallax";
  const double sweep = step * (sheet.sheet().lens().pixels - 1.0);
  return "parallax " + format(step) + " pixels a view, " + format(sweep) + " over all views";
}

std::string parallax_line(const Lenticular& sheet, const char* which, double depth) {
  return std::string(which) + " visible point " + format(std::fabs(depth)) +
         (depth < 0.0 ? " before" : " behind") +
         " the sheet: " + parallax_text(sheet, parallax(sheet, depth));
}

/// "48 x 36 mm (1.89 x 1.417 in)".
std::string size_text(double width, double height) {
  return format(width) + " x " + format(height) + " mm (" + format(width / 25.4) + " x " +
         format(height / 25.4) + " in)";
}

/// What a lens and its model are worth.
std::vector<std::string> lens_lines(const Lenticular& sheet) {
  const LensSheet& columns = sheet.sheet();
  const LensParameters& lens = columns.lens();
  std::vector<std::string> out;
  out.push_back("Lens pitch " + format(lens.pitch) + " mm, focal length " +
                format(lens.focal_length) + " mm, index " + format(lens.ior) + ", model " +
                name_of(lens.model) + ", viewing distance " +
                (lens.is_finite() ? format(lens.view_distance) + " mm" : "infinite"));
  out.push_back("Paraxial rays are off Snell's law by at most " + format(columns.paraxial_error()) +
                " pixels of the print; the cheapest model within " + format(kModelTolerance) +
                " pixels is " + name_of(columns.cheapest_model(kModelTolerance)));
  for (std::string& line : sheet.model_report()) out.push_back(std::move(line));
  return out;
}

std::vector<std::string> depth_lines(const Lenticular& sheet, const SceneProbe& probe) {
  const LensParameters& lens = sheet.sheet().lens();
  const DepthRange range = visible_depths(sheet, probe);
  std::vector<std::string> out;
  if (range.nearest <= range.farthest) {
    out.push_back(parallax_line(sheet, "Nearest", range.nearest));
    out.push_back(parallax_line(sheet, "Farthest", range.farthest));
  }
  if (range.open) {
    out.push_back("Background, infinitely far: " +
                  (lens.is_finite() ? parallax_text(sheet, parallax(sheet, core::Bounds::kInf))
                                    : std::string("it moves along with the eye")));
  }
  return out;
}

}  // namespace

double parallax(const Lenticular& sheet, double depth) {
  const LensParameters& lens = sheet.sheet().lens();
  const double step = lens.ior * lens.pixel_size() / lens.focal_length;  // slope a view
  if (std::isinf(depth)) return step * lens.view_distance / lens.pitch;
  const double behind = depth / sheet.scale();  // mm
  return step * behind / (1.0 + behind / lens.view_distance) / lens.pitch;
}

std::vector<std::string> report_of(const Lenticular& sheet, const SceneProbe& probe) {
  const LensParameters& lens = sheet.sheet().lens();
  std::vector<std::string> out;
  out.push_back("Lens sheet " +
                size_text(sheet.sheet().sheet_width(), sheet.placement().height / sheet.scale()) +
                ", " + format(sheet.sheet().lenses()) + " lenses, " +
                format(lens.lenses_per_inch()) + " lpi, " + format(lens.pixels) + " pixels a lens");
  out.push_back("Print " + size_text(sheet.print_width(), sheet.print_height()) + ", " +
                format(sheet.print_dpi_x()) + " x " + format(sheet.print_dpi_y()) + " ppi, pitch " +
                format(lens.print_pitch()) + " mm");
  for (std::string& line : lens_lines(sheet)) out.push_back(std::move(line));
  if (!probe) return out;
  for (std::string& line : depth_lines(sheet, probe)) out.push_back(std::move(line));
  return out;
}

}  // namespace lentray::camera
