#include "tools/lentray-print/tiles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "camera/text.h"
#include "tools/lentray-print/letters.h"
#include "tools/lentray-print/page_error.h"

namespace lentray::print {

using camera::format;

namespace {

constexpr double kFrame = 5.0;  ///< around a window, for ticks and label
constexpr double kTickGap = 0.5, kTickLength = 3.0, kTickWidth = 0.15;
constexpr int kMostTiles = 100;  ///< a side

/// One side of the whole, cut.
struct Cuts {
  std::vector<std::int64_t> cuts;        ///< between pieces
  std::vector<std::int64_t> first, end;  ///< of each piece, with its overlaps
  std::size_t pieces() const { return first.size(); }
};

/// `size` pixels in pieces of `room` at most that overlap by `overlap`. `allowed`: where cuts may be; empty: anywhere.
std::optional<Cuts> cuts_of(std::int64_t size, std::int64_t room, std::int64_t overlap,
                            const std::vector<std::int64_t>& allowed) {
  for (int pieces = 1; pieces <= kMostTiles; ++pieces) {
    Cuts out;
    for (int i = 1; i < pieces; ++i) {
      std::int64_t cut = size * i / pieces;
      if (!allowed.empty()) {
        cut = *std::ranges::min_element(
            allowed, {}, [cut](std::int64_t place) { return std::abs(place - cut); });
      }
      out.cuts.push_back(cut);
    }
    if (std::ranges::adjacent_find(out.cuts, std::greater_equal<>{}) != out.cuts.end()) continue;
    bool fits = true;
    for (int i = 0; i < pieces; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const std::int64_t first =
          i == 0 ? 0 : std::max<std::int64_t>(0, out.cuts[at - 1] - overlap / 2);
      const std::int64_t end =
          i + 1 == pieces ? size : std::min(size, out.cuts[at] + (overlap - overlap / 2));
      fits = fits && end - first <= room && end > first;
      out.first.push_back(first);
      out.end.push_back(end);
    }
    if (fits) return out;
  }
  return std::nullopt;
}

std::optional<TilePlan> plan_on(const Page& whole, const std::vector<std::int64_t>& boundaries,
                                const TileStyle& style, const parser::Extent& paper) {
  const double px = whole.pixel_width(), py = whole.pixel_height();
  const double border = style.margin + kFrame;
  const auto pixels = [](double mm, double pixel) {
    return static_cast<std::int64_t>(std::floor(mm / pixel + 1e-9));
  };
  const auto across = cuts_of(whole.columns(), pixels(paper.width - 2.0 * border, px),
                              pixels(style.overlap, px), boundaries);
  const auto down =
      cuts_of(whole.rows(), pixels(paper.height - 2.0 * border, py), pixels(style.overlap, py), {});
  if (!across || !down) return std::nullopt;
  TilePlan plan{.paper = paper,
                .rows = static_cast<int>(down->pieces()),
                .columns = static_cast<int>(across->pieces())};
  plan.left = std::llround(border / px);
  plan.top = std::llround(border / py);
  for (std::size_t row = 0; row < down->pieces(); ++row) {
    for (std::size_t column = 0; column < across->pieces(); ++column) {
      Tile tile{.row = static_cast<int>(row), .column = static_cast<int>(column)};
      tile.window = {across->first[column], down->first[row],
                     static_cast<std::uint32_t>(across->end[column] - across->first[column]),
                     static_cast<std::uint32_t>(down->end[row] - down->first[row])};
      if (column > 0) tile.cut_columns.push_back(across->cuts[column - 1]);
      if (column + 1 < across->pieces()) tile.cut_columns.push_back(across->cuts[column]);
      if (row > 0) tile.cut_rows.push_back(down->cuts[row - 1]);
      if (row + 1 < down->pieces()) tile.cut_rows.push_back(down->cuts[row]);
      plan.tiles.push_back(std::move(tile));
    }
  }
  return plan;
}

}  // namespace

TilePlan tile_plan(const Page& whole, const std::vector<std::int64_t>& boundaries,
                   const TileStyle& style) {
  const parser::Extent& paper = style.paper;
  const auto upright = plan_on(whole, boundaries, style, paper);
  const auto across = plan_on(whole, boundaries, style, {paper.height, paper.width});
  if (!upright && !across) {
    throw PageError("paper of " + format(paper.width) + " x " + format(paper.height) +
                    " mm is too small for tiles of a sheet of " + format(whole.width) + " x " +
                    format(whole.height) + " mm with an overlap of " + format(style.overlap) +
                    " mm and margins of " + format(style.margin + kFrame) + " mm");
  }
  if (!upright) return *across;
  if (!across) return *upright;
  return across->tiles.size() < upright->tiles.size() ? *across : *upright;
}

Page tile_page(const Page& whole, const TilePlan& plan, const Tile& tile, int bits) {
  Page page = page_of(plan.paper.width, plan.paper.height, whole.dpi_x, whole.dpi_y);
  page.title = whole.title;
  page.pictures.push_back({stored_window(whole, tile.window, bits), plan.left, plan.top});
  const double px = page.pixel_width(), py = page.pixel_height();
  const Box art{static_cast<double>(plan.left) * px, static_cast<double>(plan.top) * py,
                tile.window.width * px, tile.window.height * py};
  const double half = kTickWidth / 2.0;
  for (const std::int64_t cut : tile.cut_columns) {
    const double x = art.left + static_cast<double>(cut - tile.window.column) * px;
    page.bars.push_back({x - half, art.top - kTickGap - kTickLength, kTickWidth, kTickLength});
    page.bars.push_back({x - half, art.bottom() + kTickGap, kTickWidth, kTickLength});
  }
  for (const std::int64_t cut : tile.cut_rows) {
    const double y = art.top + static_cast<double>(cut - tile.window.row) * py;
    page.bars.push_back({art.left - kTickGap - kTickLength, y - half, kTickLength, kTickWidth});
    page.bars.push_back({art.right() + kTickGap, y - half, kTickLength, kTickWidth});
  }
  constexpr double kHeight = 2.0;
  const std::string place = "row " + std::to_string(tile.row + 1) + " column " +
                            std::to_string(tile.column + 1) + " of " + std::to_string(plan.rows) +
                            " x " + std::to_string(plan.columns);
  // Between the ticks, as far as they leave room.
  double left = art.left + 1.0;
  for (const std::int64_t cut : tile.cut_columns) {
    const double x = art.left + static_cast<double>(cut - tile.window.column) * px;
    if (x < art.left + art.width / 2.0) left = x + 2.0;
  }
  const std::string named = whole.title + ": " + place + "; cut at the ticks";
  const bool is_room = text_width(named, kHeight) < art.width - 2.0 * (left - art.left);
  add_text(page, is_room ? named : place, {left, art.top - kTickGap - 0.6}, kHeight);
  return page;
}

std::string suffix_of(const Tile& tile) {
  return "-r" + std::to_string(tile.row + 1) + "-c" + std::to_string(tile.column + 1);
}

}  // namespace lentray::print
