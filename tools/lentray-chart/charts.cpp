#include "tools/lentray-chart/charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/formed.h"
#include "tools/common/gnuplot.h"
#include "tools/common/inline_svg.h"
#include "tools/common/page_text.h"
#include "tools/lentray-chart/page_labels.h"

namespace lentray::chart {
namespace {

/// Colours of the scripts; the page has its own in their places.
constexpr unsigned kText = 0x101112, kQuiet = 0x595a5b, kGrid = 0xe3e4e5, kBand = 0xe9eaeb;
constexpr double kLeastSeconds = 0.001;  ///< what clocks distinguish

struct KindLook {
  int filled, hollow;  ///< gnuplot's point types
  unsigned rgb;
  const char* css;
  const char* symbol;  ///< of the page, in a square of 16: as gnuplot's
};

constexpr const char* kDot = "<circle cx=\"8\" cy=\"8\" r=\"5\"/>";
constexpr const char* kSquare = "<rect x=\"3.5\" y=\"3.5\" width=\"9\" height=\"9\"/>";
constexpr const char* kTriangle = "<path d=\"M8 2.5 13.5 12.5H2.5z\"/>";
constexpr const char* kDiamond = "<path d=\"M8 2 14 8 8 14 2 8z\"/>";
constexpr const char* kHanging = "<path d=\"M8 13.5 2.5 3.5h11z\"/>";
constexpr const char* kStar = "<path d=\"M8 2v12M2.8 5l10.4 6M13.2 5 2.8 11\"/>";
constexpr const char* kCross = "<path d=\"M3 3l10 10M13 3 3 13\"/>";
constexpr const char* kPlus = "<path d=\"M8 2v12M2 8h12\"/>";
constexpr const char* kPentagon = "<path d=\"M8 2l6 4.4-2.3 7H4.3L2 6.4z\"/>";

/// In the order of Kind. Points of lines alone are thin where others are hollow.
constexpr std::array<KindLook, 12> kLooks{{{7, 6, 0x0072b2, "var(--series-1)", kDot},
                                           {5, 4, 0xc74f00, "var(--series-2)", kSquare},
                                           {9, 8, 0x8a6100, "var(--series-5)", kTriangle},
                                           {13, 12, 0x00795a, "var(--series-3)", kDiamond},
                                           {11, 10, 0xa3468b, "var(--series-4)", kHanging},
                                           {3, 3, 0x5f7a00, "var(--series-9)", kStar},
                                           {9, 8, 0x007d99, "var(--series-10)", kTriangle},
                                           {13, 12, 0x6b3fa0, "var(--series-11)", kDiamond},
                                           {2, 2, 0x4c6fff, "var(--series-6)", kCross},
                                           {1, 1, 0x5c636e, "var(--series-8)", kPlus},
                                           {15, 14, 0xb01030, "var(--series-7)", kPentagon},
                                           {7, 6, 0x333435, "var(--text)", kDot}}};
constexpr std::size_t kKindCount = kLooks.size();
static_assert(kKindCount == static_cast<std::size_t>(Kind::exact) + 1, "each kind has its look");

std::size_t place_of(Kind kind) { return static_cast<std::size_t>(kind); }

std::string number(double value) { return core::formed("%.9g", value); }
std::string colour(unsigned rgb) { return core::formed("'#%06x'", rgb); }

/// In gnuplot's single quotes.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += '\'';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "'";
}

bool is_timed(const Point& p) { return p.state == State::done && !p.cpu_s.empty(); }
double time_of(const Point& p) { return std::max(kLeastSeconds, p.seconds()); }
std::string number_of_seconds(double s) {
  return core::formed(s < 9.995 ? "%.3g" : "%.0f", s) + " s";
}

/// Where a chart lies on a canvas, in pixels from its left and top.
struct Frame {
  double width = 0, height = 0;  ///< of the canvas
  double left = 0, right = 0, top = 0, bottom = 0;
  double x(double part) const { return left + part * (right - left); }
  double y(double part) const { return bottom - part * (bottom - top); }
  std::string margins() const {
    return "set lmargin at screen " + number(left / width) + "\nset rmargin at screen " +
           number(right / width) + "\nset tmargin at screen " + number(1.0 - top / height) +
           "\nset bmargin at screen " + number(1.0 - bottom / height) + "\n";
  }
};

struct LogAxis {
  double low = 0.1, high = 10.0;
  double part(double value) const { return std::log(value / low) / std::log(high / low); }
  void widen(double ratio) {
    const double times = std::sqrt(ratio / std::min(ratio, high / low));
    low /= times;
    high *= times;
  }
};

/// Powers of ten, with 2 and 5 between them where there are few; `most` at most.
std::string log_tics(const LogAxis& axis, std::size_t most, double zero) {
  std::vector<double> tics;
  for (const auto& steps :
       {std::vector{1.0}, {1.0, 3.0}, {1.0, 2.0, 5.0}, {1., 2., 3., 4., 6., 8.}}) {
    std::vector<double> finer;
    for (int k = -12; k <= 12; ++k) {
      for (const double step : steps) {
        const double value = step * std::pow(10.0, k);
        if (value >= axis.low && value <= axis.high && value > 1.5 * zero) finer.push_back(value);
      }
    }
    if (!tics.empty() && finer.size() > most) break;
    tics = finer;
  }
  const std::size_t stride = std::max<std::size_t>(1, (tics.size() + most - 1) / most);
  std::string out = zero > 0.0 ? "'0' " + number(zero) : "";
  for (std::size_t i = 0; i < tics.size(); i += stride) {
    out += (out.empty() ? "'" : ", '") + core::formed("%g", tics[i]) + "' " + number(tics[i]);
  }
  return "(" + out + ")";
}

/// A setting in the chart of errors.
struct Mark {
  const Point* point;
  double x, y;
  bool is_hollow;
};

/// What the chart of errors shows, and its axes.
struct ErrorView {
  std::vector<Mark> marks{};  ///< in the order of times
  LogAxis time{}, error{};
  double zero = 0.0;  ///< where errors of 0 stand; 0: there are none
  double band = 0.0;  ///< its upper end; 0: it is not seen
};

bool has_stock(const Point& p) {
  return p.stock_cpu_s && *p.stock_cpu_s > 0.0 && p.stock_error && p.stock_error->rms > 0.0;
}

void set_time_axis(ErrorView& view) {
  double low = 1e300, high = 0.0;
  for (const Mark& mark : view.marks) {
    low = std::min({low, mark.x, std::max(kLeastSeconds, mark.point->least())});
    high = std::max({high, mark.x, mark.point->most()});
    if (!has_stock(*mark.point)) continue;
    low = std::min(low, std::max(kLeastSeconds, *mark.point->stock_cpu_s));
    high = std::max(high, *mark.point->stock_cpu_s);
  }
  view.time = {low / 1.3, high * 1.3};
  view.time.widen(6.0);
}

void set_error_axis(ErrorView& view, double change) {
  constexpr double kMostBelow = 1000.0;
  double low = 1e300, high = 0.0;
  bool has_zero = false;
  for (const Mark& mark : view.marks) {
    const double rms = mark.point->error->rms;
    if (!(rms > 0.0)) {
      has_zero = true;
      continue;
    }
    low = std::min(low, rms);
    high = std::max(high, rms);
    if (!has_stock(*mark.point)) continue;
    low = std::min(low, mark.point->stock_error->rms);
    high = std::max(high, mark.point->stock_error->rms);
  }
  const bool is_all_zero = high == 0.0;
  if (is_all_zero) low = high = change > 0.0 ? 10.0 * change : 1.0;
  if (const double band = 10.0 * change; std::isfinite(band) && band > low / kMostBelow) {
    view.band = band;
    low = std::min(low, band / 1.5);
    high = std::max(high, band * 1.5);
  }
  view.zero = has_zero ? low / 3.0 : 0.0;
  view.error = {has_zero ? low / 5.0 : low / 1.6, high * 1.8};
  view.error.widen(12.0);
  if (has_zero) view.zero = std::min(view.zero, view.error.low * 1.7);
  for (Mark& mark : view.marks) {
    if (!(mark.point->error->rms > 0.0)) mark.y = view.zero;
  }
}

double change_of(const Chart& chart, Subject subject) {
  const bool is_lens = subject == Subject::lens_models && chart.lens_reference;
  return (is_lens ? *chart.lens_reference : chart.reference).change;
}

ErrorView view_of(const Chart& chart, Subject subject) {
  ErrorView view;
  for (const Point& p : chart.points) {
    if (is_in_error_chart(chart, p, subject))
      view.marks.push_back({&p, time_of(p), p.error->rms, !p.told_apart});
  }
  if (view.marks.empty()) return view;
  std::stable_sort(view.marks.begin(), view.marks.end(),
                   [](const Mark& a, const Mark& b) { return a.x < b.x; });
  set_time_axis(view);
  set_error_axis(view, change_of(chart, subject));
  return view;
}

std::string common_look(const Frame& frame) {
  return frame.margins() + "set border 3 linecolor rgb " + colour(kQuiet) +
         "\nset grid linetype 1 linewidth 0.7 linecolor rgb " + colour(kGrid) +
         "\nset tics textcolor rgb " + colour(kText) + " font ',12' noenhanced\n" +
         "set bars 0.6\n";
}

std::string axis_label(const char* axis, const std::string& text) {
  return std::string("set ") + axis + "label " + quoted(text) +
         " noenhanced font ',12' textcolor rgb " + colour(kText) + "\n";
}

std::string block(const std::string& name, const std::string& rows) {
  return "$" + name + " << EOD\n" + rows + "EOD\n";
}

/// A setting's id for a label: long ones have their words shortened, then their end.
std::string label_of(const Setting& setting) {
  constexpr std::size_t kLong = 16, kMost = 24;
  if (setting.is_plain) return "plain";
  std::string text = setting.id;
  for (const auto& [word, letter] :
       {std::pair{"method", "m"}, {"depth", "d"}, {"threshold", "t"}, {"quality", "q"}}) {
    const std::size_t at = text.find(word);
    if (text.size() > kLong && at != std::string::npos)
      text.replace(at, std::string(word).size(), letter);
  }
  return text.size() <= kMost ? text : text.substr(0, kMost - 2) + "..";
}

/// The ends first, then what halves what is left: few labels show the whole front.
std::vector<LabelWish> spread(const std::vector<LabelWish>& wishes) {
  if (wishes.size() < 3) return wishes;
  std::vector<LabelWish> out{wishes.front(), wishes.back()};
  std::vector<std::pair<std::size_t, std::size_t>> gaps{{0, wishes.size() - 1}};
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const auto [from, to] = gaps[i];
    if (to - from < 2) continue;
    const std::size_t middle = (from + to) / 2;
    out.push_back(wishes[middle]);
    gaps.insert(gaps.end(), {{from, middle}, {middle, to}});
  }
  return out;
}

std::string labels_script(const ErrorView& view, const Frame& frame, std::size_t most) {
  std::vector<LabelWish> wishes;
  std::vector<Spot> spots;
  for (const Mark& mark : view.marks) {
    const Spot at{frame.x(view.time.part(mark.x)), frame.y(view.error.part(mark.y))};
    spots.push_back(at);
    if (has_stock(*mark.point)) {
      spots.push_back({frame.x(view.time.part(std::max(kLeastSeconds, *mark.point->stock_cpu_s))),
                       frame.y(view.error.part(mark.point->stock_error->rms))});
    }
    const Setting& setting = mark.point->setting;
    if (!mark.point->on_front && !setting.is_plain) continue;
    wishes.push_back({at, label_of(setting), setting.is_plain});
  }
  std::string out;
  for (const PlacedLabel& label : placed_labels(
           spread(wishes), spots, {frame.left, frame.top, frame.right, frame.bottom}, most)) {
    out += "set label " + quoted(label.text) + " at screen " + number(label.left / frame.width) +
           ", screen " + number(1.0 - label.middle / frame.height) +
           " left front noenhanced font ',11' textcolor rgb " + colour(kText) + "\n";
  }
  return out;
}

std::string time_bars(const Mark& mark) {
  return number(mark.x) + " " + number(mark.y) + " " +
         number(std::max(kLeastSeconds, mark.point->least())) + " " +
         number(std::max(mark.x, mark.point->most())) + "\n";
}

/// From where a time is enough for anything to the end of the axis.
std::string front_rows(const ErrorView& view) {
  std::string rows;
  double last = 0.0;
  for (const Mark& mark : view.marks) {
    if (!mark.point->on_front) continue;
    if (rows.empty()) rows = number(mark.x) + " " + number(view.error.high) + "\n";
    rows += number(mark.x) + " " + number(mark.y) + "\n";
    last = mark.y;
  }
  return rows.empty() ? rows : rows + number(view.time.high) + " " + number(last) + "\n";
}

/// What is plotted, and the data before it.
struct Plot {
  std::string data{}, command = "plot NaN notitle";
  std::vector<int> kinds{-1};  ///< of the series, for the page; -1: none
  void add(const std::string& name, const std::string& rows, const std::string& look, int kind) {
    if (rows.empty()) return;
    data += block(name, rows);
    command += ", $" + name + " using " + look;
    kinds.push_back(kind);
  }
};

Plot error_plot(const ErrorView& view) {
  Plot plot;
  plot.add("front", front_rows(view),
           "1:2 with steps linewidth 1.6 linecolor rgb " + colour(kQuiet) + " title 'front'", -1);
  for (std::size_t k = 0; k < kKindCount; ++k) {
    for (const bool is_hollow : {false, true}) {
      std::string rows;
      bool has_full = false;
      for (const Mark& mark : view.marks) {
        if (place_of(mark.point->setting.kind) != k || mark.point->setting.is_plain) continue;
        has_full |= !mark.is_hollow;
        if (mark.is_hollow == is_hollow) rows += time_bars(mark);
      }
      const KindLook& look = kLooks[k];
      const bool is_thin = is_hollow && look.filled == look.hollow;
      const bool is_named = !is_hollow || !has_full;
      plot.add(std::string(is_hollow ? "hollow" : "kind") + std::to_string(k), rows,
               "1:2:3:4 with xerrorbars pointtype " +
                   std::to_string(is_hollow ? look.hollow : look.filled) +
                   " pointsize 1.15 linewidth " + (is_thin ? "0.8" : "1.4") + " linecolor rgb " +
                   colour(look.rgb) +
                   (is_named ? " title " + quoted(words_of(static_cast<Kind>(k))) : " notitle"),
               static_cast<int>(k));
    }
  }
  std::string plain, stock;
  for (const Mark& mark : view.marks) {
    if (mark.point->setting.is_plain) plain += time_bars(mark);
    if (!has_stock(*mark.point)) continue;
    stock += number(std::max(kLeastSeconds, *mark.point->stock_cpu_s)) + " " +
             number(mark.point->stock_error->rms) + "\n";
  }
  plot.add("stock", stock,
           "1:2 with points pointtype 3 pointsize 1.1 linewidth 1.2 linecolor rgb " +
               colour(kText) + " title 'POV-Ray'",
           -1);
  plot.add("plain", plain,
           "1:2:3:4 with xerrorbars pointtype 7 pointsize 1.3 linewidth 1.6 linecolor rgb " +
               colour(kText) + " title 'plain'",
           -1);
  plot.add("ring", plain,
           "1:2 with points pointtype 6 pointsize 2.3 linewidth 1.6 linecolor rgb " +
               colour(kText) + " notitle",
           -1);
  return plot;
}

std::string error_script(const ErrorView& view, const Frame& frame, const Plot& plot,
                         bool is_narrow) {
  std::string script = common_look(frame) + axis_label("x", "processor time, s") +
                       axis_label("y", "error, rms in 1/255") + "set logscale xy\nset xrange [" +
                       number(view.time.low) + ":" + number(view.time.high) + "]\nset yrange [" +
                       number(view.error.low) + ":" + number(view.error.high) + "]\nset xtics " +
                       log_tics(view.time, is_narrow ? 5 : 8, 0.0) + "\nset ytics " +
                       log_tics(view.error, is_narrow ? 6 : 8, view.zero) + "\n";
  if (view.band > view.error.low) {
    script += "set object 1 rectangle from graph 0, graph 0 to graph 1, first " +
              number(std::min(view.band, view.error.high)) + " behind fillcolor rgb " +
              colour(kBand) + " fillstyle solid noborder\n";
  }
  return script + labels_script(view, frame, is_narrow ? 4 : 9) + plot.data + plot.command + "\n";
}

/// The settings of the exact chart, fastest first.
std::vector<const Point*> exact_points(const Chart& chart) {
  std::vector<const Point*> points;
  bool has_exact = false;
  for (const Point& p : chart.points) {
    if (!is_in_exact_chart(p)) continue;
    points.push_back(&p);
    has_exact |= !p.setting.is_plain;
  }
  if (!has_exact) points.clear();
  std::stable_sort(points.begin(), points.end(),
                   [](const Point* a, const Point* b) { return a->seconds() < b->seconds(); });
  return points;
}

std::string exact_name(const Point& p, std::size_t most) {
  const bool differs = p.from_plain && p.from_plain->rms > 0.0;
  return tool::cut_text(p.setting.is_plain ? "plain" : p.setting.label, most) +
         (differs ? " (differs)" : "");
}

double exact_end(const std::vector<const Point*>& points) {
  double high = kLeastSeconds;
  for (const Point* p : points) high = std::max({high, p->seconds(), p->most()});
  return 1.08 * high;
}

std::string exact_script(const std::vector<const Point*>& points, const Frame& frame,
                         std::size_t most) {
  std::string tics, rows, script;
  const auto count = static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string place = number(count - static_cast<double>(i));
    tics += (tics.empty() ? "" : ", ") + quoted(exact_name(*points[i], most)) + " " + place;
    rows += number(points[i]->seconds()) + " " + place + " " + number(points[i]->least()) + " " +
            number(points[i]->most()) + "\n";
    if (points[i]->setting.is_plain) {
      script += "set arrow 1 from first " + number(points[i]->seconds()) + ", graph 0 to first " +
                number(points[i]->seconds()) +
                ", graph 1 nohead linewidth 1 dashtype 2 linecolor rgb " + colour(kQuiet) + "\n";
    }
  }
  return common_look(frame) + axis_label("x", "processor time, s") +
         "unset ylabel\nset xrange [0:" + number(exact_end(points)) +
         "]\nset yrange [0.4:" + number(count + 0.6) +
         "]\nset xtics auto\nset format x '%g'\nset ytics (" + tics + ")\n" + script +
         block("exact", rows) +
         "plot $exact using 1:2:3:4 with xerrorbars pointtype 7 pointsize 1.1 linewidth 1.4 "
         "linecolor rgb " +
         colour(kLooks[place_of(Kind::exact)].rgb) + " notitle\n";
}

constexpr double kRow = 24.0;    ///< of the exact chart
constexpr double kLetter = 7.0;  ///< the mean width of 12 pixels' text

std::size_t widest(const std::vector<const Point*>& points, std::size_t most) {
  std::size_t letters = 5;
  for (const Point* p : points) letters = std::max(letters, exact_name(*p, most).size());
  return letters;
}

std::string file(const Chart& chart, const std::string& type) {
  const ErrorView view = view_of(chart, Subject::settings);
  const ErrorView lens = view_of(chart, Subject::lens_models);
  const std::vector<const Point*> exact = exact_points(chart);
  const double exact_height = kRow * static_cast<double>(exact.size());
  const double lens_height = lens.marks.empty() ? 0.0 : 380.0;
  const double width = exact.empty() && lens.marks.empty() ? 900 : 1400;
  const double height = std::max(640.0, exact_height + 130 + lens_height);
  const double side = kLetter * static_cast<double>(widest(exact, 40)) + 20;
  std::string script =
      tool::gnuplot_preamble(type, static_cast<int>(width), static_cast<int>(height)) +
      "set multiplot title " +
      quoted(tool::cut_text(chart.scene, 90) + ": speed against accuracy") +
      " noenhanced font ',14' textcolor rgb " + colour(kText) + "\n";
  const Frame left{width, height, 75, 880, 50, height - 150};
  if (view.marks.empty()) {
    script +=
        left.margins() + "set xrange [0:1]\nset yrange [0:1]\nunset tics\nunset border\n" +
        "set label 1 'No setting has a time and an error yet.' at graph 0.5, graph 0.5 center\n" +
        "plot NaN notitle\n";
  } else {
    script += "set key at screen " + number(477 / width) + ", screen " + number(66 / height) +
              " center center horizontal maxrows 3 samplen 2 noenhanced font ',12' textcolor rgb " +
              colour(kText) + "\n" + error_script(view, left, error_plot(view), false);
  }
  const std::string anew =
      "unset logscale\nunset label\nunset object\nunset arrow\nunset key\nset border\nset tics\n";
  if (!exact.empty()) {
    script +=
        anew + "set title 'the picture stays as it is' noenhanced font ',12'\n" +
        exact_script(exact, {width, height, 890 + side, width - 25, 50, 50 + exact_height}, 40);
  }
  if (!lens.marks.empty()) {
    const double top = height - lens_height - 20;
    script += anew + "set format x\nset title 'lens models' noenhanced font ',12'\n" +
              error_script(lens, {width, height, 970, width - 25, top + 20, height - 60},
                           error_plot(lens), true);
  }
  return tool::gnuplot(script + "unset multiplot\n", "");
}

std::vector<tool::ChartColour> page_colours() {
  std::vector<tool::ChartColour> all{{kText, "var(--text)"},
                                     {kQuiet, "var(--quiet)"},
                                     {kGrid, "var(--grid)"},
                                     {kBand, "var(--band)"}};
  for (const KindLook& look : kLooks) all.push_back({look.rgb, look.css});
  return all;
}

std::string hit(const Point& p, double x, double y, bool is_first) {
  const std::string error = p.error ? ", error " + core::formed("%.3g", p.error->rms) : "";
  const std::string text =
      tool::html_text(p.setting.label + ": " + number_of_seconds(p.seconds()) + error);
  return "<circle class=\"hit\" data-id=\"" + tool::html_text(p.setting.id) + "\" data-kind=\"" +
         tool::html_text(name_of(p.setting.kind)) + "\" cx=\"" + core::formed("%.1f", x) +
         "\" cy=\"" + core::formed("%.1f", y) + "\" r=\"9\" tabindex=\"" + (is_first ? "0" : "-1") +
         "\" role=\"button\" aria-label=\"" + text + "\"/>\n";
}

/// Series say which kind they show, so that the page can put the others behind.
std::string with_kinds(std::string svg, const std::string& name, const std::vector<int>& kinds) {
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::string id = "id=\"" + name + "-series-" + std::to_string(i) + "\"";
    const std::size_t at = svg.find(id);
    if (at == std::string::npos || kinds[i] < 0) continue;
    svg.insert(at, "class=\"series\" data-kind=\"" +
                       tool::html_text(name_of(static_cast<Kind>(kinds[i]))) + "\" ");
  }
  return svg;
}

}  // namespace

bool is_in_error_chart(const Chart& chart, const Point& p, Subject subject) {
  const bool is_apart = p.setting.kind == Kind::lens_model && chart.lens_reference;
  if (is_apart != (subject == Subject::lens_models)) return false;
  const bool is_shown = p.setting.kind != Kind::exact || p.setting.is_plain || p.on_front;
  return is_timed(p) && is_shown && p.error && std::isfinite(p.error->rms);
}

bool is_in_exact_chart(const Point& p) {
  return is_timed(p) && (p.setting.kind == Kind::exact || p.setting.is_plain);
}

std::string words_of(Kind kind) {
  std::string words = name_of(kind);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string chart_svg(const Chart& chart) { return file(chart, "svg"); }
std::string chart_png(const Chart& chart) { return file(chart, "png"); }

std::string error_chart(const Chart& chart, Subject subject, Window window) {
  const bool is_narrow = window == Window::narrow;
  const ErrorView view = view_of(chart, subject);
  if (view.marks.empty()) return {};
  const Frame frame =
      is_narrow ? Frame{380, 400, 58, 370, 12, 350} : Frame{720, 480, 66, 708, 12, 430};
  const Plot plot = error_plot(view);
  const std::string svg = tool::gnuplot(
      tool::gnuplot_preamble("svg", static_cast<int>(frame.width), static_cast<int>(frame.height)) +
          "unset key\n" + error_script(view, frame, plot, is_narrow),
      "");
  const std::string name = std::string(subject == Subject::settings ? "errors" : "lens") +
                           (is_narrow ? "-narrow" : "-wide");
  std::string hits = "<g>\n";
  for (const Mark& mark : view.marks) {
    hits += hit(*mark.point, frame.x(view.time.part(mark.x)), frame.y(view.error.part(mark.y)),
                &mark == &view.marks.front());
  }
  return with_kinds(tool::inline_svg(svg, {name, "Error over processor time, a symbol a setting",
                                           page_colours(), hits + "</g>\n"}),
                    name, plot.kinds);
}

std::string exact_chart(const Chart& chart, Window window) {
  const bool is_narrow = window == Window::narrow;
  const std::vector<const Point*> points = exact_points(chart);
  if (points.empty()) return {};
  const std::size_t most = is_narrow ? 22 : 40;
  const double width = is_narrow ? 380 : 720, rows = kRow * static_cast<double>(points.size());
  const Frame frame{width,      rows + 62, kLetter * static_cast<double>(widest(points, most)) + 16,
                    width - 16, 8,         rows + 12};
  const std::string svg = tool::gnuplot(
      tool::gnuplot_preamble("svg", static_cast<int>(width), static_cast<int>(frame.height)) +
          "unset key\n" + exact_script(points, frame, most),
      "");
  std::string hits = "<g>\n";
  const auto count = static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    hits += hit(*points[i], frame.x(points[i]->seconds() / exact_end(points)),
                frame.y((count - static_cast<double>(i) - 0.4) / (count + 0.2)), i == 0);
  }
  return tool::inline_svg(svg, {is_narrow ? "exact-narrow" : "exact-wide",
                                "Processor times of settings that leave the picture as it is",
                                page_colours(), hits + "</g>\n"});
}

std::string symbol_of(Kind kind, bool is_hollow) {
  const KindLook& look = kLooks[place_of(kind)];
  const std::string css = look.css;
  return "<svg class=\"symbol\" width=\"16\" height=\"16\" viewBox=\"0 0 16 16\" "
         "aria-hidden=\"true\" fill=\"" +
         (is_hollow ? "none" : css) + "\" stroke=\"" + css + "\" stroke-width=\"1.8\">" +
         look.symbol + "</svg>";
}

}  // namespace lentray::chart
