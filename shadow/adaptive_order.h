// The order `adaptive`: blocks of whole lenses, about kBlock pixels a side, a row of blocks after
// another; in a block strips of a lens, lens after lens, as in strips(w,h), but as wide and as high
// as shadows went on in the blocks traced before, and each traced along its longer runs.
#pragma once

#include <cstdint>

#include "shadow/sequence.h"

namespace lentray::shadow {

class RunMeter;

inline constexpr std::uint32_t kBlock = 64;  ///< pixels

/// Lenses by their columns, those of the region, and how they lie in blocks; without a sheet
/// columns are cut into "lenses" of kBlock.
struct LensBlocks {
  std::vector<Strip> lenses;
  std::vector<std::size_t> first;  ///< lens of each block; one more at the end
};
LensBlocks blocks_of(std::uint32_t left, std::uint32_t right, const camera::LensSheet* sheet);

/// `meter` outlives the order; null: strips are 4 x 32 throughout.
OrderPtr make_adaptive_order(const PixelRegion& region, std::shared_ptr<const LensBlocks> blocks,
                             const RunMeter* meter);

}  // namespace lentray::shadow
