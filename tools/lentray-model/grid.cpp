#include "tools/lentray-model/grid.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "shadow/hit_model/paper_test.h"

namespace lentray::model {

using tool::csv_field;
using tool::number_text;

using shadow::paper::Alpha;

Point model_point(const shadow::PaperSheet& sheet, const shadow::Enumeration& enumeration,
                  const shadow::ShadowSquare& shadow, const shadow::Style& style) {
  Point point;
  point.a = shadow.size;
  point.d = shadow.distance;
  const shadow::ClosedForm printed = shadow::closed_form(sheet, shadow, style, Alpha::kPrinted);
  if (printed.exists) {
    point.printed = printed.hits;
    point.refracted = shadow::closed_form(sheet, shadow, style, Alpha::kRefracted).hits;
  }
  point.enumerated = enumeration.continuous_hits(style);
  return point;
}

Grid make_grid(const Arguments& arguments, const shadow::PaperSheet& sheet,
               const std::vector<shadow::Style>& styles,
               const std::function<bool(const shadow::Style&)>& measured,
               const std::function<void(double)>& progress) {
  Grid grid{arguments.a.values(), arguments.d.values(), {}};
  const std::size_t points = grid.a.size() * grid.d.size();
  for (const shadow::Style& style : styles) {
    grid.styles.push_back({style, std::vector<Point>(points)});
  }
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    arguments.threads > 0
                                        ? static_cast<std::size_t>(arguments.threads)
                                        : std::max(1u, std::thread::hardware_concurrency()));
  std::atomic<std::size_t> done = 0;
  tbb::parallel_for(std::size_t{0}, points, [&](std::size_t i) {
    const auto square = arguments.shadow(grid.a[i / grid.d.size()], grid.d[i % grid.d.size()]);
    const shadow::Enumeration enumeration(sheet, square);
    std::optional<shadow::PaperTest> test;
    for (StyleGrid& style : grid.styles) {
      Point& point = style.points[i];
      point = model_point(sheet, enumeration, square, style.style);
      if (!measured(style.style)) continue;
      if (!test) test.emplace(sheet, enumeration, square.distance);
      point.measured = test->measure(style.style).continuous_hits;
    }
    const std::size_t so_far = ++done;
    if (progress) progress(static_cast<double>(so_far) / static_cast<double>(points));
  });
  // Says to the thread sanitizer too, which does not see oneTBB wait, that the points are written.
  if (done.load() != points) throw std::logic_error("points of the grid are missing");
  return grid;
}

std::string csv_of(const Grid& grid, const Arguments& arguments) {
  std::string out = "style,A,D,xstart,closed_form,enumerated,measured\n";
  const auto number = [](std::optional<std::uint64_t> n) { return n ? std::to_string(*n) : ""; };
  for (const StyleGrid& style : grid.styles) {
    for (const Point& p : style.points) {
      out += csv_field(style.style.name()) + "," + number_text(p.a) + "," + number_text(p.d) + "," +
             number_text(arguments.x) + "," + number(p.closed(arguments.alpha)) + "," +
             std::to_string(p.enumerated) + "," + number(p.measured) + "\n";
    }
  }
  return out;
}

}  // namespace lentray::model
