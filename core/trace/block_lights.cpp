#include "core/trace/block_lights.h"

#include "core/base/processor.h"
#include "core/scene/tolerances.h"

namespace lentray::core {
namespace {

/// Whether what arrives of it depends on its buffer alone.
bool is_simple(const Light& light) {
  return is_straight(light) && !light.has_area && !light.shadowless && !light.projector;
}

}  // namespace

BlockLights::BlockLights(ThreadContext& context, ShadowTester& shadows)
    : m_context(context), m_tolerance(kShadowTolerance * context.scene.tolerance_scale()),
      m_answers(context.scene.lights().size()) {
  // Tests are counted one by one; air dims every ray.
  if (!shadows.plain() || context.tests || context.scene.needs().dimming_air || !has_avx2()) return;
  m_knows_all = true;
  for (const std::uint32_t light : context.scene.global_lights()) {
    if (context.scene.light_buffer(light) && is_simple(context.scene.lights()[light])) {
      m_answers[light] = std::make_unique<LightAnswers>();
      m_works = true;
    } else {
      m_knows_all = false;
    }
  }
}

void BlockLights::find() {
  m_points.fill_up();
  for (std::size_t light = 0; light < m_answers.size(); ++light) {
    if (!m_answers[light]) continue;
    m_context.scene.light_buffer(light)->ask_together(m_points, m_tolerance, m_context.lists,
                                                      *m_answers[light]);
  }
}

}  // namespace lentray::core
