#include "tools/lentray-print/layout.h"

#include <algorithm>
#include <cmath>

namespace lentray::print {
namespace {

/// The whole column nearest to a place, and what is left: above -1/2, 1/2 at most.
LayoutPlace beside_whole(double place) {
  const double column = std::ceil(place - 0.5);
  LayoutPlace out{.column = static_cast<std::int64_t>(column), .origin = place - column};
  if (std::fabs(out.origin) < kWholeColumn) out.origin = 0.0;
  return out;
}

/// The places where rows or columns of a grid begin.
std::vector<std::int64_t> starts(const std::vector<std::int64_t>& sizes, std::int64_t gap) {
  std::vector<std::int64_t> out{0};
  for (const std::int64_t size : sizes) out.push_back(out.back() + size + gap);
  return out;
}

/// Moves columns of a grid to the right until pictures stand at whole columns of pixels, each by `more` at most.
void move_to_whole(std::vector<std::int64_t>& lenses, const LayoutStyle& style) {
  std::int64_t moved = 0;
  for (std::size_t i = 1; i + 1 < lenses.size(); ++i) {
    std::int64_t best = lenses[i] + moved;
    const auto miss = [&](std::int64_t lens) {
      const double at = static_cast<double>(lens) * style.lens;
      return std::fabs(at - std::round(at));
    };
    for (std::int64_t lens = best; lens <= lenses[i] + moved + style.more_lenses; ++lens) {
      if (miss(lens) >= kWholeColumn) continue;
      best = lens;
      break;
    }
    moved = best - lenses[i];
    lenses[i] = best;
  }
  lenses.back() += moved;
}

}  // namespace

Layout layout_of(const std::vector<LayoutItem>& items, LayoutGrid grid, const LayoutStyle& style) {
  const auto count = static_cast<int>(items.size());
  grid.columns = std::min(grid.columns, count);
  grid.rows = (count + grid.columns - 1) / grid.columns;
  std::vector<std::int64_t> widths(static_cast<std::size_t>(grid.columns), 0);
  std::vector<std::int64_t> heights(static_cast<std::size_t>(grid.rows), 0);
  const auto column_of = [&](std::size_t i) { return i % widths.size(); };
  const auto row_of = [&](std::size_t i) { return i / widths.size(); };
  for (std::size_t i = 0; i < items.size(); ++i) {
    widths[column_of(i)] = std::max(widths[column_of(i)], items[i].lenses);
    heights[row_of(i)] = std::max(heights[row_of(i)], items[i].rows);
  }
  std::vector<std::int64_t> across = starts(widths, style.gap_lenses);
  if (style.lens == style.strip) move_to_whole(across, style);
  const std::vector<std::int64_t> down = starts(heights, style.gap_rows);

  Layout out{.grid = grid,
             .places = {},
             .marks = {},
             .lenses = across.back() - style.gap_lenses,
             .rows = down.back() - style.gap_rows};
  /// The middle of a picture on the sheet, in lenses.
  const auto middle = [&](std::size_t i) {
    const std::int64_t first = across[column_of(i)] + (widths[column_of(i)] - items[i].lenses) / 2;
    return static_cast<double>(first) + 0.5 * static_cast<double>(items[i].lenses);
  };
  const auto half = [&](std::size_t i) {
    return (static_cast<double>(items[i].first_lens) + 0.5 * static_cast<double>(items[i].lenses)) *
           style.strip;
  };
  /// Where the sheet's lens 0 begins, so that the first picture's own begins at `origin`.
  const double base = style.origin + half(0) - middle(0) * style.lens;
  for (std::size_t i = 0; i < items.size(); ++i) {
    LayoutPlace place = beside_whole(base + middle(i) * style.lens - half(i));
    const std::int64_t top = down[row_of(i)] + (heights[row_of(i)] - items[i].rows) / 2;
    place.row = top - items[i].first_row - (heights[0] - items[0].rows) / 2 + items[0].first_row;
    out.places.push_back(place);
  }
  const double all = 0.5 * static_cast<double>(out.lenses);
  out.marks = {.pixels = style.strip, .origin = base + all * style.lens - all * style.strip};
  return out;
}

LayoutGrid best_grid(int count, const std::function<double(const LayoutGrid&)>& extent) {
  LayoutGrid best{.columns = 0, .rows = 0};
  double least = -1.0;
  for (int columns = count; columns >= 1; --columns) {
    const LayoutGrid grid{.columns = columns, .rows = (count + columns - 1) / columns};
    // The same rows with fewer columns leave fewer places empty.
    if (columns > 1 && (count + columns - 2) / (columns - 1) == grid.rows) continue;
    const double size = extent(grid);
    if (size < 0.0 || (least >= 0.0 && size >= least)) continue;
    least = size;
    best = grid;
  }
  return best;
}

double origin_about_middle(std::int64_t lenses, double from, double to) {
  const double moved = 0.5 * static_cast<double>(lenses) * (from - to);
  return moved - std::ceil(moved - 0.5);
}

}  // namespace lentray::print
