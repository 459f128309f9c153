#include "parser/options/create_ini.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tools/common/process.h"

namespace lentray::parser {
namespace {

RenderOptions read(const std::vector<std::string>& arguments) {
  return read_options(arguments, {});
}

TEST(UnitParserCreateIni, AsksForTheSameRunAgain) {
  const std::vector<std::vector<std::string>> runs = {
      {"a.pov"},
      {"+Isome where/a b.pov",
       "+W641",
       "+H77",
       "+A0.07",
       "+AM2",
       "+R5",
       "-J",
       "+AG1.8",
       "Declare=X=3.25",
       "Declare=T=\"text\"",
       "+L/tmp/a folder",
       "+SC0.25",
       "+EC100",
       "+SR3",
       "+ER0.5",
       "+Q7",
       "+UA",
       "+WT3",
       "+Oout/of here.png",
       "+FN16",
       "File_Gamma=1.7",
       "+THB3",
       "Grayscale_Output=on",
       "Compression=50",
       "Display_Gamma=1.8",
       "+C",
       "-V",
       "+WL5",
       "-GS",
       "+GFfatal.txt"},
      {"a.pov", "+K0.1", "+MV3.5"},
      {"a.pov", "Stock_Messages=On"},
      {"a.pov", "+KFI3", "+KFF12", "+KI0.5", "+KF2", "+SF0.5", "+EF11", "+STP2", "+KC"},
      {"a.pov", "Lenticular=On", "Lens_Model=thick", "Lens_Rays=5"},
      {"a.pov", "Lenticular=On", "Depth_Budget=1.25"},
      {"a.pov", "Lenticular=On", "Depth_Budget=0.5mm"},
      {"a.pov", "Lenticular=On", "Lens_Slant=-1/3"},
      {"a.pov", "Lenticular=On", "Lens_Direction=across"},
      {"a.pov", "Lenticular=On", "Lens_Direction=across", "Lens_Direction=up"},
      {"a.pov", "Lenticular=On", "Lens_LPI=40", "Lens_Direction=across", "Sheet_Width=10cm",
       "Sheet_Height=70", "Print_DPI=1440x720", "View_Distance=40cm"},
      {"a.pov", "Lenticular=On", "Print_LPI=39.8", "View_Distance=40cm"},
      {"a.pov", "Lenticular=On", "Lens_Sheet=75lpi-0.457mm", "Sheet_Width=10cm", "Sheet_Height=70",
       "Print_DPI=1440x720", "View_Distance=40cm", "Lens_Model=auto", "Lens_Tolerance=0.5"},
      {"a.pov", "Lenticular=On", "Lens_LPI=40", "Lens_Angle=50", "Sheet_Width=100",
       "Sheet_Height=70", "+W2000", "+H77"},
      {"a.pov", "Lenticular=On", "Sheet_Width=100", "Sheet_Height=70"},
      {"a.pov", "Lenticular=On", "Lens_Sheet=60", "Sheet_Size=A6-landscape", "Print_DPI=600"},
      {"a.pov",
       "Lenticular=On",
       "Lens_Pitch=0.7",
       "Lens_Focal_Length=2.1",
       "Lens_IOR=1.56",
       "Lens_Pixels=12.4",
       "View_Distance=400",
       "Sheet_Distance=7",
       "Lens_Model=pinhole",
       "View=3",
       "Antialias_Angle=4",
       "Antialias_Grid=5",
       "Max_Trace_Level=9",
       "Adc_Bailout=0.01",
       "Area_Light_Samples=6",
       "Area_Light_Adaptive=off",
       "Blur_Samples=11",
       "Radiosity_Count=50",
       "Radiosity_Error_Bound=0.25",
       "Radiosity_Nearest_Count=7",
       "Radiosity_Recursion_Limit=3",
       "Photon_Count=7000",
       "Photon_Gather=60",
       "Subsurface_Samples=30",
       "Pixel_Order=strips(4,32)",
       "Shadow_Cache=tree",
       "Accelerator=grid",
       "-UL",
       "Specialised_Paths=Off",
       "Max_Memory=100M",
       "Max_Pixels=9M",
       "Max_Written=2G",
       "Max_Files=7",
       "Max_Time=90",
       "Band_Height=7",
       "Statistics_File=s.json",
       "Count_Tests=Off",
       "Dependencies_File=d.json",
       "View_Cameras=v.json",
       "Scene_Writes=memory",
       "+RFI",
       "+RFO",
       "+RFkept/",
       "Radiosity_Samples=500",
       "Restrict_IO=On"}};
  for (const auto& arguments : runs) {
    const tool::TemporaryFolder folder;
    const std::string text = ini_text(read(arguments)), path = (folder / "again.ini").string();
    std::ofstream(path) << text;
    const RenderOptions again = read({path});
    EXPECT_EQ(ini_text(again), text);
    EXPECT_EQ(again.width, read(arguments).width);
    EXPECT_EQ(again.height, read(arguments).height);
    EXPECT_TRUE(again.warnings.empty()) << again.warnings.front();
  }
}

/// What names may be of that an INI file reads in its own way.
const std::vector<std::string> kOddNames = {"a;b.pov",
                                            "a#b.pov",
                                            " a.pov ",
                                            "'a'.pov",
                                            "\"a\"",
                                            "it's.pov",
                                            "a\"b.pov",
                                            "a\";b.pov",
                                            "a';b.pov",
                                            "a\"'.pov",
                                            "[a].pov",
                                            "a[b]",
                                            "a=b.pov",
                                            "+W9.pov",
                                            "-x",
                                            "a\\b.pov",
                                            "\ta.pov",
                                            "%s.pov",
                                            "\"",
                                            "'",
                                            "\"\"",
                                            "''",
                                            "\"'",
                                            "' \"",
                                            "a b\" +W9",
                                            "caf\xc3\xa9.pov",
                                            "a\xff.pov",
                                            ";",
                                            "#",
                                            "\xef\xbb\xbf.pov",
                                            "it's \"x;y\"",
                                            "\"a;b\"",
                                            "'a#b'",
                                            "a' ;'b",
                                            "a\" #\"b"};

/// The name comes back, or is refused: never another one.
TEST(UnitParserCreateIni, OddNamesComeBackOrAreRefused) {
  std::size_t held = 0;
  for (const std::string& name : kOddNames) {
    RenderOptions options = read({"a.pov"});
    options.input = options.output = options.include_header = name;
    options.library_paths = {name};
    options.declares = {{"Text", name}};
    options.commands[0].text = name;
    std::string text;
    try {
      text = ini_text(options);
    } catch (const OptionError& error) {
      EXPECT_NE(std::string(error.what()).find("cannot hold"), std::string::npos);
      continue;
    }
    ++held;
    const tool::TemporaryFolder folder;
    const std::string path = (folder / "again.ini").string();
    std::ofstream(path) << text;
    const RenderOptions again = read({path});
    EXPECT_EQ(again.input, name) << text;
    EXPECT_EQ(again.output, name) << text;
    EXPECT_EQ(again.include_header, name) << text;
    EXPECT_EQ(again.library_paths, options.library_paths) << text;
    EXPECT_EQ(again.declares, options.declares) << text;
    EXPECT_EQ(again.commands[0].text, name) << text;
    EXPECT_EQ(ini_text(again), text);
  }
  EXPECT_GE(held, kOddNames.size() - 6);
}

TEST(UnitParserCreateIni, LinesOfTheirOwnAreRefused) {
  for (const std::string name : {"a\nAll_File=x", "a\r", "\n", "a\x1b[1m", "a\f+W9"}) {
    RenderOptions options = read({"a.pov"});
    options.input = name;
    EXPECT_THROW(ini_text(options), OptionError) << name;
    options.input = "a.pov";
    options.declares = {{"Text", name}};
    EXPECT_THROW(ini_text(options), OptionError) << name;
  }
}

TEST(UnitParserCreateIni, PlaceOfTheFile) {
  EXPECT_EQ(ini_path(read({"x/a.pov"})), "");
  EXPECT_EQ(ini_path(read({"x/a.pov", "Create_Ini=true"})), "a.ini");
  EXPECT_EQ(ini_path(read({"x/a.pov", "+GI"})), "a.ini");
  EXPECT_EQ(ini_path(read({"x/a.pov", "+GIrerun.ini"})), "rerun.ini");
  EXPECT_EQ(ini_path(read({"x/a.pov", "Create_Ini=rerun.ini", "Create_Ini=off"})), "");
}

TEST(UnitParserCreateIni, WorkIsNoPartOfThePicture) {
  EXPECT_EQ(picture_lines(read({"a.pov", "+WT1", "-V", "Pixel_Order=rows", "+Ox.png", "+C"})),
            picture_lines(read({"b.pov", "+WT7", "Shadow_Cache=off"})));
  EXPECT_NE(picture_lines(read({"a.pov", "+A"})), picture_lines(read({"a.pov"})));
}

}  // namespace
}  // namespace lentray::parser
