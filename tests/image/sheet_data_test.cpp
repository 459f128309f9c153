// Wrong data of a sheet, as users give them in an INI file: each message says what is wrong, where it was said, and what
// to do; an older picture stays. Data that are only odd make a picture and a warning.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/base/joined.h"
#include "tests/support/render.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

/// Each line of `ini` stands in sheet.ini; `parts` are in the message.
struct SheetData {
  std::vector<std::string> ini, parts;
  int status = 1;
};

const SheetData kWrongSheets[] = {
    {{"Sheet_Width=100"}, {"Sheet_Width needs Sheet_Height too", "sheet.ini:1", "Sheet_Size=A5"}},
    {{"Sheet_Size=B99"}, {"sheet.ini:1: option Sheet_Size=B99", "A4, A5", "or 200x100mm"}},
    {{"Lens_Sheet=unknown"},
     {"no lens sheet 'unknown'", "sheet.ini:1", "there are 10lpi, 15lpi", "Lens_Sheet=list"}},
    {{"Lens_Sheet=61"},
     {"no lens sheet '61'", "sheet.ini:1", "60lpi is the nearest", "Lens_LPI=61 takes any"}},
    {{"Sheet_Size=A6", "Print_DPI=0"}, {"sheet.ini:2: option Print_DPI=0", "such as 600"}},
    {{"Print_LPI=60.2", "Sheet_Size=A6"},
     {"Print_LPI needs a View_Distance", "sheet.ini:1", "give the one"}},
    {{"Lens_LPI=60", "Print_LPI=60.2", "View_Distance=40cm"},
     {"Print_LPI gives the lenses' pitch", "Print_LPI=60.2 in sheet.ini:2", "give one of them"}},
    {{"Lens_LPI=60", "Lens_Radius=0.1mm"},
     {"radius of 0.1 mm", "sheet.ini:2", "give a radius of at least 0.2117 mm"}},
    {{"Lens_LPI=60", "Lens_Pixels=15", "Sheet_Size=A6", "Print_DPI=600", "View_Distance=inf"},
     {"15 pixels a lens and 600 pixels an inch (10 pixels a lens)", "sheet.ini:2", "sheet.ini:4",
      "give one of them"}},
    {{"View_Distance=-3"}, {"sheet.ini:1: option View_Distance=-3", "mm, 0 or inf"}},
    {{"Sheet_Distance=4cm"},
     {"sheet.ini:1: option Sheet_Distance=4cm", "scene's own units", "a plain number"}},
    {{"Sheet_Size=100x75ft"}, {"sheet.ini:1", "unknown unit 'ft'", "mm, cm, m, um, in"}},
    {{"Lens_Slant=85"}, {"sheet.ini:1: option Lens_Slant=85", "-80 to 80 degrees"}},
    {{"Depth_Budget=0"}, {"sheet.ini:1: option Depth_Budget=0", "greater than 0", "pixels a view"}},
    {{"Lens_LPI=60", "Sheet_Size=A6", "Print_DPI=2", "View_Distance=inf"},
     {"at 2 pixels an inch a lens has 0.03333 pixels", "Print_DPI=2 in sheet.ini:3",
      "at least 60 dpi, or at most 2 lpi"}},
    {{"Lens_Sheet=60", "Sheet_Size=3x3mm", "Print_DPI=600", "View_Distance=inf"},
     {"warning: the sheet has 7.1 lenses", "a Sheet_Width of 4.24 mm", "least that shows"},
     0},
    {{"Lens_Sheet=60", "Sheet_Size=20x5mm", "Print_DPI=200", "View_Distance=inf"},
     {"warning: a lens has 3.333 pixels", "at least 360 dpi, or at most 33.3 lpi"},
     0},
    {{"Lens_LPI=4", "Sheet_Width=100", "Sheet_Height=5", "Print_DPI=60", "View_Distance=inf"},
     {"warning: the lenses are 6.35 mm wide", "Lens_LPI is lenses an inch"},
     0},
    {{"Lens_LPI=10", "Sheet_Width=300cm", "Sheet_Height=5", "Print_DPI=60", "View_Distance=inf"},
     {"warning: the sheet is 3 m wide", "such as 300mm"},
     0},
};

class ErrorSheetData : public ::testing::TestWithParam<SheetData> {};

TEST_P(ErrorSheetData, SayWhatToDo) {
  const SheetData& data = GetParam();
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "s.pov",
                   "#version 3.7; global_settings { assumed_gamma 1 }\n"
                   "camera { location -9*z look_at 0 }\nsphere { 0, 1 pigment { rgb 1 } }\n");
  tool::write_text(folder / "s.png", "an older picture");
  tool::write_text(folder / "sheet.ini", core::joined(data.ini, "\n") + "\n");
  const tool::RunResult run =
      run_lentray({"s.pov", "sheet.ini", "Lenticular=On", "-D", "-V"}, folder.path());
  EXPECT_EQ(run.status, data.status) << run.output;
  for (const std::string& part : data.parts)
    EXPECT_NE(run.output.find(part), std::string::npos) << part << "\nis not in\n" << run.output;
  const bool is_kept = tool::read_text(folder / "s.png") == "an older picture";
  EXPECT_EQ(is_kept, data.status != 0);
}

INSTANTIATE_TEST_SUITE_P(All, ErrorSheetData, ::testing::ValuesIn(kWrongSheets));

}  // namespace
}  // namespace lentray::test
