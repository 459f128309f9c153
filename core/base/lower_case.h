// Text without large letters. Pure.
#pragma once

#include <cctype>
#include <string>

namespace lentray::core {

/// Bytes beyond ASCII stay as they are.
inline std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace lentray::core
