// Reads single looks in tests: the text after `#declare` would be a pigment, texture, finish ...
#pragma once

#include <string>

#include "parser/build/texture_compiler.h"
#include "parser/descriptions/object.h"
#include "tests/unit/scene_text.h"

namespace lentray::parser::test {

/// The looks of `sphere { 0, 1 <text> }`.
class LooksText {
 public:
  explicit LooksText(const std::string& looks, const std::string& before = "")
      : m_scene(before + " sphere { 0, 1 " + looks + " }") {}
  const ObjectDesc& object() const { return m_scene.object(m_scene.scene.objects.size() - 1); }
  const TextureDesc& texture() const { return *object().texture; }
  const TextureLayerDesc& layer() const { return texture().layers.back(); }
  const PigmentDesc& pigment() const { return *layer().pigment; }
  const FinishDesc& finish() const { return *layer().finish; }
  const NormalDesc& normal() const { return *layer().normal; }
  const PatternDesc& pattern() const { return pigment().pattern; }
  bool warned(const std::string& part) const { return m_scene.warned(part); }

 private:
  SceneText m_scene;
};

inline std::shared_ptr<const core::Pigment> compiled(const PigmentDesc& pigment, int quality = 9) {
  TextureSettings settings;
  settings.quality = quality;
  return TextureCompiler(settings).pigment(std::make_shared<PigmentDesc>(pigment));
}

/// The colour a pigment gives at a point.
inline core::Colour colour_at(const std::string& pigment, const core::Vec3& point) {
  const LooksText text("pigment { " + pigment + " }");
  return compiled(text.pigment())->colour(point);
}

inline void expect_rgb(const core::Rgb& colour, double r, double g, double b,
                       double tolerance = 1e-6) {
  EXPECT_NEAR(colour.r, r, tolerance);
  EXPECT_NEAR(colour.g, g, tolerance);
  EXPECT_NEAR(colour.b, b, tolerance);
}

}  // namespace lentray::parser::test
