#include "camera/composition.h"

#include <algorithm>
#include <cmath>

#include "camera/depth_budget.h"

namespace lentray::camera {
namespace {

/// What is so much farther away than the nearest point counts as infinitely far: that costs a tenth of the
/// depth, and what a survey missed beyond it does not jump.
constexpr double kFar = 10.0;
/// The part of the budget that is left for points between the rays of a survey.
constexpr double kSpare = 2.5e-2;
/// A sheet that stands nearer than that part of the distance to where it was surveyed shows the same.
constexpr double kNear = 0.05;
constexpr double kLeastDepth = 1e-6;

bool sees_far(const SceneDepths& seen) {
  return seen.has_background || seen.points.farthest > kFar * seen.points.nearest;
}

DistanceRange range_of(double nearest, double farthest, double distance) {
  return {nearest + distance, farthest + distance};
}

/// "Chair at a.pov:3:1" is called Chair, Chair at a.pov:3:1, and a.pov:3:1.
bool is_called(const std::string& object, const std::string& name) {
  const std::size_t at = object.find(" at ");
  if (object == name || object.substr(0, at) == name) return true;
  return at != std::string::npos && object.substr(at + 4) == name;
}

std::string list_of(const std::vector<const SeenObject*>& objects) {
  constexpr std::size_t kMost = 8;
  std::string out;
  for (std::size_t i = 0; i < std::min(objects.size(), kMost); ++i)
    out += (i > 0 ? ", " : "") + objects[i]->name;
  if (objects.size() > kMost) out += " and " + std::to_string(objects.size() - kMost) + " more";
  return out;
}

/// The one visible object of that name.
const SeenObject& object_called(const DepthSurvey& seen, const std::string& name) {
  std::vector<const SeenObject*> found, all;
  for (const SeenObject& object : seen.objects) {
    all.push_back(&object);
    if (is_called(object.name, name)) found.push_back(&object);
  }
  if (found.size() == 1) return *found.front();
  if (!found.empty()) {
    throw CameraError("Sheet_At=" + name + " may be any of " + list_of(found) +
                          ": give its place, FILE:LINE:COLUMN",
                      {"Sheet_At"});
  }
  std::ranges::stable_sort(all, [](const auto* a, const auto* b) { return a->share > b->share; });
  throw CameraError("Sheet_At=" + name + ": no visible object is called so" +
                        (all.empty() ? "" : "; there are " + list_of(all)),
                    {"Sheet_At"});
}

SceneDepths depths_of(const DepthSurvey& seen, double distance, const std::string& sheet_at) {
  SceneDepths out;
  out.has_background = seen.background > 0.0;
  if (seen.has_points()) out.points = range_of(seen.nearest, seen.farthest, distance);
  if (sheet_at.empty()) return out;
  const SeenObject& object = object_called(seen, sheet_at);
  out.named = range_of(object.nearest, object.farthest, distance);
  return out;
}

/// The same survey by a sheet that stands elsewhere: by how much depths behind it grow.
void shift(const Lenticular& sheet, double by, DepthSurvey& seen) {
  if (!seen.has_points()) return;
  const auto move = [by](auto&... depths) { ((depths += by), ...); };
  move(seen.nearest, seen.farthest, seen.near_part, seen.far_part);
  for (SeenObject& object : seen.objects) {
    move(object.nearest, object.farthest);
    for (PlanPoint& point : object.outline) {
      point.depth += by;
      point.x += by * sheet.placement().eye_slope_x;
    }
  }
  const ParallaxRule rule = parallax_rule(sheet, most_bend(sheet.sheet()));
  seen.least_step = rule.at(seen.nearest / sheet.scale());
  seen.most_step = rule.at(seen.farthest / sheet.scale());
}

double distance_of(const CompositionRequest& request, const SceneDepths& seen) {
  if (request.distance) return *request.distance;
  const bool is_perspective = request.is_perspective;
  if (!seen.named.is_empty()) return *balanced_distance({seen.named, false, {}}, is_perspective);
  if (request.mode == DepthMode::kScene) return request.usual_distance;
  return balanced_distance(seen, is_perspective).value_or(request.usual_distance);
}

/// Of the light from the edges of the strip behind the middle lens: no pixel's goes farther aside.
double outermost_slope(const LensParameters& lens) {
  const double offset = 0.5 * lens.print_pitch();
  double slope = 0.0;
  if (!slope_of(lens, offset, slope)) slope = lens.ior * offset / lens.focal_length;
  return slope / lens.slant_cosine();
}

/// Where the sheet is to stand, and the part of the depth that it may show.
Composition fitted(const CompositionRequest& request, const SceneDepths& seen,
                   const SheetAt& make) {
  Composition out;
  out.distance = distance_of(request, seen);
  if (!(out.distance > 0.0) && request.is_perspective) out.distance = request.usual_distance;
  const std::unique_ptr<Lenticular> sheet = make(out.distance, 1.0);
  const LensParameters& lens = sheet->sheet().lens();
  const double pixels =
      request.budget ? budget_pixels(*request.budget, lens) * (1.0 - kSpare) : core::Bounds::kInf;
  out.factor = largest_factor(seen, *sheet, out.distance, pixels);
  const double reach = out.distance * outermost_slope(lens);  // of the eyes, were depth true
  out.is_held = out.factor * reach > request.free_way;
  if (out.is_held) out.factor = request.free_way / reach;
  return out;
}

}  // namespace

void DistanceRange::add(const DistanceRange& other) {
  nearest = std::min(nearest, other.nearest);
  farthest = std::max(farthest, other.farthest);
}

void SceneDepths::add(const SceneDepths& other) {
  points.add(other.points);
  named.add(other.named);
  has_background = has_background || other.has_background;
}

std::optional<double> balanced_distance(const SceneDepths& seen, bool is_perspective) {
  const DistanceRange& points = seen.points;
  if (points.is_empty()) return std::nullopt;
  if (!is_perspective) return 0.5 * (points.nearest + points.farthest);
  if (sees_far(seen)) return 2.0 * points.nearest;
  return 2.0 * points.nearest * points.farthest / (points.nearest + points.farthest);
}

double largest_factor(const SceneDepths& seen, const Lenticular& sheet, double distance,
                      double pixels) {
  const LensParameters& lens = sheet.sheet().lens();
  const double bend = most_bend(sheet.sheet()), eye = sheet.eye_distance() / sheet.scale();
  const bool is_near = sheet.has_near_eye(), is_far = is_near && sees_far(seen);
  // A viewer's two eyes look in parallel directions at what is m D (1 - D/z) = V away.
  const double farthest = is_far ? core::Bounds::kInf : seen.points.farthest;
  const double part = seen.points.is_empty() && !is_far ? 0.0 : 1.0 - distance / farthest;
  const double reach = is_near ? eye * std::max(part, 0.0) : 0.0;
  const double most = reach > lens.view_distance ? lens.view_distance / reach : 1.0;
  const auto is_within = [&](double factor) {
    const ParallaxRule rule = parallax_rule(lens, eye, factor, bend);
    const auto moves = [&](double depth) { return std::fabs(rule.at(depth / sheet.scale())); };
    if (is_far && moves(core::Bounds::kInf) > pixels) return false;
    if (seen.points.is_empty()) return true;
    return moves(seen.points.nearest - distance) <= pixels &&
           moves(seen.points.farthest - distance) <= pixels;
  };
  if (is_within(most)) return most;
  constexpr int kHalvings = 60;
  double low = 0.0, high = most;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (is_within(middle) ? low : high) = middle;
  }
  return std::max(low, kLeastDepth);
}

Composition compose(const CompositionRequest& request, const SheetAt& make,
                    const SceneProbe& probe) {
  constexpr int kMostSurveys = 4;
  Composition out = fitted(request, request.depths.value_or(request.expected), make);
  for (int i = 0; i < kMostSurveys; ++i) {
    std::unique_ptr<Lenticular> sheet = make(out.distance, out.factor);
    out.seen = survey_depth(*sheet, probe, request.rays);
    out.depths = depths_of(out.seen, out.distance, request.depths ? "" : request.sheet_at);
    if (request.depths) break;
    const Composition next = fitted(request, out.depths, make);
    const double moved = out.distance - next.distance;
    out.distance = next.distance;
    out.factor = next.factor;
    out.is_held = next.is_held;
    if (std::fabs(moved) > kNear * next.distance) continue;
    shift(*make(out.distance, out.factor), moved, out.seen);
    break;
  }
  return out;
}

}  // namespace lentray::camera
