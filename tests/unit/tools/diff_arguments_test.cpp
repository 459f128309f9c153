// What of a command line goes to lentray, and what to stock; and the report's figures.
#include "tools/lentray-diff/arguments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "parser/options/ini.h"
#include "tools/common/process.h"
#include "tools/lentray-diff/report.h"

namespace lentray::diff {
namespace {

namespace fs = std::filesystem;
using DiffArgumentsWords = std::vector<std::string>;

class UnitDiffArguments : public ::testing::Test {
 protected:
  void SetUp() override { tool::write_text(m_folder / "a.pov", "#version 3.7;\n"); }
  Arguments parse(DiffArgumentsWords words) {
    return parse_arguments(with_scene(std::move(words)));
  }
  DiffArgumentsWords with_scene(DiffArgumentsWords words) const {
    words.insert(words.begin(), (m_folder / "a.pov").string());
    return words;
  }
  tool::TemporaryFolder m_folder;
};

TEST_F(UnitDiffArguments, SceneOptionsReachBoth) {
  const Arguments a = parse({"Declare=Size=2", "+Q5", "+K0.5", "File_Gamma=1.0", "+Linc", "+W30"});
  EXPECT_EQ(a.for_lentray,
            with_scene({"Declare=Size=2", "+Q5", "+K0.5", "File_Gamma=1.0", "+Linc", "+W30"}));
  EXPECT_EQ(a.stock.arguments,
            (DiffArgumentsWords{"Declare=Size=2", "+Q5", "+K0.5", "File_Gamma=1.0"}));
  ASSERT_FALSE(a.stock.library_paths.empty());
  EXPECT_EQ(a.stock.library_paths.back(), fs::current_path() / "inc");
}

TEST_F(UnitDiffArguments, LensOptionsReachLentrayAlone) {
  const Arguments a = parse({"Lenticular=On", "Lens_Pixels=7.37", "View=3"});
  EXPECT_EQ(a.for_lentray, with_scene({"Lenticular=On", "Lens_Pixels=7.37", "View=3"}));
  EXPECT_TRUE(a.stock.arguments.empty());
  EXPECT_EQ(a.options.view, 3u);
}

TEST_F(UnitDiffArguments, FramesReachBoth) {
  const DiffArgumentsWords frames{"+KFI1", "+KFF9", "Final_Clock=2", "+SF3", "+EF3"};
  EXPECT_EQ(parse(frames).stock.arguments, frames);
  EXPECT_EQ(parse(frames).for_lentray, with_scene(frames));
}

TEST_F(UnitDiffArguments, PicturesThatAreThereNeedTheirStatistics) {
  const Arguments a = parse({"--ours", "a.png", "--statistics=a.json"});
  EXPECT_EQ(a.ours, "a.png");
  EXPECT_EQ(a.statistics, "a.json");
  EXPECT_THROW(parse({"--ours", "a.png"}), parser::OptionError);
  EXPECT_TRUE(parse({"--stock-alone"}).stock_alone);
}

TEST_F(UnitDiffArguments, OutputNamesThePictures) {
  const Arguments a = parse({"+Oout/b.png", "Output_File_Name=c.png"});
  EXPECT_EQ(a.prefix, "c");
  EXPECT_EQ(parse({"+Oout/b.png", "--output", "d"}).prefix, "d");
  EXPECT_EQ(parse({}).prefix, "a-diff");
}

TEST_F(UnitDiffArguments, IniFilesAreReadForStock) {
  tool::write_text(m_folder / "o.ini",
                   "; comment\nLenticular=On\nDeclare=Size=3\n[small]\nQuality=4\n");
  const std::string ini = (m_folder / "o.ini").string();
  EXPECT_EQ(parse({ini}).stock.arguments, (DiffArgumentsWords{"Declare=Size=3"}));
  EXPECT_EQ(parse({ini + "[small]"}).stock.arguments,
            (DiffArgumentsWords{"Declare=Size=3", "Quality=4"}));
  EXPECT_EQ(parse({ini}).for_lentray, with_scene({ini}));
}

TEST_F(UnitDiffArguments, ScenesIniNamesNeitherSceneNorOutput) {
  tool::write_text(m_folder / "s.ini",
                   "Input_File_Name=/etc/passwd\nOutput_File_Name=x.png\nQuality=4\n+Linc\n");
  for (const DiffArgumentsWords& more :
       {DiffArgumentsWords{}, DiffArgumentsWords{"Restrict_IO=On"}}) {
    DiffArgumentsWords words = more;
    words.insert(words.end(), {"--scene-ini", (m_folder / "s.ini").string()});
    const Arguments a = parse(words);
    EXPECT_EQ(a.scene, m_folder / "a.pov");
    EXPECT_EQ(a.prefix, "a-diff");
    EXPECT_EQ(a.stock.arguments, (DiffArgumentsWords{"Quality=4"}));
    ASSERT_FALSE(a.stock.library_paths.empty());
    EXPECT_EQ(a.stock.library_paths.back(), fs::current_path() / "inc");
  }
  tool::write_text(m_folder / "up.ini", "../x.ini\n");
  EXPECT_THROW(parse({"--scene-ini", (m_folder / "up.ini").string()}), parser::OptionError);
}

TEST_F(UnitDiffArguments, OwnOptions) {
  const Arguments a =
      parse({"--grade", "exact", "--json=x.json", "--threads", "3", "--bits=16", "--noise", "off"});
  EXPECT_EQ(a.noise, AskNoise::never);
  EXPECT_EQ(parse({}).noise, AskNoise::where_it_is);
  EXPECT_EQ(a.asked, core::Grade::exact);
  EXPECT_EQ(a.json, "x.json");
  EXPECT_EQ(a.stock.processes, 3);
  EXPECT_EQ(a.stock.bits, 16);
  EXPECT_EQ(a.for_lentray, with_scene({}));
}

TEST_F(UnitDiffArguments, TwoPictures) {
  const Arguments a = parse_arguments({"a.png", "b.tif", "Lens_Pixels=15"});
  EXPECT_EQ(a.pictures.size(), 2u);
  EXPECT_EQ(a.options.lens.pixels, 15.0);
}

TEST_F(UnitDiffArguments, Refused) {
  EXPECT_THROW(parse({"--grade", "good"}), parser::OptionError);
  EXPECT_THROW(parse({"--grade"}), parser::OptionError);
  EXPECT_THROW(parse({"--noise", "loud"}), parser::OptionError);
  EXPECT_THROW(parse({"--nonsense"}), parser::OptionError);
  EXPECT_THROW(parse({"other.pov"}), parser::OptionError);
  EXPECT_THROW(parse({"b.png"}), parser::OptionError);
  EXPECT_THROW(parse_arguments({"a.png"}), parser::OptionError);
  EXPECT_THROW(parse_arguments({"a.png", "b.png", "Lens_Pixels=none"}), parser::OptionError);
  EXPECT_THROW(parse_arguments({"+W20"}), parser::OptionError);
  EXPECT_THROW(parse_arguments({(m_folder / "none.pov").string()}), parser::OptionError);
}

core::StoredImage flat(std::uint32_t width, std::uint32_t height, float value) {
  core::StoredImage image;
  image.width = width;
  image.height = height;
  image.channels = 3;
  image.samples.assign(std::size_t{3} * width * height, value);
  return image;
}

TEST(UnitDiffReport, Pictures) {
  const core::StoredImage a = flat(6, 2, 100);
  core::StoredImage b = a;
  b.at(2, 1, 0) = 105;
  b.at(3, 1, 2) = 0;
  const core::StoredImage heat = heat_map(a, b);
  EXPECT_EQ(heat.at(0, 0, 0), 0.0f);
  EXPECT_EQ(heat.at(2, 1, 0), 255.0f);  // between yellow and red
  EXPECT_EQ(heat.at(3, 1, 1), 255.0f);  // white
  const core::StoredImage side = side_by_side(a, b);
  EXPECT_EQ(side.width, 3u * 6 + 8);
  EXPECT_EQ(side.at(2 + 10, 1, 0), 105.0f);
  EXPECT_EQ(side.at(2 + 20, 1, 0), 40.0f);
  EXPECT_EQ(side.at(3 + 20, 1, 2), 255.0f);
}

TEST(UnitDiffReport, TableAndJson) {
  const core::StoredImage a = flat(40, 4, 100);
  core::StoredImage b = a;
  b.at(17, 2, 0) = 110;
  const core::LensComparison c = core::compare_lenses(a, b, 5);
  const std::string text = table(c, false);
  EXPECT_NE(text.find("whole"), std::string::npos);
  EXPECT_NE(text.find("view 4"), std::string::npos);
  EXPECT_NE(text.find("8 lenses:"), std::string::npos);
  // The hurt lens comes first among the worst.
  EXPECT_EQ(text.find("lens 3"), text.find("lens "));
  const std::string every = table(c, true);
  EXPECT_LT(every.find("lens 0"), every.find("lens 3"));
  const nlohmann::json json = to_json(c);
  EXPECT_EQ(json["lenses"].size(), 8u);
  EXPECT_EQ(json["lenses"][3]["largest"], 10.0);
  EXPECT_TRUE(json["lenses"][2]["psnr"].is_null());
  EXPECT_EQ(json["views"][2]["beyond_1"], 1.0 / 32);
}

}  // namespace
}  // namespace lentray::diff
