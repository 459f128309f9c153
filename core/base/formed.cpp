#include "core/base/formed.h"

#include <cstdarg>
#include <cstdio>

namespace lentray::core {

std::string formed(const char* how, ...) {
  va_list values, again;
  va_start(values, how);
  va_copy(again, values);
  const int length = std::vsnprintf(nullptr, 0, how, values);
  va_end(values);
  std::string text(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
  std::vsnprintf(text.data(), text.size() + 1, how, again);
  va_end(again);
  return text;
}

}  // namespace lentray::core
