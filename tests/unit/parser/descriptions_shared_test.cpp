// What descriptions share, and that they go as they are compiled.
#include <gtest/gtest.h>

#include <memory>

#include "core/material/blend_map.h"
#include "parser/base/edit.h"
#include "parser/descriptions/texture.h"
#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

const FinishDesc* finish_of(const ObjectDesc& object) {
  return object.texture->layers.back().finish.get();
}

TEST(UnitDescriptionsShared, WhatNobodyElseRefersToIsChangedInPlace) {
  Ref<PigmentDesc> alone = std::make_shared<PigmentDesc>();
  const PigmentDesc* const before = alone.get();
  edit(alone).colour.filter = 0.5f;
  EXPECT_EQ(alone.get(), before);

  const Ref<PigmentDesc> other = alone;
  edit(alone).colour.filter = 1.0f;
  EXPECT_EQ(other->colour.filter, 0.5f);
  EXPECT_EQ(alone->colour.filter, 1.0f);
}

TEST(UnitDescriptionsShared, ATransformLeavesTheDeclaredTextureWhereItIs) {
  SceneText s(
      "#declare T = texture { pigment { checker scale 2 } }; "
      "sphere { 0, 1 texture { T } translate x } sphere { 0, 1 texture { T } }");
  const auto& moved = s.object(0).texture->layers[0].pigment->pattern.placement;
  const auto& declared = s.object(1).texture->layers[0].pigment->pattern.placement;
  ASSERT_EQ(moved.size(), 1u);
  ASSERT_EQ(declared.size(), 1u);
  EXPECT_EQ(moved[0].transform->point({0, 0, 0}), Vec3(1, 0, 0));
  EXPECT_EQ(declared[0].transform->point({0, 0, 0}), Vec3(0, 0, 0));
}

// It is moved when it is compiled, or when the statement goes on to change it.
TEST(UnitDescriptionsShared, ATextureThatOnlyItsObjectMovesIsShared) {
  SceneText s(
      "#declare T = texture { pigment { checker } }; "
      "#for (I, 1, 2) sphere { 0, 1 texture { T } translate x*I scale 2 } #end "
      "sphere { 0, 1 texture { T } translate x scale 2 finish { phong 1 } }");
  EXPECT_EQ(s.object(0).texture->layers[0].pigment, s.object(1).texture->layers[0].pigment);
  EXPECT_TRUE(s.object(0).texture->layers[0].pigment->pattern.placement.empty());
  for (const std::size_t i : {0u, 2u}) {
    ObjectDesc object = s.object(i);
    EXPECT_EQ(object.texture_waits, i == 0);
    settle_texture(object);
    const auto& placement = object.texture->layers[0].pigment->pattern.placement;
    ASSERT_EQ(placement.size(), 1u);
    EXPECT_EQ(placement[0].transform->point({0, 0, 0}), Vec3(2, 0, 0));
  }
  const core::SceneParts parts = s.build();
  EXPECT_NE(parts.objects[0]->attributes().texture, parts.objects[1]->attributes().texture);
}

// Colours alone are the same wherever they are moved.
TEST(UnitDescriptionsShared, ATextureWithoutAPlaceIsCompiledOnce) {
  SceneText s(
      "#declare T = texture { pigment { rgb 1 } finish { phong 1 } }; "
      "#for (I, 1, 3) sphere { 0, 1 texture { T } translate x*I } #end");
  const core::SceneParts parts = s.build();
  EXPECT_EQ(parts.objects[0]->attributes().texture, parts.objects[2]->attributes().texture);
  EXPECT_EQ(parts.textures.size(), 1u);
}

TEST(UnitDescriptionsShared, CopiesOfABlendMapShareTheEntries) {
  const core::BlendMap<double> map({{0.0, 3.0}, {1.0, 5.0}});
  const core::BlendMap<double> copy = map;
  EXPECT_EQ(&copy.items(), &map.items());
  EXPECT_EQ(*copy.find(0.5).after, 5.0);
}

TEST(UnitDescriptionsShared, AFinishThatALoopRepeatsIsOne) {
  SceneText s("#for (I, 0, 2) sphere { I, 1 finish { phong .5 } } #end");
  EXPECT_EQ(finish_of(s.object(0)), finish_of(s.object(1)));
  EXPECT_EQ(finish_of(s.object(1)), finish_of(s.object(2)));
}

TEST(UnitDescriptionsShared, FinishesThatDifferAreNot) {
  SceneText s("#for (I, 0, 1) sphere { I, 1 finish { phong I/2 } } #end");
  EXPECT_NE(finish_of(s.object(0)), finish_of(s.object(1)));
  EXPECT_EQ(finish_of(s.object(0))->phong, 0.0);
  EXPECT_EQ(finish_of(s.object(1))->phong, 0.5);
}

TEST(UnitDescriptionsShared, ObjectsAreUsedUpAsTheyAreCompiled) {
  SceneText s("#for (I, 0, 9) sphere { I, 1 pigment { rgb I/9 } } #end");
  const std::weak_ptr<const ObjectDesc> object = s.scene.objects[3].object;
  const std::weak_ptr<const TextureDesc> texture = s.object(3).texture;
  const core::SceneParts parts = build_scene(s.scene, s.diagnostics());
  EXPECT_TRUE(s.scene.objects.empty());
  EXPECT_TRUE(object.expired());
  EXPECT_TRUE(texture.expired());
  EXPECT_EQ(parts.objects.size(), 10u);
  EXPECT_EQ(parts.textures.size(), 10u);
}

TEST(UnitDescriptionsShared, CopiesOfATextureAreCompiledOnce) {
  SceneText s(
      "#declare A = sphere { 0, 1 pigment { checker } }; A A "
      "sphere { 3, 1 pigment { rgb 1 } } A");
  const core::SceneParts parts = s.build();
  ASSERT_EQ(parts.objects.size(), 4u);
  EXPECT_EQ(parts.textures.size(), 2u);
  EXPECT_EQ(parts.objects[0]->attributes().texture, parts.objects[3]->attributes().texture);
}

TEST(UnitDescriptionsShared, AReopenedObjectIsNotAskedAsItWas) {
  SceneText s(
      "#macro Ball() #local B = sphere { 0, 1 }; #if (inside(B, 0)) B #end #end "
      "#declare Moved = object { Ball() translate x*5 }; "
      "#debug concat(str(inside(Moved, 0), 0, 0)) "
      "sphere { x*10*inside(Moved, <5, 0, 0>) - y*inside(Moved, <0, 0, 0>), 1 }");
  EXPECT_EQ(s.shape<SphereShape>().centre, Vec3(10, 0, 0));
}

}  // namespace
}  // namespace lentray::parser::test
