// What a lens sheet shows, by depth: its nearest and farthest visible point, and how deep each object
// lies. Depths are scene units behind the sheet, negative before it. A pass (core/pass/pass.h).
//
// A picture of at most twice kSurveyRays pixels is looked at pixel by pixel. Of a larger one a grid of its
// pixels is looked at, in several views. From the nearest and the farthest of them a search goes on to
// nearer and farther pixels beside them, down to single ones. What lies between the grid's rays
// and next to none of these may be missed. The same sheet and scene give the same survey.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "camera/lenticular.h"
#include "camera/scene_probe.h"
#include "core/base/bounds.h"
#include "core/pass/pass.h"

namespace lentray::camera {

inline constexpr std::uint64_t kSurveyRays = std::uint64_t{1} << 18;

/// A place seen from above: `x` scene units to the right of the sheet's middle.
struct PlanPoint {
  double x = 0.0, depth = 0.0;
  bool operator==(const PlanPoint&) const = default;
};

/// All that has one name: an object, or those that one statement made.
struct SeenObject {
  std::string name;
  double nearest = core::Bounds::kInf, farthest = -core::Bounds::kInf;
  double share = 0.0;              ///< of the picture
  std::vector<PlanPoint> outline;  ///< convex, about what was met of it
};

struct DepthSurvey {
  double nearest = core::Bounds::kInf, farthest = -core::Bounds::kInf;
  /// Depths that leave out the nearest and the farthest twentieth of the pixels that show an object.
  double near_part = 0.0, far_part = 0.0;
  /// Parallax of what was met, between the neighbouring views that met it: pixels of a view.
  double least_step = core::Bounds::kInf, most_step = -core::Bounds::kInf;
  double background = 0.0;          ///< share of the picture where rays meet nothing
  std::vector<SeenObject> objects;  ///< the nearest first
  std::uint64_t rays = 0;
  bool is_whole = false;  ///< every pixel was looked at

  bool has_points() const { return nearest <= farthest; }
  /// The most parallax either way; 0 without points.
  double largest_step() const {
    return has_points() ? std::max(std::fabs(least_step), std::fabs(most_step)) : 0.0;
  }
};

class DepthSurveyPass final : public core::Pass {
 public:
  /// `probe` is asked by many threads; the sheet and it outlive the pass.
  DepthSurveyPass(const Lenticular& sheet, const SceneProbe& probe,
                  std::uint64_t most_rays = kSurveyRays)
      : m_sheet(sheet), m_probe(probe), m_most(most_rays) {}
  std::string name() const override { return "depth survey"; }
  double work() const override;
  void run(core::PassRun& run) override;
  const DepthSurvey& result() const { return m_result; }

 private:
  const Lenticular& m_sheet;
  const SceneProbe& m_probe;
  const std::uint64_t m_most;
  DepthSurvey m_result;
};

/// The pass alone, on the probe's threads.
DepthSurvey survey_depth(const Lenticular& sheet, const SceneProbe& probe,
                         std::uint64_t most_rays = kSurveyRays);

/// The corners of the smallest convex polygon about the points, in order.
std::vector<PlanPoint> convex_outline(std::vector<PlanPoint> points);

}  // namespace lentray::camera
