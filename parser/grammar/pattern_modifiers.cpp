#include <algorithm>
#include <array>
#include <string>
#include <variant>

#include "parser/grammar/helpers.h"
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

void only_in(Parser& parser, bool right, std::string_view word, std::string_view where) {
  if (!right) {
    parser.fail("'" + std::string(word) + "' can only be used with " + std::string(where));
  }
}

bool is_fractal(PatternKind kind) {
  return kind == PatternKind::kMandel || kind == PatternKind::kJulia ||
         kind == PatternKind::kMagnetMandel || kind == PatternKind::kMagnetJulia;
}

int parse_octaves(Parser& parser) { return std::clamp(parser.parse_int(), 1, 10); }

bool accept_wave(Parser& parser, PatternDesc& pattern) {
  static constexpr std::pair<Keyword, WaveForm> kWords[] = {
      {Keyword::kRampWave, WaveForm::kRamp},   {Keyword::kTriangleWave, WaveForm::kTriangle},
      {Keyword::kSineWave, WaveForm::kSine},   {Keyword::kScallopWave, WaveForm::kScallop},
      {Keyword::kCubicWave, WaveForm::kCubic}, {Keyword::kPolyWave, WaveForm::kPoly}};
  for (const auto& [word, form] : kWords) {
    if (!parser.accept(word)) continue;
    pattern.wave = form;
    if (form == WaveForm::kPoly) {
      pattern.wave_exponent = parse_optional_float(parser, pattern.wave_exponent);
    }
    return true;
  }
  return parser.accept(Keyword::kFrequency, pattern.frequency) ||
         parser.accept(Keyword::kPhase, pattern.phase);
}

bool accept_crackle_word(Parser& parser, PatternDesc& p) {
  const bool crackle = p.kind == PatternKind::kCrackle;
  const bool facets = p.kind == PatternKind::kFacets;
  if (parser.accept(Keyword::kSolid)) {
    only_in(parser, crackle, "solid", "crackle");
    p.own.edit().crackle_solid = true;
  } else if (parser.accept(Keyword::kForm)) {
    only_in(parser, crackle || p.kind == PatternKind::kPavement, "form", "crackle or pavement");
    if (crackle) {
      p.own.edit().crackle_form = parser.parse_vector();
    } else {
      p.own.edit().pavement_form = parser.parse_int();
    }
  } else if (parser.accept(Keyword::kMetric)) {
    only_in(parser, crackle || facets, "metric", "crackle or facets");
    (crackle ? p.own.edit().crackle_metric : p.own.edit().facets_metric) = parser.parse_vector().x;
  } else {
    return false;
  }
  return true;
}

bool accept_fractal_word(Parser& parser, PatternDesc& p) {
  const bool pavement = p.kind == PatternKind::kPavement;
  const auto read = [&](std::string_view word, int most, int& type, double& factor, int& paving) {
    only_in(parser, pavement || is_fractal(p.kind), word, "mandel, julia, magnet or pavement");
    const int number = parser.parse_int();
    if (pavement) {
      paving = number;
      return;
    }
    if (number < 0 || number > most) {
      parser.fail("the " + std::string(word) + " type of a fractal pattern is between 0 and " +
                  std::to_string(most));
    }
    type = number;
    parser.parse_comma();
    factor = parser.parse_float();
  };
  if (parser.accept(Keyword::kExterior)) {
    PatternParameters& own = p.own.edit();
    read("exterior", 8, own.exterior_type, own.exterior_factor, own.pavement_exterior);
  } else if (parser.accept(Keyword::kInterior)) {
    PatternParameters& own = p.own.edit();
    read("interior", 6, own.interior_type, own.interior_factor, own.pavement_interior);
  } else if (parser.accept(Keyword::kExponent)) {
    only_in(parser, p.kind == PatternKind::kMandel || p.kind == PatternKind::kJulia, "exponent",
            "mandel or julia");
    PatternParameters& own = p.own.edit();
    own.exponent = parser.parse_int();
    if (own.exponent < 2 || own.exponent > 33) {
      parser.warn("exponents of mandel and julia go from 2 to 33; 2 is taken");
      own.exponent = 2;
    }
  } else {
    return false;
  }
  return true;
}

/// A word that one pattern alone has, with a number or vector behind it.
struct OwnWord {
  Keyword keyword;
  PatternKind kind;
  std::variant<double PatternParameters::*, int PatternParameters::*,
               core::Vec3 PatternParameters::*>
      value;
};
constexpr std::array kOwnWords{
    OwnWord{Keyword::kOffset, PatternKind::kCrackle, &PatternParameters::crackle_offset},
    OwnWord{Keyword::kCoords, PatternKind::kFacets, &PatternParameters::facets_coords},
    OwnWord{Keyword::kSize, PatternKind::kFacets, &PatternParameters::facets_size},
    OwnWord{Keyword::kNumberOfSides, PatternKind::kPavement, &PatternParameters::pavement_sides},
    OwnWord{Keyword::kNumberOfTiles, PatternKind::kPavement, &PatternParameters::pavement_tiles},
    OwnWord{Keyword::kPattern, PatternKind::kPavement, &PatternParameters::pavement_pattern},
    OwnWord{Keyword::kControl0, PatternKind::kQuilted, &PatternParameters::quilt0},
    OwnWord{Keyword::kControl1, PatternKind::kQuilted, &PatternParameters::quilt1},
    OwnWord{Keyword::kAgateTurb, PatternKind::kAgate, &PatternParameters::agate_turbulence},
    OwnWord{Keyword::kBrickSize, PatternKind::kBrick, &PatternParameters::brick_size},
    OwnWord{Keyword::kMortar, PatternKind::kBrick, &PatternParameters::mortar},
    OwnWord{Keyword::kInterpolate, PatternKind::kDensityFile,
            &PatternParameters::density_interpolate},
};

bool accept_own_word(Parser& parser, PatternDesc& p) {
  const OwnWord* word = find_entry<kOwnWords>(parser.peek());
  if (!word) return false;
  parser.next();
  only_in(parser, p.kind == word->kind, spelling(word->keyword), pattern_name(word->kind));
  const auto read = [&]<typename T>(T PatternParameters::*value) {
    const T read_now = parser.parse<T>();
    p.own.edit().*value = read_now;
  };
  std::visit(read, word->value);
  return true;
}

bool accept_noise_word(Parser& parser, PatternDesc& p) {
  int generator = 0;
  if (!parser.accept(Keyword::kNoiseGenerator, generator)) return false;
  if (generator < 0 || generator > 3) parser.fail("noise_generator is 0, 1, 2 or 3");
  p.noise_generator |= generator;  // as in stock: 1 and then 2 give 3, in a copy too
  return true;
}

/// Words of another statement: a message that says where they belong.
void refuse_foreign_word(Parser& parser) {
  static constexpr std::pair<Keyword, const char*> kHomes[] = {
      {Keyword::kColorMap, "color_map can only be used in a pigment or density"},
      {Keyword::kPigmentMap, "pigment_map can only be used in a pigment"},
      {Keyword::kDensityMap, "density_map can only be used in a density"},
      {Keyword::kSlopeMap, "slope_map can only be used in a normal"},
      {Keyword::kNormalMap, "normal_map can only be used in a normal"},
      {Keyword::kTextureMap, "texture_map can only be used in a texture"},
      {Keyword::kQuickColor, "quick_color can only be used in a pigment"},
      {Keyword::kBumpSize, "bump_size can only be used in a normal"},
      {Keyword::kAccuracy, "accuracy can only be used in a normal"},
  };
  for (const auto& [word, message] : kHomes) {
    if (parser.at(word)) parser.fail(message);
  }
}

/// `orientation` and `dist_exp` of a mapping warp.
bool accept_mapping_word(Parser& parser, WarpDesc::Kind kind, WarpParameters& warp) {
  if (parser.accept(Keyword::kDistExp, warp.distance_exponent)) return true;
  if (parser.accept(Keyword::kOrientation)) {
    warp.orientation = core::normalized(parser.parse_vector());
  } else if (kind == WarpDesc::Kind::kToroidal && parser.accept(Keyword::kMajorRadius)) {
    warp.major_radius = parser.parse_float();
  } else {
    return false;
  }
  return true;
}

void parse_repeat(Parser& parser, WarpParameters& warp) {
  const core::Vec3 step = parser.parse_vector();
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (step[axis] == 0.0) continue;
    warp.axis = axis;
    ++axes;
  }
  if (axes == 0) parser.fail("repeat needs an axis");
  if (axes > 1) parser.fail("repeat goes along one axis only");
  warp.width = step[warp.axis];
  for (;;) {
    if (parser.accept(Keyword::kOffset, warp.offset)) continue;
    if (parser.accept(Keyword::kFlip)) {
      const core::Vec3 flip = parser.parse_vector();
      for (int axis = 0; axis < 3; ++axis) warp.flip[axis] = flip[axis] != 0.0 ? -1.0 : 1.0;
    } else {
      return;
    }
  }
}

/// Repeated holes must lie inside their blocks, wherever turbulence moves them: stock makes room.
void fit_black_hole(Parser& parser, core::BlackHole& hole) {
  if (!hole.repeats) return;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(hole.repeat[axis] > 0.0)) continue;
    hole.centre[axis] = std::max(hole.centre[axis], hole.radius);
    const double room = hole.centre[axis] + hole.radius + hole.uncertainty[axis];
    if (hole.repeat[axis] >= room) continue;
    hole.repeat[axis] = room;
    parser.warn("the repeat of this black_hole is too small; it is made larger");
  }
}

void parse_black_hole(Parser& parser, core::BlackHole& hole) {
  parse_values(parser, hole.centre, hole.radius);
  for (;;) {
    if (parser.accept(Keyword::kStrength, hole.strength) ||
        parser.accept(Keyword::kFalloff, hole.power))
      continue;
    if (parser.accept(Keyword::kInverse)) {
      hole.inverse = true;
    } else if (parser.accept(Keyword::kType)) {
      parser.parse_float();
    } else if (parser.accept(Keyword::kRepeat)) {
      hole.repeat = parser.parse_vector();
      hole.repeats = true;
      fit_black_hole(parser, hole);
    } else if (parser.accept(Keyword::kTurbulence)) {
      hole.uncertainty = parser.parse_vector();
      hole.uncertain = true;
      fit_black_hole(parser, hole);
    } else {
      return;
    }
  }
}

void parse_warp_turbulence(Parser& parser, WarpParameters& warp) {
  warp.turbulence.amount = parser.parse_vector();
  for (;;) {
    if (parser.accept(Keyword::kOmega, warp.turbulence.omega) ||
        parser.accept(Keyword::kLambda, warp.turbulence.lambda))
      continue;
    if (parser.accept(Keyword::kOctaves)) {
      warp.turbulence.octaves = parse_octaves(parser);
    } else {
      return;
    }
  }
}

}  // namespace

WarpDesc parse_warp(Parser& parser) {
  WarpDesc warp;
  WarpParameters& own = warp.own.edit();
  parser.expect(Punct::kLeftCurly);
  if (parser.accept(Keyword::kTurbulence)) {
    warp.kind = WarpDesc::Kind::kTurbulence;
    parse_warp_turbulence(parser, own);
  } else if (parser.accept(Keyword::kRepeat)) {
    warp.kind = WarpDesc::Kind::kRepeat;
    parse_repeat(parser, own);
  } else if (parser.accept(Keyword::kBlackHole)) {
    warp.kind = WarpDesc::Kind::kBlackHole;
    parse_black_hole(parser, own.hole);
  } else if (parser.accept(Keyword::kPlanar)) {
    warp.kind = WarpDesc::Kind::kPlanar;
    if (parser.at_expression()) {
      own.orientation = core::normalized(parser.parse_vector());
      parser.parse_comma();
      own.plane_offset = parser.parse_float();
    }
  } else if (parser.accept(Keyword::kCubic)) {
    warp.kind = WarpDesc::Kind::kCubic;
  } else {
    warp.kind = parser.accept(Keyword::kCylindrical) ? WarpDesc::Kind::kCylindrical
                : parser.accept(Keyword::kSpherical) ? WarpDesc::Kind::kSpherical
                                                     : WarpDesc::Kind::kToroidal;
    if (warp.kind == WarpDesc::Kind::kToroidal && !parser.accept(Keyword::kToroidal)) {
      parser.fail_expected("a kind of warp");
    }
    while (accept_mapping_word(parser, warp.kind, own)) {
    }
  }
  end_block(parser, "a word of this warp");
  return warp;
}

bool accept_turbulence_word(Parser& parser, PatternDesc& pattern) {
  if (parser.accept(Keyword::kTurbulence)) {
    const core::Vec3 amount = parser.parse_vector();
    pattern.classic_turbulence().amount = amount;
  } else if (parser.accept(Keyword::kOctaves)) {
    pattern.classic_turbulence().octaves = parse_octaves(parser);
  } else if (parser.accept(Keyword::kOmega)) {
    pattern.classic_turbulence().omega = parser.parse_float();
  } else if (parser.accept(Keyword::kLambda)) {
    pattern.classic_turbulence().lambda = parser.parse_float();
  } else {
    return false;
  }
  return true;
}

bool accept_pattern_modifier(Parser& parser, PatternTarget& target) {
  PatternDesc& pattern = target.pattern();
  if (accept_turbulence_word(parser, pattern) || accept_wave(parser, pattern) ||
      accept_crackle_word(parser, pattern) || accept_fractal_word(parser, pattern) ||
      accept_own_word(parser, pattern) || accept_noise_word(parser, pattern)) {
    return true;
  }
  if (parser.accept(Keyword::kWarp)) {
    pattern.placement.push_back(parse_warp(parser));
    return true;
  }
  if (const auto transform = parser.accept_transforms()) {
    pattern.transform(*transform);
    return true;
  }
  refuse_foreign_word(parser);
  return false;
}

}  // namespace lentray::parser
