// How a sheet is composed: where it stands in a scene that is seen from its own camera, and how far apart the
// eyes of the views stand (camera/scene_eye.h), so that no visible point moves by more than a budget from one
// view to the next.
//
// A point at the distance z from the camera moves by a multiple of m (1 - D/z). The sheet that stands at the
// harmonic mean of the nearest and the farthest distance shows the most depth within a budget: both ends move by
// as much. The background is infinitely far and counts as well. Parallel rays (an orthographic camera)
// move points by a multiple of m (z - D): there D is the middle, and the background moves along with the eye.
//
// Distances are scene units from the camera along the sheet's normal. One thread calls; surveys run on the
// probe's threads. Errors: CameraError.
// Source: docs/depth.md, which derives it; the harmonic mean: Flux-Frontiers/quiltwright, docs/povray.md.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "camera/depth_survey.h"
#include "camera/lens_request.h"
#include "camera/lenticular.h"
#include "camera/parallax.h"
#include "camera/scene_probe.h"

namespace lentray::camera {

struct DistanceRange {
  double nearest = core::Bounds::kInf, farthest = -core::Bounds::kInf;
  bool is_empty() const { return nearest > farthest; }
  void add(const DistanceRange& other);
};

/// What is visible of a scene, or of several frames of an animation.
struct SceneDepths {
  DistanceRange points{};
  bool has_background = false;  ///< some rays meet nothing
  DistanceRange named{};        ///< of the object that Sheet_At names
  void add(const SceneDepths& other);
};

/// Where points move by as much before the sheet as behind it. Nothing without points.
std::optional<double> balanced_distance(const SceneDepths& seen, bool is_perspective);

/// The largest m, at most 1, with which points move by at most that many pixels a view of a sheet
/// that stands at D. It is also so small that a viewer's eyes need not turn outwards for anything
/// that is visible.
double largest_factor(const SceneDepths& seen, const Lenticular& sheet, double distance,
                      double pixels);

struct CompositionRequest {
  DepthMode mode = DepthMode::kPrint;
  bool is_perspective = true;
  std::optional<double> distance{};      ///< D, as asked for
  double usual_distance = 1.0;           ///< D of DepthMode::kScene, and where nothing is visible
  std::string sheet_at{};                ///< NAME, or FILE:LINE:COLUMN; empty: none
  std::optional<DepthBudget> budget{};   ///< empty: depth is true
  double most_parallax = kMostParallax;  ///< pixels a view, beyond which things are said to jump
  /// How far the eye may go to either side before it runs into an object, which that is; infinite: nothing.
  double free_way = core::Bounds::kInf;
  std::string in_the_way{};
  SceneDepths expected{};  ///< what a few rays met
  /// Of all of an animation; empty: what the survey finds.
  std::optional<SceneDepths> depths{};
  std::uint64_t rays = kSurveyRays;  ///< of a survey
};

struct Composition {
  double distance = 1.0;  ///< D, where the sheet stands; the eye's too, unless rays are parallel
  double factor = 1.0;    ///< m
  bool is_held = false;   ///< by free_way
  SceneDepths depths{};   ///< of this picture
  DepthSurvey seen{};     ///< by the sheet
};

/// A sheet that stands there, and shows that part of the true depth.
using SheetAt = std::function<std::unique_ptr<Lenticular>(double distance, double factor)>;

/// Throws CameraError where Sheet_At names no visible object, or several.
Composition compose(const CompositionRequest& request, const SheetAt& make,
                    const SceneProbe& probe);

}  // namespace lentray::camera
