// Heights are worked out once for a height_field and its copies.
#include "parser/shapes/height_grid.h"

#include <gtest/gtest.h>

#include <memory>
#include <variant>

#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

const Sparse<HeightFieldShape>& field_of(const SceneDesc& scene, std::size_t i) {
  return std::get<Sparse<HeightFieldShape>>(scene.objects.at(i).object->shape);
}

TEST(UnitHeightGrid, CopiesShareIt) {
  SceneText s(
      "#declare H = height_field { function 8, 6 { x*y } }"
      "object { H } object { H translate 3*x } height_field { function 8, 6 { x*y } smooth }");
  const auto first = build_height_grid(field_of(s.scene, 0));
  EXPECT_EQ(build_height_grid(field_of(s.scene, 0)), first);
  EXPECT_EQ(build_height_grid(field_of(s.scene, 1)), first);
  EXPECT_NE(build_height_grid(field_of(s.scene, 2)), first);
}

TEST(UnitHeightGrid, IsGoneWithItsObjects) {
  SceneText s("height_field { function 8, 6 { x*y } }");
  const std::weak_ptr<const core::HeightGrid> grid = build_height_grid(field_of(s.scene, 0));
  EXPECT_TRUE(grid.expired());
  EXPECT_TRUE(build_height_grid(field_of(s.scene, 0)));
}

TEST(UnitHeightGrid, ChangedCopiesHaveTheirOwn) {
  SceneText s("height_field { function 8, 6 { x*y } }");
  const auto first = build_height_grid(field_of(s.scene, 0));
  Sparse<HeightFieldShape> other = field_of(s.scene, 0);
  other.edit().smooth = true;
  EXPECT_NE(build_height_grid(other), first);
}

}  // namespace
}  // namespace lentray::parser::test
