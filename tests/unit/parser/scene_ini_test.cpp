// INI files that came with a scene: they say what the picture is like, and nothing of what the run reads and writes.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/image/run_files.h"
#include "core/image/writer.h"
#include "parser/options/create_ini.h"
#include "parser/options/options.h"
#include "parser/options/options_table.h"
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

bool warns_of(const RenderOptions& options, const std::string& line) {
  return std::ranges::any_of(options.warnings, [&line](const std::string& text) {
    return text.find(line + ": left out") != std::string::npos;
  });
}

/// No option keeps a name of a file but those by which scenes look for their own.
TEST(UnitSceneIni, NamesNoFiles) {
  const SceneIni scene;
  constexpr const char* kName = "outside/stolen";
  for (const OptionRow& row : option_table()) {
    if (row.name == "Library_Path" || row.name == "Include_Header") continue;
    if (row.name == "Sheet_At") continue;  // an object of the scene
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
      EXPECT_EQ(ini_text(options).find("stolen"), std::string::npos) << line;
    }
  }
}

/// What is the user's to say is left out, whatever its value, with its line; and nothing changes by it.
TEST(UnitSceneIni, LeavesTheRunToTheUser) {
  const SceneIni scene;
  const RenderOptions plain = scene.read("Width=9\n");
  EXPECT_EQ(plain.width, 9);
  EXPECT_TRUE(plain.warnings.empty());
  for (const char* line : {"Debug_File=x",
                           "+GDx",
                           "Create_Ini=On",
                           "Output_File_Name=x.png",
                           "+Ox",
                           "-F",
                           "Input_File_Name=b.pov",
                           "b.pov",
                           "Statistics_File=x",
                           "Dependencies_File=x",
                           "View_Cameras=x",
                           "Radiosity_File_Name=x",
                           "+RFO",
                           "+RFI",
                           "Pre_Scene_Command=touch x",
                           "Post_Frame_Return=A",
                           "Restrict_IO=Off",
                           "Restrict_IO=On",
                           "Permitted_Path=/",
                           "Scene_Writes=disk",
                           "Continue_Trace=On",
                           "Warning_Level=0",
                           "Max_Memory=1T",
                           "Max_Pixels=1T",
                           "Max_Written=1T",
                           "Max_Files=1000000",
                           "Max_Time=1",
                           "Work_Threads=400",
                           "Append_File=On",
                           "All_Console=Off",
                           "Band_Height=1"}) {
    const RenderOptions options = scene.read(std::string("Width=9\n") + line + "\n");
    EXPECT_EQ(ini_text(options), ini_text(plain)) << line;
    ASSERT_EQ(options.warnings.size(), 1u) << line;
    EXPECT_TRUE(options.warnings[0].find(std::string("a.ini:2: option ") + line) !=
                std::string::npos)
        << options.warnings[0];
  }
}

TEST(UnitSceneIni, SaysWhatThePictureIsLike) {
  const SceneIni scene;
  const RenderOptions o = scene.read(
      "Antialias=On\nDisplay=On\nPause_When_Done=On\nInitial_Frame=2\nFinal_Frame=5\nDeclare=A=2\n"
      "Quality=5\nOutput_File_Type=J\nBounding=On\nLibrary_Path=inc\nInclude_Header=h.inc\n+KC "
      "+UL\n"
      "Lenticular=On\nClock=3\nBits_Per_Color=8\nBits_Per_Colour=8\n");
  EXPECT_TRUE(o.warnings.empty());
  EXPECT_TRUE(o.antialias && o.lenticular);
  EXPECT_EQ(o.animation.final_frame, 5);
  EXPECT_EQ(o.library_paths, std::vector<std::string>{"inc"});
  EXPECT_TRUE(o.users_libraries.empty()) << "a name to look for files, no place to read";
  EXPECT_EQ(scene.read("Library_Path=inc\n", {}, {"+Lmine"}).users_libraries,
            std::vector<std::string>{"mine"});
}

/// Nobody misses what the user says himself, before or behind.
TEST(UnitSceneIni, UsersWordsNeedNoWarning) {
  const SceneIni scene;
  EXPECT_TRUE(scene.read("Debug_File=x\n", {}, {"Debug_File=mine"}).warnings.empty());
  const RenderOptions o =
      scene.read("Input_File_Name=x.pov\nOutput_File_Name=y\nb.pov\n", {"a.pov"}, {"+Ob"});
  EXPECT_TRUE(o.warnings.empty());
  EXPECT_EQ(o.input, "a.pov");
  EXPECT_EQ(o.output, "b");
  EXPECT_TRUE(warns_of(scene.read("Debug_File=x\n", {"Warning_File=mine"}), "Debug_File=x"));
}

TEST(UnitSceneIni, RestrictIoStaysOn) {
  const auto is_on = [](const std::vector<std::string>& words) {
    return read_options(words, {}).restrict_io;
  };
  EXPECT_TRUE(is_on({"Restrict_IO=On", "Restrict_IO=Off"}));
  EXPECT_TRUE(is_on({"Restrict_IO=Off", "Restrict_IO=On"}));
  EXPECT_FALSE(is_on({"Restrict_IO=Off"}));
  const SceneIni scene;
  EXPECT_TRUE(scene.read("Restrict_IO=Off\n", {"Restrict_IO=On"}).restrict_io);
  EXPECT_TRUE(scene.read("Restrict_IO=Off\n", {}, {"Restrict_IO=On"}).restrict_io);
  EXPECT_FALSE(scene.read("Restrict_IO=On\n").restrict_io) << "the user's alone";
  EXPECT_FALSE(scene.read("Scene_Writes=disk\n", {"Scene_Writes=memory"}).writes_to_disk);
}

TEST(UnitSceneIni, OutsideIniFilesAreNotRead) {
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
  const std::vector<std::string> permits{"Restrict_IO=On",
                                         "Permitted_Path=" + outside.path().string()};
  EXPECT_EQ(scene.read("Include_Ini=" + other + "\n", permits).width, 77);
}

/// Who judges folders himself trusts no name of one, which may mean another a moment later.
TEST(UnitSceneIni, OnlyPermittedFoldersWhereTheScenesIsNotTrusted) {
  const SceneIni scene;
  const std::string ini = (scene.folder() / "a.ini").string();
  EXPECT_EQ(scene.read("Quality=5\n", {"Restrict_IO=On"}).quality, 5);
  OptionSources sources{{}, {}};
  sources.trusts_scene_folder = false;
  const std::vector<std::string> words{"Restrict_IO=On", "--scene-ini", ini};
  EXPECT_THROW(read_options(words, sources), OptionError);
  std::vector<std::string> more = words;
  more.push_back("Permitted_Path=" + scene.folder().string());
  EXPECT_EQ(read_options(more, sources).quality, 5);
}

/// The number of a file that the run made and that is gone becomes that of another, which it reads.
TEST(UnitRunFiles, NumbersOfFilesThatAreGoneMeanNothing) {
  const tool::TemporaryFolder folder;
  const auto number = [&](const char* name) {
    struct stat status {};
    return ::stat((folder / name).c_str(), &status) == 0 ? status.st_ino : 0;
  };
  constexpr int kTries = 200;
  for (int i = 0; i < kTries; ++i) {
    tool::write_whole(folder / "made", "x");
    const auto made = number("made");
    fs::remove(folder / "made");
    tool::write_text(folder / "read", "y");
    if (number("read") == made) {
      core::note_input(folder / "read");
      EXPECT_THROW(core::check_not_input(folder / "read"), core::ImageError);
      core::forget_run_files();
      return;
    }
    fs::remove(folder / "read");
  }
  GTEST_SKIP() << "this file system gives no number again";
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
