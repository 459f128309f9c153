// Where labels of points stand in a chart: beside their points, clear of all points and of each other.
// Units: pixels from the left and top. Errors: none. Threads: any number; pure.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lentray::chart {

struct Spot {
  double x = 0.0, y = 0.0;
};

struct LabelWish {
  Spot at;
  std::string text;
  bool is_first = false;  ///< it has a place before others
};

struct PlacedLabel {
  std::string text;
  double left = 0.0, middle = 0.0;  ///< its left end and half of its height
};

struct LabelArea {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

/// How much room a label takes.
double label_width(const std::string& text);
inline constexpr double kLabelHeight = 13.0;

/// At most `most`; those that have no clear place within the area are left out. `spots` are the points of the chart.
std::vector<PlacedLabel> placed_labels(const std::vector<LabelWish>& wishes,
                                       const std::vector<Spot>& spots, const LabelArea& area,
                                       std::size_t most);

}  // namespace lentray::chart
