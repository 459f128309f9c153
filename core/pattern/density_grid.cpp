#include "core/pattern/density_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lentray::core {
namespace {

/// A coordinate as a voxel and the rest of the way to the next.
struct Step {
  std::size_t cell;
  double rest;
  Step(double coordinate, std::size_t size) {
    const double scaled = coordinate * static_cast<double>(size);
    cell = std::min(static_cast<std::size_t>(scaled), size - 1);
    rest = scaled - std::floor(scaled);
  }
};

double blend(double a, double b, double t) { return a * (1.0 - t) + b * t; }

/// Through b and c, with slopes from their neighbours.
float catmull_rom(float t, const std::array<float, 4>& p) {
  const float from = (p[2] - p[0]) * 0.5f, to = (p[3] - p[1]) * 0.5f;
  const float cubic = 2.0f * (p[1] - p[2]) + from + to;
  const float square = -3.0f * (p[1] - p[2]) - 2.0f * from - to;
  return ((cubic * t + square) * t + from) * t + p[1];
}

class DensityPattern final : public Pattern {
 public:
  DensityPattern(std::shared_ptr<const DensityGrid> grid, GridInterpolation interpolation)
      : m_grid(std::move(grid)), m_interpolation(interpolation) {}

  double value(const Vec3& p) const override {
    for (int axis = 0; axis < 3; ++axis) {
      if (!(p[axis] >= 0.0 && p[axis] < 1.0)) return 0.0;
    }
    const Step x(p.x, m_grid->size[0]), y(p.y, m_grid->size[1]), z(p.z, m_grid->size[2]);
    switch (m_interpolation) {
      case GridInterpolation::kNone: return at(x.cell, y.cell, z.cell);
      case GridInterpolation::kTrilinear: return trilinear(x, y, z);
      case GridInterpolation::kTricubic: return std::max(0.0, tricubic(x, y, z));
    }
    return 0.0;
  }

 private:
  float at(std::size_t x, std::size_t y, std::size_t z) const {
    const auto& size = m_grid->size;
    return m_grid->values[(z % size[2] * size[1] + y % size[1]) * size[0] + x % size[0]];
  }

  double trilinear(const Step& x, const Step& y, const Step& z) const {
    const auto row = [&](std::size_t j, std::size_t k) {
      return blend(at(x.cell, j, k), at(x.cell + 1, j, k), x.rest);
    };
    const auto layer = [&](std::size_t k) {
      return blend(row(y.cell, k), row(y.cell + 1, k), y.rest);
    };
    return blend(layer(z.cell), layer(z.cell + 1), z.rest);
  }

  double tricubic(const Step& x, const Step& y, const Step& z) const {
    const auto& size = m_grid->size;
    std::array<float, 4> rows, columns, depths;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t k = 0; k < 4; ++k) {
          depths[k] =
              at(x.cell + size[0] + i - 1, y.cell + size[1] + j - 1, z.cell + size[2] + k - 1);
        }
        columns[j] = catmull_rom(static_cast<float>(z.rest), depths);
      }
      rows[i] = catmull_rom(static_cast<float>(y.rest), columns);
    }
    return catmull_rom(static_cast<float>(x.rest), rows);
  }

  std::shared_ptr<const DensityGrid> m_grid;
  GridInterpolation m_interpolation;
};

}  // namespace

PatternPtr make_density_pattern(std::shared_ptr<const DensityGrid> grid,
                                GridInterpolation interpolation) {
  return std::make_unique<DensityPattern>(std::move(grid), interpolation);
}

}  // namespace lentray::core
