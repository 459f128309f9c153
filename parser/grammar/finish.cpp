#include "parser/descriptions/finish.h"

#include <cmath>

#include "parser/grammar/helpers.h"
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

void parse_reflection_block(Parser& parser, FinishDesc& finish) {
  ReflectionDesc& reflection = finish.reflection;
  parser.expect(Punct::kLeftCurly);
  reflection.block = true;
  reflection.minimum = parse_rgb(parser);
  parser.parse_comma();
  const bool second = parser.at_colour() || parser.at_expression();
  reflection.maximum = second ? parse_rgb(parser) : reflection.minimum;
  for (;;) {
    if (parser.accept(Keyword::kFalloff, reflection.falloff) ||
        parser.accept(Keyword::kExponent, finish.reflection_exponent))
      continue;
    if (parser.accept(Keyword::kFresnel)) {
      const int fresnel = static_cast<int>(parse_optional_float(parser, 1.0));
      if (fresnel != 0 && fresnel != 1) parser.fail("fresnel is on or off");
      reflection.fresnel = fresnel == 1;
      // With one colour, fresnel goes from nothing to it: otherwise it would change nothing.
      if (reflection.fresnel && !second) reflection.minimum = {};
    } else if (parser.accept(Keyword::kMetallic)) {
      reflection.metallic = parse_optional_float(parser, 1.0);
    } else {
      break;
    }
  }
  end_block(parser, "one of fresnel, falloff, exponent, metallic");
}

void parse_reflection(Parser& parser, FinishDesc& finish) {
  if (parser.at(Punct::kLeftCurly)) {
    parse_reflection_block(parser, finish);
    return;
  }
  if (!parser.at_colour() && !parser.at_expression()) return;  // stock lets it be empty
  ReflectionDesc& reflection = finish.reflection;
  reflection.maximum = parse_rgb(parser);
  reflection.minimum = reflection.maximum;
  reflection.falloff = 1.0;
  reflection.fresnel = false;
  reflection.block = false;
}

void parse_irid(Parser& parser, FinishDesc& finish) {
  parser.expect(Punct::kLeftCurly);
  finish.irid = parser.parse_float();
  for (;;) {
    if (parser.accept(Keyword::kThickness, finish.irid_thickness)) continue;
    if (parser.accept(Keyword::kTurbulence)) {
      finish.irid_turbulence = parser.parse_vector().x;
    } else {
      break;
    }
  }
  end_block(parser, "one of thickness, turbulence");
}

void parse_subsurface(Parser& parser, FinishDesc& finish) {
  parser.expect(Punct::kLeftCurly);
  SubsurfaceDesc subsurface;
  while (accept_rgb(parser, Keyword::kTranslucency, subsurface.translucency) ||
         accept_rgb(parser, Keyword::kAnisotropy, subsurface.anisotropy)) {
  }
  finish.subsurface = subsurface;
  end_block(parser, "one of translucency, anisotropy");
}

bool accept_diffuse_word(Parser& parser, FinishDesc& finish) {
  if (parser.accept(Keyword::kBrilliance, finish.brilliance) ||
      parser.accept(Keyword::kCrand, finish.crand) ||
      accept_rgb(parser, Keyword::kAmbient, finish.ambient) ||
      accept_rgb(parser, Keyword::kEmission, finish.emission))
    return true;
  if (!parser.accept(Keyword::kDiffuse)) return false;
  finish.diffuse_albedo = parser.accept(Keyword::kAlbedo) || finish.diffuse_albedo;
  finish.diffuse = parser.parse_float();
  parser.parse_comma();
  finish.diffuse_back = parse_optional_float(parser, 0.0);
  return true;
}

bool accept_highlight_word(Parser& parser, FinishDesc& finish) {
  if (parser.accept(Keyword::kPhongSize, finish.phong_size)) return true;
  if (parser.accept(Keyword::kPhong)) {
    finish.phong_albedo = parser.accept(Keyword::kAlbedo) || finish.phong_albedo;
    finish.phong = parser.parse_float();
  } else if (parser.accept(Keyword::kSpecular)) {
    finish.specular_albedo = parser.accept(Keyword::kAlbedo) || finish.specular_albedo;
    finish.specular = parser.parse_float();
  } else if (parser.accept(Keyword::kRoughness)) {
    finish.roughness = parser.parse_float();
    if (finish.roughness == 0.0) parser.warn("roughness is 0");
  } else if (parser.accept(Keyword::kMetallic)) {
    finish.metallic = parse_optional_float(parser, 1.0);
  } else {
    return false;
  }
  return true;
}

/// Words that belong to the interior since POV-Ray 3.1.
bool accept_interior_word(Parser& parser, FinishDesc& finish) {
  const Location where = parser.location();
  const Keyword word = parser.peek().keyword;
  if (!parser.accept(Keyword::kIor, finish.ior) &&
      !parser.accept(Keyword::kCaustics, finish.caustics) &&
      !parser.accept(Keyword::kRefraction, finish.refraction))
    return false;
  parser.warn_at(where, std::string(spelling(word)) +
                            " belongs in the interior { } of an object, not in a finish");
  return true;
}

bool accept_other_word(Parser& parser, FinishDesc& finish) {
  if (parser.accept(Keyword::kReflectionExponent, finish.reflection_exponent)) return true;
  if (parser.accept(Keyword::kReflection)) {
    parse_reflection(parser, finish);
  } else if (parser.accept(Keyword::kConserveEnergy)) {
    finish.conserve_energy = true;
  } else if (parser.accept(Keyword::kIrid)) {
    parse_irid(parser, finish);
  } else if (parser.accept(Keyword::kSubsurface)) {
    parse_subsurface(parser, finish);
  } else {
    return false;
  }
  return true;
}

/// What `albedo` asked for holds for the numbers of this block only: an identifier with
/// modifications starts from the scaled numbers.
void apply_albedo(FinishDesc& finish) {
  finish.albedo_factor = finish.diffuse_albedo ? (finish.brilliance + 1.0) / 2.0 : 1.0;
  finish.diffuse *= finish.albedo_factor;
  finish.diffuse_back *= finish.albedo_factor;
  if (finish.phong_albedo) finish.phong *= (finish.phong_size + 1.0) / 2.0;
  if (finish.specular_albedo && finish.roughness != 0.0) {
    const double exponent = 1.0 / finish.roughness;
    finish.specular *= (exponent + 2.0) / (4.0 * (2.0 - std::pow(2.0, -exponent / 2.0)));
  }
  finish.diffuse_albedo = finish.phong_albedo = finish.specular_albedo = false;
}

}  // namespace

Ref<FinishDesc> parse_finish_block(Parser& parser, MaterialContext& context, Ref<FinishDesc> base) {
  const Location where = parser.location();
  parser.expect(Punct::kLeftCurly);
  auto finish = start_of(parser, base);
  finish->where = where;
  while (accept_diffuse_word(parser, *finish) || accept_highlight_word(parser, *finish) ||
         accept_interior_word(parser, *finish) || accept_other_word(parser, *finish)) {
  }
  apply_albedo(*finish);
  end_block(parser,
            "one of ambient, emission, diffuse, brilliance, crand, phong, phong_size, "
            "specular, roughness, metallic, reflection, reflection_exponent, conserve_energy, "
            "irid, subsurface");
  // A statement in a loop mostly says the same every time.
  if (!context.last_finish || *context.last_finish != *finish) context.last_finish = finish;
  return context.last_finish;
}

Ref<FinishDesc> parse_finish(Parser& parser, MaterialContext& context) {
  return parse_finish_block(parser, context, default_layer(context).finish);
}

}  // namespace lentray::parser
