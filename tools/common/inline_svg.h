// Charts of gnuplot inside a page: in its colours, light and dark, as wide as there is room, and with names of their own.
// Errors: none. Threads: any number; all functions are pure.
#pragma once

#include <string>
#include <vector>

namespace lentray::tool {

/// A colour that a chart's script names, and what the page has instead of it, such as "var(--series-1)".
struct ChartColour {
  unsigned rgb = 0;  ///< 0xRRGGBB
  std::string css;
};

/// For gnuplot's own first eight line colours.
const std::vector<ChartColour>& default_series_colours();

struct InlineSvg {
  std::string
      name;  ///< of letters, digits and -: ids begin with it, so that charts of one page do not share any
  std::string label;  ///< what the chart shows, for those who do not see it
  std::vector<ChartColour> colours = default_series_colours();
  std::string inside{};  ///< SVG that is drawn on top and that readers can act on
};

/// `svg` as gnuplot() gives it, for the inside of a page of page_of(). Text and axes have the page's colour, and
/// there is no background. Series i, from 0, is a group of the id NAME-series-i.
std::string inline_svg(const std::string& svg, const InlineSvg& as);

}  // namespace lentray::tool
