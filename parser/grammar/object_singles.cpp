// Shapes that share nothing with others.
// Source: reference manual 3.7, "Bicubic Patch", "Height Field", "Julia Fractal", "Ovus",
// "Superquadric Ellipsoid", "Text".
#include <algorithm>
#include <array>

#include "parser/base/shown.h"
#include "parser/grammar/helpers.h"
#include "parser/grammar/object.h"
#include "parser/grammar/object_shapes.h"

namespace lentray::parser {
namespace {

constexpr double kLeastExponent = 1e-10;

bool is_julia_function(Keyword k) {
  static constexpr std::array kFunctions{
      Keyword::kSqr,   Keyword::kCube,  Keyword::kExp,   Keyword::kReciprocal, Keyword::kSin,
      Keyword::kAsin,  Keyword::kSinh,  Keyword::kAsinh, Keyword::kCos,        Keyword::kAcos,
      Keyword::kCosh,  Keyword::kAcosh, Keyword::kTan,   Keyword::kAtan,       Keyword::kTanh,
      Keyword::kAtanh, Keyword::kLn,    Keyword::kPwr};
  return std::find(kFunctions.begin(), kFunctions.end(), k) != kFunctions.end();
}

}  // namespace

ShapeDesc parse_bicubic_patch(Parser& parser, Context&) {
  auto s = std::make_shared<BicubicPatchShape>();
  while (true) {
    if (parser.accept(Keyword::kFlatness, s->flatness) ||
        parser.accept(Keyword::kUSteps, s->u_steps) || parser.accept(Keyword::kVSteps, s->v_steps))
      continue;
    if (parser.accept(Keyword::kType)) {
      const Location where = parser.location();
      s->type = parser.parse_int();
      if (s->type == 2 || s->type == 3) {
        parser.warn_at(where, "types 2 and 3 of a bicubic_patch are gone: type 1 is used");
        s->type = 1;
      }
      if (s->type != 0 && s->type != 1) {
        parser.fail_at(where, "The type of a bicubic_patch must be 0 or 1.");
      }
    } else if (parser.accept(Keyword::kAccuracy)) {
      (void)parser.parse_float();
    } else if (parser.accept(Keyword::kUvVectors)) {
      s->uv.emplace();
      for (Vec2& uv : *s->uv) {
        uv = parse_uv(parser);
        parser.parse_comma();
      }
    } else {
      break;
    }
    parser.parse_comma();
  }
  if (at_float(parser)) {  // the bare numbers of old scenes: type, flatness, steps
    s->type = parser.parse_int();
    parser.parse_comma();
    if (at_float(parser)) s->flatness = parser.parse_float();
    parser.parse_comma();
    if (at_float(parser)) s->u_steps = parser.parse_int();
    parser.parse_comma();
    if (at_float(parser)) s->v_steps = parser.parse_int();
    parser.parse_comma();
  }
  for (Vec3& p : s->points) {
    parser.parse_comma();
    p = parser.parse_vector();
  }
  return std::shared_ptr<const BicubicPatchShape>(std::move(s));
}

ShapeDesc parse_height_field(Parser& parser, Context&) {
  HeightFieldShape s;
  if (parser.accept(Keyword::kFunction)) {
    const Location where = parser.location();
    parse_values(parser, s.width, s.height);
    check_points(parser, where, s.width, s.height);
    s.function = parser.parse_function_body();
  } else {
    static constexpr std::array kTypes{Keyword::kGif,  Keyword::kTga, Keyword::kPot, Keyword::kPng,
                                       Keyword::kPgm,  Keyword::kPpm, Keyword::kSys, Keyword::kJpeg,
                                       Keyword::kTiff, Keyword::kExr, Keyword::kHdr, Keyword::kBmp};
    for (const Keyword type : kTypes) {
      if (parser.accept(type)) {
        s.file_type = spelling(type);
        break;
      }
    }
    const Location where = parser.location();
    const std::string name = parser.parse_string();
    auto found = parser.find_to_open(name, where);
    if (!found && !s.file_type.empty())
      found = parser.find_to_open(name + "." + s.file_type, where);
    if (!found)
      parser.fail_at(where, "Cannot find the height_field's file \"" + shown_name(name) + "\".");
    s.file = std::move(*found);
  }
  while (true) {
    if (parser.accept(Keyword::kGamma)) {
      s.file_gamma = parser.accept(Keyword::kSrgb) ? -1.0 : parser.parse_float();
    } else if (parser.accept(Keyword::kPremultiplied)) {
      (void)optional_switch(parser);
    } else if (parser.accept(Keyword::kWaterLevel)) {
      s.water_level = parser.parse_float();
    } else if (parser.accept(Keyword::kSmooth)) {
      s.smooth = optional_switch(parser);
    } else {
      return s;
    }
  }
}

ShapeDesc parse_julia_fractal(Parser& parser, Context&) {
  JuliaFractalShape s;
  s.parameter = parse_vector4(parser);
  while (true) {
    const Token token = parser.peek();
    if (parser.accept(Keyword::kMaxIteration, s.max_iteration)) continue;
    if (parser.accept(Keyword::kQuaternion)) {
      s.hypercomplex = false;
    } else if (parser.accept(Keyword::kHypercomplex)) {
      s.hypercomplex = true;
    } else if (parser.accept(Keyword::kPrecision)) {
      s.precision = parser.parse_float();
      if (s.precision < 1.0) parser.fail("precision must be at least 1.");
    } else if (parser.accept(Keyword::kSlice)) {
      const Location where = parser.location();
      s.slice = parse_vector4(parser);
      if (s.slice[3] == 0.0)
        parser.fail_at(where, "The fourth component of a slice must not be 0.");
      parser.parse_comma();
      s.slice_distance = parser.parse_float();
    } else if (token.kind == TokenKind::kKeyword && is_julia_function(token.keyword)) {
      parser.next();
      s.function = spelling(token.keyword);
      if (token.keyword == Keyword::kPwr) {
        parser.accept(Punct::kLeftParen);
        const Number n = parser.parse_number(1, 2);
        parser.parse_comma();
        s.exponent = n.size == 1
                         ? Vec2{n.v[0], parser.at(Punct::kRightParen) ? 0.0 : parser.parse_float()}
                         : Vec2{n.v[0], n.v[1]};
        parser.accept(Punct::kRightParen);
      }
    } else {
      break;
    }
  }
  if (!s.hypercomplex && s.function != "sqr" && s.function != "cube") {
    parser.fail("quaternion fractals have the functions sqr and cube only");
  }
  return s;
}

ShapeDesc parse_ovus(Parser& parser, Context&) {
  OvusShape s;
  parse_values(parser, s.bottom, s.top);
  if (s.bottom < 0.0 || s.top < 0.0) parser.fail("The radii of an ovus must be positive.");
  if (s.top >= 2.0 * s.bottom) {
    parser.warn("the upper radius of this ovus is at least twice the lower one: it is a sphere");
  }
  return s;
}

ShapeDesc parse_superellipsoid(Parser& parser, Context&) {
  const Vec2 v = parse_uv(parser);
  // Stock takes the exponents as they are; the smallest that it distinguishes from 0.
  return SuperellipsoidShape{std::max(v.u, kLeastExponent), std::max(v.v, kLeastExponent)};
}

FoundFile find_font(Parser& parser, const std::string& name, const Location& where) {
  auto found = parser.find_to_open(name, where);
  if (!found) found = parser.find_to_open(name + ".ttf", where);
  if (!found) parser.fail_at(where, "Cannot find the font file \"" + shown_name(name) + "\".");
  return std::move(*found);
}

ShapeDesc parse_text(Parser& parser, Context& context) {
  TextShape s;
  const Location where = parser.location();
  std::string name;
  if (parser.accept(Keyword::kInternal)) {
    static constexpr std::array kFonts{"povlogo.ttf", "timrom.ttf", "cyrvetic.ttf", "crystal.ttf"};
    const int number = parser.parse_int();
    name = kFonts[number >= 0 && number < 4 ? static_cast<std::size_t>(number) : 0];
  } else {
    if (!parser.accept(Keyword::kTtf)) parser.fail_expected("ttf or internal");
    name = parser.parse_string();
  }
  const auto [font, is_new] = context.fonts.try_emplace(name);
  if (is_new) font->second = find_font(parser, name, where);
  s.font = font->second;
  parser.parse_comma();
  s.text = parser.parse_string();
  parser.parse_comma();
  parse_values(parser, s.thickness, s.offset);
  s.unicode = parser.utf8();
  return s;
}

}  // namespace lentray::parser
