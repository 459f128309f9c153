// What one thread traces with: scratch that grows and is used again, counters, and the interiors its
// rays lie in. One a thread; it outlives what is made with it.
#pragma once

#include "core/base/counters.h"
#include "core/base/pixel.h"
#include "core/light/area_light.h"
#include "core/object/hit.h"
#include "core/scene/scene.h"
#include "core/trace/interior_table.h"

namespace lentray::core {

class IndirectLight;
struct Illumination;

struct ThreadContext {
  /// `count_tests`: whether tests of bounds and primitives are counted too.
  ThreadContext(const Scene& s, bool count_tests, const Illumination* light = nullptr)
      : scene(s), illumination(light), tests(count_tests ? &counters : nullptr) {
    counters.lights.resize(s.lights().size());
  }
  ThreadContext(const ThreadContext&) = delete;
  ThreadContext& operator=(const ThreadContext&) = delete;

  const Scene& scene;
  const Illumination* const illumination;  ///< what passes left; null: there were none
  HitLists lists;
  Counters counters;
  Counters* const tests;  ///< where tests are counted; null: nowhere
  AreaScratch area;
  InteriorTable interiors;
  IndirectLight* indirect = nullptr;  ///< null: light sources alone light surfaces
  Pixel pixel;                        ///< of the sample
};

}  // namespace lentray::core
