#include "tools/common/inline_svg.h"

#include <cstdlib>
#include <string_view>

#include "tools/common/formed.h"
#include "tools/common/page_text.h"

namespace lentray::tool {
namespace {

void replace_all(std::string& text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at)) {
    text.replace(at, what.size(), with);
    at += with.size();
  }
}

/// Whole elements from `begin` to `end`, both with it.
void remove_all(std::string& text, std::string_view begin, std::string_view end) {
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
    const std::size_t last = text.find(end, at);
    if (last == std::string::npos) return;
    text.erase(at, last + end.size() - at);
  }
}

/// gnuplot pads the numbers of strokes, and not those of fills.
void recolour(std::string& text, const ChartColour& colour) {
  const unsigned r = colour.rgb >> 16 & 255u, g = colour.rgb >> 8 & 255u, b = colour.rgb & 255u;
  for (const char* pattern : {"rgb(%3u, %3u, %3u)", "rgb(%u,%u,%u)", "rgb(%u, %u, %u)"}) {
    replace_all(text, formed(pattern, r, g, b), colour.css);
  }
}

/// gnuplot's series count from 1.
void rename_series(std::string& text, const std::string& name) {
  const std::string_view mark = "id=\"gnuplot_plot_";
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at)) {
    const std::size_t end = text.find('"', at + mark.size());
    const int number = std::atoi(text.c_str() + at + mark.size());
    const std::string id = "id=\"" + name + "-series-" + std::to_string(number - 1);
    text.replace(at, end - at, id);
    at += id.size();
  }
}

}  // namespace

const std::vector<ChartColour>& default_series_colours() {
  static const std::vector<ChartColour> all{
      {0x9400d3, "var(--series-4)"}, {0x009e73, "var(--series-3)"}, {0x56b4e9, "var(--series-6)"},
      {0xe69f00, "var(--series-5)"}, {0xf0e442, "var(--series-2)"}, {0x0072b2, "var(--series-1)"},
      {0xe51e10, "var(--series-7)"}, {0x000000, "currentColor"}};
  return all;
}

std::string inline_svg(const std::string& svg, const InlineSvg& as) {
  const std::size_t begin = svg.find("<svg"), inside = svg.find('>', begin);
  if (begin == std::string::npos || inside == std::string::npos) return {};
  const std::size_t box = svg.find("viewBox=\"", begin) + 9;
  const std::string view = svg.substr(box, svg.find('"', box) - box);
  std::string rest = svg.substr(inside + 1);
  remove_all(rest, "<title>", "</title>");  // of the program and of series: no tooltips
  remove_all(rest, "<desc>", "</desc>");
  remove_all(rest, "<rect x=\"0\" y=\"0\"", "/>");
  replace_all(rest, "id=\"gnuplot_canvas\"", "");
  for (const char* prefix : {"gpPt", "gpDot", "textbox", "greybox"}) {
    replace_all(rest, "id='" + std::string(prefix), "id='" + as.name + '-' + prefix);
    replace_all(rest, "href='#" + std::string(prefix), "href='#" + as.name + '-' + prefix);
  }
  rename_series(rest, as.name);
  replace_all(rest, "color=\"black\"", "");
  replace_all(rest, "fill=\"black\"", "fill=\"currentColor\"");
  replace_all(rest, "stroke='black'", "stroke='currentColor'");
  replace_all(rest, "color=\"gray\"", "color=\"var(--grid)\"");
  replace_all(rest, "font-family=\"Sans\"", "");
  for (const ChartColour& colour : as.colours) recolour(rest, colour);
  const std::size_t end = rest.rfind("</svg>");
  return "<svg class=\"chart\" viewBox=\"" + view +
         "\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" role=\"" +
         (as.inside.empty() ? "img" : "group") + "\" aria-label=\"" + html_text(as.label) +
         "\">\n" + rest.substr(0, end) + as.inside + "</svg>\n";
}

}  // namespace lentray::tool
