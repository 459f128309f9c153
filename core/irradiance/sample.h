// Light that was gathered at a point of a surface, and how far it may be used again. World space, colours
// linear. Plain values.
// Source: Ward, Rubinstein and Clear, SIGGRAPH 1988; the rule of reuse in detail is the one that replays
// stock's pictures.
#pragma once

#include "core/base/color.h"
#include "core/base/vec3.h"

namespace lentray::core {

struct IrradianceSample {
  Vec3 point, normal;
  Vec3 to_nearest;       ///< unit, towards the nearest thing that was met; null: nothing was
  Rgb light;             ///< the mean of what the gather's rays brought
  float radius = 0.0f;   ///< harmonic mean of the distances, within the lengths of reuse
  float nearest = 0.0f;  ///< distance of the nearest thing
  float quality = 0.0f;  ///< 0..1: how good the samples were that the gather used itself
};

/// A place whose light is asked for.
struct ReuseQuery {
  Vec3 point, normal;
  double error_bound;  ///< the greatest error, factors of the depth included
  bool smooth;         ///< weights fall off without an edge: of the first depth, in the picture
};

/// How much a sample counts there, 0..1; 0: it is of no use. The sample's quality is not in it.
double reuse_weight(const IrradianceSample& sample, const ReuseQuery& query);

}  // namespace lentray::core
