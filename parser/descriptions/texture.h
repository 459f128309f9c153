// Textures as written: a list of layers, topmost last. Immutable; shared by Ref.
// Source: reference manual 3.7, "Texture".
#pragma once

#include <vector>

#include "parser/base/recycled.h"
#include "parser/descriptions/finish.h"
#include "parser/descriptions/normal.h"
#include "parser/descriptions/pigment.h"

namespace lentray::parser {

/// One layer: plain (pigment, normal, finish), or patterned (texture map, material_map, tiles).
struct TextureLayerDesc {
  Location where;
  Ref<PigmentDesc> pigment;  ///< never null in a plain layer
  Ref<NormalDesc> normal;    ///< null: the surface's own
  Ref<FinishDesc> finish;    ///< never null in a plain layer
  /// Patterned when `map` is set; the three above are unused then.
  Sparse<PatternDesc> pattern;
  Ref<TextureMapDesc> map;
  bool is_patterned() const { return map != nullptr; }
  /// One colour everywhere, and the surface's own normal.
  bool is_plain() const {
    return !is_patterned() && !normal && pigment->pattern.kind == PatternKind::kPlain;
  }
};

struct TextureDesc {
  Location where;
  std::vector<TextureLayerDesc, Recycled<TextureLayerDesc>> layers;
};

/// The texture after one more transform, pigments and normals included.
Ref<TextureDesc> transformed(Ref<TextureDesc> texture, const core::Transform& transform);
/// Whether it may be moved later, together with what moves it then: none of its patterns ends in a transform,
/// whose product with the next would be rounded otherwise.
bool can_wait(const TextureDesc& texture);
/// Whether it is the same wherever it is moved: colours and finishes alone.
bool is_placeless(const TextureDesc& texture);
/// The layers of `above` over those of `below`; either may be null.
Ref<TextureDesc> layered(Ref<TextureDesc> below, Ref<TextureDesc> above);
/// The default texture of a scene that has no #default: black pigment, default finish.
Ref<TextureDesc> standard_texture();

}  // namespace lentray::parser
