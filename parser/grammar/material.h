// Productions of everything that gives an object its material. Each parse_* is called with its keyword
// consumed and reads the whole block, braces included; all throw ParseError through Parser::fail.
// Source: reference manual 3.7, "Texture" and below.
#pragma once

#include <functional>
#include <optional>

#include "parser/descriptions/interior.h"
#include "parser/descriptions/media.h"
#include "parser/descriptions/texture.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

/// What the productions of materials need to know of the scene. One a parse; owned by the productions.
struct MaterialContext {
  MaterialContext() : default_texture(standard_texture()) {}
  Ref<TextureDesc> default_texture;  ///< changed by #default
  Ref<FinishDesc> last_finish;       ///< the last that was read; null: none
  /// One object or object identifier, for the patterns `object` and `potential`.
  std::function<Ref<ObjectDesc>(Parser&)> parse_object;
  bool in_default = false;  ///< inside #default: a normal need not have a pattern
};

Ref<PigmentDesc> parse_pigment(Parser& parser, MaterialContext& context);
Ref<NormalDesc> parse_normal(Parser& parser, MaterialContext& context);
Ref<FinishDesc> parse_finish(Parser& parser, MaterialContext& context);
/// One `texture {}` (its identifier may bring several layers).
Ref<TextureDesc> parse_texture(Parser& parser, MaterialContext& context);
/// `below`: the interior that is there already, which it changes (null: none).
Ref<InteriorDesc> parse_interior(Parser& parser, MaterialContext& context,
                                 const Ref<InteriorDesc>& below = nullptr);
Ref<MaterialDesc> parse_material(Parser& parser, MaterialContext& context);
Ref<MediaDesc> parse_media(Parser& parser, MaterialContext& context);
Ref<DensityDesc> parse_density(Parser& parser, MaterialContext& context);

Ref<ColourMapDesc> parse_colour_map(Parser& parser, MaterialContext& context);
Ref<PigmentMapDesc> parse_pigment_map(Parser& parser, MaterialContext& context,
                                      bool average = false);
Ref<NormalMapDesc> parse_normal_map(Parser& parser, MaterialContext& context, bool average = false);
Ref<SlopeMapDesc> parse_slope_map(Parser& parser, MaterialContext& context);
Ref<TextureMapDesc> parse_texture_map(Parser& parser, MaterialContext& context,
                                      bool average = false);
Ref<DensityMapDesc> parse_density_map(Parser& parser, MaterialContext& context,
                                      bool average = false);

/// `function { pigment { ... } }` and `function { pattern { ... } }`: the parser stands at the inner
/// keyword, the function's own braces are not read. Gives a function of x, y, z with 5 results (a
/// colour with filter and transmit) or 1.
Ref<FunctionDesc> parse_pattern_function(Parser& parser, MaterialContext& context);

/// The material of an object as its modifiers build them up.
struct Looks {
  Ref<TextureDesc> texture, interior_texture;
  Ref<InteriorDesc> interior;
};
/// One of texture, pigment, normal, finish, interior_texture, interior, material, media and the old
/// colour words (`color rgb ..` in an object), if it is next: consumes and applies it. False if the
/// next token is none of these.
bool accept_looks(Parser& parser, MaterialContext& context, Looks& looks);
/// A transform of the object reaches what it has been given so far.
void transform_looks(Looks& looks, const core::Transform& transform);

/// For #declare: a value that starts with one of the keywords of this header (pigment, texture ...,
/// color_map, ...), or nullopt with nothing consumed. `texture {} texture {}` gives the layers.
std::optional<Value> accept_material_value(Parser& parser, MaterialContext& context);
/// One texture, pigment, normal or finish inside #default { }; false if none is next.
bool accept_material_default(Parser& parser, MaterialContext& context);

}  // namespace lentray::parser
