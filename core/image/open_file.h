// A C file that closes itself, for libraries that read from one.
#pragma once

#include <cstdio>
#include <memory>

namespace lentray::core {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

}  // namespace lentray::core
