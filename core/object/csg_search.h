// What a CSG's boxes and its tests share: the hierarchies over its parts' boxes. World space. Internal to
// csg.cpp and csg_bounds.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/bvh/wide_bvh.h"
#include "core/object/csg.h"

namespace lentray::core {

inline bool joins(CsgKind kind) { return kind == CsgKind::kUnion || kind == CsgKind::kMerge; }

/// Hierarchies over the children's boxes; those with infinite ones are listed apart.
struct Csg::Search {
  WideBvh surfaces, solids;
  std::vector<std::uint32_t> open_surfaces, open_solids;
  std::size_t in_beyond = 0;   ///< children in `solids` that are inside beyond their box
  std::size_t out_beyond = 0;  ///< ... outside beyond it
};

}  // namespace lentray::core
