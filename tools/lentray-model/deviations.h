// Where the paper's equations leave the enumeration, and by how much: regions of (A, D), style by
// style, with and without n in alpha. Differences are equation minus enumeration, in rays.
// Pure functions.
#pragma once

#include <string>
#include <vector>

#include "tools/lentray-model/grid.h"

namespace lentray::model {

/// A region of the grid; regions overlap, but for "elsewhere", which is the rest.
struct Region {
  std::string name, meaning;
};
/// all, near, full, small, tiny, edge, elsewhere.
const std::vector<Region>& regions();
/// Whether the region of that number holds the shadow.
bool lies_in(std::size_t region, const shadow::PaperSheet& sheet,
             const shadow::ShadowSquare& shadow, shadow::paper::Alpha alpha);

struct Deviation {
  std::string style, region;
  shadow::paper::Alpha alpha{};
  std::size_t points = 0, equal = 0;
  double mean = 0.0;           ///< of the difference
  double mean_relative = 0.0;  ///< of |difference| / enumerated, where something is enumerated
  double worst = 0.0;          ///< the largest |difference|, with its sign
  Point at;                    ///< where that is
};

/// Regions without points are left out.
std::vector<Deviation> deviations(const Grid& grid, const Arguments& arguments,
                                  const shadow::PaperSheet& sheet);
std::string csv_of(const std::vector<Deviation>& deviations);
/// A table to read, with what the regions mean.
std::string table_of(const std::vector<Deviation>& deviations);

}  // namespace lentray::model
