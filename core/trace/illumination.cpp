#include "core/trace/illumination.h"

#include "core/trace/radiosity_light.h"
#include "core/trace/thread_context.h"

namespace lentray::core {

std::unique_ptr<IndirectLight> make_indirect_light(ThreadContext& context, ShadowTester& shadows) {
  if (!context.illumination || !context.illumination->irradiance) return nullptr;
  auto light =
      std::make_unique<RadiosityLight>(context, shadows, *context.illumination->irradiance);
  context.indirect = light.get();
  return light;
}

}  // namespace lentray::core
