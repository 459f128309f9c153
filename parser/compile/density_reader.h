// Files of densities (.df3): three sizes of 16 bits, then a value a voxel of 8, 16 or 32 bits,
// big-endian. Source: reference manual 3.7, "Density File".
#pragma once

#include <memory>

#include "core/pattern/density_grid.h"
#include "parser/files/files.h"

namespace lentray::parser {

/// Throws std::runtime_error if the file cannot be read or its length fits no size of voxel.
std::shared_ptr<const core::DensityGrid> read_density_file(const FoundFile& found);

}  // namespace lentray::parser
