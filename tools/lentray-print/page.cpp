#include "tools/lentray-print/page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "camera/text.h"
#include "core/image/orientation.h"
#include "tools/lentray-print/letters.h"

namespace lentray::print {
namespace {

bool is_told(const Box& box) { return box.width > 0.0; }

/// All but pictures.
void move_parts(Page& page, const auto& move_box, const auto& moved_point) {
  std::ranges::for_each(page.bars, move_box);
  if (is_told(page.trim)) move_box(page.trim);
  if (is_told(page.bleed)) move_box(page.bleed);
  for (Stroke& stroke : page.strokes) {
    for (Point& point : stroke.points) point = moved_point(point);
  }
}

}  // namespace

std::uint32_t Page::columns() const {
  return static_cast<std::uint32_t>(std::max(1LL, std::llround(width / pixel_width())));
}
std::uint32_t Page::rows() const {
  return static_cast<std::uint32_t>(std::max(1LL, std::llround(height / pixel_height())));
}

Page page_of(double width, double height, double dpi_x, double dpi_y, Colour background) {
  Page page{.width = width, .height = height, .dpi_x = dpi_x, .dpi_y = dpi_y};
  page.background = background;
  const double bright = 0.3 * background.red + 0.59 * background.green + 0.11 * background.blue;
  if (bright < 0.5) page.ink = kWhite;
  return page;
}

std::string dpi_text(double dpi_x, double dpi_y) {
  const std::string down = dpi_y == dpi_x ? std::string() : " x " + camera::format(dpi_y);
  return camera::format(dpi_x) + down + " dpi";
}

void add_text(Page& page, std::string_view text, Point foot, double height, Align align) {
  const double width = text_width(text, height);
  if (align == Align::centre) foot.x -= width / 2.0;
  if (align == Align::right) foot.x -= width;
  for (Stroke& stroke : text_strokes(text, foot, height)) page.strokes.push_back(std::move(stroke));
}

int add_paragraph(Page& page, std::string_view text, Point foot, double height, double width) {
  int lines = 0;
  std::string line;
  const auto flush = [&] {
    add_text(page, line, {foot.x, foot.y + lines * kLineStep * height}, height);
    ++lines;
    line.clear();
  };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word(text.substr(at, end - at));
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && text_width(longer, height) > width) {
      flush();
      line = word;
    } else {
      line = longer;
    }
    at = end + 1;
  }
  if (!line.empty()) flush();
  return lines;
}

void add_double_arrow(Page& page, Point middle, double length) {
  constexpr double kWidth = 0.3;
  const double half = length / 2.0, head = std::min(1.6, length / 4.0);
  const Point top{middle.x, middle.y - half}, bottom{middle.x, middle.y + half};
  page.strokes.push_back({{top, bottom}, kWidth});
  for (const auto& [tip, back] : {std::pair{top, head}, std::pair{bottom, -head}}) {
    page.strokes.push_back(
        {{{tip.x - head * 0.6, tip.y + back}, tip, {tip.x + head * 0.6, tip.y + back}}, kWidth});
  }
}

Page mirrored(Page page) {
  const auto columns = static_cast<std::int64_t>(page.columns());
  const double right = static_cast<double>(columns) * page.pixel_width();
  for (Picture& picture : page.pictures) {
    picture.column = columns - picture.column - picture.image.width;
    picture.image = core::upright(std::move(picture.image), core::kMirrored);
  }
  move_parts(
      page, [right](Box& box) { box.left = right - box.right(); },
      [right](Point p) {
        return Point{right - p.x, p.y};
      });
  return page;
}

Page turned(Page page) {
  const auto rows = static_cast<std::int64_t>(page.rows());
  const double bottom = static_cast<double>(rows) * page.pixel_height();
  for (Picture& picture : page.pictures) {
    const std::int64_t column = rows - picture.row - picture.image.height;
    picture.row = picture.column;
    picture.column = column;
    picture.image = core::upright(std::move(picture.image), core::kTurned);
  }
  const auto turn = [bottom](Box& box) {
    box = {bottom - box.bottom(), box.left, box.height, box.width};
  };
  move_parts(page, turn, [bottom](Point p) { return Point{bottom - p.y, p.x}; });
  std::swap(page.width, page.height);
  std::swap(page.dpi_x, page.dpi_y);
  return page;
}

}  // namespace lentray::print
