#include "parser/shapes/shape_geometry.h"

#include <new>
#include <utility>

#include "core/object/leaf.h"
#include "core/shape/prism.h"
#include "parser/shapes/shapes.h"
#include "parser/source/build_error.h"

namespace lentray::parser {
namespace {

std::vector<const FunctionDesc*> functions_of(const ObjectDesc& object) {
  std::vector<const FunctionDesc*> all;
  if (const auto* field = std::get_if<Sparse<HeightFieldShape>>(&object.shape)) {
    if ((*field)->function) all.push_back((*field)->function.get());
  } else if (const auto* surface = std::get_if<Sparse<IsosurfaceShape>>(&object.shape)) {
    all.push_back((*surface)->function.get());
  } else if (const auto* patch = std::get_if<Sparse<ParametricShape>>(&object.shape)) {
    for (const Ref<FunctionDesc>& f : (*patch)->functions) all.push_back(f.get());
  }
  return all;
}

std::unique_ptr<core::Object> leaf_geometry(const ObjectDesc& object, bool& is_whole) {
  std::unique_ptr<core::Shape> shape;
  if (missing_function(object).empty()) {
    const bool is_mesh = object.is_any<std::shared_ptr<const MeshShape>>();
    shape = is_mesh ? build_mesh(object) : build_shape(object);
  }
  if (!shape) {
    is_whole = false;
    return nullptr;
  }
  return std::make_unique<core::Leaf>(std::move(shape), core::Transform());
}

}  // namespace

std::string missing_function(const ObjectDesc& object) {
  for (const FunctionDesc* function : functions_of(object)) {
    std::string missing = function->function->not_yet();
    if (!missing.empty()) return missing;
  }
  return {};
}

std::vector<std::unique_ptr<core::Object>> text_glyphs(TextLayout& fonts, const TextShape& text,
                                                       const core::Transform& to_world) {
  std::vector<std::unique_ptr<core::Object>> glyphs;
  for (const PlacedGlyph& glyph : fonts.place(text)) {
    if (!glyph.outline) continue;
    auto shape = std::make_unique<core::Prism>("text", glyph.outline, core::Prism::Sweep::kAlongZ,
                                               0.0, text.thickness, false);
    glyphs.push_back(std::make_unique<core::Leaf>(
        std::move(shape), core::Transform::translation(glyph.offset).then(to_world)));
  }
  return glyphs;
}

core::Bounds text_box(const TextShape& text, const Location& where) {
  try {
    TextLayout fonts;
    core::Bounds box;
    for (const PlacedGlyph& glyph : fonts.place(text)) {
      box.include(core::Vec3{glyph.lo.u, glyph.lo.v, 0.0});
      box.include(core::Vec3{glyph.hi.u, glyph.hi.v, text.thickness});
    }
    return box;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw BuildError(where, error.what());
  }
}

std::unique_ptr<core::Object> shape_geometry(const ObjectDesc& object, bool& is_whole) {
  if (object.is_light() || object.csg()) return nullptr;
  try {
    return leaf_geometry(object, is_whole);
  } catch (const BuildError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw BuildError(object.where, error.what());
  }
}

}  // namespace lentray::parser
