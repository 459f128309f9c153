#include "tools/lentray-print/commands.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "camera/text.h"
#include "core/image/writer.h"
#include "parser/options/ini.h"
#include "tools/lentray-print/page_error.h"
#include "tools/lentray-print/page_file.h"
#include "tools/lentray-print/pixels.h"
#include "tools/lentray-print/repitch.h"
#include "tools/lentray-print/test_pages.h"
#include "tools/lentray-print/tiles.h"

namespace lentray::print {

using camera::format;
using parser::OptionError;

namespace {

std::string mm(double value) {
  char text[48];
  std::snprintf(text, sizeof text, "%.3f", value);
  std::string out = text;
  out.erase(out.find_last_not_of('0') + 1);
  if (out.back() == '.') out.pop_back();
  return out;
}

std::string size_text(double width, double height) {
  return mm(width) + " x " + mm(height) + " mm";
}

std::string decibels(double value) {
  return std::isfinite(value) ? mm(std::round(value)) : "infinite";
}

/// As it is printed.
Page finished(Page page, const Arguments& a) {
  if (a.horizontal) page = turned(std::move(page));
  if (a.mirror) page = mirrored(std::move(page));
  return page;
}

std::vector<double> lpis_of(const Arguments& a) {
  constexpr double kFineSpan = 0.1, kFineStep = 0.01;
  const bool is_phase = a.command == Command::phase_test;
  const double nominal = kInch / *a.lens.lens_pitch;
  const double span = a.fine ? kFineSpan : a.span.value_or(is_phase ? 0.2 : 0.5);
  if (a.bands) {
    if (*a.bands == 1) return {nominal};
    std::vector<double> all;
    all.reserve(static_cast<std::size_t>(*a.bands));
    for (int i = 0; i < *a.bands; ++i)
      all.push_back(nominal + span * (2.0 * i / (*a.bands - 1) - 1.0));
    return all;
  }
  const double step = a.fine ? kFineStep : a.step.value_or(0.1);
  constexpr double kMost = 100.0;
  if (span / step > kMost) {
    throw OptionError("a span of " + format(span) + " lpi by " + format(step) + " makes " +
                      format(2.0 * std::floor(span / step) + 1.0) + " gratings; 201 are possible");
  }
  return series(nominal, span, step);
}

Page test_page_of(const Arguments& a) {
  constexpr parser::Extent kPage{200.0, 100.0};
  const parser::Extent size = a.size.value_or(kPage);
  const TestPaper paper{.width = a.horizontal ? size.height : size.width,
                        .height = a.horizontal ? size.width : size.height,
                        .dpi = a.lens.dpi_x.value_or(600.0),
                        .is_hard = a.hard_edges};
  constexpr double kMostPixels = 100000.0;
  if (std::max(size.width, size.height) / kInch * paper.dpi > kMostPixels) {
    throw PageError("a test page of " + size_text(size.width, size.height) + " at " +
                    format(paper.dpi) + " dpi has more than 100000 pixels a side");
  }
  if (a.command == Command::eye_test) {
    return eye_test(paper, {.lens_pitch = *a.lens.lens_pitch,
                            .focal_length = a.focal_length,
                            .ior = a.ior,
                            .distance = a.distance,
                            .separation = a.separation});
  }
  std::vector<double> lpis = lpis_of(a);
  if (!(lpis.front() >= 1.0)) {
    throw OptionError("gratings down to " + format(lpis.front()) +
                      " lines an inch: 1 is the least; give a smaller --span");
  }
  return a.command == Command::pitch_test ? pitch_test(paper, std::move(lpis))
                                          : phase_test(paper, std::move(lpis), a.phases);
}

Report run_test(const Arguments& a) {
  Page page = finished(test_page_of(a), a);
  Report report;
  report.lines.push_back(a.out.string() + ": " + page.title + "; page " +
                         size_text(page.width, page.height));
  constexpr int kBits = 8;
  report.warnings = write_pages({{"", [&page] { return std::move(page); }}}, a.out, kBits);
  return report;
}

/// One run of `sheet`.
class SheetRun {
 public:
  explicit SheetRun(const Arguments& arguments)
      : m_a(arguments), m_reader(arguments.profiles), m_style(arguments.style) {}

  Report run() {
    read();
    if (m_a.print_pitch) change_pitch();
    SheetArt art = sheet_art(std::move(m_image), m_data, m_style);
    if (art.cut_columns > 0) {
      say("left out at the right: " + std::to_string(art.cut_columns) + " pixels of a cut lens");
    }
    say("picture: " + std::to_string(art.trim_right - art.trim_left) + " x " +
        std::to_string(art.trim_bottom - art.trim_top) + " pixels, " +
        std::to_string(art.end_lens - art.first_lens) + " lenses of " + format(m_data.pixels) +
        " pixels, strips " + mm(m_data.print_pitch()) + " mm apart (" + format(m_data.print_lpi()) +
        " lpi), " + format(m_data.dpi_x) + " x " + format(m_data.dpi_y) + " dpi");
    m_a.tiles ? write_tiles(std::move(art)) : write_page(std::move(art));
    for (const std::string& warning : m_reader.warnings()) m_report.warnings.push_back(warning);
    return std::move(m_report);
  }

 private:
  void say(const std::string& line) { m_report.lines.push_back(line); }

  void read() {
    core::StoredImage image = m_reader.read(m_a.image);
    tool::use_srgb_curve(image);
    m_data = lens_data_of(image, m_a.lens, m_a.image.string());
    m_bits = m_a.bits != 0 ? m_a.bits : image.bits == 8 ? 8 : 16;
    m_image = as_printed(std::move(image), m_bits, m_style.background);
    m_style.name = m_a.image.stem().string();
  }

  void change_pitch() {
    // A cut lens has not all of its views.
    const std::uint32_t whole = whole_lens_columns(m_image.width, m_data.pixels);
    const std::uint32_t width = m_image.width, height = m_image.height;
    m_image = rearranged(std::move(m_image), continued_columns(0, whole, width, m_data.pixels),
                         continued_rows(0, height, height));
    const double pixels = *m_a.print_pitch * m_data.dpi_x / kInch;
    // The cut one counts too: the scene is as wide as the sheet.
    const double lenses = width / m_data.pixels;
    const double ratio = *m_a.print_pitch / m_data.print_pitch();
    const std::string options = render_options(m_data, *m_a.print_pitch, lenses, m_image.height);
    Repitched made = repitched(m_image, m_data.pixels, pixels);
    say("--pitch: strips of " + format(pixels) + " pixels are made of views of " +
        format(m_data.pixels) + ": directions are up to " + mm(made.largest_offset) +
        " of these pixels off; the interpolation has about " + decibels(made.step_psnr) + " to " +
        decibels(made.smooth_psnr) +
        " dB PSNR, as colours jump from view to view or change smoothly; the sheet is " +
        mm(std::fabs(ratio - 1.0) * 100.0) + " % " + (ratio < 1.0 ? "narrower" : "wider"));
    if (options.empty()) {
      say("exact: a new render with Lens_Pixels=" + format(pixels) +
          "; the picture does not tell its lens");
    } else {
      say("exact: lentray SCENE.pov " + options);
    }
    m_image = std::move(made.image);
    m_data.pixels = pixels;
  }

  void write_page(SheetArt art) {
    Page page = finished(sheet_page(std::move(art), m_data, m_style).page, m_a);
    say("trimmed: " + size_text(page.trim.width, page.trim.height) + " at " + mm(page.trim.left) +
        ", " + mm(page.trim.top) + " mm" +
        (m_style.bleed > 0.0 ? "; with bleed " + size_text(page.bleed.width, page.bleed.height)
                             : std::string()));
    say(m_a.out.string() + ": page " + size_text(page.width, page.height));
    m_report.warnings = write_pages({{"", [&page] { return std::move(page); }}}, m_a.out, m_bits);
  }

  void write_tiles(SheetArt art) {
    SheetStyle whole_style = m_style;
    whole_style.paper.reset();
    whole_style.margin = 1.0;  // marks do not end at the edge of a window
    const SheetPage sheet = sheet_page(std::move(art), m_data, whole_style);
    const Page& whole = sheet.page;
    const TilePlan plan =
        tile_plan(whole, sheet.boundaries,
                  {.paper = *m_style.paper, .margin = m_style.margin, .overlap = m_a.overlap});
    std::vector<PageSource> pages;
    for (const Tile& tile : plan.tiles) {
      pages.push_back({suffix_of(tile),
                       [&, this] { return finished(tile_page(whole, plan, tile, m_bits), m_a); }});
    }
    m_report.warnings = write_pages(pages, m_a.out, m_bits);
    say("whole sheet with its marks: " + size_text(whole.width, whole.height));
    for (const Tile& tile : plan.tiles) {
      const Window& w = tile.window;
      say(file_of(m_a.out, suffix_of(tile)).string() + ": row " + std::to_string(tile.row + 1) +
          " column " + std::to_string(tile.column + 1) + " of " + std::to_string(plan.rows) +
          " x " + std::to_string(plan.columns) + ": columns " + std::to_string(w.column) + " to " +
          std::to_string(w.column + w.width - 1) + ", rows " + std::to_string(w.row) + " to " +
          std::to_string(w.row + w.height - 1));
    }
  }

  const Arguments& m_a;
  tool::PhotoReader m_reader;
  SheetStyle m_style;
  core::StoredImage m_image;
  LensData m_data;
  int m_bits = 8;
  Report m_report;
};

}  // namespace

Report run_command(const Arguments& a) {
  check_page_file(a.out);
  core::check_writable(a.out);
  return a.command == Command::sheet ? SheetRun(a).run() : run_test(a);
}

}  // namespace lentray::print
