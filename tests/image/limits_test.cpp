// The limits of a service end a run with status 1, a place and the older files.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kLimitedScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
light_source { -5*z, 1 }
plane { -z, -3 pigment { granite scale 0.01 } }
)";

struct Limited {
  tool::RunResult run(const std::string& scene, std::vector<std::string> words) const {
    tool::write_text(folder / "a.pov", scene);
    words.insert(words.end(), {"a.pov", "-V"});
    return run_lentray(words, folder.path());
  }
  tool::TemporaryFolder folder;
};

TEST(ImageLimits, ScenesWriteNoMore) {
  const Limited limited;
  const auto result = limited.run(std::string(kLimitedScene) +
                                      "#fopen F \"out.txt\" write\n"
                                      "#while (1)\n#write (F, \"0123456789\\n\")\n#end\n",
                                  {"Max_Written=1M"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(
      result.output.find("a.pov:7:9: error: cannot write 'out.txt': the run may write 1.05 MB "
                         "(Max_Written)"),
      std::string::npos)
      << result.output;
  EXPECT_LE(std::filesystem::file_size(limited.folder / "out.txt"), 1u << 20);
}

TEST(ImageLimits, PicturesThatAreTooLargeLeaveTheOlderOnes) {
  for (const std::string type : {"N", "T", "E", "P"}) {
    const Limited limited;
    const std::string name = "out." + std::string(type == "N"   ? "png"
                                                  : type == "T" ? "tga"
                                                  : type == "E" ? "exr"
                                                                : "ppm");
    tool::write_text(limited.folder / name, "an older picture");
    const auto result =
        limited.run(kLimitedScene, {"+W1000", "+H800", "+F" + type, "+O" + name, "Max_Written=1M"});
    EXPECT_EQ(result.status, 1) << type << result.output;
    EXPECT_NE(result.output.find("(Max_Written)"), std::string::npos) << type << result.output;
    EXPECT_EQ(tool::read_text(limited.folder / name), "an older picture") << type;
  }
}

TEST(ImageLimits, FilesAndPixelsAreCounted) {
  const Limited limited;
  tool::write_text(limited.folder / "b.inc", "");
  const auto files = limited.run(
      std::string(kLimitedScene) + "#for (I, 1, 9) #fopen F \"b.inc\" read #fclose F #end\n",
      {"Max_Files=5"});
  EXPECT_EQ(files.status, 1);
  EXPECT_NE(files.output.find("a.pov:5:25: error: 'b.inc' is refused: the scene may open 5 files "
                              "(Max_Files)"),
            std::string::npos)
      << files.output;
  tool::write_text(limited.folder / "scene.ini", "Final_Frame=2000000000\n");
  const auto pixels =
      limited.run(kLimitedScene, {"+W10", "+H10", "--scene-ini=scene.ini", "Max_Pixels=1M"});
  EXPECT_EQ(pixels.status, 1);
  EXPECT_NE(pixels.output.find("2000000000 pictures of 10 x 10 pixels are more than the 1000000 of "
                               "Max_Pixels"),
            std::string::npos)
      << pixels.output;
  EXPECT_FALSE(std::filesystem::exists(limited.folder / "a.png"));
}

/// Whoever names the header is told where.
TEST(ImageLimits, ARefusedHeaderHasItsLine) {
  const Limited limited;
  tool::write_text(limited.folder / "scene.ini", "Width=8\nInclude_Header=/etc/passwd\n");
  const auto result =
      limited.run(kLimitedScene, {"--scene-ini=scene.ini", "Restrict_IO=On", "Permitted_Path=."});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.output.find("'/etc/passwd' is refused"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("(Include_Header in scene.ini:2)"), std::string::npos)
      << result.output;
}

}  // namespace
}  // namespace lentray::test
