#include "parser/grammar/object_modifiers.h"

#include "parser/grammar/helpers.h"
#include "parser/grammar/object.h"
#include "parser/grammar/object_shapes.h"
#include "parser/grammar/transform.h"
#include "parser/stock/history.h"

namespace lentray::parser {
namespace {

using Modifier = void (*)(Parser&, Context&, ObjectDesc&);

void check_region(Parser& parser, const std::vector<Ref<ObjectDesc>>& regions) {
  for (const Ref<ObjectDesc>& region : regions) {
    if (is_patch(*region)) {
      parser.fail("What bounds or clips must have an inside: a triangle, patch or light has none.");
    }
  }
}

/// The objects of clipped_by or bounded_by, with transforms that hold for all of them.
std::vector<Ref<ObjectDesc>> parse_regions(Parser& parser, Context& context) {
  std::vector<Ref<ObjectDesc>> regions{expect_object(parser, context)};
  while (Ref<ObjectDesc> more = accept_object(parser, context)) regions.push_back(std::move(more));
  check_region(parser, regions);
  if (const auto transform = parser.accept_transforms()) {
    for (Ref<ObjectDesc>& region : regions) region = transformed(region, *transform);
  }
  return regions;
}

/// clipped_by or bounded_by: regions, or the other word for the same ones.
template <bool kClips>
void parse_limits(Parser& parser, Context& context, ObjectDesc& object) {
  constexpr auto kOwn = kClips ? &RareParts::clipped_by : &RareParts::bounded_by;
  constexpr auto kOther = kClips ? &RareParts::bounded_by : &RareParts::clipped_by;
  const std::string own = kClips ? "clips" : "bounds", other = kClips ? "bounds" : "clips";
  parser.expect(Punct::kLeftCurly);
  if (object.bounds_are_clips)
    parser.fail("Cannot add " + own + " after linking bounds and clips.");
  if (parser.accept(kClips ? Keyword::kBoundedBy : Keyword::kClippedBy)) {
    if (!((*object.rare).*kOwn).empty())
      parser.fail("Cannot link " + other + " with previous " + own + ".");
    if (object.rare.is_stored()) object.rare.edit().*kOwn = (*object.rare).*kOther;
    object.bounds_are_clips = true;
  } else {
    const auto added = parse_regions(parser, context);
    auto& regions = object.rare.edit().*kOwn;
    regions.insert(regions.end(), added.begin(), added.end());
    if (kClips) note_clips(object);
  }
  parser.expect(Punct::kRightCurly);
}

void parse_radiosity(Parser& parser, Context&, ObjectDesc& object) {
  parser.expect(Punct::kLeftCurly);
  while (parser.accept(Keyword::kImportance)) {
    object.rare.edit().radiosity_importance = parse_importance(parser);
  }
  parser.expect(Punct::kRightCurly);
}

void parse_split_union(Parser& parser, Context&, ObjectDesc& object) {
  auto* csg = std::get_if<CsgShape>(&object.shape);
  const bool is_union = csg && csg->operation == CsgOperation::kUnion;
  const bool is_merge = csg && csg->operation == CsgOperation::kMerge;  // where it means nothing
  if (!is_union && !is_merge) {
    parser.fail("split_union holds for a union only.");
  }
  const bool splits = parser.parse_bool();
  if (is_union) csg->split_union = splits;
}

bool has_cutaway(const ObjectDesc& object) {
  const CsgShape* csg = object.csg();
  return csg && (csg->operation == CsgOperation::kIntersection ||
                 csg->operation == CsgOperation::kDifference);
}

/// Solvers that sturm chooses.
bool has_sturm(const ObjectDesc& object) {
  return object.is_any<std::shared_ptr<const BlobShape>, LatheShape, OvusShape, PolyShape,
                       PrismShape, SorShape, TorusShape>();
}

bool has_hierarchy(const ObjectDesc& object) {
  return object.is_any<std::shared_ptr<const BlobShape>, std::shared_ptr<const MeshShape>,
                       Sparse<HeightFieldShape>>();
}

void parse_uv_mapping(Parser& parser, Context&, ObjectDesc& object) {
  if (object.texture) parser.fail("uv_mapping must be specified before texture.");
  object.uv_mapping = true;
}

struct ModifierEntry {
  Keyword keyword;
  Modifier read;
  bool (*allowed)(const ObjectDesc&) = nullptr;  ///< null: in all objects
  const char* objects = "";                      ///< that allow it, for the message
};

constexpr std::array kModifiers{
    ModifierEntry{Keyword::kBoundedBy, parse_limits<false>},
    ModifierEntry{Keyword::kClippedBy, parse_limits<true>},
    ModifierEntry{Keyword::kCutawayTextures,
                  [](Parser&, Context&, ObjectDesc& object) {
                    std::get<CsgShape>(object.shape).cutaway_textures = true;
                  },
                  has_cutaway, "intersection and difference"},
    ModifierEntry{Keyword::kDoubleIlluminate, read_switch<&ObjectDesc::double_illuminate>},
    ModifierEntry{Keyword::kHierarchy, read_switch<&ObjectDesc::hierarchy>, has_hierarchy,
                  "blob, mesh and height_field"},
    ModifierEntry{Keyword::kHollow, read_switch<&ObjectDesc::hollow>},
    ModifierEntry{Keyword::kInverse,
                  [](Parser&, Context&, ObjectDesc& object) { object.inverse = !object.inverse; }},
    ModifierEntry{Keyword::kNoImage, read_switch<&ObjectDesc::no_image>},
    ModifierEntry{Keyword::kNoRadiosity, read_switch<&ObjectDesc::no_radiosity>},
    ModifierEntry{Keyword::kNoReflection, read_switch<&ObjectDesc::no_reflection>},
    ModifierEntry{Keyword::kNoShadow, turn_on<&ObjectDesc::no_shadow>},
    ModifierEntry{Keyword::kPhotons,
                  [](Parser& parser, Context&, ObjectDesc& object) {
                    parse_photon_flags(parser, object.rare.edit().photons, false);
                  }},
    ModifierEntry{Keyword::kRadiosity, parse_radiosity},
    ModifierEntry{Keyword::kSplitUnion, parse_split_union},
    ModifierEntry{Keyword::kSturm, read_switch<&ObjectDesc::sturm>, has_sturm,
                  "blob, lathe, ovus, poly, prism, sor and torus"},
    ModifierEntry{Keyword::kUvMapping, parse_uv_mapping},
};

/// Looks, in the form in which their productions build them up.
bool accept_object_looks(Parser& parser, Context& context, ObjectDesc& object) {
  settle_texture(object);
  Looks looks{std::move(object.texture), object.rare->interior_texture, object.rare->interior};
  const bool accepted = accept_looks(parser, context.materials, looks);
  object.texture = std::move(looks.texture);
  if (looks.interior_texture != object.rare->interior_texture ||
      looks.interior != object.rare->interior) {
    RareParts& rare = object.rare.edit();
    rare.interior_texture = std::move(looks.interior_texture);
    rare.interior = std::move(looks.interior);
  }
  return accepted;
}

}  // namespace

double parse_importance(Parser& parser) {
  const double importance = parser.parse_float();
  if (importance <= 0.0 || importance > 1.0) {
    parser.fail("Radiosity importance must be greater than 0 and at most 1.");
  }
  return importance;
}

void parse_photon_flags(Parser& parser, PhotonFlags& photons, bool of_light) {
  photons.given = true;
  parser.expect(Punct::kLeftCurly);
  while (true) {
    if (!of_light && parser.accept(Keyword::kTarget)) {
      photons.density = optional_float(parser, 1.0);
      photons.target = photons.density > 0.0;
    } else if (parser.accept(Keyword::kRefraction)) {
      photons.refraction = parser.parse_float() != 0.0;
    } else if (parser.accept(Keyword::kReflection)) {
      photons.reflection = parser.parse_float() != 0.0;
    } else if (!of_light && parser.accept(Keyword::kPassThrough)) {
      photons.pass_through = optional_switch(parser);
    } else if (!of_light && parser.accept(Keyword::kCollect)) {
      photons.collect = optional_switch(parser);
    } else if (of_light && parser.accept(Keyword::kAreaLight)) {
      photons.area_light = true;
    } else if (parser.at(Punct::kRightCurly)) {
      break;
    } else {
      parser.fail_expected(of_light ? "one of refraction, reflection, area_light or }"
                                    : "one of target, refraction, reflection, pass_through, "
                                      "collect or }");
    }
  }
  if (photons.pass_through && photons.target && photons.refraction.value_or(false)) {
    parser.warn("what photons pass through cannot refract them as a target: refraction is off");
    photons.refraction = false;
  }
  parser.expect(Punct::kRightCurly);
}

bool accept_object_modifier(Parser& parser, Context& context, ObjectDesc& object) {
  if (accept_transforms(parser, object)) return true;
  if (const ModifierEntry* entry = find_entry<kModifiers>(parser.peek())) {
    if (entry->allowed && !entry->allowed(object)) {
      parser.fail(std::string(spelling(entry->keyword)) + " holds for " + entry->objects +
                  " only.");
    }
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
      parser.fail_expected(
          "one of translate, rotate, scale, matrix, transform, texture, pigment, "
          "normal, finish, interior, interior_texture, material, " +
          word_list(kModifiers) + " or }");
    }
  }
  if (!object.texture && object.rare->interior_texture) {
    parser.fail("interior_texture requires an exterior texture.");
  }
}

}  // namespace lentray::parser
