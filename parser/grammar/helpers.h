// Small readers that many productions share.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/base/joined.h"
#include "parser/interpreter/parser.h"
#include "parser/tokens/keywords.h"

namespace lentray::parser {

/// True if a float may start here: the next token starts an expression, and neither is it a
/// vector's "<" nor does it name a vector.
inline bool at_float(Parser& parser) {
  if (!parser.at_expression() || parser.at(Punct::kLess)) return false;
  const Value* value = parser.peek_value();
  const Number* number = value ? std::get_if<Number>(value) : nullptr;
  return !number || number->size == 1;
}

/// The brace that ends a block; `words` are what else could have come: "one of a, b".
inline void end_block(Parser& parser, std::string_view words) {
  if (!parser.accept(Punct::kRightCurly)) parser.fail_expected(std::string(words) + " or }");
}

/// A float if one is next, the default otherwise.
inline double optional_float(Parser& parser, double otherwise) {
  return at_float(parser) ? parser.parse_float() : otherwise;
}

/// A switch that says "on" by standing alone.
inline bool optional_switch(Parser& parser) { return optional_float(parser, 1.0) > 0.0; }

/// A comma, which may be missing, then a float if one is next.
inline double next_float(Parser& parser, double otherwise) {
  parser.parse_comma();
  return optional_float(parser, otherwise);
}

/// Numbers and vectors with commas between them, which may be missing.
template <typename First, typename... Rest>
void parse_values(Parser& parser, First& first, Rest&... rest) {
  first = parser.parse<First>();
  ((parser.parse_comma(), rest = parser.parse<Rest>()), ...);
}

/// A word of a table of readers: the value behind it goes to this member.
template <auto kMember, typename Context, typename Desc>
void read_value(Parser& parser, Context&, Desc& desc) {
  desc.*kMember = parser.parse<std::remove_reference_t<decltype(desc.*kMember)>>();
}

/// A word of a table of readers: it stands alone and turns this member on.
template <auto kMember, typename Context, typename Desc>
void turn_on(Parser&, Context&, Desc& desc) {
  desc.*kMember = true;
}

/// A word of a table of readers: the switch behind it goes to this member.
template <auto kMember, typename Context, typename Desc>
void read_switch(Parser& parser, Context&, Desc& desc) {
  desc.*kMember = optional_switch(parser);
}

/// A vector of two components; a float stands for both.
inline core::Vec2 parse_uv(Parser& parser) {
  const Number n = parser.parse_number(1, 5);
  return n.size == 1 ? core::Vec2{n.v[0], n.v[0]} : core::Vec2{n.v[0], n.v[1]};
}

/// Fails if a picture that a function makes has more points than memory is meant for.
inline void check_points(Parser& parser, const Location& where, double width, double height) {
  const double most = static_cast<double>(parser.options().limits.array_elements);
  if (std::max(width, 0.0) * std::max(height, 0.0) <= most) return;
  parser.fail_at(where, "a picture made by a function has at most " +
                            std::to_string(parser.options().limits.array_elements) + " points");
}

/// A vector of four components; a float stands for all.
inline std::array<double, 4> parse_vector4(Parser& parser) {
  const Number n = parser.parse_number(1, 5);
  if (n.size == 1) return {n.v[0], n.v[0], n.v[0], n.v[0]};
  return {n.v[0], n.v[1], n.v[2], n.v[3]};
}

/// "a, b, c" of the words of a table whose entries have a `keyword`.
template <typename Table>
std::string word_list(const Table& table) {
  return core::joined(table, ", ", [](const auto& entry) { return spelling(entry.keyword); });
}

/// Which entry of a table each keyword has, from 1; 0: none.
template <const auto& kTable>
inline constexpr auto kEntryOf = [] {
  std::array<std::uint8_t, static_cast<std::size_t>(Keyword::kEndOfKeywords)> entry_of{};
  static_assert(kTable.size() < 256);
  std::uint8_t count = 0;
  for (const auto& entry : kTable) entry_of[static_cast<std::size_t>(entry.keyword)] = ++count;
  return entry_of;
}();

/// The entry of a table for the next token, or null.
template <const auto& kTable>
auto find_entry(const Token& token) -> decltype(kTable.data()) {
  if (token.kind != TokenKind::kKeyword) return nullptr;
  const std::size_t entry = kEntryOf<kTable>[static_cast<std::size_t>(token.keyword)];
  return entry ? kTable.data() + (entry - 1) : nullptr;
}

}  // namespace lentray::parser
