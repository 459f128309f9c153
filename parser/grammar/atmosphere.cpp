#include "parser/grammar/atmosphere.h"

#include "core/base/tiny.h"
#include "parser/grammar/helpers.h"

namespace lentray::parser {
namespace {

using core::kTiny;

/// One item of a fog; false if none is next.
bool accept_fog_item(Parser& parser, FogDesc& fog) {
  if (parser.accept(Keyword::kFogType, fog.type) ||
      parser.accept(Keyword::kDistance, fog.distance) ||
      parser.accept(Keyword::kTurbulence, fog.turbulence) ||
      parser.accept(Keyword::kTurbDepth, fog.turb_depth) ||
      parser.accept(Keyword::kFogOffset, fog.fog_offset) ||
      parser.accept(Keyword::kFogAlt, fog.fog_alt))
    return true;
  if (const auto transform = parser.accept_transforms()) {
    fog.transform = fog.transform.then(*transform);
    fog.up = transform->vector(fog.up);
  } else if (parser.accept(Keyword::kOctaves, fog.octaves) ||
             parser.accept(Keyword::kLambda, fog.lambda) ||
             parser.accept(Keyword::kOmega, fog.omega)) {
    // Any word about turbulence sets it. Where it is 0, every place has the noise of the origin.
    if (!fog.turbulence) fog.turbulence.emplace();
  } else if (at_float(parser) && !parser.at_colour()) {  // POV-Ray 1
    fog.distance = parser.parse_float();
    if (parser.language_version() >= 150)
      parser.warn("the distance of a fog wants the word distance");
  } else if (parser.accept(Keyword::kUp)) {
    fog.up = normalized(parser.parse_vector());
  } else if (parser.at_colour()) {
    fog.colour = to_colour(parser.parse_colour());
  } else {
    return false;
  }
  return true;
}

bool accept_rainbow_item(Parser& parser, Context& context, RainbowDesc& rainbow) {
  if (parser.accept(Keyword::kDirection, rainbow.direction) ||
      parser.accept(Keyword::kUp, rainbow.up) || parser.accept(Keyword::kAngle, rainbow.angle) ||
      parser.accept(Keyword::kWidth, rainbow.width) ||
      parser.accept(Keyword::kDistance, rainbow.distance) ||
      parser.accept(Keyword::kJitter, rainbow.jitter) ||
      parser.accept(Keyword::kArcAngle, rainbow.arc_angle) ||
      parser.accept(Keyword::kFalloffAngle, rainbow.falloff_angle))
    return true;
  if (parser.accept(Keyword::kColorMap)) {
    rainbow.colour_map = parse_colour_map(parser, context.materials);
  } else if (parser.at_colour()) {
    (void)parser.parse_colour();
  } else {
    return false;
  }
  return true;
}

}  // namespace

FogDesc parse_fog(Parser& parser, Context&) {
  parser.expect(Punct::kLeftCurly);
  FogDesc fog;
  if (auto named = parser.accept_value<Ref<FogDesc>>()) fog = **named;
  fog.where = parser.location();
  parser.parse_comma();
  while (!parser.accept(Punct::kRightCurly)) {
    if (!accept_fog_item(parser, fog)) {
      parser.fail_expected(
          "one of fog_type, distance, color, turbulence, octaves, lambda, omega, "
          "turb_depth, fog_offset, fog_alt, up, a transform or }");
    }
    parser.parse_comma();
  }
  return fog;
}

RainbowDesc parse_rainbow(Parser& parser, Context& context) {
  parser.expect(Punct::kLeftCurly);
  RainbowDesc rainbow;
  if (auto named = parser.accept_value<Ref<RainbowDesc>>()) rainbow = **named;
  rainbow.where = parser.location();
  while (!parser.accept(Punct::kRightCurly)) {
    if (!accept_rainbow_item(parser, context, rainbow)) {
      parser.fail_expected(
          "one of direction, up, angle, width, distance, jitter, arc_angle, "
          "falloff_angle, color_map, color or }");
    }
    parser.parse_comma();
  }
  if (length(rainbow.direction) < kTiny) {
    parser.fail_at(rainbow.where, "a rainbow needs a direction");
  }
  return rainbow;
}

SkySphereDesc parse_sky_sphere(Parser& parser, Context& context) {
  parser.expect(Punct::kLeftCurly);
  SkySphereDesc sky;
  if (auto named = parser.accept_value<Ref<SkySphereDesc>>()) sky = **named;
  sky.where = parser.location();
  while (!parser.accept(Punct::kRightCurly)) {
    if (const auto transform = parser.accept_transforms()) {
      sky.transform = sky.transform.then(*transform);
    } else if (parser.accept(Keyword::kPigment)) {
      sky.pigments.push_back(parse_pigment(parser, context.materials));
    } else if (parser.accept(Keyword::kEmission)) {
      sky.emission = to_colour(parser.parse_colour()).rgb;
    } else {
      parser.fail_expected("pigment, emission, a transform or }");
    }
  }
  if (sky.pigments.empty()) parser.fail_at(sky.where, "a sky_sphere needs a pigment");
  return sky;
}

core::Colour parse_background(Parser& parser, Context&) {
  parser.expect(Punct::kLeftCurly);
  const core::Colour colour = to_colour(parser.parse_colour());
  parser.expect(Punct::kRightCurly);
  return colour;
}

}  // namespace lentray::parser
