// Names of files that belong to another one, whose name may already be as long as names can be.
// Pure functions.
#pragma once

#include <string>

namespace lentray::tool {

/// The path with `end` behind it; of a name that would be longer than a file system takes, its
/// beginning and its checksum.
std::string companion_path(const std::string& path, const std::string& end);

/// The journal of the picture at that path (tools/session/picture_journal.h).
std::string journal_path(const std::string& picture);

}  // namespace lentray::tool
