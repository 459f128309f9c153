// Radiosity that is kept (+RF, +RFI, +RFO): POV-Ray's files in both programs, whole passes bit for bit, and who
// shares one.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "tests/support/pass_kills.h"
#include "tests/support/render.h"
#include "tools/common/child.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKeptRoom = R"(
camera { location <0, 1.2, -4.5> look_at <0, 0.9, 0> angle 50 }
light_source { <1.5, 3, -2> rgb 0.6 }
background { rgb <0.3, 0.4, 0.6> }
#default { finish { ambient 0.3 diffuse 0.7 } }
plane { y, 0 pigment { rgb <0.8, 0.8, 0.7> } }
plane { -z, -2 pigment { rgb <0.7, 0.3, 0.2> } }
sphere { <0.2, 0.5, 0.3>, 0.5 pigment { rgb 0.9 } }
sphere { <1.5, 0.6, 1>, 0.4 pigment { rgb <1, 0.8, 0.4> } finish { emission 2 diffuse 0 } }
)";

std::string kept_room(const std::string& settings) {
  return "#version 3.7; global_settings { assumed_gamma 1 radiosity { " + settings + " } }" +
         kKeptRoom;
}

class ImageRadiosityFiles : public ::testing::Test {
 protected:
  void SetUp() override { write("a.pov", kept_room("count 40 error_bound 0.6 recursion_limit 2")); }
  void write(const std::string& name, const std::string& text) {
    tool::write_text(folder / name, text);
  }
  tool::RunResult run(std::vector<std::string> words) {
    words.insert(words.begin(), {"-V", "-A", "+W72", "+H54"});
    return run_lentray(words, folder.path());
  }
  /// A picture of a.pov.
  StoredImage ours(std::vector<std::string> words) {
    words.insert(words.begin(), {"+Ia.pov", "+Oours.png"});
    const tool::RunResult result = run(words);
    EXPECT_EQ(result.status, 0) << result.output;
    said = result.output;
    return core::read_image(folder / "ours.png");
  }
  StoredImage stock(std::vector<std::string> words) {
    words.insert(words.begin(), {"povray", "+Ia.pov", "+Ostock.png", "-V", "-A", "-D", "-GA",
                                 "+W72", "+H54", "+WT1"});
    const tool::RunResult result = tool::run_program(words, folder.path());
    EXPECT_EQ(result.status, 0) << result.output;
    return core::read_image(folder / "stock.png");
  }
  bool is_there(const std::string& name) const { return fs::exists(folder / name); }

  const tool::TemporaryFolder folder;
  std::string said;
};

TEST_F(ImageRadiosityFiles, StocksFileLightsBothAlike) {
  stock({"+RFO"});
  ASSERT_TRUE(is_there("object.rca"));
  const StoredImage reference = stock({"+RFI"});
  // Its last line counts in neither.
  EXPECT_TRUE(reaches(ours({"+RFI"}), reference, Grade::exact));
  EXPECT_NE(said.find("besides those in 'object.rca'"), std::string::npos) << said;
  EXPECT_FALSE(same_bits(ours({}), reference)) << "the file makes no difference";
}

TEST_F(ImageRadiosityFiles, OursLightsBothAlike) {
  ours({"+RFO", "+RFmine.rca"});
  const StoredImage reference = stock({"+RFI", "+RFmine.rca"});
  EXPECT_TRUE(reaches(ours({"+RFI", "+RFmine.rca"}), reference, Grade::exact));
}

TEST_F(ImageRadiosityFiles, PhotonsAloneLeaveNone) {
  write("a.pov",
        std::string("#version 3.7; global_settings { assumed_gamma 1 photons { count 200 } }") +
            kKeptRoom +
            "sphere { <-0.8, 0.5, 0>, 0.4 pigment { rgbt 1 } interior { ior 1.5 }"
            " photons { target refraction on } }");
  ours({"+RFO", "+RFI"});
  EXPECT_FALSE(is_there("object.rca"));
}

TEST_F(ImageRadiosityFiles, OursIsStocks) {
  stock({"+RFO", "+RFstock.rca"});
  ours({"+RFO", "+RFours.rca"});
  const auto lines = [&](const char* name) {
    std::istringstream in(tool::read_text(folder / name));
    std::vector<std::string> out;
    for (std::string line; std::getline(in, line);) {
      if (!line.empty()) out.push_back(line);
    }
    std::ranges::sort(out);
    return out;
  };
  const auto first = lines("stock.rca"), second = lines("ours.rca");
  ASSERT_EQ(first.size(), second.size());
  std::size_t others = 0;
  for (const std::string& line : second) others += std::ranges::binary_search(first, line) ? 0 : 1;
  EXPECT_LE(others, first.size() / 50) << "of " << first.size();
}

TEST_F(ImageRadiosityFiles, WhatIsNewIsAdded) {
  ours({"+RFO"});
  const std::string before = tool::read_text(folder / "object.rca");
  ours({"+RFI", "+RFO", "+W90", "+H70"});
  const std::string after = tool::read_text(folder / "object.rca");
  EXPECT_TRUE(after.starts_with(before));
  EXPECT_GT(after.size(), before.size());
  ours({"+RFO"});
  EXPECT_EQ(tool::read_text(folder / "object.rca"), before) << "without +RFI it is written anew";
}

TEST_F(ImageRadiosityFiles, AWholePassGivesItsBits) {
  const StoredImage made = ours({"+WT2"});
  EXPECT_TRUE(same_bits(ours({"+RFO", "+RFa.light", "+WT1"}), made));
  for (const std::vector<std::string>& way :
       {std::vector<std::string>{"+WT1"},
        {"+WT2", "Pixel_Order=hilbert"},
        {"+WT5", "Band_Height=8", "Shadow_Cache=tree"},
        {"Pixel_Order=columns", "Accelerator=grid"},
        {"+WT2", "Pixel_Order=tiles", "Band_Height=1", "-UL"}}) {
    std::vector<std::string> words{"+RFI", "+RFa.light", "Statistics_File=a.json"};
    words.insert(words.end(), way.begin(), way.end());
    EXPECT_TRUE(same_bits(ours(words), made)) << way[0];
    const auto all = nlohmann::json::parse(tool::read_text(folder / "a.json"));
    EXPECT_TRUE(all.at("radiosity").at("is_kept_pass"));
    EXPECT_FALSE(all.contains("passes") && !all.at("passes").empty());
  }
  // With antialiasing pixels gather for themselves.
  EXPECT_TRUE(same_bits(ours({"+RFI", "+RFa.light", "+A0.1"}), ours({"+A0.1"})));
}

TEST_F(ImageRadiosityFiles, PartsOfAPictureShareIt) {
  const StoredImage made = ours({});
  ours({"+SR1", "+ER20", "+RFI", "+RFO", "+RFkept/"});
  EXPECT_TRUE(same_bits(ours({"+RFI", "+RFkept/", "Statistics_File=a.json"}), made));
  EXPECT_TRUE(
      nlohmann::json::parse(tool::read_text(folder / "a.json")).at("radiosity").at("is_kept_pass"));
}

TEST_F(ImageRadiosityFiles, ASheetAndItsViewsShareIt) {
  const std::vector<std::string> sheet{"+Ia.pov", "Lenticular=On", "Lens_Pixels=3",
                                       "+W60",    "+H40",          "+RFI",
                                       "+RFO",    "+RFkept/",      "Statistics_File=a.json"};
  const auto is_kept = [&](std::vector<std::string> words, const char* json) {
    words.insert(words.begin(), sheet.begin(), sheet.end());
    const tool::RunResult result = run(words);
    EXPECT_EQ(result.status, 0) << result.output;
    return nlohmann::json::parse(tool::read_text(folder / json))
        .at("radiosity")
        .at("is_kept_pass")
        .get<bool>();
  };
  EXPECT_FALSE(is_kept({"+Osheet.png"}, "a.json"));
  EXPECT_TRUE(is_kept({"+Oagain.png"}, "a.json"));
  EXPECT_TRUE(is_kept({"+Oview.png", "View=1"}, "a.json"));
  EXPECT_TRUE(is_kept({"+Oall.png", "Views=3", "View_Size=40x30"}, "a0.json"));
  EXPECT_TRUE(
      same_bits(core::read_image(folder / "sheet.png"), core::read_image(folder / "again.png")));
  EXPECT_FALSE(is_kept({"+Oother.png", "Lens_Pixels=4"}, "a.json"));
}

TEST_F(ImageRadiosityFiles, AnotherSceneIsRefused) {
  ours({"+RFO", "+RFa.light"});
  const std::string good = tool::read_text(folder / "a.light");
  write("a.pov", kept_room("count 41"));
  const tool::RunResult result = run({"+Ia.pov", "+Ob.png", "+RFI", "+RFO", "+RFa.light"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.output.find("'a.light' cannot be used: the scene has changed"),
            std::string::npos)
      << result.output;
  EXPECT_FALSE(is_there("b.png"));
  EXPECT_EQ(tool::read_text(folder / "a.light"), good);
  const tool::RunResult folders = run({"+Ia.pov", "+Ob.png", "+RFI", "+RFO", "+RFkept/"});
  EXPECT_EQ(folders.status, 0) << folders.output;
}

TEST_F(ImageRadiosityFiles, NamesAndPlaces) {
  ours({"+RFO", "+RFobject.rca"});  // begins as the switch +RFO does
  EXPECT_TRUE(is_there("object.rca"));
  ours({"Radiosity_To_File=on", "Radiosity_File_Name=ini.rca"});
  EXPECT_TRUE(is_there("ini.rca"));
  EXPECT_NE((ours({"+RFI", "+RFnone.rca"}), said).find("there is no 'none.rca'"),
            std::string::npos);
  const auto refuses = [&](std::vector<std::string> words, const char* text) {
    words.insert(words.begin(), {"+Ia.pov", "+Ob.png"});
    const tool::RunResult result = run(words);
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.output.find(text), std::string::npos) << result.output;
  };
  refuses({"+RFO", "+RF"}, "the name of a file or folder is expected");
  refuses({"+RFO", "+RFa.pov"}, "a.pov");
  refuses({"+RFO", "+RFmissing/a.light"}, "missing/a.light");
  refuses({"Radiosity_Samples=20"}, "Radiosity_Samples=20");
  EXPECT_EQ(tool::read_text(folder / "a.pov").find("#version"), 0u);
}

TEST_F(ImageRadiosityFiles, ExplainTellsThePlan) {
  const std::string text = run({"+Ia.pov", "--explain"}).output;
  for (const char* part : {"Radiosity\n", "count 40, 1600",
                           "gathers with 40, 20 rays, bounce by bounce", "then every pixel"})
    EXPECT_NE(text.find(part), std::string::npos) << part << text;
}

TEST_F(ImageRadiosityFiles, StocksFormTellsSamplesAsStockDoes) {
  const auto numbers = [](const std::string& text) {
    std::string out;
    std::istringstream in(text.substr(std::min(text.find("Radiosity samples"), text.size())));
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with("  Total") || line.starts_with("  Final") || line.starts_with("  1 ") ||
          line.find("calculated") != line.npos || line.find("reused") != line.npos ||
          line.find("rays shot") != line.npos)
        out += line + "\n";
    }
    return out;
  };
  const std::string by_stock =
      tool::run_program({"povray", "+Ia.pov", "-F", "-D", "-V", "-A", "+W72", "+H54", "+WT1"},
                        folder.path())
          .output;
  const std::string by_us = run({"+Ia.pov", "-F", "Stock_Messages=On", "+WT1"}).output;
  EXPECT_NE(numbers(by_stock), "");
  EXPECT_EQ(numbers(by_us), numbers(by_stock));
}

/// A batch that was stopped goes on with the views that it lacks, and with their radiosity.
TEST_F(ImageRadiosityFiles, RunsOfABatchShareIt) {
  fs::create_directory(folder / "in");
  fs::rename(folder / "a.pov", folder / "in/a.pov");
  const std::vector<std::string> command{program("lentray-batch").string(),
                                         "in",
                                         "--out",
                                         "out",
                                         "--jobs",
                                         "1",
                                         "-A",
                                         "Lenticular=On",
                                         "+W240",
                                         "+H160",
                                         "Lens_Pixels=8",
                                         "Views=8",
                                         "View_Size=240x160"};
  {
    tool::Launch launch;
    launch.command = command;
    launch.folder = folder.path();
    launch.log = folder / "log";
    tool::Child child(launch);
    while (!child.ended() && !is_there("out/a1.png"))
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    child.ask_to_stop();
    while (!child.ended()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_FALSE(is_there("out/a7.png")) << "it was over too soon";
  EXPECT_FALSE(fs::is_empty(folder / "out/.lentray-batch/radiosity"));
  const tool::RunResult rest = tool::run_program(command, folder.path());
  EXPECT_EQ(rest.status, 0) << rest.output;
  std::size_t kept = 0;
  for (const auto& file : fs::directory_iterator(folder / "out/.lentray-batch/runs")) {
    const std::string name = file.path().filename().string();
    if (!name.ends_with("7.statistics")) continue;
    ++kept;
    EXPECT_TRUE(
        nlohmann::json::parse(tool::read_text(file.path())).at("radiosity").at("is_kept_pass"));
  }
  EXPECT_EQ(kept, 1u);
  EXPECT_FALSE(is_there("out/.lentray-batch/radiosity"));
}

/// What a run has kept is there a second after its start at the earliest, so the pass takes a while.
TEST(SlowRadiosityGoingOn, KilledTwentyTimesItHasTheBitsOfOneRun) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "a.pov",
                   kept_room("count 1600 error_bound 0.08 recursion_limit 3 nearest_count 10"));
  expect_bits_after_kills("160", "120", folder.path());
}

}  // namespace
}  // namespace lentray::test
