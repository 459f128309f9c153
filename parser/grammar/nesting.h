// What descriptions hold, counted, and where that ends: textures and objects that are named and used
// again nest without a brace in the text that would show it.
#pragma once

#include "parser/descriptions/interior.h"
#include "parser/descriptions/object.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

/// Of a pigment, normal or density.
template <typename Desc>
const Nesting& nesting_of(const Desc& desc) {
  return desc.pattern.nesting;
}
Nesting nesting_of(const TextureDesc& texture);
Nesting nesting_of(const InteriorDesc& interior);

/// What a pattern itself holds: a pigment, object, function or picture. Maps are added by their
/// statement.
Nesting held_by(const PatternDesc& pattern);
/// What a map holds; null holds nothing.
template <typename Item>
void hold_map(Nesting& nesting, const BlendMapDesc<Ref<Item>>* map) {
  if (!map) return;
  for (const auto& entry : map->entries) {
    if (entry.item) nesting.hold(nesting_of(*entry.item));
  }
}

/// Keeps what was counted; fails at `where` beyond the limits. `what` is for the message: "pigments".
void keep_nesting(Parser& parser, Nesting& place, const Nesting& counted, const Location& where,
                  std::string_view what);
/// Counts what is nested in an object that has been read; fails beyond the limits.
void measure(Parser& parser, ObjectDesc& object);
/// Fails beyond the most layers a texture can have.
void check_layers(Parser& parser, const TextureDesc& texture);

}  // namespace lentray::parser
