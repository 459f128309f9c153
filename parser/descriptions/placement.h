// Where the transforms of a statement lead, and how they were written where bounds depend on it. Plain data;
// copies share the steps.
#pragma once

#include <vector>

#include "core/base/transform.h"
#include "parser/base/sparse.h"
#include "parser/values/value.h"

namespace lentray::parser {

/// A step on the way. What comes before the first that matters is composed to one (parser/stock/history.h).
struct PlacementStep {
  enum class Kind {
    kBefore,     ///< all that came before the steps that are kept
    kTransform,  ///< a statement, or several that may as well be one
    kClips,  ///< `clipped_by`: `transform` is all that came before it, `clips` are as they stood then
  } kind = Kind::kTransform;
  core::Transform transform;
  std::vector<Ref<ObjectDesc>> clips;
};
using PlacementSteps = std::vector<PlacementStep>;

/// The whole transform. Most placements keep no steps.
struct Placement : core::Transform {
  Sparse<PlacementSteps> steps;

  /// `next` behind all there is.
  void add(const core::Transform& next) { core::Transform::operator=(then(next)); }
};

}  // namespace lentray::parser
