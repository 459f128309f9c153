// cutaway_textures: which surfaces of a CSG are left without a texture of their own, and what they
// show instead (core/material/cutaway_texture.h). One object of the scene at a time, one thread.
// Source: reference manual 3.7, "Cutaway Textures"; what has no texture measured on stock
// (tests/image/cutaway_test.cpp).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "core/material/cutaway_texture.h"
#include "core/object/csg.h"
#include "core/object/object.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// The kind that a CSG is built as; what inverts it changes that.
core::CsgKind csg_kind(CsgOperation operation);

class Cutaways {
 public:
  using Compile = std::function<const core::Texture*(const Ref<TextureDesc>&)>;
  using Keep = std::function<void(std::shared_ptr<const core::Texture>)>;
  /// Whether the object, or one in it, has cutaway_textures.
  static bool occur_in(const ObjectDesc& object);

  /// Each object as it is built, with the texture that its statement gives it (null: none).
  void record(const core::Object& object, const ObjectDesc& desc, Ref<TextureDesc> own);
  /// When the whole is built: gives the surfaces without a texture what they show. `inherited`:
  /// null for none. `compile`: null stands for the default texture; `keep` takes the new textures;
  /// `least`: adc_bailout.
  void apply(core::Object& whole, Ref<TextureDesc> inherited, const Compile& compile,
             const Keep& keep, double least) const;

 private:
  struct Record {
    const ObjectDesc* desc = nullptr;
    Ref<TextureDesc> own;
  };
  struct Around;
  struct Pass;
  bool textured(const core::Object& object) const;
  core::CutawayTexture::Part walk(core::Object& object, const Around& around, Pass& pass) const;

  std::map<const core::Object*, Record> m_records;
};

}  // namespace lentray::parser
