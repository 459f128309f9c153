// Work before the picture whose result the whole picture reads, such as a map of light. A pass is
// made with all that it works on and with the place of its result, which others read when run() has
// returned and nobody changes. The same bits for every number of threads.
// Errors: what run() throws reaches the caller of PassList::run(). One thread calls.
#pragma once

#include <string>

#include "core/pass/pass_run.h"

namespace lentray::core {

class Pass {
 public:
  virtual ~Pass() = default;
  /// For progress and statistics: "radiosity".
  virtual std::string name() const = 0;
  /// About how many camera rays it takes the time of: weighs its progress beside others'.
  virtual double work() const = 0;
  /// Threads, order, progress, statistics, and what is kept of it: see PassRun.
  virtual void run(PassRun& run) = 0;
};

}  // namespace lentray::core
