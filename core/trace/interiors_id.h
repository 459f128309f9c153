// The number of a stack of interiors in a thread's InteriorTable (core/trace/interior_table.h).
#pragma once

#include <cstdint>

namespace lentray::core {

enum class InteriorsId : std::uint32_t { kOpen = 0 };  ///< kOpen: in no interior

}  // namespace lentray::core
