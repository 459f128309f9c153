// Options of lens sheets: units of lengths, sizes that become columns and rows, lens data and sheets by
// name, and every message.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "parser/options/lens_sheets.h"
#include "parser/options/options.h"
#include "tools/common/process.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;

/// A folder for INI files that is the current one while a test runs.
class UnitSheetOptions : public ::testing::Test {
 protected:
  void SetUp() override {
    m_before = fs::current_path();
    fs::current_path(m_folder.path());
  }
  void TearDown() override { fs::current_path(m_before); }
  static RenderOptions read(const std::vector<std::string>& arguments,
                            OptionSources sources = without_sheets()) {
    return read_options(arguments, sources);
  }
  /// The message has that part, and no nan or inf but what the user wrote.
  static void expect_message(const std::vector<std::string>& arguments, const std::string& part) {
    std::string text;
    try {
      (void)read(arguments);
    } catch (const OptionError& error) {
      text = error.what();
    }
    EXPECT_NE(text.find(part), std::string::npos) << "got: " << text << "\nwanted: " << part;
    if (const std::size_t at = text.find(arguments.back()); at != std::string::npos) {
      text.erase(at, arguments.back().size());
    }
    if (const std::size_t at = text.find("0 or inf is"); at != std::string::npos) text.erase(at, 8);
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_EQ(text.find("inf"), std::string::npos) << text;
  }

 private:
  static OptionSources without_sheets() {
    OptionSources sources;
    sources.lens_sheet_files.clear();
    return sources;
  }
  tool::TemporaryFolder m_folder;
  fs::path m_before;
};
using ErrorSheetOptions = UnitSheetOptions;

TEST_F(UnitSheetOptions, LensData) {
  const RenderOptions shop = read({"Lens_Thickness=0.9", "Lens_Radius=0.34", "Lens_Angle=54",
                                   "Lens_Tolerance=0.5", "Lens_Model=pinhole", "Lens_Model=auto"});
  EXPECT_EQ(shop.lens.thickness, 0.9);
  EXPECT_EQ(shop.lens.radius, 0.34);
  EXPECT_EQ(shop.lens.angle, 54.0);
  EXPECT_EQ(shop.lens.tolerance, 0.5);
  EXPECT_TRUE(shop.lens.automatic_model);
  EXPECT_FALSE(shop.lens.model);
  EXPECT_FALSE(read({"Lens_Model=auto", "Lens_Model=thick"}).lens.automatic_model);
}

TEST_F(UnitSheetOptions, ADepthBudgetIsInPixelsOrOnThePrint) {
  EXPECT_FALSE(read({}).lens.depth_budget);
  for (const auto& [text, value, is_mm] : std::vector<std::tuple<const char*, double, bool>>{
           {"1.5", 1.5, false}, {"2px", 2.0, false}, {"1 mm", 1.0, true}, {"0.1cm", 1.0, true}}) {
    const auto budget = read({std::string("Depth_Budget=") + text}).lens.depth_budget;
    ASSERT_TRUE(budget) << text;
    EXPECT_NEAR(budget->value, value, 1e-12) << text;
    EXPECT_EQ(budget->is_mm, is_mm) << text;
  }
}

TEST_F(ErrorSheetOptions, DepthBudgets) {
  for (const char* value : {"0", "-1", "0mm", "-2mm"}) {
    expect_message({std::string("Depth_Budget=") + value},
                   "a parallax greater than 0 is expected: pixels a view, or with a unit mm on the "
                   "print");
  }
  for (const char* value : {"nan", "inf", "wide", "", "1e999"}) {
    expect_message({std::string("Depth_Budget=") + value}, "a number is expected");
  }
  expect_message({"Depth_Budget=1e300"}, "at most a million pixels a view are expected");
  expect_message({"Depth_Budget=1e300mm"}, "a length of at most 100 m is expected");
  expect_message({"Depth_Budget=1km"}, "mm, cm");
}

TEST_F(UnitSheetOptions, DepthIsAskedForWithAndWithoutADrawing) {
  EXPECT_FALSE(read({}).depth);
  EXPECT_TRUE(read({"--depth"}).depth);
  EXPECT_TRUE(read({"--depth-view=a.svg"}).depth);
  EXPECT_EQ(read({"--depth-view", "a.svg"}).depth_view, "a.svg");
  expect_message({"--depth-view"}, "--depth-view needs the name of a file");
}

TEST_F(UnitSheetOptions, LengthsHaveUnits) {
  for (const auto& [text, mm] : std::vector<std::pair<const char*, double>>{{"40", 40.0},
                                                                            {"40mm", 40.0},
                                                                            {"40cm", 400.0},
                                                                            {"0.4m", 400.0},
                                                                            {"500um", 0.5},
                                                                            {"0.025in", 0.635},
                                                                            {"2inch", 50.8},
                                                                            {"3 MM", 3.0},
                                                                            {"+1e1cm", 100.0}}) {
    EXPECT_NEAR(*read({std::string("View_Distance=") + text}).lens.view_distance, mm, 1e-12)
        << text;
    EXPECT_NEAR(*read({std::string("Lens_Pitch=") + text}).lens.pitch, mm, 1e-12) << text;
    EXPECT_NEAR(*read({std::string("Lens_Thickness=") + text}).lens.thickness, mm, 1e-12) << text;
    EXPECT_NEAR(*read({std::string("Lens_Radius=") + text}).lens.radius, mm, 1e-12) << text;
    EXPECT_NEAR(*read({std::string("Lens_Focal_Length=") + text}).lens.focal_length, mm, 1e-12);
  }
  EXPECT_EQ(read({"View_Distance=0"}).lens.view_distance, 0.0);
  const RenderOptions size = read({"Sheet_Width=10cm", "Sheet_Height=2in", "Print_DPI=254"});
  EXPECT_EQ(size.sheet_width, 100.0);
  EXPECT_NEAR(*size.sheet_height, 50.8, 1e-12);
}

TEST_F(ErrorSheetOptions, BadLengths) {
  for (const std::string name : {"Lens_Pitch", "Lens_Thickness", "Lens_Radius", "Lens_Focal_Length",
                                 "View_Distance", "Sheet_Width", "Sheet_Height"}) {
    expect_message({name + "=3ft"},
                   "option " + name +
                       "=3ft: unknown unit 'ft': a length is a number of mm, or has "
                       "one of the units mm, cm, m, um, in, inch");
    expect_message({name + "=4\""}, "one of the units");
    expect_message({name + "=3,5cm"}, "a decimal point is expected instead of the comma");
    expect_message({name + "=cm"}, "a number is expected");
    expect_message({name + "=nan"}, "a number is expected");
    expect_message({name + "=1e400"}, "a number is expected");
    expect_message({name + "=1e308m"}, "a shorter length is expected");
    if (name == "View_Distance") continue;
    expect_message({name + "=0mm"}, "a length greater than 0 is expected");
    expect_message({name + "=-1cm"}, "a length greater than 0 is expected");
    expect_message({name + "=inf"}, "a number is expected");
  }
  expect_message({"View_Distance=-1cm"}, "a distance in mm, 0 or inf is expected");
  for (const std::string name : {"Sheet_Distance", "Lens_Front"}) {
    expect_message({name + "=40cm"},
                   "option " + name +
                       "=40cm: this length is in the scene's own units, which are no "
                       "mm: a plain number is expected (View_Distance takes mm)");
    expect_message({name + "=40 feet"}, "a number is expected");
    expect_message({name + "=-1"}, "a distance of 0 or more is expected");
  }
}

TEST_F(UnitSheetOptions, ASheetsSizeGivesColumnsAndRows) {
  // 100 mm at 600 pixels an inch are 2362.2, 70 mm 1653.5.
  const RenderOptions far =
      read({"Lens_LPI=40", "Sheet_Width=100mm", "Sheet_Height=70mm", "Print_DPI=600"});
  EXPECT_EQ(far.width, 2362);
  EXPECT_EQ(far.height, 1654);
  ASSERT_TRUE(far.lens.size);
  EXPECT_EQ(far.lens.size->width, 100.0);
  // From 400 mm the print is 1 + t/(nV) times as large.
  const RenderOptions near =
      read({"Lens_LPI=40", "Lens_Thickness=2", "Lens_IOR=1.5", "Sheet_Width=10cm",
            "Sheet_Height=7cm", "Print_DPI=600", "View_Distance=40cm"});
  const double larger = 1.0 + 2.0 / (1.5 * 400.0);
  EXPECT_EQ(near.width, std::llround(100.0 * larger / 25.4 * 600.0));
  EXPECT_EQ(near.height, std::llround(70.0 * larger / 25.4 * 600.0));
  // Another resolution downwards.
  const RenderOptions two =
      read({"Lens_LPI=40", "Sheet_Width=100", "Sheet_Height=70", "Print_DPI=1440x720"});
  EXPECT_EQ(two.width, 5669);
  EXPECT_EQ(two.height, 1984);
  EXPECT_EQ(two.lens.size->dpi_down, 720.0);
  EXPECT_FALSE(read({"Print_DPI=1440x720", "Print_DPI=600"}).print_dpi_down);
  // Pixels a lens; the default's 15; and columns, from which they follow.
  EXPECT_EQ(read({"Lens_Pitch=0.5", "Sheet_Width=100", "Sheet_Height=70", "Lens_Pixels=8"}).width,
            1600);
  EXPECT_EQ(read({"Lens_Pitch=0.5", "Sheet_Width=100", "Sheet_Height=70"}).height, 2100);
  const RenderOptions columns =
      read({"Lens_Pitch=0.5", "Sheet_Width=100", "Sheet_Height=70", "+W1000"});
  EXPECT_EQ(columns.lens.pixels, 5.0);
  EXPECT_EQ(columns.height, 700);
  const RenderOptions rows =
      read({"Lens_Pitch=0.5", "Sheet_Width=100", "Sheet_Height=70", "+H1400"});
  EXPECT_EQ(rows.lens.pixels, 10.0);
  EXPECT_EQ(rows.width, 2000);
  EXPECT_TRUE(read({"Lens_Pitch=0.5", "Sheet_Width=100", "Sheet_Height=70", "+W1000", "+H77"})
                  .lens.size->rows_fill_it);
  // Agreeing numbers may be given.
  EXPECT_EQ(read({"Lens_LPI=40", "Sheet_Width=100mm", "Sheet_Height=70mm", "Print_DPI=600",
                  "+W2363", "+H1653"})
                .width,
            2363);
  // A default INI file's size is not meant for the sheet.
  std::ofstream("default.ini") << "Width=800\nHeight=600\n";
  OptionSources sources;
  sources.default_ini_files = {"default.ini"};
  EXPECT_EQ(
      read({"Lens_LPI=40", "Sheet_Width=100mm", "Sheet_Height=70mm", "Print_DPI=600"}, sources)
          .width,
      2362);
}

/// Pitch, N and the first resolution are downwards in the upright picture.
TEST_F(UnitSheetOptions, LensesThatLieAcross) {
  const std::vector<std::string> size{"Lens_LPI=40", "Sheet_Width=100", "Sheet_Height=70",
                                      "Lens_Direction=across"};
  const auto with = [&size](std::vector<std::string> more) {
    more.insert(more.begin(), size.begin(), size.end());
    return more;
  };
  const RenderOptions two = read(with({"Print_DPI=1440x720"}));
  EXPECT_EQ(two.width, 2835);
  EXPECT_EQ(two.height, 3969);
  EXPECT_EQ(two.lens.size->width, 70.0);
  EXPECT_EQ(two.lens.size->height, 100.0);
  EXPECT_EQ(read(with({"Lens_Pixels=8"})).height, std::llround(70.0 / 0.635 * 8));
  EXPECT_EQ(read(with({"+H1000"})).lens.pixels, 1000.0 / 70.0 * 0.635);
  expect_message(with({"Print_DPI=600x300", "+H2000"}),
                 "Height=2000 and Sheet_Height=70mm at 600 pixels an inch (1654 pixels)");
  expect_message(with({"Print_DPI=600x300", "+W2000"}), "at 300 pixels an inch (1181 pixels)");
  expect_message(with({"Sheet_Height=1um"}), "less than one of its rows");
  EXPECT_FALSE(*read(with({"Lens_Direction=UP"})).lens.across);
  expect_message({"Lens_Direction=down"}, "up");
}

TEST_F(ErrorSheetOptions, SheetSizes) {
  expect_message({"Sheet_Width=100"}, "Sheet_Width needs Sheet_Height too");
  expect_message({"Sheet_Height=100"}, "Sheet_Height needs Sheet_Width too");
  expect_message({"Print_DPI=600x300"}, "needs Sheet_Width and Sheet_Height");
  expect_message({"Print_DPI=600x"}, "pixels an inch are expected");
  expect_message({"Print_DPI=0x600"}, "pixels an inch are expected, greater than 0");
  expect_message({"Print_DPI=600x-1"}, "pixels an inch are expected, greater than 0");
  expect_message({"Print_DPI=fine"}, "pixels an inch are expected");
  const std::vector<std::string> size{"Lens_LPI=40", "Sheet_Width=100", "Sheet_Height=70"};
  const auto with = [&size](std::vector<std::string> more) {
    more.insert(more.begin(), size.begin(), size.end());
    return more;
  };
  expect_message(
      with({"Print_DPI=600", "+W2000"}),
      "Width=2000 and Sheet_Width=100mm at 600 pixels an inch (2362 pixels) contradict each "
      "other: leave out one of them");
  expect_message(with({"Print_DPI=600", "+H2000"}),
                 "Height=2000 and Sheet_Height=70mm at 600 pixels an inch (1654 pixels)");
  expect_message(with({"Print_DPI=600x300", "+H1654"}), "at 300 pixels an inch (827 pixels)");
  expect_message(with({"Lens_Pixels=15", "+W2000"}), "at 15 pixels a lens (2362 pixels)");
  expect_message(with({"+W100"}), "a lens must be at least one pixel wide");
  expect_message(
      with({"Print_DPI=20"}),
      "at 20 pixels an inch a lens has 0.5 pixels: at least 40 dpi, or at most 20 lpi give "
      "it one");
  expect_message(with({"Print_DPI=1e300"}), "resolution must be 1e9 pixels an inch at most");
  expect_message(with({"Print_DPI=1e9"}), "a lens must be a million pixels wide at most");
  expect_message(with({"Lens_Pitch=0.635", "Sheet_Width=1e300"}),
                 "the sheet must be 1e-6 to 1e6 mm wide and high");
  expect_message(with({"Print_DPI=3e7", "Sheet_Width=10m"}), "columns: 2147483647 are the most");
  expect_message(with({"Print_DPI=600x1e9"}), "rows: 2147483647 are the most");
  expect_message(with({"Print_DPI=600x1e300"}), "resolution must be 1e9 pixels an inch at most");
  expect_message(with({"Sheet_Height=1e-300"}), "the sheet must be 1e-6 to 1e6 mm wide and high");
  expect_message(with({"Sheet_Width=1um"}), "less than one of its columns");
  expect_message(with({"Sheet_Height=1um"}), "less than one of its rows");
  expect_message(with({"Lens_Pitch=0.7"}), "contradict each other");
  expect_message(with({"View_Distance=1e300"}), "the viewing distance must be 1e-6 to 1e12 mm");
}

TEST_F(ErrorSheetOptions, LensData) {
  expect_message({"Lens_Angle=0"}, "greater than 0 and less than 180 degrees");
  expect_message({"Lens_Angle=180"}, "greater than 0 and less than 180 degrees");
  expect_message({"Lens_Angle=wide"}, "a number is expected");
  expect_message({"Lens_IOR=nan"}, "a number is expected");
  expect_message({"Lens_LPI=0"}, "greater than 0");
  expect_message({"Lens_LPI=inf"}, "a number is expected");
  expect_message({"Lens_Tolerance=0"}, "greater than 0");
  for (const char* bad : {"nan", "90", "-90", "1e300", "steep", "1/0", "1/nan", "10/1", ""}) {
    expect_message({std::string("Lens_Slant=") + bad},
                   "an angle of -80 to 80 degrees (9.46) or its tangent as a fraction (1/6) is "
                   "expected");
  }
  expect_message({"Lens_Sheet="},
                 "the name of a lens sheet is expected; Lens_Sheet=list shows them");
}

TEST_F(UnitSheetOptions, Slant) {
  EXPECT_EQ(read({"Lens_Slant=-1/6"}).lens.slant, -1.0 / 6.0);
  EXPECT_NEAR(*read({"Lens_Slant=9.46232"}).lens.slant, 1.0 / 6.0, 1e-7);
  EXPECT_EQ(read({"Lens_Slant=0"}).lens.slant, 0.0);
  EXPECT_FALSE(read({}).lens.slant);
}

TEST_F(UnitSheetOptions, LensSheetsByName) {
  const RenderOptions common = read({"Lens_Sheet=75LPI-0.457mm"});
  EXPECT_EQ(common.lens.pitch, 0.33665);
  EXPECT_EQ(common.lens.radius, 0.1905);
  EXPECT_EQ(common.lens.sheet_name, "75lpi-0.457mm");
  EXPECT_FALSE(common.lens.sheet_is_nominal);
  EXPECT_TRUE(read({"Lens_Sheet=40lpi"}).lens.sheet_is_nominal);
  // What is said besides holds, before and behind the name.
  const RenderOptions other =
      read({"Lens_Thickness=0.5", "Lens_Sheet=75lpi-0.457mm", "Lens_IOR=1.5"});
  EXPECT_EQ(other.lens.thickness, 0.5);
  EXPECT_EQ(other.lens.ior, 1.5);
  EXPECT_EQ(other.lens.radius, 0.1905);
  EXPECT_FALSE(other.lens.angle);
  EXPECT_TRUE(read({"Lens_Sheet=list"}).list_lens_sheets);
  EXPECT_TRUE(read({"--lens-sheets"}).list_lens_sheets);
}

TEST_F(UnitSheetOptions, LensSheetsOfUsers) {
  std::ofstream("lens_sheets.ini") << "Lens_IOR=1.55\n[our 60]\nLens_LPI=60.02 ; measured\n"
                                      "Lens_Thickness=0.65mm\n[40lpi]\nLens_Pitch=0.025in\n"
                                      "[our 60]\nLens_Angle=48\n";
  fs::create_directory("there");
  std::ofstream("there/sheets.ini") << "[far one]\nLens_LPI=50\n";
  OptionSources sources;
  sources.lens_sheet_files = {"there/sheets.ini", "there/none.ini"};
  const RenderOptions ours = read({"Lens_Sheet=Our 60"}, sources);
  EXPECT_EQ(ours.lens.lpi, 60.02);
  EXPECT_EQ(ours.lens.thickness, 0.65);
  EXPECT_EQ(ours.lens.ior, 1.55);
  EXPECT_EQ(ours.lens.angle, 48.0);
  EXPECT_FALSE(ours.lens.sheet_is_nominal);
  EXPECT_NEAR(*read({"Lens_Sheet=40lpi"}, sources).lens.pitch, 0.635,
              1e-15);  // hides the common one
  EXPECT_EQ(read({"Lens_Sheet=far one"}, sources).lens.lpi, 50.0);
  // A scene's folder may be a stranger's.
  EXPECT_EQ(read({"Lens_Sheet=40lpi", "Restrict_IO=On"}, sources).lens.lpi, 40.0);
  fs::rename("lens_sheets.ini", "there/lens_sheets.ini");
  EXPECT_EQ(read({"+Lthere", "Lens_Sheet=our 60"}, sources).lens.lpi, 60.02);
  const std::string list =
      lens_sheet_list(read({"+Lthere", "--lens-sheets"}), sources.lens_sheet_files);
  for (const char* part :
       {"our 60             60.02      0.65       -   1.55     48  there/lens_sheets.ini",
        "far one               50         -       -      -      -  there/sheets.ini",
        "75lpi-0.457mm      75.45     0.457  0.1905  1.557   64.6  Wikipedia",
        "200lpi               200      0.18       -   1.59      -  nominal"}) {
    EXPECT_NE(list.find(part), std::string::npos) << list;
  }
}

TEST_F(UnitSheetOptions, ALensSheetByItsNumberAlone) {
  EXPECT_EQ(read({"Lens_Sheet=60"}).lens.sheet_name, "60lpi");
  std::ofstream("lens_sheets.ini") << "[60]\nLens_LPI=60.02\n";
  EXPECT_EQ(read({"Lens_Sheet=60"}).lens.lpi, 60.02) << "a sheet of that name comes first";
}

TEST_F(UnitSheetOptions, SizesByTheNamesOfPapers) {
  const auto size = [](const std::vector<std::string>& words) {
    const RenderOptions o = read(words);
    return std::pair(o.sheet_width, o.sheet_height);
  };
  using Size = std::pair<std::optional<double>, std::optional<double>>;
  EXPECT_EQ(size({"Sheet_Size=A5"}), Size(148, 210));
  EXPECT_EQ(size({"Sheet_Size=a5-Landscape"}), Size(210, 148));
  EXPECT_EQ(size({"Sheet_Size=letter-portrait"}), Size(215.9, 279.4));
  EXPECT_EQ(size({"Sheet_Size=postcard"}), Size(105, 148));
  EXPECT_EQ(size({"Sheet_Size=100x75mm"}), Size(100, 75));
  EXPECT_EQ(size({"Sheet_Size=4x6in"}), Size(101.6, 6 * 25.4));
  EXPECT_EQ(size({"Sheet_Size=A5", "Sheet_Width=10cm"}), Size(100, 210)) << "what is said last";
  for (const char* word : {"Sheet_Size=B99", "Sheet_Size=A5-tall", "Sheet_Size=", "Sheet_Size=-"}) {
    expect_message({word},
                   "the name of a paper (-landscape lays it on its side) or its size is "
                   "expected: A0, A1,");
  }
  expect_message({"Sheet_Size=100x75ft"}, "unknown unit 'ft'");
  expect_message({"Sheet_Size=A5", "Lens_LPI=60", "Print_DPI=600", "+W20"}, "Sheet_Size=A5");
}

TEST_F(ErrorSheetOptions, LensSheets) {
  for (const char* word : {"Lens_Sheet=41lpi", "Lens_Sheet=41"})
    expect_message({word}, "': 40lpi is the nearest; Lens_LPI=41 takes any");
  expect_message({"Lens_Sheet=75lpi-0.475mm"}, "did you mean 75lpi-0.457mm?");
  expect_message({"Lens_Sheet=something"},
                 "there is no lens sheet 'something': there are 10lpi, 15lpi, 20lpi,");
  std::ofstream("lens_sheets.ini") << "[mine]\nLens_LPI=60\nWidth=30\n";
  expect_message({"Lens_Sheet=mine"},
                 "lens_sheets.ini:3: 'Width' says nothing of a lens sheet: there are Lens_Pitch, "
                 "Lens_LPI, Lens_Focal_Length, Lens_Thickness, Lens_Radius, Lens_IOR, Lens_Angle");
  std::ofstream("lens_sheets.ini") << "[mine]\n+W30\n";
  expect_message({"Lens_Sheet=mine"}, "lens_sheets.ini:2: '+W30' says nothing");
  std::ofstream("lens_sheets.ini") << "[mine]\nLens_Thickness=3ft\n";
  expect_message({"Lens_Sheet=mine"}, "lens_sheets.ini:2: option Lens_Thickness=3ft: unknown unit");
  std::ofstream("lens_sheets.ini") << "[mine\n";
  expect_message({"Lens_Sheet=mine"}, "lens_sheets.ini:1: a section label lacks its ]");
}

}  // namespace
}  // namespace lentray::parser
