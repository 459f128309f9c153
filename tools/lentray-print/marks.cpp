#include "tools/lentray-print/marks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "camera/text.h"
#include "tools/lentray-print/letters.h"
#include "tools/lentray-print/lines.h"

namespace lentray::print {

using camera::format;

namespace {

constexpr double kMarkGap = 1.0;     ///< between a picture and its marks, and between marks
constexpr double kLinesDepth = 3.0;  ///< of the gratings, at least
constexpr double kCropLength = 5.0, kCropWidth = 0.2;
constexpr double kLeastCrop = 1.0;  ///< shorter ones, between two pictures, are left out
constexpr double kCorner = 2.0;     ///< that gratings and bars leave free beside crop marks
constexpr double kBarWidth = 2.0;   ///< about
constexpr double kLabelHeight = 1.6, kLabelGap = 0.8;

/// How far a mark may reach from its picture before it comes near another one, by steps of one side.
/// `from`, `to`: its place beside the picture, `along` its middle line.
double free_length(double from, int direction, double along, const std::vector<Box>& art,
                   bool is_level) {
  double length = kCropLength;
  for (const Box& box : art) {
    const double near_side = is_level ? box.top : box.left;
    const double far_side = is_level ? box.bottom() : box.right();
    if (along <= near_side - kMarkGap || along >= far_side + kMarkGap) continue;
    const double begin = is_level ? box.left : box.top;
    const double end = is_level ? box.right() : box.bottom();
    const double room = direction > 0 ? begin - kMarkGap - from : from - (end + kMarkGap);
    const bool is_behind = direction > 0 ? end <= from : begin >= from;
    if (!is_behind) length = std::min(length, room);
  }
  return length;
}

std::string joined_facts(const std::vector<LabelFact>& facts) {
  std::string text;
  for (const LabelFact& fact : facts) text += (text.empty() ? "" : "  |  ") + fact.text;
  return text;
}

/// Puts marks around the art.
class Marking {
 public:
  Marking(Page& page, const MarkedSheet& sheet, const LensData& data, Marks marks)
      : m_page(page), m_sheet(sheet), m_data(data),
        m_room(mark_room(data, marks, sheet.is_across)) {}

  void put_crop_marks() {
    for (std::size_t i = 0; i < m_sheet.cuts.size(); ++i) {
      const Box &cut = m_sheet.cuts[i], &art = m_sheet.art[i];
      for (const double x : {cut.left, cut.right()}) {
        put_crop(art.top - kMarkGap, -1, x, false);
        put_crop(art.bottom() + kMarkGap, 1, x, false);
      }
      for (const double y : {cut.top, cut.bottom()}) {
        put_crop(art.left - kMarkGap, -1, y, true);
        put_crop(art.right() + kMarkGap, 1, y, true);
      }
    }
  }

  void put_lines_beside() {
    const auto sides = side_gratings();
    const double py = m_page.pixel_height();
    for (const Piece& rows : free_rows()) {
      const auto height = static_cast<std::uint32_t>(rows.end - rows.begin);
      for (const Grating& side : sides)
        m_page.pictures.push_back(grating(side, rows.begin, height, m_page));
      const double from = static_cast<double>(rows.begin) * py, length = height * py;
      m_page.bars.push_back({left_bar(), from, m_room.bar_width, length});
      m_page.bars.push_back({right_bar(), from, m_room.bar_width, length});
    }
  }

  void put_lines_above() {
    const auto rows = static_cast<std::uint32_t>(
        std::max(1LL, std::llround(kLinesDepth / m_page.pixel_height())));
    const auto above = std::llround((m_sheet.all.top - kMarkGap) / m_page.pixel_height());
    const auto below = std::llround((m_sheet.all.bottom() + kMarkGap) / m_page.pixel_height());
    for (const Piece& lenses : free_lenses()) {
      const Grating all = between(lenses.begin, lenses.end);
      m_page.pictures.push_back(grating(all, above - rows, rows, m_page));
      m_page.pictures.push_back(grating(all, below, rows, m_page));
    }
  }

  /// As many facts as there is room for. The strips' pitch and the resolution are what a print has to be printed with,
  /// so they go last, after smaller letters were tried.
  void put_label() {
    const double left = m_sheet.all_cut.left + kCorner, right = m_sheet.all_cut.right() - kCorner;
    const double below = m_sheet.all.bottom() + kMarkGap + kLinesDepth + kLabelGap + kLabelHeight;
    const double above = m_sheet.all.top - kMarkGap - kLinesDepth - kLabelGap;
    if (text_width(kTop, kLabelHeight) < right - left) {
      add_text(m_page, kTop, {(left + right) / 2.0, above}, kLabelHeight, Align::centre);
    }
    const Label label = label_within(label_facts(), right - left);
    add_text(m_page, label.text, {left, below}, label.height);
  }

  /// The same of a page that will be turned clockwise: what is its left now is its top then.
  void put_label_across() {
    const double top = m_sheet.all_cut.top + kCorner, bottom = m_sheet.all_cut.bottom() - kCorner;
    const double width = text_width(kTop, kLabelHeight);
    if (width < bottom - top) {
      add_rising_text(kTop, {left_bar() - kLabelGap, (top + bottom + width) / 2.0}, kLabelHeight);
    }
    const Label label = label_within(label_facts(), bottom - top);
    const double foot = right_bar() + m_room.bar_width + kLabelGap + kLabelHeight;
    add_rising_text(label.text, {foot, bottom}, label.height);
  }

  std::vector<LabelFact> label_facts() const {
    enum : int { kName = 3, kLenses = 2, kStrips = 6, kDpi = 5, kLens = 1, kSeen = 0, kSize = 4 };
    std::vector<LabelFact> facts{{m_sheet.name, kName},
                                 {std::to_string(m_sheet.end_lens) + " lenses", kLenses},
                                 {"print " + format(m_data.print_lpi()) + " lpi", kStrips},
                                 {dpi_text(m_data.dpi_x, m_data.dpi_y), kDpi}};
    if (m_data.lens) {
      facts.push_back({"lens " + format(m_data.lens->pitch) + " mm", kLens});
      facts.push_back({m_data.lens->view_distance > 0.0
                           ? "seen from " + format(m_data.lens->view_distance) + " mm"
                           : "seen from far",
                       kSeen});
    }
    facts.push_back({"100 %", kSize});
    return facts;
  }

 private:
  static constexpr const char* kTop = "TOP";

  /// Before and behind all lenses.
  std::array<Grating, 2> side_gratings() const {
    const std::int64_t before = m_sheet.lenses.lens_of(column_at(m_sheet.all.left));
    const std::int64_t behind = std::max(
        m_sheet.end_lens - before, m_sheet.lenses.lens_of(column_at(m_sheet.all.right()) - 1) + 1);
    const std::int64_t left = before - m_room.gap_lenses, right = behind + m_room.gap_lenses;
    return {between(left - m_room.line_lenses, left), between(right, right + m_room.line_lenses)};
  }
  double left_bar() const {
    return side_gratings()[0].left * m_page.pixel_width() - kMarkGap - m_room.bar_width;
  }
  double right_bar() const { return side_gratings()[1].right * m_page.pixel_width() + kMarkGap; }

  /// From the bottom to the top.
  void add_rising_text(const std::string& text, Point foot, double height) {
    for (Stroke& stroke : text_strokes(text, {0.0, 0.0}, height)) {
      for (Point& p : stroke.points) p = {foot.x + p.y, foot.y - p.x};
      m_page.strokes.push_back(std::move(stroke));
    }
  }

  /// Rows or lenses, from one to before another.
  struct Piece {
    std::int64_t begin, end;
  };

  std::int64_t column_at(double mm) const { return std::llround(mm / m_page.pixel_width()); }
  std::int64_t row_at(double mm) const { return std::llround(mm / m_page.pixel_height()); }

  /// Between the crop marks at the sides.
  std::vector<Piece> free_rows() const {
    std::vector<std::int64_t> cuts;
    for (const Box& cut : m_sheet.cuts) {
      cuts.push_back(row_at(cut.top));
      cuts.push_back(row_at(cut.bottom()));
    }
    std::ranges::sort(cuts);
    std::vector<Piece> out;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const Piece piece{cuts[i - 1] + row_at(kCorner), cuts[i] - row_at(kCorner)};
      if (piece.end - piece.begin >= row_at(kCorner)) out.push_back(piece);
    }
    return out;
  }

  /// Between the crop marks above and below, in whole lenses.
  std::vector<Piece> free_lenses() const {
    const core::LensColumns& lenses = m_sheet.lenses;
    std::vector<double> cuts;  // in lenses; those of the edges are lens edges
    for (const Box& cut : m_sheet.cuts) {
      for (const double x : {cut.left, cut.right()})
        cuts.push_back((x / m_page.pixel_width() - lenses.origin) / lenses.pixels);
    }
    std::ranges::sort(cuts);
    const double corner = kCorner / m_data.print_pitch(), pixel = 0.5 / lenses.pixels;
    std::vector<Piece> out;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      // Cuts are whole pixels, up to half a one beside the lens's edge.
      const Piece piece{static_cast<std::int64_t>(std::ceil(cuts[i - 1] + corner - pixel)),
                        static_cast<std::int64_t>(std::floor(cuts[i] - corner + pixel))};
      const bool is_gap = m_sheet.cuts.size() > 1 && (cuts[i] - cuts[i - 1]) < 3.0 * corner;
      if (piece.end > piece.begin && !is_gap) out.push_back(piece);
    }
    return out;
  }

  /// A mark from a place away from its picture: along a row if it is level, else along a column.
  void put_crop(double from, int direction, double along, bool is_level) {
    const Box& all = m_sheet.all_cut;
    const double first = is_level ? all.top : all.left,
                 last = is_level ? all.bottom() : all.right();
    constexpr double kTouch = 1e-6;
    // Those between corners end with the gratings, before the label.
    const bool is_corner = std::fabs(along - first) < kTouch || std::fabs(along - last) < kTouch;
    const double length = std::min(free_length(from, direction, along, m_sheet.art, is_level),
                                   is_corner ? kCropLength : kLinesDepth);
    if (length < kLeastCrop) return;
    const double begin = direction > 0 ? from : from - length, side = along - kCropWidth / 2.0;
    const Box mark =
        is_level ? Box{begin, side, length, kCropWidth} : Box{side, begin, kCropWidth, length};
    // Neighbours in a grid have theirs in common.
    const auto is_same = [&mark](const Box& bar) {
      return std::fabs(bar.left - mark.left) < kTouch && std::fabs(bar.top - mark.top) < kTouch &&
             std::fabs(bar.width - mark.width) < kTouch &&
             std::fabs(bar.height - mark.height) < kTouch;
    };
    if (std::ranges::none_of(m_page.bars, is_same)) m_page.bars.push_back(mark);
  }

  /// Between the edges of two lenses, which need not be whole pixels.
  Grating between(std::int64_t first, std::int64_t end) const {
    const core::LensColumns& lenses = m_sheet.lenses;
    return {{.period = lenses.pixels, .origin = lenses.origin},
            lenses.edge(static_cast<double>(first)),
            lenses.edge(static_cast<double>(end))};
  }

  Page& m_page;
  const MarkedSheet& m_sheet;
  const LensData& m_data;
  const MarkRoom m_room;
};

}  // namespace

Label label_within(std::vector<LabelFact> facts, double width) {
  constexpr double kLeastHeight = 0.9;
  constexpr std::size_t kLastTwo = 2;
  const auto is_lower = [](const LabelFact& a, const LabelFact& b) { return a.weight < b.weight; };
  while (!facts.empty()) {
    const std::string text = joined_facts(facts);
    const double needed = text_width(text, kLabelHeight);
    if (needed <= width) return {text, kLabelHeight};
    const double smaller = kLabelHeight * width / needed;
    if (facts.size() <= kLastTwo && smaller >= kLeastHeight) return {text, smaller};
    facts.erase(std::ranges::min_element(facts, is_lower));
  }
  return {};
}

std::int64_t whole_in(double length, double pitch) {
  return static_cast<std::int64_t>(std::ceil(length / pitch - 1e-9));
}

MarkRoom mark_room(const LensData& data, Marks marks, bool is_across) {
  MarkRoom room;
  if (marks == Marks::none) return room;
  room.across = room.down = kMarkGap + kCropLength;
  if (marks == Marks::crop) return room;
  const double pitch = data.print_pitch();
  room.gap_lenses = whole_in(kMarkGap, pitch);
  room.line_lenses = whole_in(kLinesDepth, pitch);
  // Half a lens more than whole ones: seen through lenses, its two edges are never alike.
  room.bar_width = (std::max(0.0, std::round(kBarWidth / pitch - 0.5)) + 0.5) * pitch;
  room.across =
      std::max(room.across, static_cast<double>(room.gap_lenses + room.line_lenses) * pitch +
                                data.print_pitch() + kMarkGap + room.bar_width);
  const double lines = kMarkGap + kLinesDepth, label = kLabelGap + kLabelHeight;
  if (is_across) room.across += label;
  room.down = std::max(room.down, is_across ? lines : lines + label);
  return room;
}

void put_marks(Page& page, const MarkedSheet& sheet, const LensData& data, Marks marks) {
  if (marks == Marks::none) return;
  Marking marking(page, sheet, data, marks);
  marking.put_crop_marks();
  if (marks == Marks::crop) return;
  marking.put_lines_beside();
  marking.put_lines_above();
  sheet.is_across ? marking.put_label_across() : marking.put_label();
}

}  // namespace lentray::print
