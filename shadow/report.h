// The statistics of one run as JSON (`Statistics_File=`). The keys are documented in
// docs/statistics.md. Reports are made once, after the frame, by one thread.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/counters.h"
#include "core/base/memory_stages.h"
#include "core/pass/pass_report.h"
#include "shadow/run_log.h"

namespace lentray::shadow {

struct RunReport {
  std::string scene;  ///< as it was named
  std::uint32_t width = 0, height = 0;
  std::string pixel_order = "rows", shadow_cache = "off", accelerator = "bvh";
  core::Counters counters;                   ///< merged over the threads
  std::vector<core::PassReport> passes;      ///< before the film
  std::uint32_t band_height = 0, bands = 0;  ///< rows in a band, and how many bands there are
  std::vector<LightRuns> shadow_log;         ///< one a light; empty: there was no log
  bool tests_counted = false;                ///< counters' tests are filled
  double parse_cpu_s = 0.0, compile_cpu_s = 0.0, render_cpu_s = 0.0, write_cpu_s = 0.0;
  double wall_s = 0.0;
  int threads = 1;
  std::uint64_t peak_bytes = 0;
  core::MemoryStages memory;  ///< what of it the stages before the film hold
};

nlohmann::json to_json(const RunReport& report);

}  // namespace lentray::shadow
