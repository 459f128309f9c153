// The words that switches take, and what they say: on or off as stock's own Create_Ini has it.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "parser/options/create_ini.h"
#include "tests/support/render.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

const std::vector<std::string> kSwitchWords = {
    "t",          "tr",     "tru",    "true",   "TRUE",   "tRuE",    "truex", "true1", "trueno",
    "T1",         "tx",     "y",      "Y",      "ye",     "yes",     "YES",   "yesno", "yesx",
    "yep",        "yo",     "o",      "on",     "On",     "onx",     "one",   "ok",    "of",
    "off",        "OFF",    "offon",  "1",      "10",     "1x",      "1.5",   "1e0",   "01",
    "+1",         "-1",     "0",      "2",      "n",      "no",      "none",  "f",     "false",
    "falsey",     "x",      "+",      "-",      "",       "\"y\"",   "'y'",   "\"n\"", "\" y\"",
    "yes please", "no yes", "on off", "t ; on", "0 # on", "on # off"};

/// Those that stock and Lentray both write into the file of Create_Ini.
const std::vector<std::string> kSharedOptions = {
    "Antialias",         "Jitter",          "Dither",         "Cyclic_Animation",
    "Continue_Trace",    "Output_Alpha",    "Output_To_File", "Grayscale_Output",
    "Verbose",           "Debug_Console",   "Fatal_Console",  "Render_Console",
    "Statistic_Console", "Warning_Console", "Append_File",    "Radiosity_From_File",
    "Radiosity_To_File", "Light_Buffer"};
/// Lentray's own.
const std::vector<std::string> kOwnOptions = {"Lenticular",        "Shadow_Log",  "Strict",
                                              "Specialised_Paths", "Count_Tests", "Stock_Messages"};

std::string lowered(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// The lines Name=On and Name=Off of an INI file.
std::map<std::string, bool> switches_of(const std::string& ini) {
  std::map<std::string, bool> out;
  for (std::size_t at = 0, end; at < ini.size(); at = end + 1) {
    end = std::min(ini.find('\n', at), ini.size());
    const std::string line = ini.substr(at, end - at);
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) continue;
    const std::string value = lowered(line.substr(equals + 1));
    if (value == "on" || value == "off") out[lowered(line.substr(0, equals))] = value == "on";
  }
  return out;
}

std::string lines_of(const std::vector<std::string>& options, const std::string& word) {
  std::string out;
  for (const std::string& option : options) out += option + "=" + word + "\n";
  return out;
}

/// Stock waits more than it works: several run beside each other.
void run_stock(const std::filesystem::path& folder) {
  std::string script;
  for (std::size_t i = 0; i < kSwitchWords.size(); ++i) {
    const std::filesystem::path place = folder / std::to_string(i);
    std::filesystem::create_directory(place);
    tool::write_text(place / "scene.pov", "#version 3.7; global_settings { assumed_gamma 1 }\n");
    tool::write_text(place / "words.ini", lines_of(kSharedOptions, kSwitchWords[i]));
    script += "(cd " + std::to_string(i) +
              " && povray words.ini +Iscene.pov +W1 +H1 -D Create_Ini=stock.txt) &\n";
    if (i % 10 == 9) script += "wait\n";
  }
  tool::run_program({"sh", "-c", script + "wait"}, folder, 120.0);
}

TEST(CompatSwitchWords, OnAndOffAsStock) {
  const tool::TemporaryFolder folder;
  run_stock(folder.path());
  for (std::size_t i = 0; i < kSwitchWords.size(); ++i) {
    const std::string& word = kSwitchWords[i];
    SCOPED_TRACE("the word '" + word + "'");
    const std::filesystem::path place = folder / std::to_string(i), ini = place / "ours.ini";
    const auto stock = switches_of(tool::read_text(place / "stock.txt"));
    tool::write_text(
        ini, lines_of(kSharedOptions, word) + lines_of(kOwnOptions, word) + "Output_File_Type=N\n");
    const auto ours = switches_of(parser::ini_text(parser::read_options({{ini.string()}}, {})));
    for (const std::string& option : kSharedOptions) {
      const std::string name = lowered(option);
      ASSERT_TRUE(stock.contains(name)) << option;
      ASSERT_TRUE(ours.contains(name)) << option;
      EXPECT_EQ(ours.at(name), stock.at(name)) << option;
    }
    for (const std::string& option : kOwnOptions)
      EXPECT_EQ(ours.at(lowered(option)), stock.at("output_alpha")) << option;
  }
}

/// By what they lead to.
TEST(CompatSwitchWords, OnTheCommandLineToo) {
  for (const std::string word : {"y", "tru", "onx", "10", "\"y\"", "", "n", "ok", "+1", "T1"}) {
    SCOPED_TRACE("the word '" + word + "'");
    const tool::TemporaryFolder folder;
    tool::write_text(folder / "scene.pov", "#version 3.7; global_settings { assumed_gamma 1 }\n");
    tool::run_program({"povray", "+Iscene.pov", "+W1", "+H1", "-D", "-V", "Output_To_File=" + word,
                       "+Ostock.png", "Create_Ini=stock.txt"},
                      folder.path(), 60.0);
    const auto ours = run_lentray(
        {"+Iscene.pov", "+W1", "+H1", "Output_To_File=" + word, "+Oours.png"}, folder.path());
    const bool has_picture = std::filesystem::exists(folder / "ours.png");
    EXPECT_EQ(has_picture, std::filesystem::exists(folder / "stock.png")) << ours.output;
    const std::size_t last = ours.output.find_last_of('\n', ours.output.size() - 2);
    EXPECT_EQ(ours.output.find("No picture is written", last) == std::string::npos, has_picture)
        << ours.output;
  }
}

}  // namespace
}  // namespace lentray::test
