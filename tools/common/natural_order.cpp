#include "tools/common/natural_order.h"

#include <clocale>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <type_traits>

#include "core/base/owned.h"

namespace lentray::tool {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Digits from a place on, without leading zeros.
std::string_view number_at(std::string_view text, std::size_t at, std::size_t& end) {
  end = at;
  while (end < text.size() && is_digit(text[end])) ++end;
  while (at + 1 < end && text[at] == '0') ++at;
  return text.substr(at, end - at);
}

int compared(std::string_view a, std::string_view b) {
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    if (i == a.size() || j == b.size()) return i == a.size() ? -1 : 1;
    if (is_digit(a[i]) && is_digit(b[j])) {
      const std::string_view m = number_at(a, i, i), n = number_at(b, j, j);
      if (m.size() != n.size()) return m.size() < n.size() ? -1 : 1;
      if (const int order = m.compare(n); order != 0) return order;
      continue;
    }
    const auto c = static_cast<unsigned char>(a[i++]), d = static_cast<unsigned char>(b[j++]);
    if (c != d) return c < d ? -1 : 1;
  }
  return 0;
}

/// As languages sort, roughly: letters and digits alone, small ones like large ones.
std::string letters_of(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || byte >= 0x80) out += static_cast<char>(std::tolower(byte));
  }
  return out;
}

/// In one of the orders of shells: by bytes, or as the user's language has it.
bool is_as_shells_have_it(const std::vector<std::string>& names) {
  const core::Owned<std::remove_pointer_t<locale_t>, freelocale> locale(
      newlocale(LC_COLLATE_MASK, "", nullptr));
  const auto is_before = [&](const std::string& a, const std::string& b) {
    return locale ? strcoll_l(a.c_str(), b.c_str(), locale.get()) < 0 : a < b;
  };
  return std::ranges::is_sorted(names) || std::ranges::is_sorted(names, is_before) ||
         std::ranges::is_sorted(names, {}, letters_of);
}

}  // namespace

bool is_before_naturally(std::string_view a, std::string_view b) {
  const int order = compared(a, b);
  return order != 0 ? order < 0 : a < b;
}

std::optional<std::vector<fs::path>> natural_order_instead(const std::vector<fs::path>& files) {
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(file.string());
  if (std::ranges::is_sorted(names, is_before_naturally) || !is_as_shells_have_it(names)) {
    return std::nullopt;
  }
  std::ranges::stable_sort(names, is_before_naturally);
  return std::vector<fs::path>(names.begin(), names.end());
}

std::string natural_order_line(const std::vector<fs::path>& files) {
  constexpr std::size_t kShown = 4;
  std::string out = "pictures taken in natural order: ";
  for (std::size_t i = 0; i < files.size(); ++i) {
    const bool is_left_out = files.size() > kShown && i >= 2 && i + 1 < files.size();
    if (is_left_out && i > 2) continue;
    out += (i > 0 ? ", " : "") + (is_left_out ? std::string("...") : files[i].string());
  }
  return out;
}

}  // namespace lentray::tool
