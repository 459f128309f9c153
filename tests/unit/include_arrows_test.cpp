// The house's arrows: core knows nobody, camera knows core, shadow and parser know camera and
// core but not each other, tools and tests may know all. OpenImageIO stays in core/image.
#include <gtest/gtest.h>

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

/// What is wrong with an include of a file; empty if nothing. `file` is relative to the root.
std::string fault(const std::string& file, const std::string& included) {
  const std::string from = file.substr(0, file.find('/'));
  const std::size_t slash = included.find('/');
  const std::string to = slash == std::string::npos ? "" : included.substr(0, slash);
  if (to == "OpenImageIO" && file.rfind("core/image/openimageio/", 0) != 0) {
    return "OpenImageIO is for core/image/openimageio alone";
  }
  if (kMayInclude.count(to) != 0 && kMayInclude.at(from).count(to) == 0) {
    return from + " must not know " + to;
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

TEST(UnitHouseArrows, OwnHeadersAreNamedFromTheRoot) {
  const fs::path root = LENTRAY_SOURCE_DIR;
  for (const Include& i : all_includes()) {
    if (!i.quoted) continue;
    EXPECT_TRUE(fs::exists(root / i.included)) << i.file << " includes " << i.included;
  }
}

TEST(UnitHouseArrows, TheRulesCanFail) {
  EXPECT_NE(fault("core/render/frame.cpp", "shadow/report.h"), "");
  EXPECT_NE(fault("parser/parser.cpp", "shadow/report.h"), "");
  EXPECT_NE(fault("shadow/report.cpp", "parser/parser.h"), "");
  EXPECT_NE(fault("camera/camera.cpp", "parser/parser.h"), "");
  EXPECT_NE(fault("tools/lentray/main.cpp", "tests/support/render.h"), "");
  EXPECT_NE(fault("tools/lentray/main.cpp", "OpenImageIO/imageio.h"), "");
  EXPECT_EQ(fault("core/image/openimageio/module.cpp", "OpenImageIO/imageio.h"), "");
  EXPECT_EQ(fault("tools/lentray/main.cpp", "parser/parser.h"), "");
  EXPECT_EQ(fault("core/base/ray.h", "vector"), "");
}

TEST(UnitHouseFolders, OnlyTheAgreedOnesAreAtTheTop) {
  const std::set<std::string> agreed{"CMakeLists.txt", "CMakePresets.json", "parser", "core",
                                     "camera", "shadow", "scenes", "tests", "tools", "docs",
                                     "README.md", "LICENSE", "CHANGELOG.md", "build", "out"};
  for (const auto& entry : fs::directory_iterator(LENTRAY_SOURCE_DIR)) {
    const std::string name = entry.path().filename();
    EXPECT_TRUE(name.front() == '.' || agreed.count(name) != 0) << name << " was left behind";
  }
}

}  // namespace
}  // namespace lentray
