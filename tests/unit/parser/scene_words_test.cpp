// INI files that came with a scene: every file that one names is known with its line; On of Restrict_IO stays on.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/image/run_files.h"
#include "core/image/writer.h"
#include "parser/options/create_ini.h"
#include "parser/options/options.h"
#include "parser/options/options_table.h"
#include "parser/options/scene_words.h"
#include "tools/common/process.h"

namespace lentray::parser::test {
namespace {

namespace fs = std::filesystem;

class SceneIni {
 public:
  RenderOptions read(const std::string& ini, std::vector<std::string> words = {},
                     const std::vector<std::string>& behind = {}) const {
    tool::write_text(m_folder / "a.ini", ini);
    words.insert(words.end(), {"--scene-ini", (m_folder / "a.ini").string()});
    words.insert(words.end(), behind.begin(), behind.end());
    return read_options(words, {});
  }
  const fs::path& folder() const { return m_folder.path(); }

 private:
  tool::TemporaryFolder m_folder;
};

/// No option gets a name past those who judge it: what is not followed refuses it, or does not keep it.
TEST(UnitSceneWords, EveryOptionThatKeepsANameIsFollowed) {
  const SceneIni scene;
  constexpr const char* kName = "outside/stolen";
  for (const OptionRow& row : option_table()) {
    for (const std::string& line :
         {std::string(row.name) + "=" + kName, "+" + std::string(row.switch_name) + kName,
          "-" + std::string(row.switch_name) + kName}) {
      if (line.starts_with("=") || line == std::string("+") + kName ||
          line == std::string("-") + kName)
        continue;
      RenderOptions options;
      try {
        options = scene.read(line + "\n");
      } catch (const OptionError&) {
        continue;
      }
      const bool is_followed = !scene_words_that_hold(options).empty();
      EXPECT_TRUE(is_followed || ini_text(options).find("stolen") == std::string::npos) << line;
    }
  }
}

TEST(UnitSceneWords, TheWordIsKnownByItsLine) {
  const SceneIni scene;
  const auto words = scene_words_that_hold(scene.read("; a scene's\n+W8 +GDx/y\n"));
  ASSERT_EQ(words.size(), 1u);
  EXPECT_EQ(words[0].option->name, "Debug_File");
  EXPECT_EQ(words[0].value, "x/y");
  EXPECT_NE(words[0].where.find("a.ini:2: option +GDx/y"), std::string::npos) << words[0].where;
}

TEST(UnitSceneWords, WordsOfTheUsersAreNot) {
  const SceneIni scene;
  EXPECT_TRUE(
      scene_words_that_hold(scene.read("+GD\nWidth=9\n", {"Debug_File=mine", "+L/lib"})).empty());
  EXPECT_TRUE(scene_words_that_hold(scene.read("Debug_File=x\n", {}, {"Debug_File=mine"})).empty());
  EXPECT_TRUE(scene_words_that_hold(
                  scene.read("Input_File_Name=x.pov\nOutput_File_Name=y\n", {}, {"+Ia.pov", "+Ob"}))
                  .empty());
  EXPECT_EQ(
      scene_words_that_hold(scene.read("Debug_File=x\n", {"Debug_File=mine"}, {"+GD"})).size(), 1u);
}

TEST(UnitSceneWords, RestrictIoStaysOn) {
  const auto is_on = [](const std::vector<std::string>& words) {
    return read_options(words, {}).restrict_io;
  };
  EXPECT_TRUE(is_on({"Restrict_IO=On", "Restrict_IO=Off"}));
  EXPECT_TRUE(is_on({"Restrict_IO=Off", "Restrict_IO=On"}));
  EXPECT_FALSE(is_on({"Restrict_IO=Off"}));
  const SceneIni scene;
  EXPECT_TRUE(scene.read("Restrict_IO=Off\n", {"Restrict_IO=On"}).restrict_io);
  EXPECT_TRUE(scene.read("Restrict_IO=Off\n", {}, {"Restrict_IO=On"}).restrict_io);
  EXPECT_TRUE(scene.read("Restrict_IO=On\n").restrict_io);
  EXPECT_FALSE(scene.read("Scene_Writes=disk\n", {"Scene_Writes=memory"}).writes_to_disk);
}

TEST(UnitSceneWords, OutsideIniFilesAreNotRead) {
  const SceneIni scene;
  const tool::TemporaryFolder outside;
  const std::string other = (outside / "b.ini").string();
  tool::write_text(other, "Width=77\n");
  fs::create_symlink(other, scene.folder() / "link.ini");
  fs::create_directory(scene.folder() / "sub");
  tool::write_text(scene.folder() / "sub/c.ini", "Width=66\n");
  for (const std::string& name : {other, (scene.folder() / "link.ini").string()}) {
    EXPECT_THROW(scene.read("Include_Ini=" + name + "\n", {"Restrict_IO=On"}), OptionError) << name;
    EXPECT_THROW(scene.read(name + "\n", {}, {"Restrict_IO=On"}), OptionError) << name;
    EXPECT_EQ(scene.read(name + "\n").width, 77);
  }
  EXPECT_EQ(scene.read((scene.folder() / "sub/c.ini").string() + "\n", {"Restrict_IO=On"}).width,
            66);
}

TEST(UnitRunFiles, AnOutputIsNoInputByAnyName) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "a", "x");
  fs::create_symlink("a", folder / "link");
  fs::create_hard_link(folder / "a", folder / "hard");
  core::note_input(folder / "a");
  for (const char* name : {"a", "link", "hard", "./a"}) {
    EXPECT_THROW(core::check_not_input(folder / name), core::ImageError) << name;
    EXPECT_THROW(core::claim_output(folder / name, "it"), core::ImageError) << name;
    EXPECT_THROW(tool::write_whole(folder / name, "y"), core::ImageError) << name;
  }
  EXPECT_EQ(tool::read_text(folder / "a"), "x");
  tool::write_whole(folder / "b", "y");
  core::note_input(folder / "b");
  tool::write_whole(folder / "b", "z");
  core::claim_output(folder / "new", "one");
  core::claim_output(folder / "new", "one");
  EXPECT_THROW(core::claim_output(folder / "new", "other"), core::ImageError);
  core::forget_run_files();
}

}  // namespace
}  // namespace lentray::parser::test
