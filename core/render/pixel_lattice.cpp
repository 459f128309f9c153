#include "core/render/pixel_lattice.h"

#include <algorithm>

namespace lentray::core {

PixelLattice PixelLattice::in_rows(std::uint32_t width) {
  PixelLattice out;
  out.left.resize(width);
  for (std::uint32_t k = 0; k < width; ++k) out.left[k] = static_cast<std::int32_t>(k) - 1;
  for (std::uint32_t k = 0; k < width; k += kTile) out.tiles.push_back(k);
  out.tiles.push_back(width);
  return out;
}

std::int32_t PixelLattice::leftmost() const {
  const auto least = std::min_element(left.begin(), left.end());
  return least == left.end() ? 0 : std::min(*least, 0);
}

}  // namespace lentray::core
