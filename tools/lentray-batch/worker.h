// A worker of a batch on a cluster: does one task, a job array's element. What other workers have done of it already is
// not done again: a task that is run anew after its node was lost goes on behind its last row.
// Errors: std::runtime_error, parser::OptionError. One thread.
#pragma once

#include "tools/lentray-batch/arguments.h"

namespace lentray::batch {

/// An exit status: 0 all rows are written, 3 a signal stopped it.
int do_task(const Arguments& arguments);

}  // namespace lentray::batch
