#include "parser/options/length.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/base/joined.h"
#include "core/base/trimmed.h"

namespace lentray::parser {
namespace {

struct LengthUnit {
  std::string_view name;
  double mm;
};
constexpr LengthUnit kUnits[] = {{"mm", 1.0},   {"cm", 10.0}, {"m", 1000.0},
                                 {"um", 0.001}, {"in", 25.4}, {"inch", 25.4}};

const LengthUnit* unit_named(std::string_view name) {
  const auto* row = std::ranges::find_if(
      kUnits, [name](const LengthUnit& unit) { return same_word(unit.name, name); });
  return row == std::end(kUnits) ? nullptr : row;
}

std::string_view without_blanks(std::string_view text) { return core::trimmed(text, " \t"); }

[[noreturn]] void refuse_unit(const GivenOption& given, std::string_view unit) {
  if (unit.front() == ',') refuse(given, "a decimal point is expected instead of the comma");
  refuse(given, "unknown unit '" + std::string(unit) +
                    "': a length is a number of mm, or has one of "
                    "the units " +
                    core::joined(kUnits, ", ", &LengthUnit::name));
}

}  // namespace

double length_mm(const GivenOption& given) {
  std::string_view rest;
  const double value = leading_number(given, rest);
  const std::string_view unit = without_blanks(rest);
  if (unit.empty()) return value;
  const LengthUnit* const row = unit_named(unit);
  if (!row) refuse_unit(given, unit);
  const double mm = value * row->mm;
  if (!std::isfinite(mm)) refuse(given, "a shorter length is expected");
  return mm;
}

double positive_length_mm(const GivenOption& given) {
  const double mm = length_mm(given);
  if (!(mm > 0.0)) refuse(given, "a length greater than 0 is expected");
  return mm;
}

double size_mm(const GivenOption& given) {
  constexpr double kLongestMm = 1e5;
  const double mm = length_mm(given);
  if (mm < 0.0) refuse(given, "a length of 0 or more is expected");
  if (mm > kLongestMm) refuse(given, "a length of at most 100 m is expected");
  return mm;
}

double positive_size_mm(const GivenOption& given) {
  const double mm = size_mm(given);
  if (!(mm > 0.0)) refuse(given, "a length greater than 0 is expected");
  return mm;
}

Extent extent_mm(const GivenOption& given) {
  const std::size_t cross = given.value.find('x');
  if (cross == std::string::npos) {
    refuse(given, "a width and a height are expected, such as 200x100mm");
  }
  GivenOption width = part_of(given, given.value.substr(0, cross));
  const GivenOption height = part_of(given, given.value.substr(cross + 1));
  std::string_view unit;
  (void)leading_number(height, unit);
  std::string_view own_unit;
  (void)leading_number(width, own_unit);
  if (without_blanks(own_unit).empty()) width.value += std::string(unit);
  return {positive_size_mm(width), positive_size_mm(height)};
}

double scene_length(const GivenOption& given, const char* instead) {
  std::string_view rest;
  const double value = leading_number(given, rest);
  const std::string_view unit = without_blanks(rest);
  if (unit_named(unit)) {
    refuse(given,
           "this length is in the scene's own units, which are no mm: a plain number is "
           "expected (" +
               std::string(instead) + " takes mm)");
  }
  if (!unit.empty()) refuse(given, "a number is expected");
  if (value < 0.0) refuse(given, "a distance of 0 or more is expected");
  return value;
}

}  // namespace lentray::parser
