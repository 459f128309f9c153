#include "parser/options/option_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/base/formed.h"
#include "core/base/joined.h"

namespace lentray::parser {
namespace {

constexpr std::string_view kOnWords[] = {"true", "yes", "on", "1"};
constexpr std::string_view kOffWords[] = {"false", "no", "off", "0"};

/// Alike as far as the shorter one goes.
bool begin_alike(std::string_view a, std::string_view b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  return same_word(a.substr(0, shorter), b.substr(0, shorter));
}

}  // namespace

GivenOption part_of(const GivenOption& given, std::string text) {
  GivenOption part = given;
  part.value = std::move(text);
  return part;
}

void refuse(const GivenOption& given, const std::string& why) {
  throw OptionError(given.where + "option " + given.shown + ": " + why);
}

SwitchWord switch_word(std::string_view text) {
  const auto is_one_of = [&](std::span<const std::string_view> words, auto compare) {
    return std::ranges::any_of(words, [&](std::string_view word) { return compare(text, word); });
  };
  const auto is_beginning = [](std::string_view beginning, std::string_view word) {
    return beginning.size() <= word.size() && begin_alike(beginning, word);
  };
  SwitchWord out;
  out.on = is_one_of(kOnWords, begin_alike);
  out.is_whole = is_one_of(out.on ? kOnWords : kOffWords, same_word);
  // "o" begins on and off.
  const bool begins_on = is_one_of(kOnWords, is_beginning);
  const bool begins_off = is_one_of(kOffWords, is_beginning);
  out.is_clear = begins_on != begins_off;
  return out;
}

bool truth(RenderOptions& options, const GivenOption& given) {
  if (given.sign != 0) return given.sign == '+';
  const SwitchWord word = switch_word(given.value);
  if (!word.is_clear) {
    options.warnings.push_back(given.where + "option " + given.shown +
                               ": neither on nor off, taken as " + (word.on ? "on" : "off"));
  }
  return word.on;
}

std::int64_t whole_number(const GivenOption& given, std::int64_t least, std::int64_t most) {
  std::string_view text = given.value;
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool range_error = error == std::errc::result_out_of_range;
  if (text.empty() || (error != std::errc() && !range_error) || end != text.data() + text.size()) {
    refuse(given, "a whole number is expected");
  }
  if (range_error || value < least || value > most) {
    refuse(given, "a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
                      " is expected");
  }
  return value;
}

namespace {

/// Takes the finite number off a text that begins with one.
std::optional<double> take_number(std::string_view& text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

}  // namespace

std::optional<double> number_in(std::string_view text) {
  const auto value = take_number(text);
  return text.empty() ? value : std::nullopt;
}

double number(const GivenOption& given) {
  const auto value = number_in(given.value);
  if (!value) refuse(given, "a number is expected");
  return *value;
}

double leading_number(const GivenOption& given, std::string_view& rest) {
  rest = given.value;
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  const auto value = take_number(rest);
  if (!value) refuse(given, "a number is expected");
  return *value;
}

namespace {

double cut(RenderOptions& options, const GivenOption& given, double value, std::string_view rest,
           double least, double most) {
  const double taken = std::clamp(value, least, most);
  if (taken != value || !rest.empty()) {
    options.warnings.push_back(given.where + "option " + given.shown +
                               core::formed(": taken as %.10g", taken));
  }
  return taken;
}

}  // namespace

double cut_number(RenderOptions& options, const GivenOption& given, double least, double most) {
  std::string_view rest;
  const double value = leading_number(given, rest);
  return cut(options, given, value, rest, least, most);
}

std::int64_t cut_whole(RenderOptions& options, const GivenOption& given, std::int64_t least,
                       std::int64_t most) {
  std::string_view rest;
  const double value = std::trunc(leading_number(given, rest));
  return static_cast<std::int64_t>(
      cut(options, given, value, rest, static_cast<double>(least), static_cast<double>(most)));
}

double positive(const GivenOption& given) {
  const double value = number(given);
  if (!(value > 0.0)) refuse(given, "a number greater than 0 is expected");
  return value;
}

std::string_view choice(const GivenOption& given, const char* what,
                        std::span<const std::string_view> there) {
  for (const std::string_view name : there) {
    if (same_word(name, given.value)) return name;
  }
  refuse(given, std::string("unknown ") + what + ": there are " + core::joined(there));
}

namespace {

/// Slips of the pen between two names, letter case ignored: letters missing, added, changed, or
/// two neighbours exchanged.
std::size_t slips(std::string_view a, std::string_view b) {
  const auto same = [&](std::size_t i, std::size_t j) {
    return same_word(a.substr(i, 1), b.substr(j, 1));
  };
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = std::min(
          {d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same(i - 1, j - 1) ? 0 : 1)});
      if (i > 1 && j > 1 && same(i - 1, j - 2) && same(i - 2, j - 1)) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string_view near_name(std::string_view written, std::span<const std::string_view> names) {
  std::string_view best;
  std::size_t fewest = std::max<std::size_t>(1, written.size() / 4) + 1;
  for (const std::string_view name : names) {
    const std::size_t shorter = std::min(written.size(), name.size());
    // So many letters are missing at least.
    if (std::max(written.size(), name.size()) - shorter >= fewest) continue;
    const std::size_t n = slips(written, name);
    if (n >= fewest) continue;
    fewest = n;
    best = name;
  }
  return best;
}

void not_yet(RenderOptions& options, const GivenOption& given, const std::string& what) {
  const std::string text = given.where + "option " + given.shown + ": not yet: " + what;
  if (!given.from_defaults) throw OptionError(text);
  options.warnings.push_back(text);
}

}  // namespace lentray::parser
