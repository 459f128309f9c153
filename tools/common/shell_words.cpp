#include "tools/common/shell_words.h"

#include <string_view>

#include "core/base/joined.h"

namespace lentray::tool {

std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-=_./:,@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

std::string shell_command(const std::vector<std::string>& words) {
  return core::joined(words, " ", shell_word);
}

}  // namespace lentray::tool
