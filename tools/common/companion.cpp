#include "tools/common/companion.h"

#include <cinttypes>

#include "core/base/formed.h"
#include "parser/files/watched_files.h"

namespace lentray::tool {

std::string companion_path(const std::string& path, const std::string& end) {
  constexpr std::size_t kLongest = 255, kKept = 180;  // bytes
  const std::size_t name = path.rfind('/') + 1;
  if (path.size() - name + end.size() <= kLongest) return path + end;
  return path.substr(0, name + kKept) +
         core::formed("~%016" PRIx64, parser::checksum(path.substr(name))) + end;
}

std::string journal_path(const std::string& picture) {
  return companion_path(picture, ".lentray-state");
}

}  // namespace lentray::tool
