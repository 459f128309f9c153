#include "parser/grammar/pattern.h"

#include <filesystem>
#include <string>

#include "core/base/vec3.h"
#include "core/pattern/pavement.h"
#include "parser/grammar/helpers.h"
#include "parser/grammar/nesting.h"

namespace lentray::parser {
namespace {

/// What reads the arguments that stand right after a pattern's keyword.
struct Reader {
  Parser& parser;
  MaterialContext& context;
  PatternTarget& target;
  PatternDesc& pattern;
};
using ReadArguments = void (*)(const Reader&);

struct PatternRule {
  Keyword keyword;
  PatternKind kind;
  ReadArguments read = nullptr;
};

void read_items(const Reader& r) {
  r.pattern.frequency = 0.0;
  r.target.read_list(r.parser, items_of(r.pattern.kind));
}

void read_triangle_wave(const Reader& r) { r.pattern.wave = WaveForm::kTriangle; }

void read_no_frequency(const Reader& r) { r.pattern.frequency = 0.0; }

void read_agate(const Reader& r) { r.pattern.classic_turbulence(); }

void read_function(const Reader& r) {
  r.pattern.own.edit().function = r.parser.parse_function_body();
}

void read_gradient(const Reader& r) {
  r.pattern.own.edit().vector = core::normalized(r.parser.parse_vector());
}

void read_spiral(const Reader& r) {
  r.pattern.own.edit().arms = r.parser.parse_int();
  read_triangle_wave(r);
}

void read_quilted(const Reader& r) {
  PatternParameters& own = r.pattern.own.edit();
  own.quilt0 = own.quilt1 = 1.0;
  read_no_frequency(r);
}

void read_crackle(const Reader& r) {
  PatternParameters& own = r.pattern.own.edit();
  own.crackle_form = {-1, 1, 0};
  own.crackle_metric = 2.0;
  own.crackle_offset = 0.0;
  own.crackle_solid = false;
}

void read_facets(const Reader& r) {
  if (r.target.statement() != "normal") r.parser.fail("facets can only be used in a normal");
  PatternParameters& own = r.pattern.own.edit();
  own.facets_size = 0.1;
  own.facets_coords = 0.0;
  own.facets_metric = 2.0;
}

int read_iterations(Parser& parser) {
  const int iterations = parser.parse_int();
  if (iterations < 1) parser.fail("a fractal pattern needs at least one iteration");
  return iterations;
}

void reset_fractal(PatternDesc& pattern) {
  PatternParameters& own = pattern.own.edit();
  own.exponent = 2;
  own.exterior_type = 1;
  own.interior_type = 0;
  own.exterior_factor = own.interior_factor = 1.0;
}

void read_mandel(const Reader& r) {
  reset_fractal(r.pattern);
  r.pattern.own.edit().iterations = read_iterations(r.parser);
}

void read_julia(const Reader& r) {
  reset_fractal(r.pattern);
  r.pattern.own.edit().julia = parse_uv(r.parser);
  r.parser.parse_comma();
  r.pattern.own.edit().iterations = read_iterations(r.parser);
}

void read_magnet(const Reader& r) {
  reset_fractal(r.pattern);
  const int magnet = r.parser.parse_int();
  r.pattern.own.edit().magnet = magnet;
  if (magnet != 1 && magnet != 2) {
    r.parser.fail("the magnet pattern is of type 1 or 2");
  }
  if (r.parser.accept(Keyword::kMandel)) {
    r.pattern.kind = PatternKind::kMagnetMandel;
  } else if (r.parser.accept(Keyword::kJulia)) {
    r.pattern.kind = PatternKind::kMagnetJulia;
    r.pattern.own.edit().julia = parse_uv(r.parser);
    r.parser.parse_comma();
  } else {
    r.parser.fail_expected("mandel or julia");
  }
  r.pattern.own.edit().iterations = read_iterations(r.parser);
}

void read_pigment_pattern(const Reader& r) {
  r.parser.expect(Punct::kLeftCurly);
  r.pattern.own.edit().pigment =
      parse_pigment_body(r.parser, r.context, std::make_shared<const PigmentDesc>());
  end_block(r.parser, kPigmentWords);
}

void read_object(const Reader& r) {
  r.parser.expect(Punct::kLeftCurly);
  if (r.context.parse_object) r.pattern.own.edit().object = r.context.parse_object(r.parser);
  if (!r.pattern.own->object) r.parser.fail_expected("an object");
  r.parser.parse_comma();
  read_items(r);
  r.parser.expect(Punct::kRightCurly);
}

void read_uv_mapping(const Reader& r) { r.target.read_item(r.parser); }

void read_image_map(const Reader& r) {
  if (r.target.statement() != "pigment") r.parser.fail("image_map can only be used in a pigment");
  read_no_frequency(r);
  r.pattern.own.edit().image = parse_image_map(r.parser);
}

void read_image_pattern(const Reader& r) {
  read_no_frequency(r);
  r.parser.expect(Punct::kLeftCurly);
  auto image = parse_image_source(r.parser);
  while (accept_image_modifier(r.parser, *image)) {
  }
  end_block(r.parser,
            "one of interpolate, map_type, once, use_color, use_index, use_alpha, "
            "repeat, offset");
  r.pattern.own.edit().image = image;
}

void read_density_file(const Reader& r) {
  r.parser.expect(Keyword::kDf3);
  PatternParameters& own = r.pattern.own.edit();
  const Location where = r.parser.location();
  own.density_file = r.parser.parse_path();
  auto found = r.parser.find_to_open(own.density_file, where);
  if (!found && !std::filesystem::path(own.density_file).has_extension()) {
    found = r.parser.find_to_open(own.density_file + ".df3", where);
  }
  own.density_path = found.value_or(FoundFile{});
}

void read_range(Parser& parser, double& low, double& high) {
  parser.parse_comma();
  low = parse_optional_float(parser, 0.0);
  parser.parse_comma();
  high = parse_optional_float(parser, 0.0);
  if (high != 0.0 && high == low) {
    parser.warn("the range is empty; it is ignored");
    low = high = 0.0;
  }
}

void read_slope(const Reader& r) {
  PatternParameters& p = r.pattern.own.edit();
  p.slope_point_at = false;
  p.altitude = {};
  p.slope_low = p.slope_high = p.altitude_low = p.altitude_high = 0.0;
  if (!r.parser.accept(Punct::kLeftCurly)) {
    p.vector = r.parser.parse_vector();
  } else {
    p.slope_point_at = r.parser.accept(Keyword::kPointAt);
    p.vector = r.parser.parse_vector();
    read_range(r.parser, p.slope_low, p.slope_high);
    while (r.parser.at(Keyword::kAltitude)) {
      if (p.slope_point_at) r.parser.fail("altitude cannot be used with point_at");
      r.parser.next();
      p.altitude = r.parser.parse_vector();
      read_range(r.parser, p.altitude_low, p.altitude_high);
    }
    end_block(r.parser, "altitude");
  }
  if (!p.slope_point_at && core::length(p.vector) + core::length(p.altitude) == 0.0) {
    r.parser.fail("both vectors of the slope pattern are null");
  }
}

void read_pavement(const Reader& r) {
  PatternParameters& own = r.pattern.own.edit();
  own.pavement_sides = 3;
  own.pavement_tiles = own.pavement_pattern = 1;
  own.pavement_exterior = own.pavement_interior = own.pavement_form = 0;
}

void read_tiling(const Reader& r) {
  const int tiling = r.parser.parse_int();
  r.pattern.own.edit().tiling = tiling;
  if (tiling < 1 || tiling > 27) {
    r.parser.fail("the number of a tiling is between 1 and 27");
  }
}

constexpr std::array kRules{
    PatternRule{Keyword::kAgate, PatternKind::kAgate, read_agate},
    PatternRule{Keyword::kAoi, PatternKind::kAoi},
    PatternRule{Keyword::kAverage, PatternKind::kAverage},
    PatternRule{Keyword::kBoxed, PatternKind::kBoxed},
    PatternRule{Keyword::kBozo, PatternKind::kBozo},
    PatternRule{Keyword::kBrick, PatternKind::kBrick, read_items},
    PatternRule{Keyword::kBumps, PatternKind::kBumps},
    PatternRule{Keyword::kCells, PatternKind::kCells},
    PatternRule{Keyword::kChecker, PatternKind::kChecker, read_items},
    PatternRule{Keyword::kCrackle, PatternKind::kCrackle, read_crackle},
    PatternRule{Keyword::kCubic, PatternKind::kCubic, read_items},
    PatternRule{Keyword::kCylindrical, PatternKind::kCylindrical},
    PatternRule{Keyword::kDensityFile, PatternKind::kDensityFile, read_density_file},
    PatternRule{Keyword::kDents, PatternKind::kDents},
    PatternRule{Keyword::kFacets, PatternKind::kFacets, read_facets},
    PatternRule{Keyword::kFunction, PatternKind::kFunction, read_function},
    PatternRule{Keyword::kGradient, PatternKind::kGradient, read_gradient},
    PatternRule{Keyword::kGranite, PatternKind::kGranite},
    PatternRule{Keyword::kHexagon, PatternKind::kHexagon, read_items},
    PatternRule{Keyword::kImageMap, PatternKind::kImageMap, read_image_map},
    PatternRule{Keyword::kImagePattern, PatternKind::kImagePattern, read_image_pattern},
    PatternRule{Keyword::kJulia, PatternKind::kJulia, read_julia},
    PatternRule{Keyword::kLeopard, PatternKind::kLeopard},
    PatternRule{Keyword::kMagnet, PatternKind::kMagnetMandel, read_magnet},
    PatternRule{Keyword::kMandel, PatternKind::kMandel, read_mandel},
    PatternRule{Keyword::kMarble, PatternKind::kMarble, read_triangle_wave},
    PatternRule{Keyword::kObject, PatternKind::kObject, read_object},
    PatternRule{Keyword::kOnion, PatternKind::kOnion},
    PatternRule{Keyword::kPavement, PatternKind::kPavement, read_pavement},
    PatternRule{Keyword::kPigmentPattern, PatternKind::kPigmentPattern, read_pigment_pattern},
    PatternRule{Keyword::kPlanar, PatternKind::kPlanar},
    PatternRule{Keyword::kQuilted, PatternKind::kQuilted, read_quilted},
    PatternRule{Keyword::kRadial, PatternKind::kRadial},
    PatternRule{Keyword::kRipples, PatternKind::kRipples},
    PatternRule{Keyword::kSlope, PatternKind::kSlope, read_slope},
    PatternRule{Keyword::kSpherical, PatternKind::kSpherical},
    PatternRule{Keyword::kSpiral1, PatternKind::kSpiral1, read_spiral},
    PatternRule{Keyword::kSpiral2, PatternKind::kSpiral2, read_spiral},
    PatternRule{Keyword::kSpotted, PatternKind::kSpotted},
    PatternRule{Keyword::kSquare, PatternKind::kSquare, read_items},
    PatternRule{Keyword::kTiling, PatternKind::kTiling, read_tiling},
    PatternRule{Keyword::kTriangular, PatternKind::kTriangular, read_items},
    PatternRule{Keyword::kUvMapping, PatternKind::kUvMapping, read_uv_mapping},
    PatternRule{Keyword::kWaves, PatternKind::kWaves},
    PatternRule{Keyword::kWood, PatternKind::kWood, read_triangle_wave},
    PatternRule{Keyword::kWrinkles, PatternKind::kWrinkles},
};

void check_pavement(Parser& parser, const PatternParameters& p) {
  const int sides = p.pavement_sides;
  if (sides != 3 && sides != 4 && sides != 6) {
    parser.fail("number_of_sides of pavement is 3, 4 or 6");
  }
  int most = 1;
  while (core::pavement_patterns(sides, most + 1) > 0) ++most;
  if (p.pavement_tiles < 1 || p.pavement_tiles > most) {
    parser.fail("number_of_tiles of this pavement is between 1 and " + std::to_string(most));
  }
  const int patterns = core::pavement_patterns(sides, p.pavement_tiles);
  if (p.pavement_pattern < 1 || p.pavement_pattern > patterns) {
    parser.fail("pattern of this pavement is between 1 and " + std::to_string(patterns));
  }
}

}  // namespace

int items_of(PatternKind kind) {
  switch (kind) {
    case PatternKind::kBrick:
    case PatternKind::kChecker:
    case PatternKind::kObject: return 2;
    case PatternKind::kHexagon: return 3;
    case PatternKind::kSquare: return 4;
    case PatternKind::kCubic:
    case PatternKind::kTriangular: return 6;
    default: return 0;
  }
}

std::optional<PatternKind> accept_kind(Parser& parser, std::span<const PatternKind> kinds) {
  const PatternRule* rule = find_entry<kRules>(parser.peek());
  if (!rule || std::ranges::find(kinds, rule->kind) == kinds.end()) return std::nullopt;
  parser.next();
  return rule->kind;
}

bool is_unset(const PatternDesc& pattern) {
  return pattern.kind == PatternKind::kPlain && pattern.where.file == 0;
}

bool accept_map(Parser& parser, Keyword map, const PatternDesc& pattern, bool average_allowed) {
  if (!parser.at(map)) return false;
  const PatternKind kind = pattern.kind;
  if (items_of(kind) > 0 || kind == PatternKind::kPlain || kind == PatternKind::kImageMap ||
      kind == PatternKind::kBumpMap || (kind == PatternKind::kAverage && !average_allowed)) {
    const std::string what =
        kind == PatternKind::kPlain ? "no pattern" : std::string(pattern_name(kind));
    parser.fail("cannot use " + std::string(spelling(map)) + " with " + what);
  }
  return parser.accept(map);
}

bool accept_pattern(Parser& parser, MaterialContext& context, PatternTarget& target) {
  PatternDesc& pattern = target.pattern();
  const Location where = parser.location();
  if (target.accept_plain(parser)) {
    pattern.kind = PatternKind::kPlain;
    pattern.where = where;
    return true;
  }
  const PatternRule* rule = find_entry<kRules>(parser.peek());
  if (!rule) return false;
  parser.next();
  pattern.kind = rule->kind;
  pattern.where = where;
  if (rule->read) rule->read({parser, context, target, pattern});
  return true;
}

void parse_pattern_body(Parser& parser, MaterialContext& context, PatternTarget& target) {
  const Location where = parser.location();
  accept_pattern(parser, context, target);
  target.after_pattern(parser);
  while (!parser.at(Punct::kRightCurly) &&
         (target.accept_own_modifier(parser) || accept_pattern_modifier(parser, target))) {
  }
  PatternDesc& pattern = target.pattern();
  Nesting nesting = held_by(pattern);
  target.hold(nesting);
  keep_nesting(parser, pattern.nesting, nesting, where, std::string(target.statement()) + "s");
  if (pattern.kind == PatternKind::kAverage && !target.has_map()) {
    parser.fail("average needs a map of " + std::string(target.statement()) + "s");
  }
  if (pattern.kind == PatternKind::kPavement) check_pavement(parser, *pattern.own);
  if (!is_unset(pattern)) return;
  if (target.statement() == "pigment") {
    if (parser.language_version() >= 150)
      parser.warn("this pigment has neither colour nor pattern, or does not begin with it");
  } else if (target.statement() == "normal" && !context.in_default) {
    if (!parser.at(Punct::kRightCurly) && !parser.at(Punct::kRightSquare)) {
      parser.fail_expected("a pattern");
    }
    parser.fail("this normal has no pattern");
  }
}

core::Rgb parse_rgb(Parser& parser) { return to_colour(parser.parse_colour()).rgb; }

bool accept_rgb(Parser& parser, Keyword keyword, core::Rgb& colour) {
  const bool next = parser.accept(keyword);
  if (next) colour = parse_rgb(parser);
  return next;
}

double parse_optional_float(Parser& parser, double otherwise) {
  return parser.at_expression() ? parser.parse_float() : otherwise;
}

}  // namespace lentray::parser
