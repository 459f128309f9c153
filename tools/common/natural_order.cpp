#include "tools/common/natural_order.h"

#include <clocale>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <iterator>
#include <set>
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

bool is_sign(char c) { return c == '-' || c == '+'; }

/// A number with or without a sign, such as -12.5, which no digit stands before.
struct Signed {
  bool is_there = false, has_minus = false;
  std::string_view whole, fraction;
  std::size_t end = 0;
};
Signed signed_at(std::string_view text, std::size_t at) {
  Signed out;
  if (at > 0 && is_digit(text[at - 1])) return out;
  const std::size_t digits = at + (at < text.size() && is_sign(text[at]) ? 1 : 0);
  if (digits == text.size() || !is_digit(text[digits])) return out;
  out.is_there = true;
  out.has_minus = text[at] == '-';
  out.whole = number_at(text, digits, out.end);
  if (out.end + 1 >= text.size() || text[out.end] != '.' || !is_digit(text[out.end + 1]))
    return out;
  const std::size_t begin = ++out.end;
  while (out.end < text.size() && is_digit(text[out.end])) ++out.end;
  out.fraction = text.substr(begin, out.end - begin);
  while (out.fraction.ends_with('0')) out.fraction.remove_suffix(1);
  return out;
}

int compared_sizes(const Signed& a, const Signed& b) {
  if (a.whole.size() != b.whole.size()) return a.whole.size() < b.whole.size() ? -1 : 1;
  const int order = a.whole.compare(b.whole);
  return order != 0 ? order : a.fraction.compare(b.fraction);
}
int compared(const Signed& a, const Signed& b) {
  const bool are_zero =
      a.whole == "0" && b.whole == "0" && a.fraction.empty() && b.fraction.empty();
  if (are_zero) return 0;
  if (a.has_minus != b.has_minus) return a.has_minus ? -1 : 1;
  return a.has_minus ? compared_sizes(b, a) : compared_sizes(a, b);
}

/// What stands before a place, numbers aside.
std::string slot_of(std::string_view text, std::size_t at) {
  std::string out;
  for (std::size_t i = 0; i < at; ++i) {
    if (!is_digit(text[i]))
      out += text[i];
    else if (!out.ends_with('0'))
      out += '0';
  }
  return out;
}

/// Where signs are meant: behind the same text some numbers have a minus and others have none.
class SignedSlots {
 public:
  explicit SignedSlots(const std::vector<std::string>& names) {
    std::set<std::string> with_minus, without;
    for (const std::string& name : names) {
      for (std::size_t at = 0; at < name.size(); ++at) {
        const Signed number = signed_at(name, at);
        if (!number.is_there) continue;
        (number.has_minus ? with_minus : without).insert(slot_of(name, at));
        at = number.end;
      }
    }
    std::ranges::set_intersection(with_minus, without, std::inserter(m_slots, m_slots.end()));
  }
  bool has(std::string_view text, std::size_t at) const {
    return !m_slots.empty() && m_slots.contains(slot_of(text, at));
  }

 private:
  std::set<std::string> m_slots;
};

int compared(std::string_view a, std::string_view b, const SignedSlots& slots) {
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    if (i == a.size() || j == b.size()) return i == a.size() ? -1 : 1;
    const Signed x = signed_at(a, i), y = signed_at(b, j);
    if (x.is_there && y.is_there && slots.has(a, i)) {
      if (const int order = compared(x, y); order != 0) return order;
      i = x.end;
      j = y.end;
      continue;
    }
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

std::optional<std::vector<fs::path>> natural_order_instead(const std::vector<fs::path>& files) {
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(file.string());
  const SignedSlots slots(names);
  const auto is_before_naturally = [&](const std::string& a, const std::string& b) {
    const int order = compared(a, b, slots);
    return order != 0 ? order < 0 : a < b;
  };
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
