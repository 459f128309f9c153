#include "tools/lentray-print/sheet_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "camera/text.h"
#include "core/image/orientation.h"
#include "tools/common/photo_reader.h"
#include "tools/common/sheet_facts.h"
#include "tools/lentray-print/page_error.h"
#include "tools/lentray-print/page_file.h"
#include "tools/lentray-print/pixels.h"
#include "tools/lentray-print/repitch.h"
#include "tools/lentray-print/report_text.h"
#include "tools/lentray-print/tiles.h"

namespace lentray::print {

using camera::format;

namespace {

std::string decibel_text(double value) {
  return std::isfinite(value) ? short_number(std::round(value)) : "infinite";
}

/// A picture as it was read, whole lenses.
struct SheetSource {
  std::string name, stem;
  core::StoredImage image;
  LensData data;
  double lenses = 0.0;  ///< of the file, a cut one by its share
  std::uint32_t cut_columns = 0;

  std::int64_t whole_lenses() const {
    return core::LensColumns{data.pixels}.whole_lenses(image.width);
  }
};

bool is_other(double a, double b) {
  constexpr double kAlike = 1e-6;
  return std::fabs(a - b) > kAlike * std::fabs(b);
}

/// One lens sheet has one pitch, one direction and one viewer.
void check_alike(const SheetSource& a, const SheetSource& b, bool is_fitted, bool is_together) {
  const auto differ = [&](const std::string& of_a, const std::string& of_b,
                          const std::string& why) {
    throw PageError("'" + a.name + "' " + of_a + " and '" + b.name + "' " + of_b + ": " + why);
  };
  if (is_other(a.data.dpi_x, b.data.dpi_x) || is_other(a.data.dpi_y, b.data.dpi_y)) {
    differ("is for " + dpi_text(a.data.dpi_x, a.data.dpi_y),
           "for " + dpi_text(b.data.dpi_x, b.data.dpi_y), "a page has one resolution");
  }
  if (!is_fitted && is_other(a.data.pixels, b.data.pixels)) {
    differ("has strips " + format(a.data.print_pitch()) + " mm apart",
           "strips " + format(b.data.print_pitch()) + " mm apart",
           "a lens sheet has one pitch; --pitch fits all to a measured one");
  }
  if (!is_together && a.data.lens && b.data.lens &&
      is_other(1.0 + a.data.lens->widening(), 1.0 + b.data.lens->widening())) {
    const auto lenses = [](const LensData& data) {
      return "lenses of " + format(data.print_pitch() / (1.0 + data.lens->widening())) + " mm";
    };
    differ("is for " + lenses(a.data), "for " + lenses(b.data),
           "they are made for other distances or thicknesses, so no lens sheet fits both");
  }
}

/// One run.
class SheetRun {
 public:
  explicit SheetRun(const Arguments& arguments)
      : m_a(arguments), m_reader(arguments.profiles), m_style(arguments.style) {}

  Report run() {
    read();
    if (m_style.is_across && m_a.horizontal) {
      say("the lenses lie across already: --horizontal changes nothing");
    }
    if (m_a.print_pitch) fit_to_pitch();
    fill_places();
    choose_layout();
    SheetPage sheet = make_page();
    say_pictures(sheet);
    m_a.tiles ? write_tiles(sheet) : write_page(std::move(sheet.page));
    for (const std::string& warning : m_reader.warnings()) m_report.warnings.push_back(warning);
    return std::move(m_report);
  }

 private:
  void say(const std::string& line) { m_report.lines.push_back(line); }
  /// Of which picture it is told, where there are several.
  std::string about(const SheetSource& source) const {
    return m_sources.size() > 1 ? source.name + ": " : std::string();
  }

  void read() {
    std::vector<core::StoredImage> images;
    double first_slant = 0.0;
    for (const std::filesystem::path& path : m_a.images) {
      core::StoredImage image = m_reader.read(path);
      tool::use_srgb_curve(image);
      if (lies_across(image, path, images.empty())) {
        image = core::upright(std::move(image), core::kTurnedBack);
      }
      const double slant = slant_in(image);
      if (images.empty()) first_slant = slant;
      if (slant != first_slant) {
        throw PageError("the lenses of '" + m_a.images[0].string() + "' are slanted by " +
                        format(first_slant) + " degrees and those of '" + path.string() + "' by " +
                        format(slant) + ": a lens sheet has one direction");
      }
      m_sources.push_back({.name = path.string(),
                           .stem = path.stem().string(),
                           .image = {},
                           .data = lens_data_of(image, m_a.lens, path.string())});
      check_alike(m_sources[0], m_sources.back(), m_a.print_pitch.has_value(),
                  m_style.is_seen_together);
      if (!images.empty() && image.profile != images[0].profile) {
        throw PageError("'" + m_a.images[0].string() + "' and '" + path.string() +
                        "' have different colour profiles; --profile srgb converts them");
      }
      images.push_back(std::move(image));
    }
    m_bits = m_a.bits;
    if (m_bits == 0) {
      m_bits = std::ranges::all_of(images, [](const auto& one) { return one.bits == 8; }) ? 8 : 16;
    }
    for (std::size_t i = 0; i < images.size(); ++i) {
      SheetSource& source = m_sources[i];
      const std::uint32_t width = images[i].width;
      source.lenses = width / source.data.pixels;
      source.image = of_whole_lenses(as_printed(std::move(images[i]), m_bits, m_style.background),
                                     source.data.pixels);
      source.cut_columns = width - source.image.width;
    }
    m_data = m_sources[0].data;
    name_sheet();
  }

  /// Strips are columns while the page is made, which is turned in the end.
  bool lies_across(const core::StoredImage& image, const std::filesystem::path& path,
                   bool is_first) {
    const bool is_across = m_a.across || tool::lies_across(tool::facts_of(image));
    if (is_first) m_style.is_across = is_across;
    if (is_across == m_style.is_across) return is_across;
    const std::string first = m_a.images[0].string(), own = path.string();
    throw PageError("lenses lie across '" + (is_across ? own : first) + "' and upright in '" +
                    (is_across ? first : own) + "': a lens sheet has one direction");
  }

  void name_sheet() {
    constexpr std::size_t kMostNames = 3;
    for (std::size_t i = 0; i < std::min(kMostNames, m_sources.size()); ++i)
      m_style.name += (i > 0 ? ", " : "") + m_sources[i].stem;
    if (m_sources.size() > kMostNames) m_style.name += ", ...";
  }

  void fit_to_pitch() {
    m_data.pixels = *m_a.print_pitch * m_data.dpi_x / kInch;
    m_origin =
        origin_about_middle(m_sources[0].whole_lenses(), m_sources[0].data.pixels, m_data.pixels);
  }

  void fill_places() {
    const auto count = static_cast<int>(m_sources.size());
    if (m_a.copies_grid) {
      for (int i = 0; i < m_a.copies_grid->places(); ++i)
        m_places.push_back(static_cast<std::size_t>(i % count));
      if (count > m_a.copies_grid->places()) refuse_grid(*m_a.copies_grid, count);
      return;
    }
    for (std::size_t i = 0; i < m_sources.size(); ++i)
      m_places.insert(m_places.end(), static_cast<std::size_t>(m_a.copies), i);
    if (const auto places = static_cast<int>(m_places.size());
        m_a.grid && places > m_a.grid->places()) {
      refuse_grid(*m_a.grid, places);
    }
  }

  /// A grid of the page as it is seen, before the page is turned; and the other way round.
  LayoutGrid of_page(LayoutGrid grid) const {
    if (m_style.is_across) std::swap(grid.columns, grid.rows);
    return grid;
  }

  [[noreturn]] static void refuse_grid(const LayoutGrid& grid, int pictures) {
    throw PageError("a grid of " + std::to_string(grid.columns) + " x " +
                    std::to_string(grid.rows) + " has no room for " + std::to_string(pictures) +
                    " pictures");
  }

  std::vector<LayoutItem> items() const {
    std::vector<LayoutItem> all;
    for (const std::size_t i : m_places) {
      const SheetSource& source = m_sources[i];
      all.push_back(layout_item(source.whole_lenses(), source.image.height, m_data, m_style));
    }
    return all;
  }

  /// Columns from lens to lens of the sheet itself.
  double lens_columns() const {
    if (m_places.size() == 1 || m_style.is_seen_together) return m_data.pixels;
    for (const SheetSource& source : m_sources) {
      if (source.data.lens) return m_data.pixels / (1.0 + source.data.lens->widening());
    }
    return m_data.pixels;
  }

  void choose_layout() {
    const LayoutStyle style = layout_style(m_data, m_style, lens_columns(), m_origin);
    const std::vector<LayoutItem> all = items();
    const auto count = static_cast<int>(all.size());
    const auto best = [&](int some, bool is_limited) {
      const std::vector<LayoutItem> first(all.begin(), all.begin() + some);
      return best_grid(some, [&](const LayoutGrid& grid) {
        const auto needed = needed_extent(layout_of(first, grid, style), m_data, m_style);
        if (is_limited && !has_room(*m_style.paper, needed, m_data)) return -1.0;
        return needed.width + needed.height;
      });
    };
    const bool is_limited = m_style.paper && !m_a.tiles;
    LayoutGrid grid;
    if (m_a.copies_grid) {
      grid = of_page(*m_a.copies_grid);
    } else if (m_a.grid) {
      grid = of_page(*m_a.grid);
    } else if (count > 1) {
      grid = best(count, is_limited);
      if (grid.columns == 0) {
        int some = count - 1;
        while (some > 0 && best(some, true).columns == 0) --some;
        throw PageError("the paper of " + size_text(m_style.paper->width, m_style.paper->height) +
                        " has room for " + std::to_string(some) + " of " + std::to_string(count) +
                        " pictures with their gaps and marks; --tiles cuts them into pages");
      }
    }
    m_layout = layout_of(all, grid, style);
  }

  SheetArt art_of(std::size_t i) {
    SheetSource& source = m_sources[m_places[i]];
    const double origin = m_layout.places[i].origin;
    if (!m_a.print_pitch && origin == 0.0) {
      const bool is_last = std::ranges::find(m_places.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                             m_places.end(), m_places[i]) == m_places.end();
      return sheet_art(is_last ? std::move(source.image) : source.image, m_data, m_style);
    }
    Repitched made =
        repitched(source.image, source.data.pixels, {.pixels = m_data.pixels, .origin = origin});
    if (m_a.print_pitch && std::ranges::find(m_places, m_places[i]) ==
                               m_places.begin() + static_cast<std::ptrdiff_t>(i)) {
      say_fit(source, made);
    }
    m_moved = std::max(m_moved, std::fabs(origin));
    return sheet_art(std::move(made.image), m_data, m_style, origin);
  }

  SheetPage make_page() {
    std::vector<SheetArt> arts;
    for (std::size_t i = 0; i < m_places.size(); ++i) arts.push_back(art_of(i));
    SheetStyle style = m_style;
    if (m_a.tiles) {
      style.paper.reset();
      style.margin = 1.0;  // marks do not end at the edge of a window
    }
    return sheet_page(std::move(arts), m_layout, m_data, style);
  }

  void say_fit(const SheetSource& source, const Repitched& made) {
    const double ratio = m_data.pixels / source.data.pixels;
    say(about(source) + "--pitch: strips of " + format(m_data.pixels) +
        " pixels are made of views of " + format(source.data.pixels) + ": directions are up to " +
        short_number(made.largest_offset) + " of these pixels off; the interpolation has about " +
        decibel_text(made.step_psnr) + " to " + decibel_text(made.smooth_psnr) +
        " dB PSNR, as colours jump from view to view or change smoothly; the sheet is " +
        short_number(std::fabs(ratio - 1.0) * 100.0) + " % " +
        (ratio < 1.0 ? "narrower" : "wider"));
    const std::string options = render_options(source.data, *m_a.print_pitch, source.lenses,
                                               source.image.height, m_style.is_across);
    say(about(source) + (options.empty()
                             ? "exact: a new render with Lens_Pixels=" + format(m_data.pixels) +
                                   "; the picture does not say its lens"
                             : "exact: lentray SCENE.pov " + options));
  }

  std::string strips_text() const {
    return "strips " + short_number(m_data.print_pitch()) + " mm apart (" +
           format(m_data.print_lpi()) + " lpi), " + format(m_data.dpi_x) + " x " +
           format(m_data.dpi_y) + " dpi";
  }

  void say_pictures(const SheetPage& sheet) {
    for (const SheetSource& source : m_sources) {
      if (source.cut_columns == 0) continue;
      say(about(source) + "left out " + (m_style.is_across ? "below" : "at the right") + ": " +
          std::to_string(source.cut_columns) + " pixels of a cut lens");
    }
    const Page& page = sheet.page;
    const auto pixels = [&](const Box& box) {
      const std::string across = std::to_string(std::llround(box.width / page.pixel_width())),
                        along = std::to_string(std::llround(box.height / page.pixel_height()));
      return (m_style.is_across ? along + " x " + across : across + " x " + along) + " pixels";
    };
    const std::string lenses = std::to_string(m_layout.lenses) + " lenses of " +
                               format(m_data.pixels) + " pixels, " + strips_text();
    if (m_places.size() == 1) {
      say("picture: " + pixels(page.trim) + ", " + lenses);
      return;
    }
    const LayoutGrid seen = of_page(m_layout.grid);
    say(std::to_string(m_places.size()) + " pictures in " + std::to_string(seen.columns) +
        " columns and " + std::to_string(seen.rows) + " rows: " + pixels(page.trim) + ", " +
        lenses);
    for (std::size_t i = 0; i < m_places.size(); ++i) {
      const auto at = static_cast<int>(i);
      const Box& side = sheet.cuts[i];
      const Box cut = m_style.is_across
                          ? Box{page.height - side.bottom(), side.left, side.height, side.width}
                          : side;
      const int row = at / m_layout.grid.columns, column = at % m_layout.grid.columns;
      say("row " + std::to_string((m_style.is_across ? column : row) + 1) + " column " +
          std::to_string((m_style.is_across ? m_layout.grid.rows - 1 - row : column) + 1) + ": " +
          m_sources[m_places[i]].name + ", " + size_text(cut.width, cut.height) + " at " +
          short_number(cut.left) + ", " + short_number(cut.top) + " mm");
    }
    if (m_a.print_pitch || m_moved == 0.0) return;
    say("strips lie up to " + short_number(m_moved) +
        " pixels beside whole columns there: pixels of such pictures are the mean of two");
  }

  void write_page(Page whole) {
    Page page = finished(std::move(whole), m_a, m_style.is_across);
    say("trimmed: " + size_text(page.trim.width, page.trim.height) + " at " +
        short_number(page.trim.left) + ", " + short_number(page.trim.top) + " mm" +
        (m_style.bleed > 0.0 ? "; with bleed " + size_text(page.bleed.width, page.bleed.height)
                             : std::string()));
    say(m_a.out.string() + ": page " + size_text(page.width, page.height));
    m_report.warnings = write_pages({{"", [&page] { return std::move(page); }}}, m_a.out, m_bits);
  }

  void write_tiles(const SheetPage& sheet) {
    const Page& whole = sheet.page;
    const TilePlan plan =
        tile_plan(whole, sheet.boundaries,
                  {.paper = *m_style.paper, .margin = m_style.margin, .overlap = m_a.overlap});
    std::vector<PageSource> pages;
    for (const Tile& tile : plan.tiles) {
      pages.push_back({suffix_of(tile), [&, this] {
                         return finished(tile_page(whole, plan, tile, m_bits), m_a,
                                         m_style.is_across);
                       }});
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
  std::vector<SheetSource> m_sources;
  std::vector<std::size_t> m_places;  ///< a source for each, row by row
  LensData m_data;                    ///< of the print
  double m_origin = 0.0;              ///< of the first picture's lens 0, in columns
  Layout m_layout;
  double m_moved = 0.0;  ///< the largest distance of strips from whole columns
  int m_bits = 8;
  Report m_report;
};

}  // namespace

Page finished(Page page, const Arguments& a, bool is_across) {
  if (a.horizontal || is_across) page = turned(std::move(page));
  if (a.mirror) page = mirrored(std::move(page));
  return page;
}

Report run_sheet(const Arguments& arguments) { return SheetRun(arguments).run(); }

}  // namespace lentray::print
