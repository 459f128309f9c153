#include "tools/lentray-batch/arguments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>

#include "core/base/lower_case.h"
#include "parser/options/ini.h"
#include "parser/options/options.h"

namespace lentray::batch {

namespace fs = std::filesystem;
using parser::OptionError;
using parser::same_word;

namespace {

double positive_number(const std::string& option, const std::string& text, std::string_view& unit) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || !(value > 0.0) || !std::isfinite(value)) {
    throw OptionError(option + ": '" + text + "': a number greater than 0 is expected");
  }
  unit = std::string_view(text).substr(static_cast<std::size_t>(end - text.c_str()));
  return value;
}

double seconds_of(const std::string& option, const std::string& text) {
  std::string_view unit;
  const double value = positive_number(option, text, unit);
  if (unit.empty() || unit == "s") return value;
  if (unit == "m") return 60.0 * value;
  if (unit == "h") return 3600.0 * value;
  throw OptionError(option + ": unknown unit '" + std::string(unit) + "': there are s, m and h");
}

double bytes_of(const std::string& option, const std::string& text) {
  std::string_view unit;
  const double value = positive_number(option, text, unit);
  if (unit.empty()) return value;
  constexpr std::string_view kUnits = "KMGT";
  const std::size_t at =
      kUnits.find(static_cast<char>(std::toupper(static_cast<unsigned char>(unit[0]))));
  if (unit.size() > 1 || at == std::string_view::npos) {
    throw OptionError(option + ": unknown unit '" + std::string(unit) +
                      "': there are K, M, G and T");
  }
  return value * std::pow(1024.0, static_cast<double>(at + 1));
}

int count_of(const std::string& option, const std::string& text) {
  std::string_view unit;
  const double value = positive_number(option, text, unit);
  if (!unit.empty() || value != std::floor(value) || value > 1e6) {
    throw OptionError(option + ": '" + text + "': a whole number is expected");
  }
  return static_cast<int>(value);
}

/// What the batch itself decides of every run.
constexpr std::array kOurs{"Input_File_Name", "Output_File_Name", "Output_To_File",
                           "Continue_Trace",  "Statistics_File",  "Dependencies_File",
                           "Scene_Writes",    "Create_Ini",       "Work_Threads",
                           "Max_Time",        "Max_Memory",       "View"};
constexpr std::array kPaths{"Library_Path", "Permitted_Path", "Include_Header", "Include_Ini"};

class Parsing {
 public:
  explicit Parsing(Arguments& arguments) : m_out(arguments) {}

  void all(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i].starts_with("--")) {
        own(words, i);
      } else {
        other(words[i]);
      }
    }
    m_out.words = words;
    finish();
  }

 private:
  void own(const std::vector<std::string>& words, std::size_t& i) {
    const std::size_t equals = words[i].find('=');
    const std::string name = words[i].substr(0, equals);
    const std::map<std::string, bool*> switches{
        {"--frames", &m_out.frames}, {"--views", &m_out.views}, {"--compare", &m_out.compare},
        {"--retry", &m_out.retry},   {"--quiet", &m_out.quiet}, {"--slurm", &m_out.slurm}};
    const std::map<std::string, std::function<void(const std::string&)>> values{
        {"--out", [&](const std::string& v) { m_out.out = v; }},
        {"--jobs", [&](const std::string& v) { m_out.jobs = count_of(name, v); }},
        {"--time-limit", [&](const std::string& v) { m_out.time_limit = seconds_of(name, v); }},
        {"--memory-limit", [&](const std::string& v) { m_out.memory_limit = bytes_of(name, v); }},
        {"--grade", [&](const std::string& v) { grade(v); }},
        {"--noise", [&](const std::string& v) { noise(v); }},
        {"--table", [&](const std::string& v) { m_out.table = fs::absolute(v); }},
        {"--lentray", [&](const std::string& v) { m_out.lentray = v; }},
        {"--sbatch", [&](const std::string& v) { m_out.sbatch = v; }},
        {"--task-time", [&](const std::string& v) { m_out.task_time = seconds_of(name, v); }},
        {"--worker", [&](const std::string& v) { m_out.worker = v; }},
        {"--task", [&](const std::string& v) { m_out.task = v == "0" ? 0 : count_of(name, v); }},
        {"--povray", [&](const std::string& v) { m_out.povray = v; }}};
    if (const auto at = switches.find(name); at != switches.end() && equals == std::string::npos) {
      *at->second = true;
      return;
    }
    if (name == "--no-scene-ini" && equals == std::string::npos) {
      m_out.scene_ini = false;
      return;
    }
    const auto found = values.find(name);
    if (found == values.end()) {
      std::string known = " --help --version --no-scene-ini";
      for (const auto& entry : switches) known += " " + entry.first;
      for (const auto& entry : values) known += " " + entry.first;
      throw OptionError((switches.contains(name) ? "no value belongs to '" : "unknown option '") +
                        name + "'; there are" + known);
    }
    std::string value;
    if (equals != std::string::npos) {
      value = words[i].substr(equals + 1);
    } else if (++i < words.size()) {
      value = words[i];
    }
    if (value.empty()) throw OptionError(name + " needs a value");
    found->second(value);
  }

  void grade(const std::string& name) {
    m_out.asked = core::grade_named(name);
    if (!m_out.asked || *m_out.asked == core::Grade::fails) {
      throw OptionError("--grade: '" + name + "'; there are exact, match, noise, close");
    }
    m_out.compare = true;
  }

  void noise(const std::string& word) {
    if (word != "auto" && word != "on" && word != "off")
      throw OptionError("--noise: '" + word + "'; there are auto, on, off");
    m_out.noise = word;
  }

  void other(const std::string& word) {
    std::error_code error;
    const bool is_switch = parser::is_switch(word);
    if (parser::is_scene_word(word) && fs::exists(word, error)) {
      m_out.inputs.emplace_back(word);
    } else if (is_switch || word.find('=') != std::string::npos) {
      m_out.for_lentray.push_back(with_whole_path(word, is_switch));
    } else if (parser::is_ini(word)) {
      m_out.for_lentray.push_back(fs::absolute(word).string());
    } else {
      throw OptionError("there is no folder or scene '" + word + "'");
    }
  }

  /// A path in an option of lentray's, seen from any folder.
  static std::string with_whole_path(const std::string& word, bool is_switch) {
    if (is_switch) {
      const bool is_library =
          word.size() > 2 && std::tolower(static_cast<unsigned char>(word[1])) == 'l';
      const bool is_header = word.size() > 3 && same_word(word.substr(1, 2), "hi");
      const std::size_t name = is_library ? 2 : is_header ? 3 : 0;
      return name == 0 ? word
                       : word.substr(0, name) +
                             fs::absolute(parser::unquoted(word.substr(name))).string();
    }
    const std::size_t equals = word.find('=');
    for (const char* path : kPaths) {
      if (!same_word(word.substr(0, equals), path)) continue;
      return word.substr(0, equals + 1) +
             fs::absolute(parser::unquoted(word.substr(equals + 1))).string();
    }
    return word;
  }

  void refuse_what_the_batch_decides() const {
    for (const std::string& word : m_out.for_lentray) {
      if (const std::string_view ours = decided_by(word); !ours.empty())
        throw OptionError("'" + word + "': the batch decides that of every scene itself" +
                          instead(ours));
    }
  }

  /// The option of the batch's own that the word says; empty: none.
  static std::string_view decided_by(const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    const auto* ours =
        std::ranges::find_if(kOurs, [&](const char* option) { return same_word(name, option); });
    if (ours != kOurs.end()) return *ours;
    if (!parser::is_switch(word)) return "";
    const std::string letters = core::lower_case(word.substr(1));
    if (letters[0] == 'o') return "Output_File_Name";
    if (letters.starts_with("wt")) return "Work_Threads";
    const bool is_ours =
        letters[0] == 'i' || letters == "f" || letters == "c" || letters.starts_with("gi");
    return is_ours ? "Input_File_Name" : "";
  }

  static std::string instead(std::string_view what) {
    if (what == "Output_File_Name") return " (--out says where pictures go)";
    if (what == "Max_Time") return " (--time-limit)";
    if (what == "Max_Memory") return " (--memory-limit)";
    if (what == "Work_Threads") return " (--jobs)";
    if (what == "View") return " (--views)";
    return "";
  }

  /// Scenes are strangers' until the command line says that they are not: INI files do not.
  void restrict() const {
    const bool is_said = std::ranges::any_of(m_out.for_lentray, [](const std::string& word) {
      return same_word(word.substr(0, word.find('=')), "Restrict_IO");
    });
    if (!is_said) m_out.for_lentray.insert(m_out.for_lentray.begin(), "Restrict_IO=On");
  }

  /// Folders that stand in INI files are relative to the current folder, as POV-Ray has it.
  void check_lentrays() const {
    const parser::RenderOptions options = parser::read_options(m_out.for_lentray, {});
    m_out.restricts = options.restrict_io;
    if (options.help || options.version || options.parse_only || options.dump || options.explain ||
        options.depth || !options.dump_rays.empty()) {
      throw OptionError("a batch renders; what else lentray does is done with lentray itself");
    }
    add_whole("Library_Path=", options.library_paths);
    add_whole("Permitted_Path=", options.permitted_paths);
  }

  void add_whole(const std::string& option, const std::vector<std::string>& folders) const {
    for (const std::string& folder : folders) {
      if (fs::path(folder).is_relative())
        m_out.for_lentray.push_back(option + fs::absolute(folder).string());
    }
  }

  void finish() {
    if (!m_out.worker.empty()) return;
    if (!m_out.sbatch.empty() && !m_out.slurm)
      throw OptionError("--sbatch gives options to Slurm: it needs --slurm");
    if (m_out.inputs.empty())
      throw OptionError("no folder and no scene was named; lentray-batch --help says how");
    if (m_out.out.empty())
      throw OptionError("--out DIR is missing: the folder for pictures, manifest and page");
    m_out.out = fs::absolute(m_out.out).lexically_normal();
    if (!m_out.out.has_filename()) m_out.out = m_out.out.parent_path();
    if (!m_out.noise.empty() && !m_out.compare)
      throw OptionError("--noise is stock's: it needs --compare");
    if (!m_out.table.empty() && !m_out.compare)
      throw OptionError("--table shows grades: it needs --compare");
    refuse_what_the_batch_decides();
    restrict();
    check_lentrays();
  }

  Arguments& m_out;
};

}  // namespace

Arguments parse_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  Parsing(arguments).all(words);
  const fs::path beside = fs::read_symlink("/proc/self/exe").parent_path();
  arguments.lentray =
      arguments.lentray.empty() ? beside / "lentray" : fs::absolute(arguments.lentray);
  arguments.diff = beside / "lentray-diff";
  arguments.merge = beside / "lentray-merge";
  return arguments;
}

std::string usage() {
  return R"(usage: lentray-batch FOLDER|SCENE... --out DIR [options of lentray]

Renders folders of POV-Ray scenes. Every scene gets its picture in DIR, a row
in DIR/manifest.jsonl and a place on the page DIR/index.html. One bad scene does
not stop the others. Started again it renders what is missing or out of date:
where the scene, a file that it reads, an option or the program has changed.

Options of lentray hold for all scenes (+W, +A, Lenticular=On, a profile.ini);
scene.ini beside scene.pov holds for that scene besides, and comes last. Files
that others include and that have no camera of their own are left out. Scenes
are rendered in their own folders, as by hand, but what they write is kept in
memory: the folders stay as they are.

Scenes are taken for strangers' (Restrict_IO=On): they read the folders that are
named here, their own, library paths (+L), Permitted_Path=FOLDER, and POV-Ray's
include files; povray.conf is not asked, and scene.ini sets what pictures look
like alone. Restrict_IO=Off on this command line lets scenes read all.

  --out DIR        where pictures, manifest and page go
  --frames         animations, frame by frame; without it a still of each
  --views          the views of integral images besides, as pictures
  --compare        stock POV-Ray's picture beside each, its grade, the
                   difference, the ratio of times
  --grade G        exact, match, noise or close: what every scene must reach
  --noise W        auto, on or off: stock renders three times more where a
                   picture is short of match, to measure its own noise (of scenes
                   with radiosity, photons or subsurface light)
  --table FILE     the comparison as a Markdown table
  --jobs N         scenes at a time (as many as there are processors)
  --time-limit T   seconds a picture may take, each view of Views= too (90, 90s,
                   10m, 2h; no limit)
  --memory-limit M bytes a scene may take (800M, 2G; half of the machine's)
  --no-scene-ini   scene.ini is not read
  --retry          tries again what failed, though nothing has changed
  --quiet          no progress
  --slurm          renders as an array of jobs of Slurm (docs/cluster.md);
                   bands of large pictures are jobs of their own
  --task-time T    how long a task of the array should take (as the work and the
                   nodes suggest, at most 3 minutes)
  --sbatch OPTIONS further options of sbatch, as "--partition=night --mem=4G"
  --lentray FILE   the lentray to use (default: the one beside this program)
  --povray FILE    the stock POV-Ray to use (default: povray)

Small scenes are rendered side by side, large ones one after another with all
processors. A signal (Ctrl-C) stops within a second; the same command goes on
from there. A second one ends at once, and loses nothing that is finished.

Exit status: 0 every picture is there (and reaches --grade), 1 some are not, 2
the batch could not be run, 3 it was stopped.

Examples:
  lentray-batch scenes --out pictures +W800 +H600 +A0.3
  lentray-batch scenes --out sheets sheet.ini Lenticular=On --views
)";
}

}  // namespace lentray::batch
