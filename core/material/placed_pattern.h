// A pattern with its place in space and its wave: what a map is looked up by.
#pragma once

#include <memory>

#include "core/pattern/pattern.h"
#include "core/pattern/placement.h"

namespace lentray::core {

struct PlacedPattern {
  Placement placement;
  std::shared_ptr<const Pattern> pattern;
  Wave wave;

  /// Of a point in the pattern's own space, as placement.inwards() gives it.
  double value(const Vec3& local, const SurfaceContext& surface = kNoSurface) const {
    return wave.apply(pattern->value_on(local, surface));
  }
};

}  // namespace lentray::core
