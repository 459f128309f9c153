// What counts as nothing.
#pragma once

namespace lentray::core {

/// Lengths, cosines and shares below it are taken for 0.
inline constexpr double kTiny = 1e-10;

}  // namespace lentray::core
