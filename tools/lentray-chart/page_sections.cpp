#include "tools/lentray-chart/page_sections.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/formed.h"
#include "core/base/joined.h"
#include "tools/common/page_text.h"
#include "tools/lentray-chart/charts.h"

namespace lentray::chart {
namespace {

using tool::html_text;

/// Three digits, and never an exponent that hides what it is.
std::string figure(double value) {
  if (!std::isfinite(value)) return "–";
  if (value == 0.0) return "0";
  if (value < 1e-4) return core::formed("%.1e", value);
  return core::formed(value < 0.01  ? "%.5f"
                      : value < 0.1 ? "%.4f"
                      : value < 1   ? "%.3f"
                      : value < 100 ? "%.2f"
                                    : "%.0f",
                      value);
}

std::string time_text(double s) {
  if (s < 0.9995) return core::formed("%.0f ms", 1000.0 * s);
  return core::formed(s < 99.95 ? "%.2f s" : "%.0f s", s);
}

std::string share_text(double share) {
  if (share > 0.0 && share < 0.00005) return "&lt; 0.01 %";
  return core::formed("%.2f %%", 100.0 * share);
}

std::string tile(const std::string& name, const std::string& value) {
  return "<div><dt>" + name + "</dt><dd>" + value + "</dd></div>\n";
}

std::size_t count_of(const Chart& chart, State state) {
  return static_cast<std::size_t>(
      std::count_if(chart.points.begin(), chart.points.end(),
                    [state](const Point& p) { return p.state == state; }));
}

const Point* find(const Chart& chart, const std::string& id) {
  const auto at = std::find_if(chart.points.begin(), chart.points.end(),
                               [&](const Point& p) { return p.setting.id == id; });
  return at == chart.points.end() ? nullptr : &*at;
}

std::string filter(const std::string& key, const std::string& text, std::size_t count) {
  return "<button type=\"button\" data-key=\"" + html_text(key) + "\" aria-pressed=\"" +
         (key == "all" ? "true" : "false") + "\">" + text + "<b>" + std::to_string(count) +
         "</b></button>\n";
}

/// `order`: what the cell is sorted by; empty: it comes last.
std::string cell(const std::string& order, const std::string& html, const char* attributes = "") {
  return std::string("<td") + attributes + " data-value=\"" + order + "\">" + html + "</td>";
}
std::string order(double value) { return std::isinf(value) ? "inf" : core::formed("%.9g", value); }

std::string cell_of(const std::optional<double>& value, std::string (*text)(double)) {
  if (!value || std::isnan(*value)) return cell("", "");
  return cell(order(*value), text(*value));
}

std::optional<double> of(const std::optional<Error>& error, double Error::*member) {
  return error ? std::optional((*error).*member) : std::nullopt;
}

std::string decibels(double psnr) {
  return std::isinf(psnr) ? "equal" : core::formed("%.1f dB", psnr);
}

std::string time_cell(const Point& p) {
  if (p.state != State::done || p.cpu_s.empty()) return cell("", "");
  const std::string spread =
      p.cpu_s.size() > 1 ? " title=\"" + time_text(p.least()) + " to " + time_text(p.most()) + "\""
                         : "";
  return cell(order(p.seconds()), time_text(p.seconds()), spread.c_str());
}

const char* class_of(const Point& p) {
  if (p.state == State::failed) return "is-failed";
  if (p.state == State::waiting) return "is-waiting";
  return p.on_front ? "is-front" : "";
}

std::string row(const Chart& chart, const Point& p) {
  const std::string id = html_text(p.setting.id), kind = html_text(name_of(p.setting.kind));
  const std::string name = html_text(tool::cut_text(p.setting.label, 300));
  std::string out =
      "<tr data-id=\"" + id + "\" data-kind=\"" + kind + "\" class=\"" + class_of(p) + "\">";
  out += "<th scope=\"row\" class=\"is-text\" data-value=\"" + name +
         "\"><button type=\"button\" class=\"go\" data-go=\"" + id + "\">" + name +
         "</button></th><td class=\"is-text\">";
  out += p.setting.is_plain
             ? "plain"
             : symbol_of(p.setting.kind, !p.told_apart) + ' ' + html_text(words_of(p.setting.kind));
  out += "</td>";
  out += time_cell(p) + cell_of(of(p.error, &Error::rms), figure) +
         "<td class=\"is-text verdict\">" + html_text(verdict(chart, p)) + "</td>" +
         cell_of(of(p.error, &Error::psnr), decibels) +
         cell_of(of(p.error, &Error::share), share_text) +
         cell_of(of(p.error, &Error::largest), figure) +
         cell_of(p.error ? p.error->perceived : std::nullopt, figure) +
         cell_of(p.error ? p.error->seen : std::nullopt, figure) +
         cell_of(of(p.from_plain, &Error::rms), figure) + cell_of(p.stock_cpu_s, time_text) +
         cell_of(of(p.from_stock, &Error::rms), figure);
  return out + "</tr>\n";
}

}  // namespace

std::string status_line(const Chart& chart, bool is_finished) {
  const std::size_t failed = count_of(chart, State::failed), all = chart.points.size();
  std::string text = std::to_string(count_of(chart, State::done)) + " of " + std::to_string(all) +
                     (all == 1 ? " setting is measured" : " settings are measured");
  if (failed > 0) text += ", " + std::to_string(failed) + " failed";
  return text + (is_finished ? "." : ". Still running.");
}

std::string tiles(const Chart& chart) {
  std::string out;
  if (chart.width > 0) {
    out += tile(chart.is_sheet ? "integral image, pixels" : "pixels",
                std::to_string(chart.width) + " × " + std::to_string(chart.height));
  }
  for (const Point& p : chart.points) {
    if (!p.setting.is_plain || p.state != State::done) continue;
    if (!p.cpu_s.empty()) out += tile("with your options", time_text(p.seconds()));
    if (p.error) out += tile("error with your options, 1/255", figure(p.error->rms));
    if (p.stock_cpu_s) out += tile("POV-Ray with your options", time_text(*p.stock_cpu_s));
  }
  out += tile("reference", chart.reference.is_converged ? "converged" : "not converged");
  if (!chart.machine.empty()) out += tile("processor", html_text(chart.machine));
  return out;
}

std::string filters(const Chart& chart) {
  const auto count = [&](const auto& is) {
    return static_cast<std::size_t>(std::count_if(chart.points.begin(), chart.points.end(), is));
  };
  std::string out = filter("all", "All", chart.points.size()) +
                    filter("front", "Front", count([](const Point& p) { return p.on_front; }));
  for (const Kind kind : kKinds) {
    const std::size_t of_kind = count([&](const Point& p) { return p.setting.kind == kind; });
    if (of_kind > 0)
      out += filter(name_of(kind), symbol_of(kind) + ' ' + html_text(words_of(kind)), of_kind);
  }
  const std::size_t failed = count_of(chart, State::failed);
  return failed > 0 ? out + filter("failed", "Failed", failed) : out;
}

std::string legend(const Chart& chart) {
  const auto any = [&](const auto& is) {
    return std::any_of(chart.points.begin(), chart.points.end(), is);
  };
  std::string out = "<p class=\"legend-text\">";
  if (any([](const Point& p) { return p.setting.is_plain; }))
    out += "A dot in a ring is your own options. ";
  out += "The line is the least error that a time gets. Bars are the spread of times. ";
  if (any([](const Point& p) { return !p.told_apart; }))
    out +=
        "Hollow or thin symbols, in the grey band, have errors that the reference cannot "
        "distinguish "
        "apart. ";
  if (any([](const Point& p) { return p.stock_error && p.stock_cpu_s; }))
    out += "Stars are POV-Ray at the same settings. ";
  if (any([](const Point& p) { return p.error && p.error->rms == 0.0; }))
    out += "At the foot of the scale, 0 is no error at all. ";
  return out + "Point at a symbol to see its picture; click it to keep it.</p>\n";
}

std::string verdict(const Chart& chart, const Point& p) {
  if (p.state == State::failed) return "failed: " + tool::cut_text(p.reason, 160);
  if (p.state == State::waiting) return "waiting";
  // Exact settings differ in time alone: no other is better or worse.
  if (p.setting.kind == Kind::exact && !p.setting.is_plain && p.from_plain) {
    return p.from_plain->largest > 0.0 ? "NOT the plain picture" : "same picture";
  }
  std::string text;
  if (p.on_front) {
    text += "on the front";
  } else if (!p.dominated_by.empty()) {
    const Point* const better = find(chart, p.dominated_by);
    text += tool::cut_text(better != nullptr ? better->setting.label : p.dominated_by, 200) +
            " is better";
  } else if (p.error) {
    text += "another is as good";
  } else {
    text += "no error is known";
  }
  return p.told_apart ? text : text + "; error not distinguished";
}

std::string table_rows(const Chart& chart) {
  std::string out;
  for (const Point& p : chart.points) out += row(chart, p);
  return out;
}

std::string reference_text(const Reference& reference, const std::string& problem) {
  std::string out = "<p>";
  out += reference.is_converged
             ? "It is converged: with half of its samples it is "
             : "<strong>It is not converged.</strong> With half of its samples it is ";
  out += figure(reference.change) + " / 255 (rms) away. Errors from " +
         figure(10.0 * reference.change) + " on are distinguished. It took " +
         time_text(reference.cpu_s) + ".</p>\n";
  if (!problem.empty())
    out += "<p class=\"is-warning\">No picture of it: " + html_text(problem) + "</p>\n";
  if (!reference.options.empty()) {
    out +=
        "<code class=\"command\">" + html_text(core::joined(reference.options, " ")) + "</code>\n";
  }
  if (reference.steps.empty()) return out;
  out +=
      "<div class=\"wide\"><table><thead><tr><th class=\"is-text\">step</th><th>change, rms in "
      "1/255</th></tr></thead><tbody>\n";
  for (const auto& [what, change] : reference.steps) {
    out += "<tr><td class=\"is-text\">" + html_text(what) + "</td><td>" + figure(change) +
           "</td></tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

}  // namespace lentray::chart
