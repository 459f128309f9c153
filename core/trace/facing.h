// When a light is behind a surface.
#pragma once

namespace lentray::core {

inline constexpr double kGrazing =
    1e-10;  ///< a light at less than this cosine is behind the surface

}  // namespace lentray::core
