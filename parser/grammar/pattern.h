// The part that pigment, normal, texture and density statements share: one pattern, then its
// modifiers. Internal to the grammar of materials.
// Source: reference manual 3.7, "Patterns"; which words go together: measured on stock.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "parser/base/recycled.h"
#include "parser/descriptions/pattern.h"
#include "parser/grammar/material.h"
#include "parser/grammar/nesting.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

/// What their blocks may hold, for messages.
inline constexpr const char* kPigmentWords =
    "one of a color, a pattern, its modifiers (turbulence, warp, scale ...), a map";
inline constexpr const char* kNormalWords =
    "one of a pattern, its modifiers (turbulence, warp, scale ...), bump_size, a map";

/// The statement around a pattern: where its description lies and what only it may hold.
class PatternTarget {
 public:
  virtual ~PatternTarget() = default;
  /// "pigment", "normal", "texture" or "density".
  std::string_view statement() const { return m_statement; }
  PatternDesc& pattern() const { return m_pattern; }
  /// A colour instead of a pattern; only where that has a meaning.
  virtual bool accept_plain(Parser&) { return false; }
  /// The items of checker, brick ...: as many as are there; the rest of `count` are defaults.
  virtual void read_list(Parser& parser, int count) = 0;
  /// The one item of uv_mapping.
  virtual void read_item(Parser& parser) = 0;
  /// What follows the pattern before its modifiers.
  virtual void after_pattern(Parser&) {}
  /// One modifier that only this statement has.
  virtual bool accept_own_modifier(Parser& parser) = 0;
  virtual bool has_map() const = 0;
  /// Counts what its map holds.
  virtual void hold(Nesting& nesting) const = 0;

 protected:
  PatternTarget(std::string_view statement, PatternDesc& pattern)
      : m_statement(statement), m_pattern(pattern) {}

 private:
  const std::string_view m_statement;
  PatternDesc& m_pattern;
};

/// The word of a map, if it is next; fails unless the map can go with the pattern.
bool accept_map(Parser& parser, Keyword map, const PatternDesc& pattern, bool average_allowed);

/// One whose description `desc` may have a map of its own kind.
template <typename Desc, typename Map>
class MapTarget : public PatternTarget {
 public:
  MapTarget(std::string_view statement, Desc& desc, PatternDesc& pattern, Ref<Map>& map,
            MaterialContext& context)
      : PatternTarget(statement, pattern), m_desc(desc), m_map(map), m_context(context) {}
  bool has_map() const final { return m_map != nullptr; }
  void hold(Nesting& nesting) const final { hold_map<>(nesting, m_map.get()); }

 protected:
  Desc& m_desc;
  Ref<Map>& m_map;
  MaterialContext& m_context;
};

/// The items of a list that begins here: each is `statement` and what `read` reads behind it; those that are
/// missing are what `standard` makes.
template <typename Map, typename Standard, typename Read>
std::shared_ptr<Map> parse_item_list(Parser& parser, int count, Keyword statement,
                                     Standard standard, Read read) {
  auto map = std::make_shared<Map>();
  map->where = parser.location();
  for (int i = 0; i < count; ++i) {
    const bool given = parser.accept(statement);
    map->entries.push_back({static_cast<double>(i), given ? read() : standard()});
    if (given) parser.parse_comma();
  }
  return map;
}
/// The map of one item that uv_mapping has.
template <typename Map, typename Item>
std::shared_ptr<Map> map_of(Item item) {
  auto map = std::make_shared<Map>();
  map->entries.push_back({0.0, std::move(item)});
  return map;
}

/// A statement of colours: a pigment or density. Items take the place of its colours, and the other way round.
template <typename Desc, typename Map>
class ColourTarget : public MapTarget<Desc, Map> {
 public:
  using MapTarget<Desc, Map>::MapTarget;
  bool accept_plain(Parser& parser) final {
    if (!parser.at_colour()) return false;
    m_desc.colour = to_colour(parser.parse_colour());
    return true;
  }

 protected:
  using MapTarget<Desc, Map>::m_desc, MapTarget<Desc, Map>::m_map, MapTarget<Desc, Map>::m_context;
  void set_colours(Ref<ColourMapDesc> colours) {
    m_desc.colour_map = std::move(colours);
    m_map = nullptr;
  }
  void set_map(Ref<Map> map) {
    m_map = std::move(map);
    m_desc.colour_map = nullptr;
  }
  /// color_map, or the map that `word` begins and `parse` reads.
  template <typename Parse>
  bool accept_either_map(Parser& parser, Keyword word, Parse parse) {
    if (accept_map(parser, Keyword::kColorMap, m_desc.pattern, false)) {
      set_colours(parse_colour_map(parser, m_context));
    } else if (accept_map(parser, word, m_desc.pattern, true)) {
      set_map(parse(parser, m_context, m_desc.pattern.kind == PatternKind::kAverage));
    } else {
      return false;
    }
    return true;
  }
};

/// A pattern (or none), then modifiers while they last.
void parse_pattern_body(Parser& parser, MaterialContext& context, PatternTarget& target);
/// What a statement changes: a copy of the description that is named here, else of `base`, else a new one.
template <typename Desc>
std::shared_ptr<Desc> start_of(Parser& parser, const Ref<Desc>& base) {
  const Location where = parser.location();
  const auto known = parser.accept_value<Ref<Desc>>();
  const Desc* from = known ? known->get() : base.get();
  auto desc = from ? make_recycled<Desc>(*from) : make_recycled<Desc>();
  desc->where = where;
  return desc;
}
/// The body of a statement with a pattern.
template <typename Target, typename Desc>
Ref<Desc> parse_body(Parser& parser, MaterialContext& context, const Ref<Desc>& base) {
  auto desc = start_of(parser, base);
  Target target(*desc, context);
  parse_pattern_body(parser, context, target);
  return desc;
}
/// A pattern keyword with its arguments, if one is next.
bool accept_pattern(Parser& parser, MaterialContext& context, PatternTarget& target);
/// One modifier of any pattern, if one is next.
bool accept_pattern_modifier(Parser& parser, PatternTarget& target);
/// `warp { ... }`, the keyword consumed.
WarpDesc parse_warp(Parser& parser);
/// turbulence, octaves, omega and lambda outside a warp.
bool accept_turbulence_word(Parser& parser, PatternDesc& pattern);

/// How many items a pattern has that stand in a list; 0: it has none, and takes a map.
int items_of(PatternKind kind);
/// The word of one of these patterns, if it is next.
std::optional<PatternKind> accept_kind(Parser& parser, std::span<const PatternKind> kinds);
/// Neither a colour nor a pattern has been said yet.
bool is_unset(const PatternDesc& pattern);

/// What stands between the braces of an image: file, gamma, and what all uses of images share.
std::shared_ptr<ImageDesc> parse_image_source(Parser& parser);
/// once, map_type, interpolate, use_color ..., repeat, offset.
bool accept_image_modifier(Parser& parser, ImageDesc& image);
/// image_map { ... } of a pigment, keyword consumed.
std::shared_ptr<const ImageDesc> parse_image_map(Parser& parser);
/// bump_map { ... }; bump_size goes to `amount`.
std::shared_ptr<const ImageDesc> parse_bump_map(Parser& parser, double& amount);

// Bodies: what stands between braces, or in an entry of a map.
Ref<PigmentDesc> parse_pigment_body(Parser& parser, MaterialContext& context,
                                    Ref<PigmentDesc> base);
Ref<NormalDesc> parse_normal_body(Parser& parser, MaterialContext& context, Ref<NormalDesc> base);
Ref<TextureDesc> parse_texture_body(Parser& parser, MaterialContext& context);
/// The language before 3.0: words of pigment, normal and finish directly in the texture.
Ref<TextureDesc> parse_old_texture_body(Parser& parser, MaterialContext& context);
/// The patterned kinds of texture.
TextureLayerDesc parse_tiles(Parser& parser, MaterialContext& context);
TextureLayerDesc parse_material_map(Parser& parser, MaterialContext& context);
Ref<FinishDesc> parse_finish_block(Parser& parser, MaterialContext& context, Ref<FinishDesc> base);
Ref<DensityDesc> parse_density_body(Parser& parser, MaterialContext& context);
/// The same between braces.
Ref<PigmentDesc> parse_pigment_block(Parser& parser, MaterialContext& context,
                                     Ref<PigmentDesc> base);
Ref<NormalDesc> parse_normal_block(Parser& parser, MaterialContext& context, Ref<NormalDesc> base);
/// A pigment, normal or finish of the layer that `layer` finds, if one is next. `default_normal`: where the layer has
/// no normal, one starts from the default's.
bool accept_part(Parser& parser, MaterialContext& context,
                 const std::function<TextureLayerDesc&()>& layer, bool default_normal);
/// The default of pigment, normal and finish in force.
const TextureLayerDesc& default_layer(const MaterialContext& context);

/// A list of colours for the pattern: what is missing is filled with the pattern's defaults.
Ref<ColourMapDesc> parse_colour_list(Parser& parser, PatternKind kind);

core::Rgb parse_rgb(Parser& parser);
/// The word and the colour behind it.
bool accept_rgb(Parser& parser, Keyword keyword, core::Rgb& colour);
/// A float if one is next, else `otherwise`.
double parse_optional_float(Parser& parser, double otherwise);

}  // namespace lentray::parser
