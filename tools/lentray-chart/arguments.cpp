#include "tools/lentray-chart/arguments.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <sstream>

#include "parser/options/options.h"
#include "parser/options/own_option.h"
#include "tools/common/duration.h"

namespace lentray::chart {

namespace fs = std::filesystem;
using parser::GivenOption;
using parser::OptionError;
using parser::same_word;

namespace {

double duration(const GivenOption& given) {
  const auto seconds = tool::duration_of(given.value);
  if (!seconds) {
    parser::refuse(given, "a time above 0 is expected, such as 30s, 2min or 500ms");
  }
  return *seconds;
}

std::vector<Kind> kinds(const GivenOption& given) {
  std::vector<Kind> out;
  std::istringstream words(given.value);
  for (std::string word; std::getline(words, word, ',');) {
    const auto kind = kind_named(word);
    if (!kind) {
      parser::refuse(given, "'" + word +
                                "' is no kind; there are lens_model, antialiasing, area_light, "
                                "focal_blur, media, radiosity, photons, subsurface, depth, "
                                "quality, combined, exact");
    }
    if (std::ranges::find(out, *kind) == out.end()) out.push_back(*kind);
  }
  if (out.empty()) parser::refuse(given, "a kind is expected, such as antialiasing,area_light");
  return out;
}

double given_error(const GivenOption& given) {
  const double error = parser::number(given);
  if (!(error >= 0.0) || !std::isfinite(error)) {
    parser::refuse(given, "an error in 1/255 is expected, 0 or more");
  }
  return error;
}

using parser::set;
constexpr char kProgram[] = "program", kFolder[] = "folder";
constexpr parser::OwnOption<Arguments> kOptions[] = {
    {"Out", set<&Arguments::out, parser::file_name, kFolder>},
    {"Repeats", set<&Arguments::repeats, parser::whole_number, 1, 1000>},
    {"Budget", set<&Arguments::budget, duration>},
    {"Error", set<&Arguments::error, given_error>},
    {"Only", set<&Arguments::only, kinds>},
    {"Reference_Limit", set<&Arguments::reference_limit, duration>},
    {"Lentray", set<&Arguments::lentray, parser::file_name, kProgram>},
    {"Povray", set<&Arguments::povray, parser::file_name, kProgram>},
};

/// What the chart decides of every picture.
constexpr std::array kOurs{"Input_File_Name",   "Output_File_Name", "Output_To_File",
                           "Output_File_Type",  "Continue_Trace",   "Statistics_File",
                           "Create_Ini",        "Max_Time",         "Scene_Writes",
                           "Dependencies_File", "Bits_Per_Color",   "Bits_Per_Colour",
                           "Antialias_Grid"};

void refuse_ours(const std::string& word) {
  bool is_ours = false;
  if (word[0] == '+' || word[0] == '-') {
    const char letter = static_cast<char>(std::tolower(static_cast<unsigned char>(word[1])));
    const std::string name = word.substr(1);
    is_ours = letter == 'i' || letter == 'o' || letter == 'f' || same_word(name, "c") ||
              same_word(name.substr(0, 2), "gi");
  } else {
    const std::string name = word.substr(0, word.find('='));
    is_ours = std::ranges::any_of(kOurs, [&](const char* ours) { return same_word(name, ours); });
  }
  if (is_ours) throw OptionError("'" + word + "': the chart decides that of every picture itself");
}

bool says_threads(const std::vector<std::string>& words) {
  return std::ranges::any_of(words, [](const std::string& word) {
    return same_word(word.substr(0, word.find('=')), "Work_Threads") ||
           (word.size() > 3 && same_word(word.substr(1, 2), "wt"));
  });
}

void take_scene(Arguments& arguments, const std::string& word) {
  if (!arguments.scene.empty()) {
    throw OptionError("two scenes: '" + arguments.scene + "' and '" + word +
                      "'; a chart is of one");
  }
  arguments.scene = word;
}

void check(Arguments& arguments) {
  if (arguments.scene.empty()) throw OptionError("no scene given; lentray-chart --help says how");
  if (!fs::is_regular_file(arguments.scene)) {
    throw OptionError("there is no scene '" + arguments.scene + "'");
  }
  if (arguments.out.empty()) {
    throw OptionError("--out DIR is missing: the folder for the table, the page and the pictures");
  }
  if (!says_threads(arguments.for_lentray)) arguments.for_lentray.emplace_back("+WT1");
  arguments.options = parser::read_options(arguments.for_lentray, {});
  if (parser::is_animation(arguments.options.animation)) {
    throw OptionError("a chart is of one picture: without frames, +K says the clock");
  }
}

}  // namespace

Arguments parse_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--no-stock") {
      arguments.with_stock = false;
    } else if (word == "--quick") {
      arguments.quick = true;
    } else if (parser::take_own_option(words, i, kOptions, arguments)) {
      continue;
    } else if (word.starts_with("--")) {
      throw OptionError("unknown option '" + word + "'; --help lists all");
    } else if (!parser::is_scene_word(word)) {
      if (parser::is_switch(word) || !parser::is_ini(word)) refuse_ours(word);
      arguments.for_lentray.push_back(word);
    } else {
      take_scene(arguments, word);
    }
  }
  check(arguments);
  const fs::path beside = fs::read_symlink("/proc/self/exe").parent_path();
  arguments.lentray =
      arguments.lentray.empty() ? beside / "lentray" : fs::absolute(arguments.lentray);
  arguments.diff = beside / "lentray-diff";
  return arguments;
}

bool wants(const Arguments& arguments, Kind kind) {
  return arguments.only.empty() || std::ranges::find(arguments.only, kind) != arguments.only.end();
}

std::string usage() {
  return R"(usage: lentray-chart SCENE --out DIR [options] [options of lentray]

Shows what each setting of a scene costs and what it gives: speed against
accuracy. Settings that trade time for error are rendered in turn, several
times each; every picture is held against a converged reference of the scene
and against stock POV-Ray's at the same settings. DIR gets chart.csv, the page
index.html and the pictures. Stopped, it continues with the same command.

  --out DIR        the folder for everything
  --budget T       names the setting with the least error that renders within
                   T seconds of processor time (30s, 2min, 500ms)
  --error E        names the fastest setting with at most this error (rms, in
                   1/255)
  --only KINDS     lens_model, antialiasing, area_light, focal_blur, media,
                   radiosity, photons, subsurface, depth, quality, combined,
                   exact; with commas between them (all that the scene has a use for)
  --quick          fewer settings
  --repeats N      timed runs of each setting, 1 to 1000 (3); dear ones run
                   less often: twice from 10 s on, once from 60 s on
  --reference-limit T
                   processor time for the reference (10min)
  --no-stock       without stock POV-Ray
  --lentray FILE   the program to measure (the one beside this program)
  --povray FILE    stock POV-Ray (povray)
  --help, --version

All else goes to lentray: +W +H +A Declare= Lenticular=On +L ... One thread
renders unless +WTn says otherwise; with -V there is no progress.

Exit status: 0 done, 1 something went wrong, 2 no setting fits the budget or
the error, 3 stopped.
)";
}

}  // namespace lentray::chart
