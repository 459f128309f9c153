// What the parts of a run of lentray-chart share, and lentray as they call it. One thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/lentray-chart/arguments.h"
#include "tools/lentray-chart/matrix.h"
#include "tools/lentray-chart/progress.h"
#include "tools/lentray-chart/runner.h"
#include "tools/lentray-chart/state.h"

namespace lentray::chart {

struct Session {
  Session(const Arguments& what, const ChartFolder& where, const Progress& shown);

  const Arguments& arguments;
  const ChartFolder& folder;
  const Progress& progress;
  Runner runner;
  ChartState state;
  MatrixRequest request;

  Chart& chart() { return state.chart; }
  void save() const { folder.save(state); }
  /// lentray with the user's options, then `options`.
  Outcome lentray(const std::vector<std::string>& options, double cpu_limit = 0.0) const;
  /// The same, with a picture of 16 bits, relative to the folder. A picture that is not finished leaves nothing behind.
  Outcome render(const std::vector<std::string>& options, const std::string& picture,
                 double cpu_limit = 0.0) const;
  /// lentray-diff with the user's options, then `options`.
  Outcome diff(const std::vector<std::string>& options, double cpu_limit = 0.0) const;
};

/// Pictures of 16 bits of a point, relative to the folder.
std::string picture_name(const std::string& id);

}  // namespace lentray::chart
