// How the areas of an image's pixels join. In an ordinary picture a pixel's neighbours are those
// beside it in the file. Behind a lens sheet they are the pixels of the same view in the next
// lenses, for the eye sees a lens as wide as it is in the colour of one pixel.
// Immutable, any number of threads.
#pragma once

#include <cstdint>
#include <vector>

namespace lentray::core {

struct PixelLattice {
  static constexpr std::uint32_t kTile = 128;  ///< pixels that join, the side of a tile

  /// By column: the column whose pixels join these on the left; negative outside the picture.
  /// Always less than the column itself.
  std::vector<std::int32_t> left;
  /// Where tiles begin, in ascending order, and the image's width at the end.
  std::vector<std::uint32_t> tiles;
  /// left[k] = k - step for every column; 0: it varies from column to column.
  std::uint32_t step = 1;

  static PixelLattice in_rows(std::uint32_t width);
  std::uint32_t width() const { return static_cast<std::uint32_t>(left.size()); }
  /// The least column that is left of another, 0 or less: how far the film looks beyond the left edge.
  std::int32_t leftmost() const;
};

}  // namespace lentray::core
