#include "parser/grammar/object_modifiers.h"

#include "parser/grammar/helpers.h"
#include "parser/grammar/object.h"
#include "parser/grammar/transform.h"

namespace lentray::parser {
namespace {

using Modifier = void (*)(Parser&, Context&, ObjectDesc&);

/// The objects of clipped_by or bounded_by, with transforms that hold for all of them.
std::vector<Ref<ObjectDesc>> parse_regions(Parser& parser, Context& context) {
  std::vector<Ref<ObjectDesc>> regions{expect_object(parser, context)};
  while (Ref<ObjectDesc> more = accept_object(parser, context)) regions.push_back(std::move(more));
  if (const auto transform = parser.accept_transforms()) {
    for (Ref<ObjectDesc>& region : regions) region = transformed(region, *transform);
  }
  return regions;
}

void append(std::vector<Ref<ObjectDesc>>& to, std::vector<Ref<ObjectDesc>> from) {
  to.insert(to.end(), from.begin(), from.end());
}

void parse_bounded_by(Parser& parser, Context& context, ObjectDesc& object) {
  parser.expect(Punct::kLeftCurly);
  if (object.bounds_are_clips) parser.fail("Cannot add bounds after linking bounds and clips.");
  if (parser.accept(Keyword::kClippedBy)) {
    if (!object.bounded_by.empty()) parser.fail("Cannot link clips with previous bounds.");
    object.bounded_by = object.clipped_by;
    object.bounds_are_clips = true;
  } else {
    append(object.bounded_by, parse_regions(parser, context));
  }
  parser.expect(Punct::kRightCurly);
}

void parse_clipped_by(Parser& parser, Context& context, ObjectDesc& object) {
  parser.expect(Punct::kLeftCurly);
  if (object.bounds_are_clips) parser.fail("Cannot add clips after linking bounds and clips.");
  if (parser.accept(Keyword::kBoundedBy)) {
    if (!object.clipped_by.empty()) parser.fail("Cannot link bounds with previous clips.");
    object.clipped_by = object.bounded_by;
    object.bounds_are_clips = true;
  } else {
    append(object.clipped_by, parse_regions(parser, context));
  }
  parser.expect(Punct::kRightCurly);
}

void parse_radiosity(Parser& parser, Context&, ObjectDesc& object) {
  parser.expect(Punct::kLeftCurly);
  while (parser.accept(Keyword::kImportance)) {
    object.radiosity_importance = parser.parse_float();
    if (*object.radiosity_importance <= 0.0 || *object.radiosity_importance > 1.0) {
      parser.fail("Radiosity importance must be greater than 0 and at most 1.");
    }
  }
  parser.expect(Punct::kRightCurly);
}

void parse_split_union(Parser& parser, Context&, ObjectDesc& object) {
  auto* csg = std::get_if<CsgShape>(&object.shape);
  if (!csg || csg->operation != CsgOperation::kUnion) {
    parser.fail("split_union holds for a union only.");
  }
  csg->split_union = parser.parse_bool();
}

void parse_cutaway(Parser& parser, Context&, ObjectDesc& object) {
  auto* csg = std::get_if<CsgShape>(&object.shape);
  if (!csg || (csg->operation != CsgOperation::kIntersection &&
               csg->operation != CsgOperation::kDifference)) {
    parser.fail("cutaway_textures holds for intersection and difference only.");
  }
  csg->cutaway_textures = true;
}

void parse_uv_mapping(Parser& parser, Context&, ObjectDesc& object) {
  if (object.texture) parser.fail("uv_mapping must be specified before texture.");
  object.uv_mapping = true;
}

template <bool ObjectDesc::*kFlag>
void parse_switch(Parser& parser, Context&, ObjectDesc& object) {
  object.*kFlag = optional_switch(parser);
}

template <std::optional<bool> ObjectDesc::*kFlag>
void parse_optional_switch(Parser& parser, Context&, ObjectDesc& object) {
  object.*kFlag = optional_switch(parser);
}

struct ModifierEntry {
  Keyword keyword;
  Modifier read;
};

const std::array kModifiers{
    ModifierEntry{Keyword::kBoundedBy, parse_bounded_by},
    ModifierEntry{Keyword::kClippedBy, parse_clipped_by},
    ModifierEntry{Keyword::kCutawayTextures, parse_cutaway},
    ModifierEntry{Keyword::kDoubleIlluminate, parse_optional_switch<&ObjectDesc::double_illuminate>},
    ModifierEntry{Keyword::kHierarchy, parse_switch<&ObjectDesc::hierarchy>},
    ModifierEntry{Keyword::kHollow, parse_optional_switch<&ObjectDesc::hollow>},
    ModifierEntry{Keyword::kInverse,
                  [](Parser&, Context&, ObjectDesc& object) { object.inverse = !object.inverse; }},
    ModifierEntry{Keyword::kNoImage, parse_switch<&ObjectDesc::no_image>},
    ModifierEntry{Keyword::kNoRadiosity, parse_switch<&ObjectDesc::no_radiosity>},
    ModifierEntry{Keyword::kNoReflection, parse_switch<&ObjectDesc::no_reflection>},
    ModifierEntry{Keyword::kNoShadow,
                  [](Parser&, Context&, ObjectDesc& object) { object.no_shadow = true; }},
    ModifierEntry{Keyword::kPhotons, [](Parser& parser, Context&,
                                        ObjectDesc& object) { parse_photon_flags(parser, object.photons); }},
    ModifierEntry{Keyword::kRadiosity, parse_radiosity},
    ModifierEntry{Keyword::kSplitUnion, parse_split_union},
    ModifierEntry{Keyword::kSturm, parse_switch<&ObjectDesc::sturm>},
    ModifierEntry{Keyword::kUvMapping, parse_uv_mapping},
};

/// Looks, in the form in which their productions build them up.
bool accept_object_looks(Parser& parser, Context& context, ObjectDesc& object) {
  Looks looks{object.texture, object.interior_texture, object.interior};
  if (!accept_looks(parser, context.materials, looks)) return false;
  object.texture = std::move(looks.texture);
  object.interior_texture = std::move(looks.interior_texture);
  object.interior = std::move(looks.interior);
  return true;
}

}  // namespace

void parse_photon_flags(Parser& parser, PhotonFlags& photons) {
  photons.given = true;
  parser.expect(Punct::kLeftCurly);
  while (true) {
    if (parser.accept(Keyword::kTarget)) {
      photons.density = optional_float(parser, 1.0);
      photons.target = photons.density > 0.0;
    } else if (parser.accept(Keyword::kRefraction)) {
      photons.refraction = parser.parse_bool();
    } else if (parser.accept(Keyword::kReflection)) {
      photons.reflection = parser.parse_bool();
    } else if (parser.accept(Keyword::kPassThrough)) {
      photons.pass_through = optional_switch(parser);
    } else if (parser.accept(Keyword::kCollect)) {
      photons.collect = optional_switch(parser);
    } else if (parser.accept(Keyword::kAreaLight)) {
      photons.area_light = true;
    } else if (parser.accept(Punct::kRightCurly)) {
      return;
    } else {
      parser.fail_expected(
          "one of target, refraction, reflection, pass_through, collect, area_light or }");
    }
  }
}

bool accept_object_modifier(Parser& parser, Context& context, ObjectDesc& object) {
  if (const auto transform = parser.accept_transforms()) {
    apply_transform(object, *transform);
    return true;
  }
  if (const ModifierEntry* entry = find_entry(kModifiers, parser.peek())) {
    parser.next();
    entry->read(parser, context, object);
    return true;
  }
  return accept_object_looks(parser, context, object);
}

void parse_object_modifiers(Parser& parser, Context& context, ObjectDesc& object) {
  while (!parser.accept(Punct::kRightCurly)) {
    if (parser.at(Keyword::kLightSource)) {
      parser.fail("A light source inside an object is written with looks_like now.");
    }
    if (!accept_object_modifier(parser, context, object)) {
      parser.fail_expected("one of translate, rotate, scale, matrix, transform, texture, pigment, "
                           "normal, finish, interior, interior_texture, material, " +
                           word_list(kModifiers) + " or }");
    }
  }
  if (!object.texture && object.interior_texture) {
    parser.fail("interior_texture requires an exterior texture.");
  }
}

}  // namespace lentray::parser
