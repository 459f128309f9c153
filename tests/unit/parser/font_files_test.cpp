// Fonts of texts: each is looked for once, however many texts have it.
#include <gtest/gtest.h>

#include <string>

#include "parser/read_scene.h"
#include "parser/source/source.h"

namespace lentray::parser {
namespace {

/// A scene beside one font, which counts how often that is opened.
class FontFolder final : public Files {
 public:
  explicit FontFolder(std::string scene) : m_scene(std::move(scene)) {}
  int holds() const { return m_holds; }

  bool exists(const std::string& path) const override { return path.ends_with("some.ttf"); }
  std::optional<std::string> find_loosely(const std::string&, const std::string&) const override {
    return std::nullopt;
  }
  std::optional<std::string> read(const std::string& path) const override {
    if (path == "fonts.pov") return m_scene;
    return std::nullopt;
  }
  std::string hold(const std::string& path) override {
    ++m_holds;
    return path;
  }
  bool may_write(const std::string&) const override { return false; }
  std::unique_ptr<FileWriter> open(const std::string&, bool) override { return nullptr; }

 private:
  std::string m_scene;
  int m_holds = 0;
};

TEST(UnitFontFiles, AreLookedForOnce) {
  FontFolder files(
      "#for (I, 1, 20) text { ttf \"some\" \"a\" 1, 0 } text { ttf \"some.ttf\" \"b\" 1, 0 } "
      "#end\n");
  SourceManager sources(files);
  Diagnostics diagnostics(sources);
  const SceneDesc scene = read_descriptions("fonts.pov", sources, diagnostics, {});
  EXPECT_EQ(scene.objects.size(), 40u);
  EXPECT_EQ(files.holds(), 2);
}

}  // namespace
}  // namespace lentray::parser
