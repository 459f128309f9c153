#include "tools/lentray-chart/page.h"

#include <algorithm>
#include <exception>
#include <nlohmann/json.hpp>

#include "tools/common/page_text.h"
#include "tools/lentray-chart/charts.h"
#include "tools/lentray-chart/page_data.h"
#include "tools/lentray-chart/page_pictures.h"
#include "tools/lentray-chart/page_sections.h"
#include "tools/lentray-chart/page_sources.h"

namespace lentray::chart {
namespace {

using tool::html_text;

/// One of them is seen, by the window's width.
template <typename Draw>
std::string both_widths(const Draw& draw) {
  const std::string wide = draw(Window::wide);
  if (wide.empty()) return {};
  return "<div class=\"for-wide\">" + wide + "</div>\n<div class=\"for-narrow\">" +
         draw(Window::narrow) + "</div>\n";
}

/// Without gnuplot there are the table and the pictures.
template <typename Draw>
std::string chart_or_problem(const Draw& draw) {
  try {
    return both_widths(draw);
  } catch (const std::exception& error) {
    return "<p class=\"is-warning note\">No chart: " + html_text(error.what()) + "</p>\n";
  }
}

std::string box(const char* id, const std::string& title, const std::string& content) {
  if (content.empty()) return {};
  return std::string("<section class=\"box\" aria-labelledby=\"") + id + "\"><h2 id=\"" + id +
         "\">" + title + "</h2>\n" + content + "</section>\n";
}

std::string note(const std::string& text) {
  return "<p class=\"is-warning note\">" + text + "</p>\n";
}

std::string notes(const Chart& chart, const PagePictures& pictures) {
  std::string out;
  if (!chart.noise.empty())
    out += note("The pictures have random noise: " + html_text(chart.noise));
  if (!chart.reference.is_converged && chart.reference.change > 0.0)
    out += note("The reference is not converged; what it distinguishes is below, at its steps.");
  if (chart.stock.empty() && !chart.stock_reason.empty())
    out += note("Nothing of POV-Ray: " + html_text(chart.stock_reason));
  if (pictures.side == 0 && !chart.points.empty())
    out += note("The page has no room for pictures.");
  return out;
}

/// Everything but pictures, which take the room that it leaves.
struct Parts {
  std::string title{}, chart{}, lens{}, exact{}, rows{};
};

Parts parts_of(const Chart& chart) {
  Parts parts;
  parts.title = html_text(tool::cut_text(chart.scene, 300)) + ": speed against accuracy";
  parts.chart = chart_or_problem(
      [&](Window window) { return error_chart(chart, Subject::settings, window); });
  if (parts.chart.empty())
    parts.chart = "<p class=\"none\">No setting has a time and an error yet.</p>";
  parts.lens = chart_or_problem(
      [&](Window window) { return error_chart(chart, Subject::lens_models, window); });
  parts.exact = chart_or_problem([&](Window window) { return exact_chart(chart, window); });
  parts.rows = table_rows(chart);
  return parts;
}

std::string body_of(const Chart& chart, const PageOptions& options, const PagePictures& pictures,
                    const Parts& parts) {
  std::string lens = parts.lens;
  if (chart.lens_reference && !lens.empty()) {
    lens =
        "<p class=\"legend-text\">They have a reference of their own, of the truest model, and are "
        "not chosen "
        "by time or error.</p>\n" +
        lens + reference_text(*chart.lens_reference, "");
  }
  const std::string again =
      options.is_finished
          ? ""
          : "<button type=\"button\" id=\"again\" class=\"plain\">Load again</button>";
  const std::string exact =
      box("exact-name", "Settings that leave the picture as it is",
          parts.exact.empty()
              ? ""
              : "<p class=\"legend-text\">They change the time alone. The upright line is your "
                "own options.</p>\n" +
                    parts.exact);
  return tool::filled(kPageHtml,
                      {{"title", parts.title},
                       {"status", status_line(chart, options.is_finished)},
                       {"again", again},
                       {"tiles", tiles(chart)},
                       {"filters", filters(chart)},
                       {"notes", notes(chart, pictures)},
                       {"chart", parts.chart},
                       {"legend", legend(chart)},
                       {"exact", exact},
                       {"lens", box("lens-name", "Lens models", lens)},
                       {"rows", parts.rows},
                       {"reference", reference_text(chart.reference, pictures.reference_problem)},
                       {"command", html_text(tool::cut_text(chart.command, 4000))}});
}

}  // namespace

std::string page(const Chart& chart, const PageOptions& options) {
  const Parts parts = parts_of(chart);
  const auto whole = [&](const PagePictures& pictures) {
    const std::string body = body_of(chart, options, pictures, parts);
    const std::string data = tool::script_text(page_data(chart, options, pictures));
    return tool::page_of({"lentray-chart", parts.title, kPageCss, body, data, kPageJs});
  };
  PagePictures none;
  none.points.resize(chart.points.size());
  for (PointPictures& one : none.points)
    one.problem = std::string(200, ' ');  // the room of a problem
  const std::size_t frame = whole(none).size();
  return whole(
      pictures_of(chart, options.folder, options.most_bytes - std::min(options.most_bytes, frame)));
}

}  // namespace lentray::chart
