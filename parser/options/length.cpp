#include "parser/options/length.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace lentray::parser {
namespace {

struct LengthUnit {
  std::string_view name;
  double mm;
};
constexpr LengthUnit kLengthUnits[] = {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}};
constexpr double kLongestMm = 1e5;

[[noreturn]] void refuse_length(const GivenOption& given) {
  refuse(given, "a length with its unit is expected, such as 10mm, 2.5cm, 0.3m or 4in");
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// The number that the text begins with; what follows it is left in `text`.
double take_number(const GivenOption& given, std::string_view& text) {
  text = without_blanks(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) refuse(given, "a length is at most 100 m");
  if (error != std::errc() || !std::isfinite(value)) refuse_length(given);
  text = without_blanks(text.substr(static_cast<std::size_t>(end - text.data())));
  return value;
}

double unit_of(const GivenOption& given, std::string_view text) {
  for (const LengthUnit& unit : kLengthUnits) {
    if (text == unit.name) return unit.mm;
  }
  refuse_length(given);
}

double checked_length(const GivenOption& given, double mm) {
  if (mm < 0.0) refuse(given, "a length is not negative");
  if (!(mm <= kLongestMm)) refuse(given, "a length is at most 100 m");
  return mm;
}

}  // namespace

double length_in_mm(const GivenOption& given) {
  std::string_view text = given.value;
  const double value = take_number(given, text);
  return checked_length(given, value * unit_of(given, text));
}

double positive_length_in_mm(const GivenOption& given) {
  const double mm = length_in_mm(given);
  if (!(mm > 0.0)) refuse(given, "a length greater than 0 is expected");
  return mm;
}

Extent extent_in_mm(const GivenOption& given) {
  const std::string_view text = given.value;
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) {
    refuse(given, "a width and a height are expected, such as 200x100mm");
  }
  std::string_view unit_x = text.substr(0, cross), unit_y = text.substr(cross + 1);
  const double width = take_number(given, unit_x), height = take_number(given, unit_y);
  const double mm = unit_of(given, unit_y);
  const Extent extent{checked_length(given, width * (unit_x.empty() ? mm : unit_of(given, unit_x))),
                      checked_length(given, height * mm)};
  if (!(extent.width > 0.0 && extent.height > 0.0)) {
    refuse(given, "a width and a height greater than 0 are expected");
  }
  return extent;
}

}  // namespace lentray::parser
