// --parse-only keeps no object that cannot go wrong, and misses no mistake for it.
#include <gtest/gtest.h>

#include "parser/compile/scene.h"
#include "parser/read_scene.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

using namespace parser;

parser::SceneDesc checked(const std::string& text) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", text);
  SourceManager sources;
  Diagnostics diagnostics(sources);
  diagnostics.connect(Stream::kWarning, {});
  ParserOptions options;
  options.only_check = true;
  SceneDesc scene = read_descriptions(folder / "scene.pov", sources, diagnostics, options);
  SceneDesc used_up = scene;
  build_scene(used_up, diagnostics);
  return scene;
}

TEST(UnitParserCheck, SoundObjectsAreCountedAndNotKept) {
  const SceneDesc scene = checked(
      "#version 3.7; sphere { 0, 1 } union { box { 0, 1 } cone { 0, 1, y, 0 } pigment { rgb 1 } }\n"
      "mesh { triangle { 0, x, y } }\n"
      "sphere { 0, 1 pigment { bozo } } light_source { 0 1 } object { sphere { 0, 1 } clipped_by { "
      "box { 0, 1 } } }");
  EXPECT_EQ(scene.dropped, 3u);
  EXPECT_EQ(scene.objects.size(), 3u);
}

TEST(UnitParserCheck, WhatCannotBeMadeIsStillSaid) {
  EXPECT_THROW(checked("#version 3.7; height_field { function 1, 1 { x } }"), ParseError);
  EXPECT_THROW(
      checked("#version 3.7; union { sphere { 0, 1 } height_field { function 1, 1 { x } } }"),
      ParseError);
}

TEST(UnitParserCheck, TheDefaultTextureCounts) {
  EXPECT_EQ(checked("#version 3.7; #default { pigment { bozo } } sphere { 0, 1 }").dropped, 0u);
}

}  // namespace
}  // namespace lentray::test
