#include "parser/descriptions/maps.h"

#include <array>
#include <span>

#include "parser/grammar/helpers.h"
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

using core::Colour;

constexpr std::array<Colour, 2> kBrick = {
    {{{0.5f, 0.5f, 0.5f}, 0, 0}, {{0.6f, 0.15f, 0.15f}, 0, 0}}};
constexpr std::array<Colour, 3> kHexagon = {
    {{{0, 0, 1}, 0, 0}, {{0, 1, 0}, 0, 0}, {{1, 0, 0}, 0, 0}}};
constexpr std::array<Colour, 6> kSix = {{{{1, 0, 0}, 0, 0},
                                         {{0, 1, 0}, 0, 0},
                                         {{0, 0, 1}, 0, 0},
                                         {{1, 1, 0}, 0, 0},
                                         {{0, 1, 1}, 0, 0},
                                         {{1, 0, 1}, 0, 0}}};

/// Colours of an item list that names none. Source: the manual's pages of the patterns; square,
/// triangular and cubic share one list (measured on stock).
std::span<const Colour> default_colours(PatternKind kind) {
  switch (kind) {
    case PatternKind::kBrick: return kBrick;
    case PatternKind::kSquare:
    case PatternKind::kTriangular:
    case PatternKind::kCubic: return kSix;
    default: return kHexagon;  // checker and object take the first two
  }
}

/// `{ identifier }` or `{ [value item] ... }`.
template <typename Map, typename ReadEntry>
Ref<Map> parse_map(Parser& parser, const char* name, ReadEntry read_entry) {
  auto map = std::make_shared<Map>();
  map->where = parser.location();
  parser.expect(Punct::kLeftCurly);
  if (auto known = parser.accept_value<Ref<Map>>()) {
    parser.expect(Punct::kRightCurly);
    return *known;
  }
  while (parser.accept(Punct::kLeftSquare)) {
    read_entry(*map);
    parser.expect(Punct::kRightSquare);
  }
  if (map->entries.empty())
    parser.fail_expected(std::string("an entry [value ...] of the ") + name);
  parser.expect(Punct::kRightCurly);
  return map;
}

double parse_entry_value(Parser& parser, bool average) {
  const double value = average ? parse_optional_float(parser, 1.0) : parser.parse_float();
  parser.parse_comma();
  return value;
}

/// Entries that are bodies without braces; `pigment { ... }` around one is understood too.
template <typename Map, typename ReadBody>
Ref<Map> parse_body_map(Parser& parser, const char* name, bool average, Keyword statement,
                        ReadBody read_body) {
  return parse_map<Map>(parser, name, [&](Map& map) {
    const double value = parse_entry_value(parser, average);
    const bool braces = parser.accept(statement);
    if (braces) parser.expect(Punct::kLeftCurly);
    map.entries.push_back({value, read_body()});
    if (braces) parser.expect(Punct::kRightCurly);
  });
}

void read_colour_entry(Parser& parser, ColourMapDesc& map) {
  const double from = parser.parse_float();
  parser.parse_comma();
  if (parser.at_colour()) {
    map.entries.push_back({from, to_colour(parser.parse_colour())});
    return;
  }
  if (!parser.at_expression()) parser.fail_expected("a color");
  const Number number = parser.parse_number(1, 5);
  if (number.size > 1) {
    map.entries.push_back({from, to_colour(number)});
    return;
  }
  // The form of POV-Ray 1: two values, then the colours at both.
  parser.parse_comma();
  map.entries.push_back({from, to_colour(parser.parse_colour())});
  parser.parse_comma();
  if (!parser.at_colour() && !parser.at_expression()) parser.fail_expected("a second color");
  map.entries.push_back({number.v[0], to_colour(parser.parse_colour())});
}

}  // namespace

Ref<ColourMapDesc> parse_colour_map(Parser& parser, MaterialContext&) {
  return parse_map<ColourMapDesc>(parser, "color_map",
                                  [&](ColourMapDesc& map) { read_colour_entry(parser, map); });
}

Ref<SlopeMapDesc> parse_slope_map(Parser& parser, MaterialContext&) {
  return parse_map<SlopeMapDesc>(parser, "slope_map", [&](SlopeMapDesc& map) {
    const double value = parse_entry_value(parser, false);
    const core::Vec2 point = parse_uv(parser);
    map.entries.push_back({value, {point.u, point.v}});
  });
}

Ref<PigmentMapDesc> parse_pigment_map(Parser& parser, MaterialContext& context, bool average) {
  return parse_body_map<PigmentMapDesc>(parser, "pigment_map", average, Keyword::kPigment, [&] {
    return parse_pigment_body(parser, context, default_layer(context).pigment);
  });
}

Ref<NormalMapDesc> parse_normal_map(Parser& parser, MaterialContext& context, bool average) {
  return parse_body_map<NormalMapDesc>(parser, "normal_map", average, Keyword::kNormal, [&] {
    return parse_normal_body(parser, context, default_layer(context).normal);
  });
}

Ref<TextureMapDesc> parse_texture_map(Parser& parser, MaterialContext& context, bool average) {
  return parse_body_map<TextureMapDesc>(parser, "texture_map", average, Keyword::kTexture,
                                        [&] { return parse_texture_body(parser, context); });
}

Ref<DensityMapDesc> parse_density_map(Parser& parser, MaterialContext& context, bool average) {
  return parse_body_map<DensityMapDesc>(parser, "density_map", average, Keyword::kDensity,
                                        [&] { return parse_density_body(parser, context); });
}

Ref<ColourMapDesc> parse_colour_list(Parser& parser, PatternKind kind) {
  auto map = std::make_shared<ColourMapDesc>();
  map->where = parser.location();
  const std::span<const Colour> defaults = default_colours(kind);
  for (int i = 0; i < items_of(kind); ++i) {
    Colour colour = defaults[static_cast<std::size_t>(i)];
    // Once one is missing all the rest are.
    if (static_cast<int>(map->entries.size()) == i &&
        (parser.at_colour() || parser.at_expression())) {
      colour = to_colour(parser.parse_colour());
      parser.parse_comma();
    }
    map->entries.push_back({static_cast<double>(i), colour});
  }
  return map;
}

}  // namespace lentray::parser
