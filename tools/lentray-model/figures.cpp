#include "tools/lentray-model/figures.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/image/run_files.h"
#include "tools/common/gnuplot.h"
#include "tools/common/process.h"
#include "tools/lentray-model/sweeps.h"

namespace lentray::model {

using tool::check_gnuplot;
using tool::gnuplot;
using tool::gnuplot_preamble;
using tool::number_text;
using tool::write_whole;

namespace fs = std::filesystem;
using shadow::Style;

namespace {

enum class Kind { kSurface, kAlongA, kAlongD, kMeasured, kSweep };

struct Figure {
  std::string name;
  Kind kind;
  Style style;
  std::string title;
};

const std::vector<Figure>& figures() {
  using S = Style::Kind;
  static const std::vector<Figure> kFigures{
      {"10", Kind::kSurface, {S::kRows}, "Figure 10: style 1 (rows)"},
      {"11", Kind::kAlongA, {S::kRows}, "Figure 11: style 1 (rows)"},
      {"12", Kind::kAlongD, {S::kRows}, "Figure 12: style 1 (rows)"},
      {"13", Kind::kSurface, {S::kViews}, "Figure 13: style 2 (views)"},
      {"14", Kind::kSurface, {S::kCombined}, "Figure 14: combined style"},
      {"15", Kind::kAlongA, {S::kCombined}, "Figure 15: combined style"},
      {"16", Kind::kAlongD, {S::kCombined}, "Figure 16: combined style"},
      {"17", Kind::kSurface, {S::kColumns}, "Figure 17: style 3 (columns)"},
      {"23", Kind::kSurface, {S::kStrips}, "Figure 23: two-dimensional style (strips)"},
      {"24a", Kind::kMeasured, {S::kRows}, "Figure 24(a): style 1 (rows), rendered"},
      {"24b", Kind::kMeasured, {S::kViews}, "Figure 24(b): style 2 (views), rendered"},
      {"24c", Kind::kMeasured, {S::kColumns}, "Figure 24(c): style 3 (columns), rendered"},
      {"24d", Kind::kMeasured, {S::kCombined}, "Figure 24(d): combined style, rendered"},
      {"24e", Kind::kMeasured, {S::kStrips}, "Figure 24(e): two-dimensional style, rendered"},
      {"near", Kind::kSweep, {}, "Shadows near the sheet, D -> 0"},
      {"theta", Kind::kSweep, {}, "Angle of the shadow against the angle of the fan"},
      {"small", Kind::kSweep, {}, "Small shadows, through ps and P"},
      {"wide", Kind::kSweep, {}, "Wide lenses"},
      {"edges", Kind::kSweep, {}, "Edges of the sheet"},
  };
  return kFigures;
}

const Figure& figure_of(const std::string& name) {
  for (const Figure& figure : figures()) {
    if (figure.name == name) return figure;
  }
  throw std::logic_error("no figure '" + name + "'");
}

const StyleGrid& grid_of(const Grid& grid, const Style& style) {
  for (const StyleGrid& one : grid.styles) {
    if (one.style == style) return one;
  }
  throw std::logic_error("no grid of " + style.name());
}

std::string lens_text(const Arguments& a) {
  return "P = " + number_text(a.lens.pitch) + " mm, f = " + number_text(a.lens.focal_length) +
         " mm, n = " + number_text(a.lens.ior) + ", N = " + number_text(a.lens.pixels) + ", " +
         std::to_string(a.lenses) + " lenses, Xstart = " + number_text(a.x) + " mm";
}

/// Columns: A, D, printed, refracted, enumerated, measured, difference. Blank line after each A.
std::string surface_data(const StyleGrid& grid, const Arguments& a) {
  std::string out;
  double last = 0.0;
  for (const Point& p : grid.points) {
    if (!out.empty() && p.a != last) out += "\n";
    last = p.a;
    const double closed = static_cast<double>(p.closed(a.alpha).value_or(0));
    out += number_text(p.a) + " " + number_text(p.d) + " " + std::to_string(p.printed.value_or(0)) +
           " " + std::to_string(p.refracted.value_or(0)) + " " + std::to_string(p.enumerated) +
           " " + std::to_string(p.measured.value_or(0)) + " " +
           number_text(closed - static_cast<double>(p.enumerated)) + "\n";
  }
  return out;
}

std::string surface_panel(const std::string& title, int column) {
  return "set title '" + title + "'\nsplot 'data' using 1:2:" + std::to_string(column) +
         " with pm3d notitle\n";
}

constexpr const char* kSurfaceLook =
    "set xlabel 'A, mm'\nset ylabel 'D, mm'\nset xyplane 0\nset view 60,320\n"
    "set pm3d border linecolor 'gray30' linewidth 0.3\n"
    "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n"
    "set colorbox\nset format z '%.0f'\n";

std::string surface_script(const Figure& figure, const StyleGrid& grid, const Arguments& a) {
  double most = 1.0, highest = 1.0;
  for (const Point& p : grid.points) {
    const auto closed = static_cast<double>(p.closed(a.alpha).value_or(0));
    const auto enumerated = static_cast<double>(p.enumerated);
    most = std::max(most, std::fabs(closed - enumerated));
    highest = std::max({highest, closed, enumerated});
  }
  const bool printed = a.alpha == shadow::paper::Alpha::kPrinted;
  const std::string alpha = std::string("alpha ") + shadow::paper::name_of(a.alpha);
  return gnuplot_preamble(a.format, 1650, 540) + "set multiplot layout 1,3 title '" + figure.title +
         ", continuous cache hits; " + lens_text(a) + "'\n" + kSurfaceLook +
         "set zrange [0:" + number_text(highest) + "]\nset cbrange [0:" + number_text(highest) +
         "]\n" + surface_panel("equation (" + alpha + ")", printed ? 3 : 4) +
         surface_panel("enumerated", 5) +
         "set view map\nset zrange [*:*]\nset palette defined (-1 'blue', 0 'white', 1 'red')\n" +
         "set cbrange [" + number_text(-most) + ":" + number_text(most) + "]\n" +
         surface_panel("equation - enumerated", 7) + "unset multiplot\n";
}

std::string measured_script(const Figure& figure, const StyleGrid& grid, const Arguments& a) {
  const auto equal = std::count_if(grid.points.begin(), grid.points.end(), [](const Point& p) {
    return p.measured && *p.measured == p.enumerated;
  });
  return gnuplot_preamble(a.format, 1200, 540) + "set multiplot layout 1,2 title '" + figure.title +
         ", continuous cache hits; " + lens_text(a) + "'\n" + kSurfaceLook +
         surface_panel("measured", 6) +
         surface_panel("enumerated: the same at " + std::to_string(equal) + " of " +
                           std::to_string(grid.points.size()) + " points",
                       5) +
         "unset multiplot\n";
}

/// The three lines of a style; `first` is the column of its printed form.
std::string lines(std::size_t first, bool key) {
  const auto line = [&](std::size_t column, const char* name, const char* look) {
    return "'data' skip 1 using 1:" + std::to_string(column) + " with steps " + look +
           (key ? std::string(" title '") + name + "'" : std::string(" notitle"));
  };
  return "plot " + line(first, "equation, alpha printed", "linecolor 'red' linewidth 1.5") + ", " +
         line(first + 1, "equation, alpha refracted", "linecolor 'orange' linewidth 1.5") + ", " +
         line(first + 2, "enumerated", "linecolor 'blue' linewidth 1.5") + "\n";
}

std::string series_script(const Figure& figure, const Series& series, const Arguments& a,
                          const std::string& where) {
  const std::string look = "set datafile separator ','\nset xlabel '" + series.axis +
                           "'\nset ylabel 'continuous cache hits'\nset grid\n" +
                           (series.logarithmic ? "set logscale x\n" : "") +
                           (series.logarithmic_hits ? "set logscale y\n" : "set yrange [0:*]\n");
  const std::string title = figure.title + " at " + where + "; " + lens_text(a);
  if (series.styles.size() == 1) {
    return gnuplot_preamble(a.format, 1000, 600) + look + "set key top " +
           (figure.kind == Kind::kAlongA ? "left" : "right") + "\nset title '" + title + "'\n" +
           lines(2, true);
  }
  std::string out = gnuplot_preamble(a.format, 1500, 900) + look +
                    "set multiplot layout 2,3 title '" + title + "'\n";
  for (std::size_t i = 0; i < series.styles.size(); ++i) {
    out += "set title '" + series.styles[i].name() + "'\n" + lines(2 + 3 * i, false);
  }
  // The last panel holds the key alone.
  return out + "unset title\nunset tics\nunset border\nunset grid\nunset xlabel\nunset ylabel\n" +
         "unset logscale\nset key center\nset xrange [0:1]\nset yrange [0:1]\n" +
         "plot NaN with lines linecolor 'red' title 'equation, alpha printed', " +
         "NaN with lines linecolor 'orange' title 'equation, alpha refracted', " +
         "NaN with lines linecolor 'blue' title 'enumerated'\nunset multiplot\n";
}

fs::path chart_place(const Arguments& a, const std::string& figure, const std::string& end) {
  return a.folder / ("figure-" + figure + "." + end);
}

bool is_series(Kind kind) {
  return kind == Kind::kAlongA || kind == Kind::kAlongD || kind == Kind::kSweep;
}

Series series_of(const Figure& figure, const Arguments& a, const shadow::PaperSheet& sheet) {
  if (figure.kind == Kind::kAlongA) return cut_along_a(a, sheet, figure.style);
  if (figure.kind == Kind::kAlongD) return cut_along_d(a, sheet, figure.style);
  return sweep(figure.name, a, sheet);
}

/// What a series holds fast.
std::string where_of(const Figure& figure, const Arguments& a) {
  const std::string at_a = "A = " + number_text(a.slice_a), at_d = "D = " + number_text(a.slice_d);
  if (figure.kind == Kind::kAlongA || figure.name == "small") return at_d + " mm";
  if (figure.name == "wide" || figure.name == "edges") return at_a + " mm, " + at_d + " mm";
  return at_a + " mm";
}

}  // namespace

const std::vector<std::string>& figure_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const Figure& figure : figures()) names.push_back(figure.name);
    return names;
  }();
  return kNames;
}

const Style* measured_style(const std::string& figure) {
  const Figure& f = figure_of(figure);
  return f.kind == Kind::kMeasured ? &f.style : nullptr;
}

bool shows_grid(const std::string& figure) { return !is_series(figure_of(figure).kind); }

void check_figures(const Arguments& a) {
  if (a.figures.empty()) return;
  check_gnuplot();
  for (const std::string& name : a.figures) {
    for (const std::string& kind : {a.format, std::string("csv")}) {
      if (kind == "csv" && shows_grid(name)) continue;
      core::claim_writable(chart_place(a, name, kind), "figure " + name + " as " + kind);
    }
    if (shows_grid(name) && (a.a.values().size() < 2 || a.d.values().size() < 2)) {
      throw std::runtime_error("figure " + name +
                               " is a surface: it needs two values or more of A "
                               "and of D");
    }
  }
}

std::string draw_figure(const std::string& name, const Arguments& a,
                        const shadow::PaperSheet& sheet, const Grid& grid) {
  const Figure& figure = figure_of(name);
  const fs::path place = chart_place(a, name, a.format);
  if (is_series(figure.kind)) {
    const Series series = series_of(figure, a, sheet);
    const std::string csv = csv_of(series);
    write_whole(place, gnuplot(series_script(figure, series, a, where_of(figure, a)), csv));
    write_whole(chart_place(a, name, "csv"), csv);
  } else {
    const StyleGrid& points = grid_of(grid, figure.style);
    const bool measured = figure.kind == Kind::kMeasured;
    write_whole(place, gnuplot(measured ? measured_script(figure, points, a)
                                        : surface_script(figure, points, a),
                               surface_data(points, a)));
  }
  return place.string();
}

}  // namespace lentray::model
