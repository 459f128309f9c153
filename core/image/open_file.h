// A C file that closes itself, for libraries that read from one.
#pragma once

#include <cstdio>
#include "core/base/owned.h"

namespace lentray::core {

using OpenFile = Owned<std::FILE, std::fclose>;

}  // namespace lentray::core
