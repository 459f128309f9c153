// Pixel orders by name, as `Pixel_Order=` takes it, cut into jobs: runs of the order, small enough
// that every thread has work to the end, large enough that a cache sees neighbours. The order of
// pixels never changes the picture.
//
//   rows     row after row, each from the left
//   views    view after view; each as rows, from lens to lens
//   columns  column after column, each from the top
//   combined(w)   row after row; in a row the first strip of w pixels of every lens, then the
//                 second of every lens, and so on
//   strips(w,h)   the same for h rows at a time: strips of w x h pixels, each as rows
//   tiles    squares of 32 pixels, a row of squares after another, each square as rows
//   serpentine  squares of 64 pixels, a row of squares after another, each column after column,
//            down and up in turn
//   hilbert  squares of 64 pixels, a row of squares after another, each along a Hilbert curve
//   adaptive strips that follow the shadows: shadow/adaptive_order.h
//   auto     serpentine where there is a lens sheet, else hilbert
//
// Views and strips: shadow/lens_columns.h. Without a lens sheet there is one view, the same as
// rows, and strips(w,h) are tiles of w x h. Without numbers, combined is combined(4), and strips
// is strips(4,32).
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "camera/lens_sheet.h"
#include "core/render/pixel_order.h"
#include "shadow/run_meter.h"
#include "shadow/sequence.h"

namespace lentray::shadow {

inline constexpr std::uint32_t kTile = 32;        ///< pixels, the side of a square of `tiles`
inline constexpr std::uint32_t kSerpentine = 64;  ///< of `serpentine`
inline constexpr std::uint32_t kHilbert = 64;     ///< and of `hilbert`

/// auto, rows, views, columns, combined, strips, tiles, serpentine, hilbert, adaptive: in this
/// order.
const std::vector<std::string_view>& order_names();

/// Throws std::invalid_argument with the list of names for one that is not there, or for numbers
/// in brackets that it does not take (letter case does not matter). An empty region has no jobs.
/// `sheet` is for the image's columns; it need not live longer than the call.
std::unique_ptr<core::PixelOrder> make_order(std::string_view name, const PixelRegion& region,
                                             const camera::LensSheet* sheet = nullptr);
std::unique_ptr<core::PixelOrder> make_order(std::string_view name, std::uint32_t width,
                                             std::uint32_t height);

/// The columns of an image that are rendered: [left, right).
struct PixelColumns {
  std::uint32_t left = 0, right = 0;
};

/// The same for the bands of an image, inside which an order stays. `meter` is for orders that
/// follow the shadows, and outlives them; null: they keep to fixed sizes.
std::unique_ptr<core::BandOrders> make_band_orders(std::string_view name,
                                                   const PixelColumns& columns,
                                                   const camera::LensSheet* sheet = nullptr,
                                                   const RunMeter* meter = nullptr);
/// Whether the order wants a meter. Throws as make_order().
bool follows_shadows(std::string_view name);

/// Rows in a band of an image of that size, if bands shall take `memory` bytes at
/// `bytes_a_row` each: as many as fit, but not more than a few million pixels, and less where the
/// order does not gain by higher bands; at least 1. Throws as make_order().
std::uint32_t band_height(std::string_view name, std::uint32_t width, std::uint32_t height,
                          double bytes_a_row, double memory);

}  // namespace lentray::shadow
