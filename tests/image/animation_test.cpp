// Animations against stock's, frame by frame: names, clocks, constants and pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

const char* const kMoving = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,1,-5> look_at 0 }
light_source { <3,5,-4> rgb 1 }
sphere { <2*clock-1,0,0>, 0.8 pigment { rgb <frame_number/8, clock_delta, 0.5*clock_on> } }
box { <-1,-1,0.5>, <final_frame/10,-0.7,1> pigment { rgb <initial_frame/3, final_clock/4, initial_clock/4> }
  rotate 20*clock*y }
)";

const char* const kReading = R"(#version 3.7;
global_settings { assumed_gamma 1 } #include "part.inc"
#if (file_exists("extra.inc")) #include "extra.inc" #end
camera { location <0,1,-5> look_at 0 }
sphere { <2*clock-1,0,0>, 0.8 pigment { rgb Shade } finish { ambient 1 } }
)";

std::vector<std::string> pictures_in(const fs::path& folder) {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".png") out.push_back(entry.path().filename().string());
  }
  std::sort(out.begin(), out.end());
  return out;
}

void expect_as_stock(std::vector<std::string> arguments) {
  const tool::TemporaryFolder folder;
  std::vector<std::string> names[2];
  arguments.insert(arguments.end(), {"+Iscene.pov", "+W60", "+H40", "-D", "-GA", "+WT1"});
  for (const bool ours : {false, true}) {
    const fs::path place = folder / (ours ? "ours" : "stock");
    fs::create_directory(place);
    tool::write_text(place / "scene.pov", kMoving);
    std::vector<std::string> command = arguments;
    if (ours) {
      const tool::RunResult run = run_lentray(command, place);
      ASSERT_EQ(run.status, 0) << run.output;
    } else {
      command.insert(command.begin(), "povray");
      tool::run_program(command, place, 300.0);
    }
    names[ours ? 1 : 0] = pictures_in(place);
  }
  ASSERT_FALSE(names[0].empty());
  ASSERT_EQ(names[1], names[0]);
  for (const std::string& name : names[0]) {
    EXPECT_TRUE(reaches(core::read_image(folder / "ours" / name),
                        core::read_image(folder / "stock" / name), Grade::exact))
        << name;
  }
}

TEST(ImageAnimation, Frames) { expect_as_stock({"+KFF3"}); }
TEST(ImageAnimation, FirstFrameAndClocks) { expect_as_stock({"+KFI2", "+KFF5", "+KI1", "+KF3"}); }
TEST(ImageAnimation, CyclicSubset) { expect_as_stock({"+KFF12", "+KC", "+SF3", "+EF0.5"}); }
TEST(ImageAnimation, StepsAndName) { expect_as_stock({"+KFF10", "+STP4", "+Omoving.png"}); }
TEST(ImageAnimation, FrameZero) { expect_as_stock({"+KFI0", "+KFF2", "+Oa.b"}); }
TEST(ImageAnimation, NoLoop) { expect_as_stock({"+KFI1", "+KFF1", "+K0.3"}); }

TEST(ImageAnimation, AFrameReadsWhatTheOneBeforeWrote) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", R"(#version 3.7; global_settings { assumed_gamma 1 }
#if (frame_number = 1) #declare Seen = 0; #else #fopen In "count.txt" read #read (In, Seen) #fclose In #end
#fopen Out "count.txt" write #write (Out, Seen + 1, ",") #fclose Out
camera { location -3*z look_at 0 } sphere { 0, 1 pigment { rgb Seen/4 } finish { ambient 1 } }
)");
  const tool::RunResult run =
      run_lentray({"+Iscene.pov", "+W16", "+H12", "+KFF4", "+FN16", "-V", "Statistics_File=s.json"},
                  folder.path());
  ASSERT_EQ(run.status, 0) << run.output;
  float last = -1.0f;
  for (const char* name : {"scene1.png", "scene2.png", "scene3.png", "scene4.png"}) {
    const StoredImage picture = core::read_image(folder / name);
    const float middle =
        picture.samples[(std::size_t{6} * 16 + 8) * static_cast<std::size_t>(picture.channels)];
    EXPECT_GT(middle, last) << name;
    last = middle;
  }
  EXPECT_TRUE(fs::exists(folder / "s3.json"));
}

/// What changes once the first frame is there is named, and the frames so far stay.
void expect_refusal(const char* file, const char* text, const char* message) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", kReading);
  tool::write_text(folder / "part.inc", "#declare Shade = 0.2;\n");
  std::thread writer([&] {
    for (int i = 0; i < 60'000 && !fs::exists(folder / "scene0001.png"); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    tool::write_text(folder / "new", text);
    fs::rename(folder / "new", folder / file);
  });
  const tool::RunResult run =
      run_lentray({"+Iscene.pov", "+W16", "+H12", "+KFF5000", "-V"}, folder.path());
  writer.join();
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.output.find(message), std::string::npos) << run.output;
  EXPECT_TRUE(fs::exists(folder / "scene0001.png"));
  EXPECT_FALSE(fs::exists(folder / "scene5000.png"));
}

TEST(ImageAnimation, AnIncludeThatChangesDuringARunEndsIt) {
  expect_refusal("part.inc", "#declare Shade = 0.9;\n", "part.inc has changed");
}
TEST(ImageAnimation, ASceneThatChangesDuringARunEndsIt) {
  expect_refusal("scene.pov", "camera { }\n", "the scene has changed");
}
TEST(ImageAnimation, AFileThatAppearsDuringARunEndsIt) {
  expect_refusal("extra.inc", "#declare Shade = 0.9;\n", "extra.inc has come to be");
}

/// Photons that the first frame saves, what frames write, pictures of frames before, and a file for each frame.
TEST(ImageAnimation, AFrameReadsWhatTheRunMade) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "part1.inc", "#declare Shade = 0.2;\n");
  tool::write_text(folder / "part2.inc", "#declare Shade = 0.4;\n");
  tool::write_text(folder / "part3.inc", "#declare Shade = 0.6;\n");
  tool::write_text(folder / "scene.pov", R"(#version 3.7;
#include concat("part", str(frame_number, 0, 0), ".inc")
#if (file_exists("log.txt")) #fopen Out "log.txt" append #else #fopen Out "log.txt" write #end
#write (Out, frame_number, ",\n") #fclose Out
#declare Before = concat("scene", str(frame_number - 1, 0, 0), ".png");
global_settings { assumed_gamma 1
  photons { count 500 #if (file_exists("a.ph")) load_file "a.ph" #else save_file "a.ph" #end } }
camera { location -3*z look_at 0 }
light_source { <2, 3, -4> rgb 1 photons { reflection on refraction on } }
sphere { 0, 1 pigment { rgbf 0.9 } interior { ior 1.5 } photons { target refraction on } }
plane { z, 2 #if (file_exists("scene1.png") & frame_number > 1) pigment { image_map { png Before } }
  #else pigment { rgb Shade } #end }
)");
  const tool::RunResult run =
      run_lentray({"+Iscene.pov", "+W16", "+H12", "+KFF3", "-V"}, folder.path());
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(fs::exists(folder / "a.ph"));
  EXPECT_TRUE(fs::exists(folder / "scene3.png"));
}

}  // namespace
}  // namespace lentray::test
