// Words as one text, with something between them. Pure.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace lentray::core {

/// `word_of`: what is shown of each.
template <class Words, class WordOf = std::identity>
std::string joined(const Words& words, std::string_view between = ", ", WordOf word_of = {}) {
  std::string out;
  for (const auto& each : words) {
    if (!out.empty()) out += between;
    out += std::invoke(word_of, each);
  }
  return out;
}

}  // namespace lentray::core
