#include "parser/compile/object_places.h"

#include <algorithm>
#include <cctype>
#include <functional>

namespace lentray::parser {
namespace {

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The identifier of `object { Name ... }`, or nothing.
std::string_view identifier_at(std::string_view text) {
  constexpr std::string_view kObject = "object";
  if (!text.starts_with(kObject)) return {};
  const auto skip_blanks = [&text] {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) {
      text.remove_prefix(1);
    }
  };
  text.remove_prefix(kObject.size());
  skip_blanks();
  if (text.empty() || text.front() != '{') return {};
  text.remove_prefix(1);
  skip_blanks();
  std::size_t length = 0;
  while (length < text.size() && is_of_word(text[length])) ++length;
  // Reserved words are lower case throughout, and few identifiers are.
  const std::string_view word = text.substr(0, length);
  const bool has_capital = word.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") != word.npos;
  return has_capital ? word : std::string_view();
}

}  // namespace

void ObjectPlaces::sort_parts() {
  std::ranges::stable_sort(parts, std::less<>(), [](const auto& part) { return part.first; });
}

const ObjectPlace* ObjectPlaces::place_of(const void* id, std::size_t whole) const {
  const auto at = std::ranges::lower_bound(
      parts, id, std::less<const void*>(),
      [](const auto& part) { return static_cast<const void*>(part.first); });
  if (at != parts.end() && at->first == id) return &at->second;
  return whole < wholes.size() ? &wholes[whole] : nullptr;
}

std::string object_name(const ObjectPlace& place, const SourceManager& sources) {
  const std::string at = sources.place(place.where);
  const std::string behind = at.empty() ? "" : " at " + at;
  const std::string_view text = sources.text(place.where.file);
  if (place.where.offset < text.size()) {
    const std::string_view name = identifier_at(text.substr(place.where.offset));
    if (!name.empty()) return std::string(name) + behind;
  }
  return std::string(place.keyword) + behind;
}

}  // namespace lentray::parser
