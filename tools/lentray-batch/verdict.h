// What lentray-diff says of a picture (its --json), as a batch keeps it.
// Errors: nlohmann::json::exception where figures are missing. Pure.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "tools/lentray-batch/row.h"

namespace lentray::batch {

/// Grade and figures of ours beside stock's.
void take_figures(const nlohmann::json& said, Verdict& verdict);

}  // namespace lentray::batch
