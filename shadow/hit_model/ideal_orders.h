// The orders that the paper's combined and two-dimensional styles presuppose: strips cut to the
// shadow, lens by lens, and all other pixels after them. The pixels are listed, 8 bytes each.
// Immutable, any number of threads.
#pragma once

#include <memory>

#include "core/render/pixel_order.h"
#include "shadow/hit_model/enumeration.h"

namespace lentray::shadow {

/// For the ideal kinds of `combined` and `strips`, for the columns [left, right) of the sheet and
/// its rows from `top` on: row 0 of the order is the sheet's row `top`.
/// combined: row after row; of each the strips of blocked columns from lens to lens, then the rest.
/// strips: the blocked pixels of one lens after those of another, a strip row after row; then the
/// rest as rows.
std::unique_ptr<core::BandOrders> make_ideal_orders(const Enumeration& shadow, Style::Kind kind,
                                                    std::uint32_t left, std::uint32_t right,
                                                    std::uint32_t top);

}  // namespace lentray::shadow
