// Times for readers. Pure functions.
#pragma once

#include <string>

namespace lentray::tool {

/// As exact as it helps: 7.4 s, 52 s, 12 min 30 s, 3 h 5 min.
std::string duration_text(double seconds);

}  // namespace lentray::tool
