// What passes leave for shading (core/pass): light that was gathered before the picture. Const, shared by all
// threads and by all pictures of a scene; a member that is null: the scene has none of it.
#pragma once

#include <memory>

namespace lentray::core {

class IrradianceCache;

struct Illumination {
  std::shared_ptr<const IrradianceCache> irradiance{};  ///< of radiosity
};

}  // namespace lentray::core
