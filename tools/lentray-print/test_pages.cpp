#include "tools/lentray-print/test_pages.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "camera/text.h"
#include "core/base/formed.h"
#include "tools/lentray-print/letters.h"
#include "tools/lentray-print/lines.h"
#include "tools/lentray-print/page_error.h"

namespace lentray::print {

using camera::format;

namespace {

constexpr double kEdge = 6.0;                              ///< blank border of the page
constexpr double kTitle = 3.0, kText = 1.8, kLabel = 2.2;  ///< heights of letters
constexpr double kRulerRoom = 11.0;
constexpr double kLeastBand = 2.5, kMostBand = 25.0, kBandGap = 0.6;

std::string with_decimals(double value, int decimals) {
  return core::formed("%.*f", decimals, value);
}

/// Where the bands go.
struct Field {
  double left, right, top, bottom;
};

/// Two scales on one line, centred: inches above it, centimetres below.
void add_ruler(Page& page, double base) {
  constexpr double kThin = 0.12;
  const double room = page.width - 2.0 * kEdge;
  const auto tick = [&](double x, double from, double to) {
    page.bars.push_back({x - kThin / 2.0, from, kThin, to - from});
  };
  const double mm = std::floor(room / 10.0) * 10.0, left = page.width / 2.0 - mm / 2.0;
  for (int i = 0; i <= static_cast<int>(mm); ++i) {
    const double length = i % 10 == 0 ? 3.0 : i % 5 == 0 ? 2.2 : 1.4;
    tick(left + i, base, base + length);
    if (i % 10 == 0 && i > 0) {
      add_text(page, std::to_string(i), {left + i - 0.6, base + 4.7}, 1.5, Align::right);
    }
  }
  add_text(page, "mm", {left + 0.8, base + 4.7}, 1.5);
  constexpr int kEighths = 8;
  const int eighths = static_cast<int>(std::floor(mm / kInch * kEighths));
  for (int i = 0; i <= eighths; ++i) {
    const double length = i % kEighths == 0 ? 3.0 : i % 4 == 0 ? 2.2 : 1.4;
    tick(left + i * kInch / kEighths, base - length, base);
    if (i % kEighths == 0 && i > 0) {
      add_text(page, std::to_string(i / kEighths), {left + i * kInch / kEighths - 0.6, base - 3.2},
               1.5, Align::right);
    }
  }
  add_text(page, "in", {left + 0.8, base - 3.2}, 1.5);
  page.bars.push_back({left - kThin / 2.0, base - kThin / 2.0, mm + kThin, kThin});
}

/// Title, instructions, the lenses' direction, rulers. Returns what is left.
Field add_frame(Page& page, const std::string& text) {
  constexpr double kArrowRoom = 17.0;
  add_text(page, page.title, {kEdge, kEdge + kTitle}, kTitle);
  const double first = kEdge + kTitle + 2.2 + kText;
  const int lines =
      add_paragraph(page, text, {kEdge, first}, kText, page.width - 2.0 * kEdge - kArrowRoom);
  const double end = std::max(first + (lines - 1) * kLineStep * kText + 2.0, kEdge + 12.0);
  const double x = page.width - kEdge - 6.0;
  add_double_arrow(page, {x, kEdge + 4.0}, 8.0);
  add_text(page, "lenses", {x, kEdge + 10.6}, 1.6, Align::centre);
  const double base = page.height - kEdge - 4.9;
  if (page.width >= 2.0 * kEdge + 20.0) add_ruler(page, base);
  return {kEdge, page.width - kEdge, end + 0.8, page.height - kEdge - kRulerRoom};
}

/// The rows of pixels of band i of n in a field, and its middle in mm.
struct BandRows {
  std::int64_t first;
  std::uint32_t count;
  double middle;
};

BandRows band_rows(const Page& page, const Field& field, std::size_t i, std::size_t n) {
  const double room = (field.bottom - field.top + kBandGap) / static_cast<double>(n);
  const double step = std::min(room, kMostBand + kBandGap);
  if (!(step - kBandGap >= kLeastBand)) {
    throw PageError("a page of " + format(page.width) + " x " + format(page.height) +
                    " mm has no room for " + std::to_string(n) + " bands, which need " +
                    format(std::ceil(page.height - (field.bottom - field.top) +
                                     static_cast<double>(n) * (kLeastBand + kBandGap))) +
                    " mm of height; give a larger --size or fewer bands");
  }
  const double top = field.top + static_cast<double>(i) * step, bottom = top + step - kBandGap;
  const auto first = std::llround(top / page.pixel_height());
  const auto end = std::llround(bottom / page.pixel_height());
  return {first, static_cast<std::uint32_t>(std::max(1LL, end - first)), (top + bottom) / 2.0};
}

/// Whole pixels between two places in mm.
struct BandColumns {
  double left, right;
};
BandColumns band_columns(const Page& page, double left, double right) {
  constexpr double kLeastLength = 10.0;
  if (right - left < kLeastLength) {
    throw PageError("a page of " + format(page.width) + " x " + format(page.height) +
                    " mm has no room for gratings beside their labels; give a larger --size");
  }
  return {std::ceil(left / page.pixel_width()), std::floor(right / page.pixel_width())};
}

double middle_column(const Page& page) { return page.columns() / 2.0; }

void check_lines(double lpi, double dpi) {
  constexpr double kLeastPixels = 2.0;
  if (dpi / lpi >= kLeastPixels) return;
  throw PageError("gratings of " + format(lpi) + " lpi at " + format(dpi) +
                  " dpi: a line and its gap need 2 pixels at least");
}

/// The widest label of gratings that can be printed.
double checked_label_width(const std::vector<double>& lpis, int decimals, double dpi) {
  double label = 0.0;
  for (const double lpi : lpis) {
    check_lines(lpi, dpi);
    label = std::max(label, text_width(with_decimals(lpi, decimals), kLabel));
  }
  return label;
}

Page test_page(const TestPaper& paper, const std::string& title) {
  constexpr double kLeast = 60.0;
  if (paper.width < kLeast || paper.height < 40.0) {
    throw PageError("a page of " + format(paper.width) + " x " + format(paper.height) +
                    " mm is too small for a test; 60 x 40 mm is the least");
  }
  Page page = page_of(paper.width, paper.height, paper.dpi, paper.dpi_down());
  page.title = title;
  return page;
}

}  // namespace

int round_to_labels(std::vector<double>& values) {
  constexpr int kMost = 4;
  int decimals = 0;
  const auto rounded = [&](double value) {
    const double scale = std::pow(10.0, decimals);
    return std::round(value * scale) / scale;
  };
  const auto is_exact = [&](double value) { return std::fabs(rounded(value) - value) < 1e-7; };
  while (decimals < kMost && !std::ranges::all_of(values, is_exact)) ++decimals;
  for (double& value : values) value = rounded(value);
  return decimals;
}

std::vector<double> series(double nominal, double span, double step) {
  const int each_side = static_cast<int>(std::floor(span / step + 1e-9));
  std::vector<double> all;
  for (int i = -each_side; i <= each_side; ++i) all.push_back(nominal + i * step);
  return all;
}

Page pitch_test(const TestPaper& paper, std::vector<double> lpis) {
  const int decimals = round_to_labels(lpis);
  const std::string range =
      with_decimals(lpis.front(), decimals) + " to " + with_decimals(lpis.back(), decimals);
  Page page =
      test_page(paper, "Pitch test " + range + " lpi, " + dpi_text(paper.dpi, paper.dpi_down()));
  const double label =
      std::max(text_width("lpi", kLabel), checked_label_width(lpis, decimals, paper.dpi));
  const double length = page.width - 2.0 * (kEdge + label + 2.0);
  const Field field = add_frame(
      page,
      "Print at 100 %, without fitting to the page, and check the rulers. Lay the lens sheet on, "
      "its "
      "lenses along the lines, and look from the final distance. Turn it until the bands stand "
      "upright. The band that turns dark or light as a whole has the right pitch: its number is "
      "for Print_LPI= of lentray, or where the picture is there already for lentray-print sheet "
      "--pitch. One stripe over a band: its number is " +
          with_decimals(kInch / length, 2) + " off.");
  const BandColumns columns =
      band_columns(page, field.left + label + 2.0, field.right - label - 2.0);
  for (std::size_t i = 0; i < lpis.size(); ++i) {
    const BandRows rows = band_rows(page, field, i, lpis.size());
    const Lines lines{.period = paper.dpi / lpis[i],
                      .origin = middle_column(page) - 0.5 * paper.dpi / lpis[i]};
    page.pictures.push_back(
        grating({lines, columns.left, columns.right, paper.is_hard}, rows.first, rows.count, page));
    const std::string text = with_decimals(lpis[i], decimals);
    const double foot = rows.middle + kLabel / 2.0;
    add_text(page, text, {field.left + label, foot}, kLabel, Align::right);
    add_text(page, text, {field.right - label, foot}, kLabel);
  }
  return page;
}

Page phase_test(const TestPaper& paper, std::vector<double> lpis, int phases) {
  constexpr double kCellGap = 1.2, kHead = 3.6, kLeastPeriods = 1.5;
  const int decimals = round_to_labels(lpis);
  Page page =
      test_page(paper, "Phase test about " + with_decimals(lpis[lpis.size() / 2], decimals) +
                           " lpi, " + dpi_text(paper.dpi, paper.dpi_down()));
  const double label = checked_label_width(lpis, decimals, paper.dpi);
  Field field = add_frame(
      page,
      "Print at 100 % and check the rulers. Lay the lens sheet on, its lenses along the lines, an "
      "edge "
      "of it at a known place. In the row of the right pitch each cell has one tone. The darkest "
      "cell's number is how far the lenses stand to the right of the page's lines, in parts of " +
          std::to_string(phases) + " of a lens.");
  field.top += kHead;
  const BandColumns whole = band_columns(page, field.left + label + 2.0, field.right);
  const double cell = (whole.right - whole.left) / phases,
               gap = std::max(kCellGap / page.pixel_width(),
                              kLeastPeriods * paper.dpi / lpis.front());
  if (!(cell - gap >= 8.0 * paper.dpi / lpis.front())) {
    throw PageError(std::to_string(phases) +
                    " cells of 8 lenses side by side do not fit on a page of " +
                    format(page.width) + " mm; give a larger --size or fewer --phases");
  }
  for (int phase = 0; phase < phases; ++phase) {
    const double middle = (whole.left + (phase + 0.5) * cell - gap / 2.0) * page.pixel_width();
    add_text(page, std::to_string(phase), {middle, field.top - 1.2}, kText, Align::centre);
  }
  for (std::size_t i = 0; i < lpis.size(); ++i) {
    const BandRows rows = band_rows(page, field, i, lpis.size());
    const double period = paper.dpi / lpis[i];
    for (int phase = 0; phase < phases; ++phase) {
      const double left = std::round(whole.left + phase * cell);
      const double right = std::round(whole.left + (phase + 1) * cell - gap);
      const double shift = static_cast<double>(phase) / phases - 0.5;
      page.pictures.push_back(
          grating({{.period = period, .origin = middle_column(page) + shift * period},
                   left,
                   right,
                   paper.is_hard},
                  rows.first, rows.count, page));
    }
    add_text(page, with_decimals(lpis[i], decimals),
             {field.left + label, rows.middle + kLabel / 2.0}, kLabel, Align::right);
  }
  return page;
}

Page eye_test(const TestPaper& paper, const EyeTest& test) {
  Page page = test_page(paper, "Eye test " + format(test.distance) + " mm, lenses of " +
                                   format(kInch / test.lens_pitch) + " lpi, " +
                                   dpi_text(paper.dpi, paper.dpi_down()));
  constexpr double kShares[] = {0.8, 0.9, 1.0, 1.1, 1.2};
  const double depth =
      test.focal_length / test.ior;  // of the print behind the lens, as the eye sees it
  const double zone = test.lens_pitch * test.distance * kShares[0] / depth;
  if (!(zone > test.separation)) {
    throw PageError("at " + format(test.distance * kShares[0]) +
                    " mm, the nearest row, a lens shows its strip over " + format(zone) +
                    " mm, in which eyes " + format(test.separation) +
                    " mm apart have no room; give a larger --distance");
  }
  double label = 0.0;
  for (const double share : kShares)
    label = std::max(label, text_width(format(share * test.distance) + " mm", kLabel));
  Field field = add_frame(
      page,
      "Print at 100 % and check the rulers. Lay the lens sheet on, its lenses along the lines, and "
      "slide it until the middle of a lens stands over the tick in the middle of the page. From "
      "the distance of a row, your "
      "left eye sees that row black and your right eye sees it white, over its whole length.");
  constexpr double kTick = 3.0, kTickWidth = 0.2;
  const double middle = middle_column(page) * page.pixel_width();
  page.bars.push_back({middle - kTickWidth / 2.0, field.top, kTickWidth, kTick});
  field.top += kTick + 0.4;
  const BandColumns columns = band_columns(page, field.left + label + 2.0, field.right);
  for (std::size_t i = 0; i < std::size(kShares); ++i) {
    const BandRows rows = band_rows(page, field, i, std::size(kShares));
    const double distance = kShares[i] * test.distance;
    const double period = test.lens_pitch * (1.0 + depth / distance) * paper.dpi / kInch;
    check_lines(paper.dpi / period, paper.dpi);
    // A strip's right half is seen from the left of its lens.
    const Lines lines{
        .period = period, .origin = middle_column(page) - 0.5 * period, .from = 0.5, .to = 1.0};
    page.pictures.push_back(
        grating({lines, columns.left, columns.right, paper.is_hard}, rows.first, rows.count, page));
    add_text(page, format(distance) + " mm", {field.left + label, rows.middle + kLabel / 2.0},
             kLabel, Align::right);
  }
  return page;
}

}  // namespace lentray::print
