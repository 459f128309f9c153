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

double most_parallax(const Lenticular& sheet, const DepthSurvey& seen) {
  if (!seen.has_points()) return 0.0;
  return std::max(std::fabs(largest_parallax(sheet, seen.nearest)),
                  std::fabs(largest_parallax(sheet, seen.farthest)));
}

std::string budget_text(const DepthBudget& budget, double pixels) {
  return "Depth_Budget " + format(budget.value) +
         (budget.is_mm ? " mm, which is " + brief(pixels) + " pixels a view" : " pixels a view");
}

/// The factor with which that is seen keeps `pixels`. With Snell's law, views that are closer together
/// are also more evenly apart, so that a few steps are needed.
double factor_for(double pixels, LensParameters lens, const DepthSurvey& seen,
                  const SheetMaker& make) {
  constexpr int kSteps = 8;
  const bool is_linear = lens.model == LensModel::kParaxial;
  if (!is_linear) lens.model = LensModel::kPinhole;  // the middle ray of a thick lens is that one's
  for (int i = 0; i < kSteps && lens.depth_factor >= kLeastFactor; ++i) {
    const double most = most_parallax(*make(lens), seen);
    lens.depth_factor *= pixels / most;
    if (is_linear || std::fabs(most / pixels - 1.0) < 1e-6) break;
  }
  return lens.depth_factor;
}

/// What of the sky: it is not counted.
std::string sky_line(const Lenticular& sheet, double budget) {
  if (!sheet.sheet().lens().is_finite()) {
    return "The background is not within the budget: it is infinitely far and moves along with the "
           "eye";
  }
  const double step = largest_parallax(sheet, core::Bounds::kInf);
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
  double most = most_parallax(*sheet, seen);
  const double before = most;
  for (int i = 0; i < kTries && most > pixels; ++i) {
    // A little less, for rounding and for what lies between the rays of a survey.
    const double margin = seen.is_whole ? 2e-6 : 2e-3;
    tried.depth_factor = factor_for(pixels * (1.0 - margin), tried, seen, make);
    if (!(tried.depth_factor >= kLeastFactor)) {
      throw CameraError(
          budget_text(budget, pixels) + ": depth would be nothing, for a visible point moves by " +
          (std::isfinite(before) ? brief(before) + " pixels a view" : "more than can be told") +
          "; a larger budget, or for points near to the eyes Lens_Front, helps");
    }
    sheet = make(tried);
    seen = survey_depth(*sheet, probe);
    most = most_parallax(*sheet, seen);
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
