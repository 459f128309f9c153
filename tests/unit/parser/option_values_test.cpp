// What the words and numbers of single options are taken for.
#include "parser/options/option_values.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lentray::parser {
namespace {

RenderOptions values_of(const std::vector<std::string>& arguments) {
  return read_options(arguments, {});
}

void expect_refusal(const std::vector<std::string>& arguments, const std::string& part) {
  try {
    (void)values_of(arguments);
    ADD_FAILURE() << arguments[0] << " is taken";
  } catch (const OptionError& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(UnitOptionValues, SwitchesTakeBeginningsOfWordsAndWhatBeginsWithThem) {
  for (const char* word : {"t", "TRU", "y", "Ye", "oN", "1", "'yes'"}) {
    const RenderOptions o = values_of({std::string("Lenticular=") + word});
    EXPECT_TRUE(o.lenticular && o.warnings.empty()) << word;
  }
  for (const char* word : {"f", "FAL", "n", "No", "of", "off", "0"}) {
    const RenderOptions o = values_of({"Lenticular=1", std::string("Lenticular=") + word});
    EXPECT_TRUE(!o.lenticular && o.warnings.empty()) << word;
  }
  for (const char* word : {"truex", "yesno", "10", "1x", "o", ""}) {
    const RenderOptions o = values_of({std::string("Lenticular=") + word});
    EXPECT_TRUE(o.lenticular) << word;
    ASSERT_EQ(o.warnings.size(), 1u) << word;
    EXPECT_NE(o.warnings[0].find("taken as on"), std::string::npos) << word;
  }
}

TEST(UnitOptionValues, FramesBeyondAllCountingAreRefused) {
  for (const char* option :
       {"+KFF2147483647", "+KFI2000000001", "+SF2147483647", "+EF3e9", "Final_Frame=99999999999"}) {
    expect_refusal({option}, option);
    expect_refusal({option}, "a number up to 2000000000 is expected");
  }
  EXPECT_EQ(values_of({"+KFF2000000000"}).animation.final_frame, 2'000'000'000);
  EXPECT_EQ(values_of({"+SF0.5"}).animation.subset_start, 0.5);
}

TEST(UnitOptionValues, GammasThatNoFileHoldsAreRefused) {
  for (const char* option : {"File_Gamma=1e-300", "File_Gamma=0", "File_Gamma=-2",
                             "File_Gamma=1e-5", "File_Gamma=6251", "Display_Gamma=1e300"}) {
    expect_refusal({option}, option);
    expect_refusal({option}, "from 0.001 to 6250, or sRGB");
  }
  EXPECT_EQ(values_of({"File_Gamma=0.001"}).file_gamma, 0.001);
  EXPECT_EQ(values_of({"File_Gamma=6250"}).file_gamma, 6250.0);
}

TEST(UnitOptionValues, NamesOfFilesWhereASwitchMayStand) {
  EXPECT_EQ(values_of({"Debug_File=y"}).debug_file, "debug.out");
  EXPECT_EQ(values_of({"Debug_File=off"}).debug_file, "");
  EXPECT_EQ(values_of({"Debug_File=text"}).debug_file, "text");
  EXPECT_EQ(values_of({"Create_Ini=ye"}).ini_file, "ye");
  EXPECT_EQ(values_of({"Create_Ini=yes"}).ini_file, "");
}

}  // namespace
}  // namespace lentray::parser
