#include "camera/composition_report.h"

#include <algorithm>
#include <cmath>

#include "camera/depth_budget.h"
#include "camera/parallax.h"
#include "camera/text.h"
#include "core/base/bounds.h"

namespace lentray::camera {
namespace {

/// A share that is seen at once; what has less does not decide how deep a print looks.
constexpr double kNoticed = 0.05;

std::string percent(double part) { return brief(std::round(1e3 * part) / 10.0) + " %"; }

/// What of the picture moves by how much from view to view.
class Moves {
 public:
  Moves(const Lenticular& sheet, const DepthSurvey& seen) : m_sheet(sheet), m_seen(seen) {}

  double of(double depth) const { return parallax(m_sheet, depth); }
  double background() const {
    return m_seen.background > 0.0 && m_sheet.has_near_eye() ? of(core::Bounds::kInf) : 0.0;
  }
  double largest() const { return std::max(m_seen.largest_step(), background()); }
  /// From the nearest to the farthest of all, or of nine tenths of the picture.
  DistanceRange all() const {
    DistanceRange out{m_seen.least_step, m_seen.most_step};
    if (m_seen.background > 0.0) out.add({background(), background()});
    return out;
  }
  DistanceRange most() const {
    if (!m_seen.has_points()) return all();
    DistanceRange out{of(m_seen.near_part), of(m_seen.far_part)};
    if (m_seen.background > kNoticed) out.add({background(), background()});
    return out;
  }
  /// How deep behind the sheet an eye at the viewing distance sees what moves so, in mm.
  double apparent(double step) const {
    const LensParameters& lens = m_sheet.sheet().lens();
    const double straight = lens.ior / lens.focal_length;
    const ParallaxRule true_depth = parallax_rule(lens, lens.view_distance, 1.0, straight);
    const double under = true_depth.step - step * true_depth.turn;
    return under > 0.0 ? step / under : core::Bounds::kInf;
  }

 private:
  const Lenticular& m_sheet;
  const DepthSurvey& m_seen;
};

std::string names_of(std::vector<const SeenObject*> objects) {
  constexpr std::size_t kMost = 3;
  std::ranges::stable_sort(objects,
                           [](const auto* a, const auto* b) { return a->share > b->share; });
  std::string out;
  for (std::size_t i = 0; i < std::min(objects.size(), kMost); ++i)
    out += (i > 0 ? ", " : "") + objects[i]->name;
  if (objects.size() > kMost) out += " and " + std::to_string(objects.size() - kMost) + " more";
  return out;
}

std::string why_there(const CompositionRequest& asked, const Composition& composed) {
  if (asked.distance) return "as Sheet_Distance asks";
  if (!asked.sheet_at.empty()) return "as Sheet_At=" + asked.sheet_at + " asks";
  if (asked.mode == DepthMode::kScene) return "where the camera looks";
  if (composed.depths.points.is_empty()) return "for nothing is visible";
  return asked.depths ? "where it shows most of all frames" : "where it shows most";
}

std::string plane_line(const CompositionRequest& asked, const Composition& composed) {
  std::vector<const SeenObject*> there;
  for (const SeenObject& object : composed.seen.objects)
    if (object.nearest <= 0.0 && object.farthest >= 0.0) there.push_back(&object);
  return "In the sheet's plane, " + format(composed.distance) + " from the camera (" +
         why_there(asked, composed) + "): " + (there.empty() ? "nothing" : names_of(there));
}

/// "12 mm before and 8.3 mm behind the sheet".
std::string range_text(const Moves& moves, const DistanceRange& steps) {
  const double before = -moves.apparent(steps.nearest), behind = moves.apparent(steps.farthest);
  const std::string back =
      std::isfinite(behind) ? brief(std::fabs(behind)) + " mm" : "infinitely far";
  if (before < 0.0) return "from " + brief(-before) + " mm to " + back + " behind the sheet";
  if (behind < 0.0) return "from " + brief(before) + " mm to " + back + " before the sheet";
  return brief(before) + " mm before and " + back + " behind the sheet";
}

std::string depth_line(const CompositionRequest& asked, const Moves& moves,
                       const Composition& composed) {
  if (moves.all().is_empty()) return "Depth: nothing is visible";
  return "Depth: " + range_text(moves, moves.all()) + ", nine tenths of the picture " +
         range_text(moves, moves.most()) + "; " +
         (composed.factor < 1.0 ? percent(composed.factor) + " of the true depth"
                                : std::string("true depth")) +
         (composed.is_held ? ", with more an eye would be in " + asked.in_the_way : "");
}

/// What jumps; empty: nothing.
std::string jumping_text(const CompositionRequest& asked, const DepthSurvey& seen,
                         const Moves& moves) {
  const auto jumps = [most = asked.most_parallax * (1.0 + 1e-6)](double step) {
    return !(std::fabs(step) <= most);
  };
  std::vector<const SeenObject*> objects;
  for (const SeenObject& object : seen.objects)
    if (jumps(moves.of(object.nearest)) || jumps(moves.of(object.farthest)))
      objects.push_back(&object);
  std::string out = names_of(objects);
  if (jumps(moves.background()))
    return out + (out.empty() ? "" : ", ") + std::string("the background");
  return out.empty() && jumps(moves.largest()) ? "what outer views show" : out;
}

std::string jump_line(const Lenticular& sheet, const std::string& jumping, const DepthSurvey& seen,
                      const Moves& moves) {
  std::string out = "Jumps: " + jumping;
  if (jumping.empty())
    out += "none, things move by " + brief(moves.largest()) + " pixels a view at most";
  if (seen.background > 0.0 && !sheet.has_near_eye())
    out += "; the background is infinitely far and moves along with the eye";
  return out;
}

/// What will be seen to be wrong.
std::string jump_warning(const CompositionRequest& asked, const std::string& jumping,
                         const Moves& moves) {
  const std::string out = "jumps: " + jumping + ", by up to " + brief(moves.largest()) +
                          " pixels a view, an eye sees that beyond " + brief(asked.most_parallax) +
                          ": ";
  if (asked.depths)
    return out +
           "the first, the middle and the last frame do not show it; a smaller Depth_Budget helps";
  return out + (asked.budget ? "a smaller Depth_Budget" : "Depth=print, or a Depth_Budget,") +
         " helps";
}

/// Why most of the picture is at nearly one depth, though depth is compressed.
std::string flat_warning(const Composition& composed, const Moves& moves) {
  const DistanceRange all = moves.all(), most = moves.most();
  std::string out = "flat: nine tenths of the picture lie " + range_text(moves, most) +
                    ", for depth is compressed to " + percent(composed.factor);
  const SeenObject* decides = nullptr;
  for (const SeenObject& object : composed.seen.objects)
    if (object.nearest == composed.seen.nearest) decides = &object;
  if (decides && most.nearest - all.nearest >= all.farthest - most.farthest) {
    out += ": " + decides->name + " is much nearer, " + percent(decides->share) + " of the picture";
  } else {
    out += ": what is far away takes the rest";
  }
  return out +
         ". A scene without that, a larger Depth_Budget, which lets it jump, more pixels a lens or "
         "thicker "
         "lenses help";
}

}  // namespace

CompositionText composition_text(const Lenticular& sheet, const CompositionRequest& asked,
                                 const Composition& composed) {
  constexpr double kFlat = 0.1;  // of the budget, both ways
  const DepthSurvey& seen = composed.seen;
  const Moves moves(sheet, seen);
  const std::string jumping = jumping_text(asked, seen, moves);
  CompositionText out;
  out.lines = {plane_line(asked, composed), depth_line(asked, moves, composed),
               jump_line(sheet, jumping, seen, moves)};
  if (!jumping.empty()) out.warnings.push_back(jump_warning(asked, jumping, moves));
  const DistanceRange most = moves.most();
  if (!asked.depths && composed.factor < 1.0 && !most.is_empty() &&
      most.farthest - most.nearest < kFlat * 2.0 * asked.most_parallax) {
    out.warnings.push_back(flat_warning(composed, moves));
  }
  return out;
}

}  // namespace lentray::camera
