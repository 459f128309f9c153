// Text in a form as printf has it. Any number of threads.
#pragma once

#include <string>

namespace lentray::core {

[[gnu::format(printf, 1, 2)]] std::string formed(const char* how, ...);

}  // namespace lentray::core
