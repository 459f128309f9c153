#include "camera/depth_budget.h"

#include <algorithm>
#include <cmath>

#include "camera/depth_survey.h"
#include "camera/parallax.h"
#include "camera/text.h"
#include "core/base/bounds.h"

namespace lentray::camera {
namespace {

/// A factor below it is none that anybody wants.
constexpr double kLeastFactor = 1e-6;

std::string budget_text(const DepthBudget& budget, double pixels) {
  return "Depth_Budget " + format(budget.value) +
         (budget.is_mm ? " mm, which is " + brief(pixels) + " pixels a view" : " pixels a view");
}

/// Why no factor will do, of points that move by so much without one.
std::string trouble(const LensParameters& lens, double step) {
  if (std::isfinite(step)) {
    return "depth would be nothing, for a visible point moves by " + brief(step) +
           " pixels a view; a larger budget, or for points near to the eyes Lens_Front, helps";
  }
  return std::string("with the lens model ") + name_of(lens.model) + " and an eye as near as " +
         brief(lens.view_distance) +
         " mm, rays of neighbouring views part before a visible point; a larger View_Distance, "
         "Lens_Model=paraxial or Lens_Front helps";
}

/// What of the sky: it is not counted.
std::string sky_line(const Lenticular& sheet, double budget) {
  if (!sheet.has_near_eye()) {
    return "The background is not within the budget: it is infinitely far and moves along with the "
           "eye";
  }
  const double step = parallax(sheet, core::Bounds::kInf);
  if (step <= budget)
    return "The background is within the budget: " + brief(step) + " pixels a view";
  return "The background is not within the budget: it moves by " + brief(step) + " pixels a view";
}

}  // namespace

double budget_pixels(const DepthBudget& budget, const LensParameters& lens) {
  return budget.is_mm ? budget.value / lens.print_pitch() : budget.value;
}

FittedDepth fit_depth(const DepthBudget& budget, const LensParameters& lens, const SheetMaker& make,
                      const SceneProbe& probe) {
  constexpr int kTries = 8;
  const double pixels = budget_pixels(budget, lens);
  FittedDepth out;
  LensParameters tried = lens;
  std::unique_ptr<Lenticular> sheet = make(tried);
  DepthSurvey seen = survey_depth(*sheet, probe);
  double most = seen.largest_step();
  const double before = most;
  // With Snell's law views that are closer together are also more evenly apart, so that the first factor
  // is too small.
  const auto is_fit = [&] {
    const bool is_tight =
        lens.model == LensModel::kParaxial || tried.depth_factor == 1.0 || most >= 0.99 * pixels;
    return most <= pixels && is_tight;
  };
  for (int i = 0; i < kTries && !is_fit(); ++i) {
    // A little less, for rounding and for what lies between the rays of a survey.
    const double margin = seen.is_whole ? 2e-6 : 5e-3;
    tried.depth_factor = std::min(1.0, tried.depth_factor * pixels / most * (1.0 - margin));
    if (!(tried.depth_factor >= kLeastFactor)) {
      throw CameraError(budget_text(budget, pixels) + ": " + trouble(lens, before),
                        {"Depth_Budget", "View_Distance", "Lens_Model", kCameraToo});
    }
    sheet = make(tried);
    seen = survey_depth(*sheet, probe);
    most = seen.largest_step();
  }
  out.factor = tried.depth_factor;
  const std::string text = budget_text(budget, pixels);
  if (!seen.has_points()) {
    out.report.push_back(text + ": no point of an object is visible");
  } else if (out.factor == 1.0) {
    out.report.push_back(text + ": visible points move by " + brief(most) +
                         " at most, so that depth stays as it is");
  } else {
    out.report.push_back(text + ": depth is compressed to " + brief(100.0 * out.factor) +
                         " %: visible points move by " + brief(most) + " at most instead of " +
                         brief(before));
  }
  if (seen.background > 0.0) out.report.push_back(sky_line(*sheet, pixels));
  return out;
}

}  // namespace lentray::camera
