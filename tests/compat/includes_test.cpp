// POV-Ray's own include files are read, with everything they include.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "parser/read_scene.h"

namespace lentray::parser {
namespace {

constexpr const char* kIncludeFolder = "/usr/share/povray-3.7/include";

class CompatIncludes : public ::testing::TestWithParam<const char*> {};

TEST_P(CompatIncludes, IsRead) {
  if (!std::filesystem::exists(kIncludeFolder)) GTEST_SKIP() << "povray-includes is not installed";
  const std::string path = ::testing::TempDir() + "lentray_include_" + GetParam() + ".pov";
  // Some need the colours or shapes declared first, in stock as well.
  std::ofstream(path) << "#version 3.7;\n#include \"colors.inc\"\n#include \"shapes.inc\"\n#include \""
                      << GetParam() << "\"\nsphere { 0, 1 }\n";
  SourceManager sources;
  Diagnostics diagnostics(sources);
  ParserOptions options;
  options.library_paths = {kIncludeFolder};
  const ReadScene scene = read_scene(path, sources, diagnostics, options);
  EXPECT_GE(scene.parts.objects.size(), 1u);
  std::filesystem::remove(path);
}

INSTANTIATE_TEST_SUITE_P(All, CompatIncludes,
                         ::testing::Values("colors.inc", "textures.inc", "shapes.inc", "transforms.inc",
                                           "math.inc", "functions.inc", "consts.inc", "finish.inc",
                                           "metals.inc", "golds.inc", "stones.inc", "woods.inc",
                                           "glass.inc", "skies.inc", "shapes_old.inc", "shapesq.inc",
                                           "strings.inc", "rand.inc", "arrays.inc", "chars.inc"),
                         [](const auto& info) {
                           std::string name = info.param;
                           for (char& c : name) if (c == '.') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace lentray::parser
