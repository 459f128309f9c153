#include "parser/grammar/light.h"

#include <cmath>

#include "parser/grammar/helpers.h"
#include "parser/grammar/nesting.h"
#include "parser/grammar/object.h"
#include "parser/grammar/object_modifiers.h"
#include "parser/grammar/object_shapes.h"
#include "parser/grammar/transform.h"

namespace lentray::parser {
namespace {

using LightWord = void (*)(Parser&, Context&, LightDesc&);

bool is_beam(const LightDesc& light) {
  return light.kind == LightKind::kSpot || light.kind == LightKind::kCylinder;
}

void parse_looks_like(Parser& parser, Context& context, LightDesc& light) {
  if (light.looks_like) parser.fail("Only one looks_like allowed per light_source.");
  parser.expect(Punct::kLeftCurly);
  auto object = std::make_shared<ObjectDesc>(*expect_object(parser, context));
  apply_transform(*object, core::Transform::translation(light.position));
  parse_object_modifiers(parser, context, *object);
  object->no_shadow = true;
  measure(parser, *object);
  light.looks_like = std::move(object);
}

void parse_projected_through(Parser& parser, Context& context, LightDesc& light) {
  if (light.projected_through) parser.fail("Only one projected_through allowed per light_source.");
  parser.expect(Punct::kLeftCurly);
  auto object = std::make_shared<ObjectDesc>(*expect_object(parser, context));
  parse_object_modifiers(parser, context, *object);
  measure(parser, *object);
  light.projected_through = std::move(object);
}

void parse_spotlight(Parser&, Context&, LightDesc& light) {
  light.kind = LightKind::kSpot;
  light.radius = 30.0;
  light.falloff = 45.0;
  light.tightness = 0.0;
}

void parse_cylinder_light(Parser&, Context&, LightDesc& light) {
  light.kind = LightKind::kCylinder;
  light.radius = 0.75;
  light.falloff = 1.0;
  light.tightness = 0.0;
  light.parallel = true;
}

void parse_point_at(Parser& parser, Context&, LightDesc& light) {
  if (!is_beam(light) && !light.parallel) {
    parser.fail("point_at needs spotlight, cylinder or parallel before it in a light_source.");
  }
  light.point_at = parser.parse_vector();
}

void parse_area_light(Parser& parser, Context&, LightDesc& light) {
  light.has_area = true;
  parse_values(parser, light.axis1, light.axis2, light.size1, light.size2);
  if (light.size1 <= 0 || light.size2 <= 0) {
    parser.fail("The numbers of lights of an area_light must be greater than zero.");
  }
  constexpr double kMostLights = 1e8;  // stock fails somewhere beyond
  if (static_cast<double>(light.size1) * light.size2 > kMostLights) {
    parser.fail("An area_light has at most 100,000,000 lights.");
  }
}

bool needs_area(Keyword word) {
  return word == Keyword::kAreaIllumination || word == Keyword::kCircular ||
         word == Keyword::kOrient;
}

bool needs_beam(Keyword word) {
  return word == Keyword::kRadius || word == Keyword::kFalloff || word == Keyword::kTightness;
}

struct LightEntry {
  Keyword keyword;
  LightWord read;
};

constexpr std::array kLightWords{
    LightEntry{Keyword::kAdaptive,
               [](Parser& p, Context&, LightDesc& l) {
                 l.adaptive = p.parse_int();
                 l.has_adaptive = true;
               }},
    LightEntry{Keyword::kAreaIllumination, read_switch<&LightDesc::area_illumination>},
    LightEntry{Keyword::kAreaLight, parse_area_light},
    LightEntry{Keyword::kCircular, turn_on<&LightDesc::circular>},
    LightEntry{Keyword::kCylinder, parse_cylinder_light},
    LightEntry{Keyword::kFadeDistance, read_value<&LightDesc::fade_distance>},
    LightEntry{Keyword::kFadePower, read_value<&LightDesc::fade_power>},
    LightEntry{Keyword::kFalloff, read_value<&LightDesc::falloff>},
    LightEntry{Keyword::kJitter, turn_on<&LightDesc::jitter>},
    LightEntry{Keyword::kLooksLike, parse_looks_like},
    LightEntry{Keyword::kMediaAttenuation, read_switch<&LightDesc::media_attenuation>},
    LightEntry{Keyword::kMediaInteraction, read_switch<&LightDesc::media_interaction>},
    LightEntry{Keyword::kOrient, turn_on<&LightDesc::orient>},
    LightEntry{Keyword::kParallel, turn_on<&LightDesc::parallel>},
    LightEntry{Keyword::kPhotons,
               [](Parser& p, Context&, LightDesc& l) { parse_photon_flags(p, l.photons, true); }},
    LightEntry{Keyword::kPointAt, parse_point_at},
    LightEntry{Keyword::kProjectedThrough, parse_projected_through},
    LightEntry{Keyword::kRadius, read_value<&LightDesc::radius>},
    LightEntry{Keyword::kShadowless,
               [](Parser&, Context&, LightDesc& l) { l.kind = LightKind::kShadowless; }},
    LightEntry{Keyword::kSpotlight, parse_spotlight},
    LightEntry{Keyword::kTightness, read_value<&LightDesc::tightness>},
};

/// Up to the closing brace.
void parse_light_words(Parser& parser, Context& context, LightDesc& light) {
  while (!parser.at(Punct::kRightCurly)) {
    const Location where = parser.location();
    if (const auto transform = parser.accept_transforms()) {
      light.apply(*transform);
    } else if (const LightEntry* entry = find_entry<kLightWords>(parser.peek())) {
      parser.next();
      if (needs_beam(entry->keyword) && !is_beam(light)) {
        parser.fail(std::string(spelling(entry->keyword)) +
                    " needs spotlight or cylinder before it in a light_source.");
      }
      entry->read(parser, context, light);
      if (needs_area(entry->keyword) && !light.has_area) {
        const bool has_value = entry->keyword == Keyword::kAreaIllumination;
        parser.warn_at(has_value ? parser.location() : where,
                       std::string(spelling(entry->keyword)) + " only affects an area_light.");
      }
    } else if (parser.accept(Keyword::kColorMap)) {
      (void)parse_colour_map(parser, context.materials);  // undocumented; stock ignores it too
    } else {
      parser.fail_expected("one of translate, rotate, scale, matrix, transform, " +
                           word_list(kLightWords) + " or }");
    }
  }
}

/// What stock checks when the block is read.
void check_light(Parser& parser, LightDesc& light) {
  if (light.fade_power != 0.0 && std::abs(light.fade_distance) < 1e-10) {
    light.fade_power = 0.0;
    light.fade_distance = 0.0;
  }
  const bool implied = light.orient && !light.circular;
  if (implied) {
    light.circular = true;
    parser.warn("orient needs a circular area_light: this one is circular now.");
  }
  if (!light.circular || (light.size1 > 1 && light.size2 > 1)) return;
  const char* rule = "A circular area_light must have more than one light along each axis.";
  if (!implied) parser.fail(rule);
  parser.warn(rule);
}

}  // namespace

Ref<ObjectDesc> parse_light_source(Parser& parser, Context& context, const Location& where) {
  parser.expect(Punct::kLeftCurly);
  if (auto named = parser.accept_value<Ref<ObjectDesc>>()) {
    auto object = std::make_shared<ObjectDesc>(**named);
    object->where = where;
    parse_object_modifiers(parser, context, *object);
    measure(parser, *object);
    return object;
  }
  auto light = std::make_shared<LightDesc>();
  light->where = where;
  light->position = parser.parse_vector();
  parser.parse_comma();
  // Without a colour stock has a black light.
  if (parser.at_colour() || parser.at_expression())
    light->colour = to_colour(parser.parse_colour());
  parse_light_words(parser, context, *light);
  check_light(parser, *light);
  parser.expect(Punct::kRightCurly);
  auto object = std::make_shared<ObjectDesc>();
  object->where = where;
  object->keyword = "light_source";
  object->shape = LightShape{std::move(light)};
  measure(parser, *object);
  return object;
}

Ref<ObjectDesc> parse_light_group(Parser& parser, Context& context, const Location& where) {
  parser.expect(Punct::kLeftCurly);
  auto object = std::make_shared<ObjectDesc>();
  object->where = where;
  object->keyword = "light_group";
  object->shape = parse_csg(parser, context, CsgOperation::kLightGroup);
  while (!parser.accept(Punct::kRightCurly)) {
    if (const auto transform = parser.accept_transforms()) {
      apply_transform(*object, *transform);
    } else if (parser.accept(Keyword::kGlobalLights)) {
      std::get<CsgShape>(object->shape).global_lights = optional_float(parser, 1.0) > 0.5;
    } else if (parser.accept(Keyword::kPhotons)) {
      parse_photon_flags(parser, object->rare.edit().photons, false);
    } else {
      parser.fail_expected("an object, a transform, global_lights, photons or }");
    }
  }
  measure(parser, *object);
  return object;
}

}  // namespace lentray::parser
