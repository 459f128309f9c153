// What objects of a scene are called, and where they stand in its text.
#include "parser/compile/object_places.h"

#include <gtest/gtest.h>

#include "parser/compile/scene.h"
#include "parser/read_scene.h"
#include "tools/common/process.h"

namespace lentray::parser {
namespace {

/// The names of the scene's objects as the compiled scene has them: unions split.
std::vector<std::string> names_in(const std::string& text) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "a.pov", "#version 3.7;\n" + text);
  SourceManager sources;
  Diagnostics diagnostics(sources);
  for (const Stream s : {Stream::kDebug, Stream::kRender, Stream::kStatistics, Stream::kWarning}) {
    diagnostics.connect(s, [](std::string_view) {});
  }
  const std::string path = (folder / "a.pov").string();
  SceneDesc description = read_descriptions(path, sources, diagnostics, {});
  ObjectPlaces places;
  BuildOptions build;
  build.places = &places;
  const core::Scene scene(build_scene(description, diagnostics, build), {});
  places.sort_parts();
  std::vector<std::string> out;
  for (const auto& object : scene.objects()) {
    const ObjectPlace* place = places.place_of(object.get(), object->whole());
    std::string name = place ? object_name(*place, sources) : "?";
    if (const std::size_t at = name.find(path); at != name.npos) name.replace(at, path.size(), "a");
    out.push_back(name);
  }
  return out;
}

using ObjectNames = std::vector<std::string>;

TEST(UnitObjectPlaces, ObjectsHaveThePlaceOfTheirStatement) {
  EXPECT_EQ(names_in("sphere { 0, 1 }\n  box { 0, 1 }"),
            (ObjectNames{"sphere at a:2:1", "box at a:3:3"}));
  EXPECT_EQ(names_in("difference { sphere { 0, 1 } box { 0, 1 } }"),
            (ObjectNames{"difference at a:2:1"}));
}

TEST(UnitObjectPlaces, PartsOfAUnionHaveTheirOwn) {
  EXPECT_EQ(names_in("union {\n sphere { 0, 1 }\n union { box { 0, 1 }\n cone { 0, 1, y, 0 } } }"),
            (ObjectNames{"sphere at a:3:2", "box at a:4:10", "cone at a:5:2"}));
  EXPECT_EQ(names_in("merge { sphere { 0, 1 } box { 0, 2 } }"), (ObjectNames{"merge at a:2:1"}));
}

TEST(UnitObjectPlaces, IdentifiersAreNames) {
  const std::string chair = "#declare Chair = union { sphere { 0, 1 } sphere { 3*x, 1 } }\n";
  EXPECT_EQ(names_in(chair + "object { Chair }\nobject{Chair translate 9*y}"),
            (ObjectNames{"Chair at a:3:1", "Chair at a:3:1", "Chair at a:4:1", "Chair at a:4:1"}));
  // In a union of others, the union's parts are told apart.
  EXPECT_EQ(names_in(chair + "union { object { Chair } box { 9, 10 } }"),
            (ObjectNames{"Chair at a:3:9", "Chair at a:3:9", "box at a:3:26"}));
}

TEST(UnitObjectPlaces, WhatALoopMakesIsOneStatement) {
  EXPECT_EQ(names_in("#for (I, 1, 3)\nsphere { 3*I*x, 1 }\n#end"),
            (ObjectNames{"sphere at a:3:1", "sphere at a:3:1", "sphere at a:3:1"}));
}

TEST(UnitObjectPlaces, WhatLightsLookLikeHasAPlace) {
  EXPECT_EQ(names_in("light_source { 9, 1 looks_like { sphere { 0, 1 } } }\nbox { 0, 1 }"),
            (ObjectNames{"sphere at a:2:34", "box at a:3:1"}));
}

}  // namespace
}  // namespace lentray::parser
