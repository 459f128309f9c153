// What arrives of the lights at up to 64 points of surfaces, asked for light by light before the surfaces are shaded
// (core/accel/light_points.h). It knows lights that are points with a light buffer; the light loop asks for others
// when their turn comes. World space. One a thread.
// Bits are those of asking one by one: which points are asked together changes none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/accel/light_points.h"
#include "core/light/light_ray.h"
#include "core/object/hit.h"
#include "core/trace/ray_state.h"
#include "core/trace/shadow_tester.h"
#include "core/trace/thread_context.h"
#include "core/trace/unmet_object.h"

namespace lentray::core {

/// The way from that place to the light, where the answer has one.
inline LightRay ray_at(const LightAnswers& answers, std::size_t place) {
  return {answers.direction_at(place), answers.distance[place]};
}

class BlockLights {
 public:
  static constexpr std::size_t kMost = LightPoints::kMost;
  using Answer = LightAnswers::Answer;

  BlockLights(ThreadContext& context, ShadowTester& shadows);
  /// False: nothing is ever known of any light.
  bool works() const { return m_works; }

  void clear() { m_points.clear(); }
  /// The next place, at most kMost. Of lights behind a plane across `front` nothing is wanted (LightPoints::add()).
  void add(const Hit& hit, const MetPlace& where, const Vec3& front) {
    if (hit.leaf->attributes().lights) return add_none();  // of a light group
    const UnmetObject unmet = unmet_object(hit, where.from_behind, where.point, m_tolerance);
    m_points.add(where.point, where.normal, front, unmet.object, unmet.slope);
  }
  /// A place that is no surface.
  void add_none() { m_points.add_none(); }
  /// Once all places are there: asks for all lights.
  void find();

  Answer answer(std::uint32_t light, std::size_t place) const {
    const LightAnswers* answers = of(light);
    return answers ? answers->at(place) : LightAnswers::kUnknown;
  }
  /// Of a light; null: nothing is known of it.
  const LightAnswers* of(std::uint32_t light) const { return m_answers[light].get(); }
  const LightPoints& points() const { return m_points; }
  /// Whether something is known of each of the scene's global lights.
  bool knows_all() const { return m_knows_all; }

 private:
  ThreadContext& m_context;
  const double m_tolerance;  ///< kShadowTolerance in this scene
  bool m_works = false, m_knows_all = false;
  LightPoints m_points;
  std::vector<std::unique_ptr<LightAnswers>>
      m_answers;  ///< one a light of the scene; null: asked alone
};

}  // namespace lentray::core
