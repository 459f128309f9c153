// A comparison with stock as a Markdown page: grades, what is not rendered yet, a line a scene. Pure functions.
#pragma once

#include <string>
#include <vector>

#include "tools/lentray-batch/row.h"

namespace lentray::batch {

/// `command`: how the page is made. `stock`: its version. Rows without a verdict are named at the end.
std::string table(const std::vector<Row>& rows, const std::string& command,
                  const std::string& stock);

}  // namespace lentray::batch
