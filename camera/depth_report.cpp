#include "camera/depth_report.h"

#include <algorithm>
#include <cmath>

#include "camera/composition.h"
#include "camera/parallax.h"
#include "camera/text.h"
#include "core/base/bounds.h"

namespace lentray::camera {
namespace {

using Lines = std::vector<std::string>;

std::string steps_text(double step) {
  return std::isfinite(step) ? brief(step) : std::string(step < 0.0 ? "-inf" : "inf");
}

/// "1.2 pixels a view, 0.76 mm on the print".
std::string parallax_words(const Lenticular& sheet, double step) {
  if (!std::isfinite(step)) return "without limit";
  return brief(step) + " pixels a view, " + brief(step * sheet.sheet().lens().print_pitch()) +
         " mm on the print";
}

std::string depth_words(double depth) {
  if (std::isinf(depth)) return "infinitely far";
  return brief(std::fabs(depth)) + (depth < 0.0 ? " before" : " behind");
}

std::string point_line(const Lenticular& sheet, const char* which, double depth) {
  return std::string(which) + " visible point " + depth_words(depth) + " the sheet: parallax " +
         parallax_words(sheet, parallax(sheet, depth));
}

/// Less than a tenth of a percent is still something.
std::string share_text(double share) {
  return share > 0.0 && share < 0.001 ? "less than 0.1 %"
                                      : brief(std::round(1e3 * share) / 10.0) + " %";
}

std::string background_line(const Lenticular& sheet, double share) {
  const std::string out = "Background, " + share_text(share) + " of the picture: ";
  if (!sheet.has_near_eye()) {
    return out + "infinitely far, so that it moves along with the eye";
  }
  return out + "parallax " + parallax_words(sheet, parallax(sheet, core::Bounds::kInf));
}

/// With Snell's law outer views are farther apart than those in the middle.
void add_outer_views(const Lenticular& sheet, const DepthSurvey& seen, Lines& out) {
  if (sheet.sheet().lens().model == LensModel::kParaxial) return;
  const double most = seen.largest_step();
  if (!std::isfinite(most)) return;
  out.push_back("Between outer views, which Snell's law draws apart, parallax is up to " +
                brief(most) + " pixels a view");
}

std::string range_text(const DepthInterval& range) {
  return "from " + brief(-range.nearest) + " before the sheet to " +
         (std::isinf(range.farthest) ? "infinity" : brief(range.farthest) + " behind it");
}

void add_ranges(const Lenticular& sheet, Lines& out) {
  const LensParameters& lens = sheet.sheet().lens();
  const double mm = 2.0 * lens.pixels * lens.focal_length / lens.ior / sheet.depth_factor();
  out.push_back("Sharp, up to 1 pixel a view: " + range_text(depths_within(sheet, kSharpParallax)) +
                " (2 N t/n = " + brief(mm) + " mm" +
                (sheet.has_near_eye() ? ", seen from afar" : "") + ")");
  out.push_back("Without jumps, up to " + brief(kMostParallax) +
                " pixels a view: " + range_text(depths_within(sheet, kMostParallax)));
}

std::string survey_line(const Lenticular& sheet, const DepthSurvey& seen) {
  const std::string pixels =
      std::to_string(std::uint64_t{sheet.width()} * sheet.height()) + " pixels";
  return seen.is_whole ? "Found with a ray through each of " + pixels
                       : "Found with " + std::to_string(seen.rays) + " rays of " + pixels;
}

/// "4.1 to 5.2 from the camera (Sheet_Distance=4.6), ".
std::string distance_text(const std::optional<SheetStand>& stand, const SeenObject& object) {
  if (!stand) return {};
  const double now = stand->distance * stand->along;
  const DistanceRange range{now + object.nearest, now + object.farthest};
  const auto middle = balanced_distance({range, false, {}}, stand->grows);
  return brief(range.nearest) + " to " + brief(range.farthest) +
         " from the camera (Sheet_Distance=" + brief(middle.value_or(now) / stand->along) + "), ";
}

void add_objects(const Lenticular& sheet, const std::optional<SheetStand>& stand,
                 const DepthSurvey& seen, Lines& out) {
  constexpr std::size_t kMost = 30;
  if (seen.objects.empty()) return;
  out.push_back("Objects, the nearest first:");
  for (std::size_t i = 0; i < std::min(seen.objects.size(), kMost); ++i) {
    const SeenObject& object = seen.objects[i];
    const double near = parallax(sheet, object.nearest), far = parallax(sheet, object.farthest);
    const double most = std::max(std::fabs(near), std::fabs(far));
    out.push_back("  " + object.name + ": " + distance_text(stand, object) + steps_text(near) +
                  " to " + steps_text(far) + " pixels a view, " + share_text(object.share) +
                  " of the picture" +
                  (most > kMostParallax    ? "; jumps"
                   : most > kSharpParallax ? "; not sharp all over"
                                           : ""));
  }
  if (seen.objects.size() > kMost)
    out.push_back("  and " + std::to_string(seen.objects.size() - kMost) + " more");
}

/// "Sheet_Distance=7.5 instead of 9: the nearest point would have -0.9, the farthest 0.9 pixels a view".
std::string stand_text(const std::optional<SheetStand>& stand, const BalancedStand& balanced) {
  const std::string figures = ": the nearest point would have " + brief(balanced.nearest_step) +
                              ", the farthest " + brief(balanced.farthest_step) + " pixels a view";
  if (!stand) {
    return "the camera's location moved by " + brief(balanced.moved) + " along its direction" +
           figures;
  }
  return "Sheet_Distance=" + format(balanced.distance) + " instead of " + format(stand->distance) +
         figures;
}

/// A place in the scene where less moves than where the sheet stands now.
bool is_better(const Lenticular& sheet, const std::optional<SheetStand>& stand, double nearest,
               double farthest, const BalancedStand& balanced) {
  constexpr double kNoticeably = 0.95;
  const double now =
      std::max(std::fabs(parallax(sheet, nearest)), std::fabs(parallax(sheet, farthest)));
  return (!stand || balanced.distance > 0.0) && balanced.farthest_step < kNoticeably * now;
}

void add_proposals(const Lenticular& sheet, const std::optional<SheetStand>& stand,
                   const DepthSurvey& seen, Lines& out) {
  const auto propose = [&](const char* what, double nearest, double farthest) {
    const auto balanced = balanced_stand(sheet, stand, nearest, farthest);
    if (balanced && is_better(sheet, stand, nearest, farthest, *balanced))
      out.push_back(what + stand_text(stand, *balanced));
  };
  propose("Proposed, for all that is visible: ", seen.nearest, seen.farthest);
  propose("For all but the nearest and the farthest twentieth of that: ", seen.near_part,
          seen.far_part);
  const bool jumps =
      seen.largest_step() > kMostParallax || (seen.background > 0.0 && sheet.has_near_eye() &&
                                              parallax(sheet, core::Bounds::kInf) > kMostParallax);
  if (jumps && stand)
    out.push_back("Depth=print compresses depth until nothing jumps, the background included");
}

}  // namespace

std::optional<BalancedStand> balanced_stand(const Lenticular& sheet,
                                            const std::optional<SheetStand>& stand, double nearest,
                                            double farthest) {
  if (!(nearest < farthest)) return std::nullopt;
  const bool grows = stand && stand->grows;
  const double now = stand ? stand->distance * stand->along : 0.0;
  const double from = now + nearest, to = now + farthest;
  const double eye = sheet.eye_distance();
  // The parallax of a depth from the camera if the sheet stood at `at`, in pixels of a view; a sheet
  // that grows has its eye and its millimetres grow along.
  const auto step = [&](double depth, double at) {
    const double growth = grows ? at / now : 1.0;
    const double same = (depth - at) / growth;  // the same depth in the scale of the present sheet
    return same > -eye ? parallax(sheet, same) : -core::Bounds::kInf;
  };
  double low = grows ? std::max(from, 0.0) : from, high = to;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (step(from, middle) + step(to, middle) > 0.0 ? low : high) = middle;
  }
  const double at = 0.5 * (low + high);
  BalancedStand out;
  out.moved = at - now;
  out.distance = stand ? at / stand->along : 0.0;
  out.nearest_step = step(from, at);
  out.farthest_step = step(to, at);
  if (!std::isfinite(out.nearest_step) || !std::isfinite(out.farthest_step)) return std::nullopt;
  return out;
}

std::vector<std::string> depth_report(const Lenticular& sheet,
                                      const std::optional<SheetStand>& stand,
                                      const DepthSurvey& seen) {
  Lines out;
  if (seen.has_points()) {
    out.push_back(point_line(sheet, "Nearest", seen.nearest));
    out.push_back(point_line(sheet, "Farthest", seen.farthest));
    add_outer_views(sheet, seen, out);
  } else {
    out.push_back("No point of an object is visible");
  }
  if (seen.background > 0.0) out.push_back(background_line(sheet, seen.background));
  if (const double factor = sheet.depth_factor(); factor != 1.0) {
    out.push_back("All of that with depth compressed to " + brief(100.0 * factor) + " %");
  }
  add_ranges(sheet, out);
  out.push_back(survey_line(sheet, seen));
  add_objects(sheet, stand, seen, out);
  add_proposals(sheet, stand, seen, out);
  return out;
}

}  // namespace lentray::camera
