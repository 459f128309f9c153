#include "tools/lentray-print/sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "camera/text.h"
#include "tools/lentray-print/letters.h"
#include "tools/lentray-print/lines.h"
#include "tools/lentray-print/page_error.h"
#include "tools/lentray-print/pixels.h"

namespace lentray::print {

using camera::format;

namespace {

constexpr double kMarkGap = 1.0;     ///< between the picture and its marks, and between marks
constexpr double kLinesDepth = 3.0;  ///< of the gratings, at least
constexpr double kCropLength = 5.0, kCropWidth = 0.2;
constexpr double kCorner = 2.0;    ///< that gratings and bars leave free beside crop marks
constexpr double kBarWidth = 2.0;  ///< about
constexpr double kLabelHeight = 1.6, kLabelGap = 0.8;

/// The first column behind a lens: floor((k + 1/2)/N) reaches its number there.
std::int64_t lens_column(std::int64_t lens, double pixels) {
  return static_cast<std::int64_t>(std::ceil(static_cast<double>(lens) * pixels - 0.5));
}

std::int64_t lenses_in(double length, double pitch) {
  return static_cast<std::int64_t>(std::ceil(length / pitch - 1e-9));
}

/// How far marks reach from the picture and its bleed.
struct MarkRoom {
  std::int64_t gap_lenses = 0, line_lenses = 0;
  double bar_width = 0.0;
  double across = 0.0, down = 0.0;
};

MarkRoom mark_room(const LensData& data, Marks marks) {
  MarkRoom room;
  if (marks == Marks::none) return room;
  room.across = room.down = kMarkGap + kCropLength;
  if (marks == Marks::crop) return room;
  const double pitch = data.print_pitch();
  room.gap_lenses = lenses_in(kMarkGap, pitch);
  room.line_lenses = lenses_in(kLinesDepth, pitch);
  // Half a lens more than whole ones: seen through lenses, its two edges are never alike.
  room.bar_width = (std::max(0.0, std::round(kBarWidth / pitch - 0.5)) + 0.5) * pitch;
  room.across =
      std::max(room.across, static_cast<double>(room.gap_lenses + room.line_lenses) * pitch +
                                data.print_pitch() + kMarkGap + room.bar_width);
  room.down = std::max(room.down, kMarkGap + kLinesDepth + kLabelGap + kLabelHeight);
  return room;
}

/// Puts marks around the art.
class Marking {
 public:
  Marking(const SheetArt& art, const LensData& data, const SheetStyle& style, SheetPage& sheet,
          std::int64_t row)
      : m_art(art), m_data(data), m_style(style), m_room(mark_room(data, style.marks)),
        m_sheet(sheet), m_page(sheet.page), m_row(row) {}

  void put() {
    if (m_style.marks == Marks::none) return;
    put_crop_marks();
    if (m_style.marks == Marks::crop) return;
    put_lines_beside();
    put_lines_above();
    put_label();
  }

 private:
  double x(std::int64_t column) const {
    return static_cast<double>(m_sheet.column + column) * m_page.pixel_width();
  }
  double y(std::int64_t row) const {
    return static_cast<double>(m_row + row) * m_page.pixel_height();
  }

  void put_crop_marks() {
    const Box& art = m_sheet.art;
    const double half = kCropWidth / 2.0;
    for (const std::int64_t column : {m_art.trim_left, m_art.trim_right}) {
      m_page.bars.push_back(
          {x(column) - half, art.top - kMarkGap - kCropLength, kCropWidth, kCropLength});
      m_page.bars.push_back({x(column) - half, art.bottom() + kMarkGap, kCropWidth, kCropLength});
    }
    for (const std::int64_t row : {m_art.trim_top, m_art.trim_bottom}) {
      m_page.bars.push_back(
          {art.left - kMarkGap - kCropLength, y(row) - half, kCropLength, kCropWidth});
      m_page.bars.push_back({art.right() + kMarkGap, y(row) - half, kCropLength, kCropWidth});
    }
  }

  Lines lines() const {
    return {.period = m_data.pixels, .origin = static_cast<double>(m_sheet.column)};
  }
  /// Between the edges of two lenses, which need not be whole pixels.
  Grating between(std::int64_t first, std::int64_t end) const {
    return {lines(),
            static_cast<double>(m_sheet.column) + static_cast<double>(first) * m_data.pixels,
            static_cast<double>(m_sheet.column) + static_cast<double>(end) * m_data.pixels};
  }

  void put_lines_beside() {
    const auto rows = [this](double mm) { return std::llround(mm / m_page.pixel_height()); };
    const std::int64_t top = m_row + m_art.trim_top + rows(kCorner);
    const std::int64_t bottom = m_row + m_art.trim_bottom - rows(kCorner);
    if (bottom - top < rows(kCorner)) return;
    const auto height = static_cast<std::uint32_t>(bottom - top);
    const std::int64_t before = static_cast<std::int64_t>(
        std::floor((static_cast<double>(m_art.first_column) + 0.5) / m_art.pixels));
    const std::int64_t behind = m_art.end_lens + (m_art.first_lens - before);
    const std::int64_t left = before - m_room.gap_lenses, right = behind + m_room.gap_lenses;
    const Grating sides[] = {between(left - m_room.line_lenses, left),
                             between(right, right + m_room.line_lenses)};
    for (const Grating& side : sides) m_page.pictures.push_back(grating(side, top, height, m_page));
    const double from = static_cast<double>(top) * m_page.pixel_height();
    const double length = height * m_page.pixel_height();
    m_page.bars.push_back({sides[0].left * m_page.pixel_width() - kMarkGap - m_room.bar_width, from,
                           m_room.bar_width, length});
    m_page.bars.push_back(
        {sides[1].right * m_page.pixel_width() + kMarkGap, from, m_room.bar_width, length});
  }

  void put_lines_above() {
    const std::int64_t corner = lenses_in(kCorner, m_data.print_pitch());
    const std::int64_t first = m_art.first_lens + corner, end = m_art.end_lens - corner;
    if (end <= first) return;
    const Grating all = between(first, end);
    const auto rows = static_cast<std::uint32_t>(
        std::max(1LL, std::llround(kLinesDepth / m_page.pixel_height())));
    const auto above = std::llround((m_sheet.art.top - kMarkGap) / m_page.pixel_height());
    const auto below = std::llround((m_sheet.art.bottom() + kMarkGap) / m_page.pixel_height());
    m_page.pictures.push_back(grating(all, above - rows, rows, m_page));
    m_page.pictures.push_back(grating(all, below, rows, m_page));
  }

  /// As many facts as there is room for.
  void put_label() {
    const double left = x(m_art.trim_left) + kCorner, right = x(m_art.trim_right) - kCorner;
    const double below = m_sheet.art.bottom() + kMarkGap + kLinesDepth + kLabelGap + kLabelHeight;
    const double above = m_sheet.art.top - kMarkGap - kLinesDepth - kLabelGap;
    const std::string top = "TOP";
    if (text_width(top, kLabelHeight) < right - left) {
      add_text(m_page, top, {(left + right) / 2.0, above}, kLabelHeight, Align::centre);
    }
    std::vector<std::string> facts{m_style.name};
    facts.push_back(std::to_string(m_art.end_lens - m_art.first_lens) + " lenses");
    facts.push_back("print " + format(m_data.print_lpi()) + " lpi, " + format(m_data.dpi_x) +
                    " dpi");
    if (m_data.lens) {
      facts.push_back("lens " + format(m_data.lens->pitch) + " mm");
      facts.push_back(m_data.lens->view_distance > 0.0
                          ? "seen from " + format(m_data.lens->view_distance) + " mm"
                          : "seen from far");
    }
    facts.push_back("100 %");
    std::string text;
    for (const std::string& fact : facts) {
      const std::string longer = text.empty() ? fact : text + "  |  " + fact;
      if (text_width(longer, kLabelHeight) > right - left) break;
      text = longer;
    }
    add_text(m_page, text, {left, below}, kLabelHeight);
  }

  const SheetArt& m_art;
  const LensData& m_data;
  const SheetStyle& m_style;
  const MarkRoom m_room;
  SheetPage& m_sheet;
  Page& m_page;
  const std::int64_t m_row;
};

std::string size_in_mm(const parser::Extent& extent) {
  return format(extent.width) + " x " + format(extent.height) + " mm";
}

/// Lets the picture's own outer part be the bleed.
void take_bleed_from(SheetArt& art, std::int64_t lenses, std::int64_t rows) {
  art.first_lens += lenses;
  art.end_lens -= lenses;
  art.trim_top += rows;
  art.trim_bottom -= rows;
  if (art.end_lens <= art.first_lens || art.trim_bottom <= art.trim_top) {
    throw PageError("nothing of the picture is left within that bleed; give a smaller --bleed");
  }
}

/// Lets the picture go on beyond its edges.
void add_bleed(SheetArt& art, std::int64_t lenses, std::int64_t rows) {
  const std::int64_t end = lens_column(art.end_lens + lenses, art.pixels);
  art.first_column = lens_column(-lenses, art.pixels);
  art.first_row = -rows;
  const std::uint32_t width = art.image.width, height = art.image.height;
  art.image = rearranged(
      std::move(art.image),
      continued_columns(art.first_column, static_cast<std::uint32_t>(end - art.first_column), width,
                        art.pixels),
      continued_rows(art.first_row, static_cast<std::uint32_t>(height + 2 * rows), height));
}

}  // namespace

SheetArt sheet_art(core::StoredImage image, const LensData& data, const SheetStyle& style) {
  SheetArt art;
  art.pixels = data.pixels;
  const std::uint32_t whole = whole_lens_columns(image.width, data.pixels);
  if (whole == 0) {
    throw PageError("the picture is " + std::to_string(image.width) +
                    " pixels wide, less than a lens of " + format(data.pixels));
  }
  art.cut_columns = image.width - whole;
  if (art.cut_columns > 0) {
    const std::uint32_t height = image.height, width = image.width;
    image = rearranged(std::move(image), continued_columns(0, whole, width, data.pixels),
                       continued_rows(0, height, height));
  }
  art.end_lens = static_cast<std::int64_t>(std::floor((whole - 0.5) / data.pixels)) + 1;
  art.trim_bottom = image.height;
  art.image = std::move(image);
  if (style.bleed > 0.0) {
    const std::int64_t lenses = lenses_in(style.bleed, data.print_pitch());
    const std::int64_t rows = lenses_in(style.bleed, kInch / data.dpi_y);
    style.bleed_of_picture ? take_bleed_from(art, lenses, rows) : add_bleed(art, lenses, rows);
  }
  art.trim_left = lens_column(art.first_lens, data.pixels);
  art.trim_right = lens_column(art.end_lens, data.pixels);
  return art;
}

parser::Extent needed_extent(const SheetArt& art, const LensData& data, const SheetStyle& style) {
  const MarkRoom room = mark_room(data, style.marks);
  const double px = kInch / data.dpi_x, py = kInch / data.dpi_y;
  return {px * (art.image.width + 2.0 * std::ceil((room.across + style.margin) / px - 1e-9)),
          py * (art.image.height + 2.0 * std::ceil((room.down + style.margin) / py - 1e-9))};
}

SheetPage sheet_page(SheetArt art, const LensData& data, const SheetStyle& style) {
  const parser::Extent needed = needed_extent(art, data, style);
  parser::Extent extent = needed;
  if (style.paper) {
    // A pixel more or less is rounding.
    const double px = 1.01 * kInch / data.dpi_x, py = 1.01 * kInch / data.dpi_y;
    const parser::Extent upright = *style.paper, across{upright.height, upright.width};
    const auto holds = [&](const parser::Extent& paper) {
      return paper.width + px >= needed.width && paper.height + py >= needed.height;
    };
    if (!holds(upright) && !holds(across)) {
      throw PageError("the sheet needs " + size_in_mm(needed) +
                      " with its marks and margins, and the paper has " + size_in_mm(upright) +
                      "; --tiles cuts it into pages");
    }
    extent = holds(upright) ? upright : across;
  }
  SheetPage sheet{
      .page = page_of(extent.width, extent.height, data.dpi_x, data.dpi_y, style.background)};
  Page& page = sheet.page;
  page.title = style.name;
  const auto centred = [](std::uint32_t room, std::uint32_t size) {
    return (static_cast<std::int64_t>(room) - static_cast<std::int64_t>(size)) / 2;
  };
  const std::int64_t left = centred(page.columns(), art.image.width);
  const std::int64_t top = centred(page.rows(), art.image.height);
  sheet.column = left - art.first_column;
  const std::int64_t row = top - art.first_row;
  const double px = page.pixel_width(), py = page.pixel_height();
  sheet.art = {static_cast<double>(left) * px, static_cast<double>(top) * py, art.image.width * px,
               art.image.height * py};
  page.pictures.push_back({std::move(art.image), left, top});
  page.trim = {static_cast<double>(sheet.column + art.trim_left) * px,
               static_cast<double>(row + art.trim_top) * py,
               static_cast<double>(art.trim_right - art.trim_left) * px,
               static_cast<double>(art.trim_bottom - art.trim_top) * py};
  page.bleed = sheet.art;
  for (std::int64_t lens = art.first_lens; lens <= art.end_lens; ++lens)
    sheet.boundaries.push_back(sheet.column + lens_column(lens, art.pixels));
  Marking(art, data, style, sheet, row).put();
  return sheet;
}

}  // namespace lentray::print
