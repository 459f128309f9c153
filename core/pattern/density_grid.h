// density_file: a grid of densities that fills the unit cube, repeated nowhere. Space: the
// pattern's. Immutable, any number of threads.
// Source: reference manual 3.7, "Density File"; compared with stock by tests/image/surface_patterns_test.cpp.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/pattern/pattern.h"

namespace lentray::core {

struct DensityGrid {
  std::array<std::size_t, 3> size{};  ///< along x, y, z; each at least 1
  std::vector<float> values;          ///< 0..1; x runs fastest, then y
};

enum class GridInterpolation { kNone, kTrilinear, kTricubic };

/// Each voxel's value stands at its corner nearest to the origin; neighbours beyond the last are
/// the first ones again.
PatternPtr make_density_pattern(std::shared_ptr<const DensityGrid> grid,
                                GridInterpolation interpolation);

}  // namespace lentray::core
