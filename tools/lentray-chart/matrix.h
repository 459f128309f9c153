// Which settings of a scene are worth charting: those that trade time for error in something that the scene uses, and
// those that change the time alone. Pure functions.
#pragma once

#include <string>
#include <vector>

#include "parser/options/options.h"
#include "tools/lentray-chart/chart.h"
#include "tools/lentray-chart/facts.h"

namespace lentray::chart {

struct MatrixRequest {
  SceneFacts facts;
  Abilities abilities;
  parser::RenderOptions own;  ///< the user's options
  std::vector<Kind> only{};   ///< empty: all kinds
  bool quick = false;
  int processors = 1;  ///< of the machine
};

/// As options take it, of six digits; whole numbers have all of theirs.
std::string number_text(double value);

/// The plain setting first, then all single ones. Settings that would repeat the user's own options are left out.
std::vector<Setting> settings_of(const MatrixRequest& request);

/// Crosses levels of the kinds that have been measured (the fastest, the least error, and one of the front between
/// them, a kind) into settings of several kinds at once; the errors of `points` are known.
std::vector<Setting> combined_settings(const std::vector<Point>& points, bool quick);

/// Whether stock POV-Ray has that setting: antialiasing by methods 1 and 2, +Q and the plain one.
bool stock_has(const Setting& setting);

}  // namespace lentray::chart
