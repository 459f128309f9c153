// Files as authors on Windows name them: letter case, backslashes, spaces around names, drives.
// Only asked when a name is not found as it stands. Errors: none, a file is found or not.
#pragma once

#include <optional>
#include <string>

namespace lentray::parser {

/// The file below `folder` that Windows would mean by `name`; of several that differ in letter case,
/// the first in order of bytes. Of an absolute Windows path only the file's name counts.
std::optional<std::string> find_loosely(const std::string& folder, const std::string& name);

}  // namespace lentray::parser
