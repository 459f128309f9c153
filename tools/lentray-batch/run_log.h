// The log of a run that makes several views of a scene: what it says of one of them, and of all.
// Errors: none. Threads: any number.
#pragma once

#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace lentray::batch {

/// The lines from "View 7 of 15, ..." to the next view's, behind those before the first view's. What the run said last
/// is of a view that it came to and did not begin. No view: all lines.
std::vector<std::string> log_lines(std::istream& log, std::optional<int> view);

}  // namespace lentray::batch
