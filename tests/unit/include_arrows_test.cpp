// The arrows between folders: core knows nobody, camera knows core, shadow and parser know camera and
// core but not each other, tools and tests may know all; within them a room knows the rooms below it, so that there are no
// circles. OpenImageIO stays in core/image, processors' instructions in core/base/simd.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace lentray {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> kMayInclude{
    {"core", {"core"}},
    {"camera", {"camera", "core"}},
    {"shadow", {"shadow", "camera", "core"}},
    {"parser", {"parser", "camera", "core"}},
    {"tools", {"tools", "parser", "shadow", "camera", "core"}},
    {"tests", {"tests", "tools", "parser", "shadow", "camera", "core"}}};

/// The rooms from the ground up: each includes itself and those before it alone.
const std::vector<std::string> kRooms{"core/base",
                                      "core/numeric",
                                      "core/bvh",
                                      "core/noise",
                                      "core/function",
                                      "core/pattern",
                                      "core/image",
                                      "core/image/openimageio",
                                      "core/shape",
                                      "core/object",
                                      "core/bundle",
                                      "core/accel",
                                      "core/light",
                                      "core/material",
                                      "core/irradiance",
                                      "core/photon",
                                      "core/subsurface",
                                      "core/scene",
                                      "core/trace",
                                      "core/render",
                                      "core/pass",
                                      "camera",
                                      "shadow",
                                      "shadow/hit_model",
                                      "parser/base",
                                      "parser/files",
                                      "parser/source",
                                      "parser/options",
                                      "parser/restrictions",
                                      "parser/tokens",
                                      "parser/values",
                                      "parser/descriptions",
                                      "parser/dump",
                                      "parser/interpreter",
                                      "parser/shapes",
                                      "parser/stock",
                                      "parser/compile",
                                      "parser/grammar",
                                      "parser"};

/// Where the folder of a file stands in kRooms; -1: tools and tests have no rooms.
int room_of(const std::string& file) {
  const auto found = std::find(kRooms.begin(), kRooms.end(), file.substr(0, file.rfind('/')));
  return found == kRooms.end() ? -1 : static_cast<int>(found - kRooms.begin());
}

/// What is wrong with an include of a file; empty if nothing. `file` is relative to the root.
std::string fault(const std::string& file, const std::string& included) {
  const std::string from = file.substr(0, file.find('/'));
  const std::size_t slash = included.find('/');
  const std::string to = slash == std::string::npos ? "" : included.substr(0, slash);
  if (to == "OpenImageIO" && file.rfind("core/image/openimageio/", 0) != 0) {
    return "OpenImageIO is for core/image/openimageio alone";
  }
  static const std::regex instructions("[a-z0-9]*intrin\\.h|arm_[a-z0-9]+\\.h");
  if (std::regex_match(included, instructions) && file != "core/base/simd.h") {
    return "instructions are for core/base/simd.h alone";
  }
  if (kMayInclude.count(to) != 0 && kMayInclude.at(from).count(to) == 0) {
    return from + " must not know " + to;
  }
  // What programs share knows none of them.
  const bool is_shared = file.starts_with("tools/common/") || file.starts_with("tools/session/");
  const bool is_session = included.starts_with("tools/session/");
  if (is_shared && to == "tools" && !included.starts_with("tools/common/") &&
      !(is_session && file.starts_with("tools/session/"))) {
    return "what programs share must not know a program";
  }
  if (room_of(included) > room_of(file) && room_of(file) >= 0) {
    return "a room must not know one above it";
  }
  return {};
}

struct Include {
  std::string file, included;
  bool quoted = false;
};

std::vector<Include> includes_of(const fs::path& root, const fs::path& file) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*(["<])([^">]+)[">])re");
  std::vector<Include> found;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (!std::regex_search(line, match, pattern)) continue;
    found.push_back({fs::relative(file, root).generic_string(), match[2], match[1] == "\""});
  }
  return found;
}

std::vector<Include> all_includes() {
  const fs::path root = LENTRAY_SOURCE_DIR;
  std::vector<Include> all;
  for (const auto& [folder, allowed] : kMayInclude) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp" && extension != ".def") continue;
      for (Include& include : includes_of(root, entry.path())) all.push_back(std::move(include));
    }
  }
  return all;
}

TEST(UnitHouseArrows, NoIncludeAgainstThem) {
  const std::vector<Include> all = all_includes();
  ASSERT_GT(all.size(), 100u) << "no sources found";
  for (const Include& i : all) {
    EXPECT_EQ(fault(i.file, i.included), "") << i.file << " includes " << i.included;
  }
}

TEST(UnitHouseArrows, EveryFileOfTheLibrariesIsInARoom) {
  for (const Include& i : all_includes()) {
    const std::string top = i.file.substr(0, i.file.find('/'));
    if (top == "tools" || top == "tests") continue;
    EXPECT_GE(room_of(i.file), 0) << i.file;
  }
}

TEST(UnitHouseArrows, OwnHeadersAreNamedFromTheRoot) {
  const fs::path root = LENTRAY_SOURCE_DIR;
  for (const Include& i : all_includes()) {
    if (!i.quoted) continue;
    EXPECT_TRUE(fs::exists(root / i.included)) << i.file << " includes " << i.included;
  }
}

TEST(UnitHouseArrows, TheRulesCanFail) {
  EXPECT_NE(fault("core/render/frame.cpp", "shadow/report.h"), "");
  EXPECT_NE(fault("parser/interpreter/parser.cpp", "shadow/report.h"), "");
  EXPECT_NE(fault("shadow/report.cpp", "parser/interpreter/parser.h"), "");
  EXPECT_NE(fault("camera/camera.cpp", "parser/interpreter/parser.h"), "");
  EXPECT_NE(fault("tools/lentray/main.cpp", "tests/support/render.h"), "");
  EXPECT_NE(fault("tools/lentray/main.cpp", "OpenImageIO/imageio.h"), "");
  EXPECT_EQ(fault("core/image/openimageio/module.cpp", "OpenImageIO/imageio.h"), "");
  EXPECT_NE(fault("core/bvh/wide_bvh.h", "immintrin.h"), "");
  EXPECT_NE(fault("core/base/processor.h", "arm_neon.h"), "");
  EXPECT_EQ(fault("core/base/simd.h", "immintrin.h"), "");
  EXPECT_EQ(fault("tools/lentray/main.cpp", "parser/interpreter/parser.h"), "");
  EXPECT_EQ(fault("core/base/ray.h", "vector"), "");
  EXPECT_NE(fault("tools/session/session.cpp", "tools/lentray/run.h"), "");
  EXPECT_NE(fault("tools/common/csv.cpp", "tools/session/session.h"), "");
  EXPECT_EQ(fault("tools/session/film.cpp", "tools/common/machine.h"), "");
  EXPECT_NE(fault("core/shape/box.h", "core/object/object.h"), "");
  EXPECT_NE(fault("parser/compile/scene.h", "parser/grammar/scene.h"), "");
  EXPECT_EQ(fault("core/object/leaf.h", "core/shape/shape.h"), "");
}

TEST(UnitHouseFolders, OnlyTheAgreedOnesAreAtTheTop) {
  const std::set<std::string> agreed{"CMakeLists.txt",
                                     "CMakePresets.json",
                                     "parser",
                                     "core",
                                     "camera",
                                     "shadow",
                                     "scenes",
                                     "tests",
                                     "tools",
                                     "docs",
                                     "README.md",
                                     "LICENSE",
                                     "CHANGELOG.md",
                                     "build",
                                     "out"};
  for (const auto& entry : fs::directory_iterator(LENTRAY_SOURCE_DIR)) {
    const std::string name = entry.path().filename();
    EXPECT_TRUE(name.front() == '.' || agreed.count(name) != 0) << name << " was left behind";
  }
}

}  // namespace
}  // namespace lentray
