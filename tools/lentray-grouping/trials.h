// The experiment: lentray run once with a log of its shadow rays for each combination, then several
// times for its time, all combinations of a scene in turn so that a slower spell of the machine
// meets all alike. Errors: std::runtime_error with what lentray said. One thread.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/lentray-grouping/arguments.h"

namespace lentray::grouping {

/// One scene and size, order, cache and accelerator. Counts are exact, over all lights.
struct Trial {
  std::string scene, order, cache, accelerator;
  std::string size{};         ///< of the scene; empty: its own
  std::vector<double> cpu_s;  ///< of rendering, one a repeat
  std::uint64_t rays = 0, blocked = 0, hits = 0;
  std::uint64_t pairs = 0, most_hits = 0;  ///< pairs of light and occluder; blocked less those
  std::uint64_t tests = 0, miss_tests = 0;
  std::uint64_t runs = 0, longest_run = 0;
  bool same_picture = true;  ///< as the scene's first trial

  double median() const;  ///< 0 where nothing was timed, as the next two
  double least() const;
  double most() const;
  double tests_a_ray() const;
  double hits_of_blocked() const;  ///< 0 where nothing is blocked
  double hits_of_most() const;
  double mean_run() const;
  /// Cm of equation 1, in tests: what a ray costs that the cache does not answer.
  double miss_cost() const;
};

std::vector<Trial> run_trials(const Arguments& arguments,
                              const std::function<void(const std::string&)>& tell);

}  // namespace lentray::grouping
