// How long pictures will take, before they are rendered: from what earlier runs took, else from coarse renders, with the
// same options and fewer pixels. Of an animation the first frame speaks for all.
// Errors: none; a scene that fails is taken for quick. One thread.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/lentray-batch/job.h"
#include "tools/lentray-batch/tasks.h"

namespace lentray::batch {

/// Names of the jobs are those of the estimates. Nothing if a signal stopped it.
std::optional<std::vector<Estimate>> estimates_of(const Plan& plan, const std::vector<Job*>& jobs,
                                                  const std::map<std::string, Row>& earlier);

}  // namespace lentray::batch
