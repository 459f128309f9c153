#include "tools/lentray-print/sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "camera/text.h"
#include "core/image/orientation.h"
#include "tools/lentray-print/page_error.h"
#include "tools/lentray-print/pixels.h"

namespace lentray::print {

using camera::format;

namespace {

std::string size_in_mm(const parser::Extent& extent) {
  return format(extent.width) + " x " + format(extent.height) + " mm";
}

std::int64_t bleed_lenses(const LensData& data, const SheetStyle& style) {
  return style.bleed > 0.0 ? whole_in(style.bleed, data.print_pitch()) : 0;
}
std::int64_t bleed_rows(const LensData& data, const SheetStyle& style) {
  return style.bleed > 0.0 ? whole_in(style.bleed, kInch / data.dpi_y) : 0;
}

/// Lets the picture go on beyond its edges.
void add_bleed(SheetArt& art, std::int64_t lenses, std::int64_t rows) {
  const std::int64_t end = art.lenses.first_column(art.end_lens + lenses);
  art.first_column = art.lenses.first_column(-lenses);
  art.first_row = -rows;
  const std::uint32_t width = art.image.width, height = art.image.height;
  art.image = core::rearranged(
      art.image,
      continued_columns(art.first_column, static_cast<std::uint32_t>(end - art.first_column), width,
                        art.lenses),
      continued_rows(art.first_row, static_cast<std::uint32_t>(height + 2 * rows), height));
}

/// Pixels of the page's grid from one place to another.
struct PixelBox {
  std::int64_t left = 0, top = 0, right = 0, bottom = 0;

  void include(const PixelBox& other) {
    left = std::min(left, other.left);
    top = std::min(top, other.top);
    right = std::max(right, other.right);
    bottom = std::max(bottom, other.bottom);
  }
  PixelBox moved(std::int64_t columns, std::int64_t rows) const {
    return {left + columns, top + rows, right + columns, bottom + rows};
  }
  Box on(const Page& page) const {
    const double px = page.pixel_width(), py = page.pixel_height();
    return {static_cast<double>(left) * px, static_cast<double>(top) * py,
            static_cast<double>(right - left) * px, static_cast<double>(bottom - top) * py};
  }
};

PixelBox box_of(const SheetArt& art, const LayoutPlace& place) {
  const std::int64_t left = place.column + art.first_column, top = place.row + art.first_row;
  return {left, top, left + art.image.width, top + art.image.height};
}
PixelBox cut_of(const SheetArt& art, const LayoutPlace& place) {
  return PixelBox{art.trim_left, art.trim_top, art.trim_right, art.trim_bottom}.moved(place.column,
                                                                                      place.row);
}

parser::Extent extent_with_marks(std::int64_t columns, std::int64_t rows, const LensData& data,
                                 const SheetStyle& style) {
  const MarkRoom room = mark_room(data, style.marks, style.is_across);
  const double px = kInch / data.dpi_x, py = kInch / data.dpi_y;
  const auto beside = [&style](double marks, double pixel) {
    return 2.0 * std::ceil((marks + style.margin) / pixel - 1e-9);
  };
  return {px * (static_cast<double>(columns) + beside(room.across, px)),
          py * (static_cast<double>(rows) + beside(room.down, py))};
}

bool holds(const parser::Extent& paper, const parser::Extent& needed, const LensData& data) {
  // A pixel more or less is rounding.
  const double px = 1.01 * kInch / data.dpi_x, py = 1.01 * kInch / data.dpi_y;
  return paper.width + px >= needed.width && paper.height + py >= needed.height;
}

/// The paper as it lies, or what is needed.
parser::Extent extent_of_page(const parser::Extent& needed, const LensData& data,
                              const SheetStyle& style) {
  if (!style.paper) return needed;
  // The page of lenses that lie across is turned when it is done.
  parser::Extent upright = *style.paper, across{upright.height, upright.width};
  if (style.is_across) std::swap(upright, across);
  if (holds(upright, needed, data)) return upright;
  if (holds(across, needed, data)) return across;
  throw PageError("the sheet needs " + size_in_mm(needed) +
                  " with its marks and margins, and the paper has " + size_in_mm(*style.paper) +
                  "; --tiles cuts it into pages");
}

}  // namespace

LayoutItem layout_item(std::int64_t lenses, std::int64_t rows, const LensData& data,
                       const SheetStyle& style) {
  LayoutItem item{.lenses = lenses, .rows = rows};
  if (!style.bleed_of_picture) return item;
  item.first_lens = bleed_lenses(data, style);
  item.first_row = bleed_rows(data, style);
  item.lenses -= 2 * item.first_lens;
  item.rows -= 2 * item.first_row;
  if (item.lenses > 0 && item.rows > 0) return item;
  throw PageError("nothing of the picture is left within that bleed; give a smaller --bleed");
}

SheetArt sheet_art(core::StoredImage image, const LensData& data, const SheetStyle& style,
                   double origin) {
  SheetArt art;
  art.lenses = {.pixels = data.pixels, .origin = origin};
  const LayoutItem item =
      layout_item(art.lenses.whole_lenses(image.width), image.height, data, style);
  art.first_lens = item.first_lens;
  art.end_lens = item.first_lens + item.lenses;
  art.trim_top = item.first_row;
  art.trim_bottom = item.first_row + item.rows;
  art.image = std::move(image);
  if (style.bleed > 0.0 && !style.bleed_of_picture) {
    add_bleed(art, bleed_lenses(data, style), bleed_rows(data, style));
  }
  art.trim_left = art.lenses.first_column(art.first_lens);
  art.trim_right = art.lenses.first_column(art.end_lens);
  return art;
}

LayoutStyle layout_style(const LensData& data, const SheetStyle& style, double lens,
                         double origin) {
  constexpr double kMore = 1.0;
  const double least = 2.0 * style.bleed, gap = style.gap.value_or(std::max(kUsualGap, least));
  if (gap < least) {
    throw PageError("a gap of " + format(gap) + " mm between pictures with a bleed of " +
                    format(style.bleed) + " mm each: give --gap " + format(least) + "mm or more");
  }
  LayoutStyle out{.strip = data.pixels, .lens = lens, .origin = origin};
  const double pitch = lens * kInch / data.dpi_x;
  out.gap_lenses = std::max(whole_in(gap, pitch), 2 * bleed_lenses(data, style));
  out.gap_rows = std::max(whole_in(gap, kInch / data.dpi_y), 2 * bleed_rows(data, style));
  out.more_lenses = static_cast<std::int64_t>(kMore / pitch);
  return out;
}

parser::Extent needed_extent(const Layout& layout, const LensData& data, const SheetStyle& style) {
  const core::LensColumns& lenses = layout.marks;
  const std::int64_t bleed = bleed_lenses(data, style);
  // Where strips are wider apart than lenses, the outer pictures reach beyond those of `marks` by less than a lens.
  return extent_with_marks(lenses.first_column(layout.lenses + bleed) - lenses.first_column(-bleed),
                           layout.rows + 2 * bleed_rows(data, style), data, style);
}

bool has_room(const parser::Extent& paper, const parser::Extent& needed, const LensData& data) {
  return holds(paper, needed, data) || holds({paper.height, paper.width}, needed, data);
}

SheetPage sheet_page(std::vector<SheetArt> arts, const Layout& layout, const LensData& data,
                     const SheetStyle& style) {
  PixelBox all = box_of(arts[0], layout.places[0]), all_cut = cut_of(arts[0], layout.places[0]);
  for (std::size_t i = 1; i < arts.size(); ++i) {
    all.include(box_of(arts[i], layout.places[i]));
    all_cut.include(cut_of(arts[i], layout.places[i]));
  }
  const std::int64_t columns = all.right - all.left, rows = all.bottom - all.top;
  const parser::Extent extent =
      extent_of_page(extent_with_marks(columns, rows, data, style), data, style);
  SheetPage sheet{
      .page = page_of(extent.width, extent.height, data.dpi_x, data.dpi_y, style.background)};
  Page& page = sheet.page;
  page.title = style.name;
  const std::int64_t right_by = (std::int64_t{page.columns()} - columns) / 2 - all.left;
  const std::int64_t down_by = (std::int64_t{page.rows()} - rows) / 2 - all.top;
  sheet.column = right_by + layout.places[0].column;
  MarkedSheet marked{.lenses = layout.marks,
                     .end_lens = layout.lenses,
                     .name = style.name,
                     .is_across = style.is_across};
  marked.lenses.origin += static_cast<double>(right_by);
  for (std::size_t i = 0; i < arts.size(); ++i) {
    const PixelBox box = box_of(arts[i], layout.places[i]).moved(right_by, down_by);
    marked.art.push_back(box.on(page));
    marked.cuts.push_back(cut_of(arts[i], layout.places[i]).moved(right_by, down_by).on(page));
    page.pictures.push_back({std::move(arts[i].image), box.left, box.top});
  }
  marked.all = sheet.art = page.bleed = all.moved(right_by, down_by).on(page);
  marked.all_cut = page.trim = all_cut.moved(right_by, down_by).on(page);
  for (std::int64_t lens = 0; lens <= layout.lenses; ++lens)
    sheet.boundaries.push_back(marked.lenses.first_column(lens));
  put_marks(page, marked, data, style.marks);
  sheet.cuts = std::move(marked.cuts);
  return sheet;
}

SheetPage sheet_page(SheetArt art, const LensData& data, const SheetStyle& style) {
  const LayoutItem item{.lenses = art.end_lens - art.first_lens,
                        .rows = art.trim_bottom - art.trim_top,
                        .first_lens = art.first_lens,
                        .first_row = art.trim_top};
  const Layout layout =
      layout_of({item}, {}, layout_style(data, style, data.pixels, art.lenses.origin));
  std::vector<SheetArt> arts;
  arts.push_back(std::move(art));
  return sheet_page(std::move(arts), layout, data, style);
}

}  // namespace lentray::print
