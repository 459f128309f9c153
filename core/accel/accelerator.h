// How objects are found that a ray may meet (`Accelerator=`). The answers are the same with all.
#pragma once

#include <cstdint>

namespace lentray::core {

enum class Accelerator : std::uint8_t {
  kBvh,   ///< a hierarchy of boxes, packs of equal objects in its leaves
  kGrid,  ///< cells of one size, walked along the ray
  kList,  ///< every object's box, one after another
};

}  // namespace lentray::core
