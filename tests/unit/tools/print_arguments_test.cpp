// lentray-print's command line, and lengths with their units.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "parser/options/ini.h"
#include "parser/options/length.h"
#include "parser/options/paper.h"
#include "tools/lentray-print/arguments.h"

namespace lentray::print {
namespace {

using PrintWords = std::vector<std::string>;

std::string print_error(const PrintWords& words) {
  try {
    parse_arguments(words);
  } catch (const parser::OptionError& e) {
    return e.what();
  }
  return "no error";
}

double print_length(const std::string& text) {
  return parser::size_mm({.shown = "--x " + text, .where = "", .value = text});
}

std::string length_error(const std::string& text) {
  try {
    print_length(text);
  } catch (const parser::OptionError& e) {
    return e.what();
  }
  return "no error";
}

TEST(UnitPrintLength, Units) {
  EXPECT_DOUBLE_EQ(print_length("10mm"), 10.0);
  EXPECT_DOUBLE_EQ(print_length("2.5cm"), 25.0);
  EXPECT_DOUBLE_EQ(print_length("0.3m"), 300.0);
  EXPECT_DOUBLE_EQ(print_length("4in"), 101.6);
  EXPECT_DOUBLE_EQ(print_length(" 1e1 mm "), 10.0);
  EXPECT_DOUBLE_EQ(print_length("0mm"), 0.0);
  EXPECT_DOUBLE_EQ(print_length("10"), 10.0);
}

TEST(UnitPrintLength, WrongOnes) {
  for (const char* text : {"", "mm", "nanmm", "infmm", "1e999mm"}) {
    EXPECT_EQ(length_error(text), std::string("option --x ") + text + ": a number is expected");
  }
  for (const char* text : {"10 inches", "1mm2"}) {
    EXPECT_NE(length_error(text).find("unknown unit '"), std::string::npos) << text;
  }
  EXPECT_EQ(length_error("-1mm"), "option --x -1mm: a length of 0 or more is expected");
  EXPECT_EQ(length_error("1e300mm"), "option --x 1e300mm: a length of at most 100 m is expected");
  EXPECT_EQ(length_error("101m"), "option --x 101m: a length of at most 100 m is expected");
  EXPECT_THROW(parser::positive_size_mm({.shown = "", .where = "", .value = "0mm"}),
               parser::OptionError);
}

TEST(UnitPrintLength, Extents) {
  const auto extent = [](const std::string& text) {
    return parser::extent_mm({.shown = "--x " + text, .where = "", .value = text});
  };
  EXPECT_DOUBLE_EQ(extent("200x100mm").width, 200.0);
  EXPECT_DOUBLE_EQ(extent("8x10in").width, 203.2);
  EXPECT_DOUBLE_EQ(extent("8inx100mm").height, 100.0);
  for (const char* text : {"200mm", "x100mm", "0x10mm", "10x-1mm", "nanx10mm"}) {
    EXPECT_THROW(extent(text), parser::OptionError) << text;
  }
}

TEST(UnitPrintArguments, Pitch) {
  const Arguments a =
      parse_arguments({"pitch-test", "--lpi", "40", "--dpi=720", "--size", "A4", "--bands", "20",
                       "--span=0.3", "--out", "p.pdf", "--mirror"});
  EXPECT_EQ(a.command, Command::pitch_test);
  EXPECT_DOUBLE_EQ(*a.lens.lens_pitch, 0.635);
  EXPECT_EQ(*a.lens.dpi_x, 720.0);
  EXPECT_EQ(a.size->width, 210.0);
  EXPECT_EQ(*a.bands, 20);
  EXPECT_TRUE(a.mirror);
  EXPECT_FALSE(a.horizontal);
  EXPECT_EQ(a.out, "p.pdf");
}

TEST(UnitPrintArguments, Sheet) {
  const Arguments a =
      parse_arguments({"sheet",   "a.png",    "--out=s.tif",  "--paper",
                       "a3",      "--bleed",  "3mm",          "--bleed-from=picture",
                       "--marks", "crop",     "--background", "#336699",
                       "--pitch", "39.87lpi", "--tiles",      "--overlap",
                       "1cm",     "--pixels", "15.5",         "--dpi",
                       "600",     "--dpi-y",  "300",          "--bits",
                       "16"});
  ASSERT_EQ(a.images.size(), 1u);
  EXPECT_EQ(a.images[0], "a.png");
  EXPECT_EQ(a.style.paper->height, 420.0);
  EXPECT_EQ(a.style.bleed, 3.0);
  EXPECT_TRUE(a.style.bleed_of_picture);
  EXPECT_EQ(a.style.marks, Marks::crop);
  EXPECT_EQ(a.style.background, (Colour{0.2, 0.4, 0.6}));
  EXPECT_DOUBLE_EQ(*a.print_pitch, 25.4 / 39.87);
  EXPECT_TRUE(a.tiles);
  EXPECT_EQ(a.overlap, 10.0);
  EXPECT_EQ(*a.lens.pixels, 15.5);
  EXPECT_EQ(*a.lens.dpi_y, 300.0);
  EXPECT_EQ(a.bits, 16);
  EXPECT_DOUBLE_EQ(
      *parse_arguments({"sheet", "a.png", "--out=s.tif", "--pitch=0.637mm"}).print_pitch, 0.637);
}

TEST(UnitPrintArguments, SeveralPictures) {
  const Arguments a = parse_arguments({"sheet", "a.png", "b.png", "--copies", "4", "--grid", "2x4",
                                       "--gap=3mm", "--seen=together", "--out=s.pdf"});
  EXPECT_EQ(a.images.size(), 2u);
  EXPECT_EQ(a.copies, 4);
  EXPECT_EQ(*a.grid, (LayoutGrid{2, 4}));
  EXPECT_EQ(*a.style.gap, 3.0);
  EXPECT_TRUE(a.style.is_seen_together);
  const Arguments b = parse_arguments({"sheet", "a.png", "--copies", "3x5", "--out=s.pdf"});
  EXPECT_EQ(*b.copies_grid, (LayoutGrid{3, 5}));
  EXPECT_EQ(b.copies, 1);
}

/// Across the lenses first, as Print_DPI of lentray has it.
TEST(UnitPrintArguments, TwoResolutions) {
  for (const char* command : {"pitch-test", "phase-test", "eye-test"}) {
    const Arguments a =
        parse_arguments({command, "--lpi", "40", "--dpi", "1440x720", "--out=p.pdf",
                         command == std::string("eye-test") ? "--focal-length=2mm" : "--mirror"});
    EXPECT_EQ(*a.lens.dpi_x, 1440.0);
    EXPECT_EQ(*a.lens.dpi_y, 720.0);
  }
  EXPECT_EQ(*parse_arguments({"sheet", "a.png", "--dpi=720X360.5", "--out=p.pdf"}).lens.dpi_y,
            360.5);
}

TEST(UnitPrintArguments, WrongTogether) {
  EXPECT_EQ(print_error({}), "no command is given; lentray-print --help lists all");
  EXPECT_EQ(print_error({"print"}),
            "unknown command 'print'; there are pitch-test, phase-test, eye-test and sheet");
  EXPECT_EQ(print_error({"pitch-test", "--lpi", "40"}),
            "--out FILE is missing: a .pdf, .tif or .png");
  EXPECT_EQ(print_error({"pitch-test", "--out", "a.pdf"}),
            "--lpi L is missing, or --lens-pitch: the lenses of the sheet");
  EXPECT_EQ(print_error({"sheet", "--out", "a.pdf"}),
            "sheet needs a picture: lentray-print sheet PICTURE --out FILE");
  EXPECT_EQ(print_error({"sheet", "a.png", "--dpi=720x360", "--dpi-y=360", "--out=a.pdf"}),
            "--dpi has two numbers, across the lenses and along them: leave --dpi-y out");
  EXPECT_EQ(print_error({"sheet", "a.png", "--copies=2x3", "--grid=3x2", "--out=a.pdf"}),
            "--copies CxR gives the grid already: leave --grid out");
  EXPECT_EQ(print_error({"sheet", "a.png", "b.png", "--copies=501", "--out=a.pdf"}),
            "2 pictures 501 times each: 1000 are possible");
  EXPECT_EQ(print_error({"pitch-test", "a.png"}),
            "pitch-test takes no picture, but 'a.png' is given");
  EXPECT_EQ(print_error({"sheet", "a.png", "--out", "a.pdf", "--tiles"}), "--tiles needs --paper");
  EXPECT_EQ(print_error({"pitch-test", "--lpi=40", "--lens-pitch=1mm", "--out=a.pdf"}),
            "--lpi and --lens-pitch say the same thing: give one of them");
  EXPECT_EQ(print_error({"pitch-test", "--lpi=40", "--bands=3", "--step=0.1", "--out=a.pdf"}),
            "--bands and --step exclude each other");
  EXPECT_EQ(print_error({"pitch-test", "--lpi=40", "--fine", "--step=0.1", "--out=a.pdf"}),
            "--fine stands for --span 0.1 --step 0.01: leave these and --bands out");
  EXPECT_EQ(
      print_error({"eye-test", "--lpi=40", "--out=a.pdf"}),
      "--focal-length F is missing: of the lens in its material, about the sheet's thickness");
  EXPECT_EQ(print_error({"pitch-test", "--bleed", "3mm"}).substr(0, 55),
            "--bleed is no option of pitch-test, which has --out --l");
  EXPECT_EQ(print_error({"pitch-test", "--tiles"}).substr(0, 49),
            "--tiles is no option of pitch-test, which has --o");
  EXPECT_EQ(print_error({"sheet", "--bled=3mm"}).substr(0, 43),
            "unknown option '--bled'; sheet has --out --");
  EXPECT_EQ(print_error({"sheet", "--out"}), "--out needs a value");
  EXPECT_EQ(print_error({"sheet", "--out="}), "option --out=: the name of a file is expected");
}

TEST(UnitPrintArguments, WrongValues) {
  const auto refused = [](const std::string& command, const std::string& option,
                          const std::string& value, const std::string& why) {
    EXPECT_EQ(print_error({command, option, value}), "option " + option + " " + value + ": " + why);
  };
  for (const char* value : {"0", "-40", "1e300", "0.5", "1001"})
    refused("pitch-test", "--lpi", value, "a number from 1 to 1000 is expected");
  for (const char* value : {"nan", "inf", "", "forty", "40lpi"})
    refused("pitch-test", "--lpi", value, "a number is expected");
  refused("pitch-test", "--lens-pitch", "0mm", "a length from 0.0254 to 25.4 mm is expected");
  refused("pitch-test", "--lens-pitch", "1e300mm", "a length of at most 100 m is expected");
  for (const char* value : {"0", "-1", "1e300", "9"})
    refused("pitch-test", "--dpi", value, "a number from 10 to 50000 is expected");
  for (const char* value : {"0", "-1", "1e300"})
    refused("pitch-test", "--step", value, "a number from 0.0001 to 1000 is expected");
  for (const char* value : {"720x", "x720", "720x0", "9x720"}) {
    EXPECT_EQ(print_error({"eye-test", "--dpi", value}).find(std::string("option --dpi ") + value),
              0u);
  }
  refused("sheet", "--grid", "3", "columns x rows of pictures are expected, such as 3x4");
  refused("sheet", "--grid", "100x100", "1000 pictures are possible");
  refused("sheet", "--copies", "0", "a whole number from 1 to 1000 is expected");
  refused("sheet", "--seen", "alone", "there are apart and together");
  refused("sheet", "--gap", "2m", "a length from 0 to 1000 mm is expected");
  refused("pitch-test", "--bands", "0", "a whole number from 1 to 200 is expected");
  refused("pitch-test", "--bands", "1e300", "a whole number is expected");
  refused("pitch-test", "--edges", "soft", "there are grey and hard");
  refused("pitch-test", "--size", "A7",
          "the name of a paper (-landscape lays it on its side) or its size is expected: " +
              parser::paper_names() + ", or 200x100mm");
  refused("phase-test", "--phases", "1", "a whole number from 2 to 64 is expected");
  refused("eye-test", "--ior", "0.9", "a number from 1 to 4 is expected");
  refused("eye-test", "--distance", "0mm", "a length from 10 to 100000 mm is expected");
  refused("sheet", "--margin", "2m", "a length from 0 to 1000 mm is expected");
  refused("sheet", "--marks", "some", "there are all, crop and none");
  refused("sheet", "--bleed-from", "sky", "there are edge and picture");
  for (const char* value : {"grey", "#12345", "#1234567", "#12345g", "123456", ""})
    refused("sheet", "--background", value, "white, black or a colour such as #c0c0c0 is expected");
  refused("sheet", "--pitch", "39.87",
          "a pitch with its unit is expected, such as 39.87lpi or 0.637mm");
  refused("sheet", "--pixels", "0", "a number from 1 to 100000 is expected");
  refused("sheet", "--bits", "12", "there are 8 and 16");
  EXPECT_EQ(print_error({"sheet", "--pitch", "nanlpi"}),
            "option --pitch nanlpi: a number is expected");
  EXPECT_EQ(print_error({"sheet", "--pitch", "0lpi"}),
            "option --pitch 0lpi: a number from 1 to 1000 is expected");
}

}  // namespace
}  // namespace lentray::print
