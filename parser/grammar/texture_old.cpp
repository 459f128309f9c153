// Textures of scenes from before POV-Ray 3.0: words of pigment, normal and finish directly in the
// texture. Source: the old syntax as stock 3.7 reads it under `#version` below 3.0.
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

/// The parts of the texture being read, each copied once.
struct OldTexture {
  std::shared_ptr<TextureDesc> texture;
  std::shared_ptr<PigmentDesc> pigment;
  std::shared_ptr<NormalDesc> normal;
  std::shared_ptr<FinishDesc> finish;

  explicit OldTexture(const Ref<TextureDesc>& base) { load(base); }

  void load(const Ref<TextureDesc>& base) {
    texture = std::make_shared<TextureDesc>(*base);
    TextureLayerDesc& layer = texture->layers.back();
    pigment = std::make_shared<PigmentDesc>(*layer.pigment);
    normal = layer.normal ? std::make_shared<NormalDesc>(*layer.normal) : nullptr;
    finish = std::make_shared<FinishDesc>(*layer.finish);
    store();
  }
  void store() {
    TextureLayerDesc& layer = texture->layers.back();
    layer.pigment = pigment;
    layer.normal = normal;
    layer.finish = finish;
  }
  NormalDesc& own_normal() {
    if (!normal) normal = std::make_shared<NormalDesc>();
    return *normal;
  }
};

constexpr PatternKind kPigments[] = {
    PatternKind::kAgate,    PatternKind::kBozo,     PatternKind::kGranite,   PatternKind::kLeopard,
    PatternKind::kMarble,   PatternKind::kMandel,   PatternKind::kOnion,     PatternKind::kSpotted,
    PatternKind::kWood,     PatternKind::kGradient, PatternKind::kChecker,   PatternKind::kHexagon,
    PatternKind::kImageMap, PatternKind::kSquare,   PatternKind::kTriangular};
constexpr PatternKind kNormals[] = {PatternKind::kBumps, PatternKind::kDents, PatternKind::kRipples,
                                    PatternKind::kWaves, PatternKind::kWrinkles};

void read_pigment_arguments(Parser& parser, PigmentDesc& pigment) {
  PatternDesc& p = pigment.pattern;
  switch (p.kind) {
    case PatternKind::kAgate: p.classic_turbulence(); break;
    case PatternKind::kMandel: p.own.edit().iterations = parser.parse_int(); break;
    case PatternKind::kGradient:
      p.own.edit().vector = core::normalized(parser.parse_vector());
      break;
    case PatternKind::kImageMap:
      p.frequency = 0.0;
      p.own.edit().image = parse_image_map(parser);
      break;
    default:
      if (items_of(p.kind) == 0) break;
      p.frequency = 0.0;
      pigment.pigment_map = nullptr;
      pigment.colour_map = parse_colour_list(parser, p.kind);
  }
}

/// Words that have a block of their own. Stock says so to scenes of 1.0, not to those of 2.0.
void warn_of_word(Parser& parser, const Location& where, std::string_view word, const char* block) {
  if (parser.language_version() < 150)
    parser.warn_at(where, "'" + std::string(word) + "' belongs in a " + block);
}

bool accept_pigment_word(Parser& parser, MaterialContext& context, OldTexture& old) {
  PigmentDesc& pigment = *old.pigment;
  if (const auto kind = accept_kind(parser, kPigments)) {
    pigment.pattern.kind = *kind;  // as in stock marble and wood have no triangle wave here
    read_pigment_arguments(parser, pigment);
  } else if (parser.at_colour()) {
    pigment.pattern.kind = PatternKind::kPlain;
    pigment.pattern.where = parser.location();
    pigment.colour = to_colour(parser.parse_colour());
  } else if (parser.accept(Keyword::kColorMap)) {
    pigment.colour_map = parse_colour_map(parser, context);
    pigment.pigment_map = nullptr;
  } else if (parser.accept(Keyword::kQuickColor)) {
    pigment.quick_colour = to_colour(parser.parse_colour());
  } else {
    return accept_turbulence_word(parser, pigment.pattern);
  }
  return true;
}

bool accept_normal_word(Parser& parser, OldTexture& old) {
  if (const auto kind = accept_kind(parser, kNormals)) {
    NormalDesc& normal = old.own_normal();
    normal.pattern.kind = *kind;
    normal.amount = parser.parse_float();
  } else if (parser.accept(Keyword::kBumpMap)) {
    NormalDesc& normal = old.own_normal();
    normal.pattern.kind = PatternKind::kBumpMap;
    normal.pattern.frequency = 0.0;
    normal.pattern.own.edit().image = parse_bump_map(parser, normal.amount);
  } else if (parser.accept(Keyword::kFrequency)) {
    old.own_normal().pattern.frequency = parser.parse_float();
  } else if (parser.accept(Keyword::kPhase)) {
    old.own_normal().pattern.phase = parser.parse_float();
  } else {
    return false;
  }
  return true;
}

bool accept_finish_word(Parser& parser, FinishDesc& finish) {
  const auto grey = [&] { return core::Rgb(static_cast<float>(parser.parse_float())); };
  if (parser.accept(Keyword::kDiffuse, finish.diffuse) ||
      parser.accept(Keyword::kBrilliance, finish.brilliance) ||
      parser.accept(Keyword::kPhong, finish.phong) ||
      parser.accept(Keyword::kPhongSize, finish.phong_size) ||
      parser.accept(Keyword::kSpecular, finish.specular) ||
      parser.accept(Keyword::kRoughness, finish.roughness) ||
      parser.accept(Keyword::kCrand, finish.crand) || parser.accept(Keyword::kIor, finish.ior) ||
      parser.accept(Keyword::kRefraction, finish.refraction))
    return true;
  if (parser.accept(Keyword::kAmbient)) {
    finish.ambient = grey();
  } else if (parser.accept(Keyword::kReflection)) {
    finish.reflection = {};
    finish.reflection.minimum = finish.reflection.maximum = grey();
  } else if (parser.accept(Keyword::kMetallic)) {
    finish.metallic = 1.0;
  } else {
    return false;
  }
  return true;
}

bool accept_block(Parser& parser, MaterialContext& context, OldTexture& old) {
  if (parser.accept(Keyword::kPigment)) {
    parser.expect(Punct::kLeftCurly);
    old.pigment = std::make_shared<PigmentDesc>(*parse_pigment_body(parser, context, old.pigment));
    parser.expect(Punct::kRightCurly);
  } else if (parser.accept(Keyword::kNormal)) {
    parser.expect(Punct::kLeftCurly);
    old.normal = std::make_shared<NormalDesc>(*parse_normal_body(parser, context, old.normal));
    parser.expect(Punct::kRightCurly);
  } else if (parser.accept(Keyword::kFinish)) {
    old.finish = std::make_shared<FinishDesc>(*parse_finish_block(parser, context, old.finish));
  } else if (const auto pigment = parser.accept_value<Ref<PigmentDesc>>()) {
    old.pigment = std::make_shared<PigmentDesc>(**pigment);
  } else if (const auto normal = parser.accept_value<Ref<NormalDesc>>()) {
    old.normal = std::make_shared<NormalDesc>(**normal);
  } else if (const auto finish = parser.accept_value<Ref<FinishDesc>>()) {
    old.finish = std::make_shared<FinishDesc>(**finish);
  } else {
    return false;
  }
  return true;
}

/// Everything one may find in such a texture; false at its end.
bool accept_word(Parser& parser, MaterialContext& context, OldTexture& old) {
  if (accept_block(parser, context, old)) return true;
  const Location where = parser.location();
  const std::string word(parser.spelling(parser.peek()));
  const char* block = accept_pigment_word(parser, context, old) ? "pigment"
                      : accept_normal_word(parser, old)         ? "normal"
                      : accept_finish_word(parser, *old.finish) ? "finish"
                                                                : nullptr;
  if (block) {
    warn_of_word(parser, where, word, block);
    return true;
  }
  if (const auto transform = parser.accept_transforms()) {
    old.store();
    old.load(transformed(old.texture, *transform));
  } else if (const auto texture = parser.accept_value<Ref<TextureDesc>>()) {
    parser.warn("this texture replaces what was said before");
    old.load(*texture);
  } else if (parser.at_expression()) {
    if (parser.language_version() >= 150) parser.warn("a bare number in a texture is crand");
    old.finish->crand = parser.parse_float();  // POV-Ray 0.5: a bare number
  } else {
    return false;
  }
  return true;
}

}  // namespace

Ref<TextureDesc> parse_old_texture_body(Parser& parser, MaterialContext& context) {
  const Location where = parser.location();
  Ref<TextureDesc> base = context.default_texture;
  if (parser.at(Keyword::kTiles) || parser.at(Keyword::kMaterialMap)) {
    const bool tiles = parser.next().is(Keyword::kTiles);
    auto texture = std::make_shared<TextureDesc>();
    texture->where = where;
    texture->layers.push_back(tiles ? parse_tiles(parser, context)
                                    : parse_material_map(parser, context));
    base = texture;
  } else if (const auto known = parser.accept_value<Ref<TextureDesc>>()) {
    base = *known;
  }
  if (base->layers.back().is_patterned()) {
    while (const auto transform = parser.accept_transforms()) base = transformed(base, *transform);
    return base;
  }
  OldTexture old(base);
  while (accept_word(parser, context, old)) {
  }
  old.store();
  old.texture->where = where;
  return old.texture;
}

}  // namespace lentray::parser
