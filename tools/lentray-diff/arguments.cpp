#include "tools/lentray-diff/arguments.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <thread>

#include "core/base/lower_case.h"
#include "parser/options/ini.h"
#include "parser/options/options.h"

namespace lentray::diff {

namespace fs = std::filesystem;
using parser::OptionError;

namespace {

double positive_number(const std::string& option, const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != '\0' || !(value > 0.0)) {
    throw OptionError(option + ": '" + text + "' is no number greater than 0");
  }
  return value;
}

class Parsing {
 public:
  explicit Parsing(Arguments& arguments) : m_out(arguments) {}

  void all(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string& word = words[i];
      if (word.rfind("--", 0) == 0) {
        own(word, words, i);
      } else {
        lentrays(word);
      }
    }
    finish();
  }

 private:
  void own(const std::string& word, const std::vector<std::string>& words, std::size_t& i) {
    if (word == "--no-pictures") return void(m_out.write_pictures = false);
    if (word == "--stock-alone") return void(m_out.stock_alone = true);
    if (word == "--all-lenses") return void(m_out.all_lenses = true);
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const std::map<std::string, std::function<void(const std::string&)>> table{
        {"--grade", [&](const std::string& v) { grade(v); }},
        {"--json", [&](const std::string& v) { m_out.json = v; }},
        {"--output", [&](const std::string& v) { m_out.prefix = v; }},
        {"--keep", [&](const std::string& v) { m_out.stock.keep = v; }},
        {"--lentray", [&](const std::string& v) { m_out.lentray = v; }},
        {"--povray", [&](const std::string& v) { m_out.stock.povray = v; }},
        {"--threads",
         [&](const std::string& v) {
           m_out.stock.processes = static_cast<int>(positive_number(name, v));
         }},
        {"--ours", [&](const std::string& v) { m_out.ours = v; }},
        {"--statistics", [&](const std::string& v) { m_out.statistics = v; }},
        {"--write-wrappers", [&](const std::string& v) { m_out.wrappers = v; }},
        {"--noise", [&](const std::string& v) { noise(v); }},
        {"--samples", [&](const std::string& v) { samples(v); }},
        {"--bits", [&](const std::string& v) { bits(v); }},
        {"--scene-ini",
         [&](const std::string& v) {
           m_out.for_lentray.insert(m_out.for_lentray.end(), {"--scene-ini", v});
           on_ini(v, 0);
         }},
        {"--time-limit",
         [&](const std::string& v) { m_out.stock.seconds = positive_number(name, v); }}};
    const auto found = table.find(name);
    if (found == table.end()) {
      std::string known;
      for (const auto& entry : table) known += " " + entry.first;
      throw OptionError("unknown option '" + name + "'; there are" + known +
                        " --no-pictures --all-lenses --stock-alone --help --version");
    }
    if (equals != std::string::npos) return found->second(word.substr(equals + 1));
    if (++i >= words.size()) throw OptionError(name + " needs a value");
    found->second(words[i]);
  }

  void grade(const std::string& name) {
    const auto grade = core::grade_named(core::lower_case(name));
    if (!grade || *grade == core::Grade::fails) {
      throw OptionError("--grade: '" + name + "'; there are exact, match, noise, close");
    }
    m_out.asked = *grade;
  }

  void noise(const std::string& value) {
    const std::map<std::string, AskNoise> words{
        {"auto", AskNoise::where_it_is}, {"on", AskNoise::always}, {"off", AskNoise::never}};
    const auto found = words.find(core::lower_case(value));
    if (found == words.end())
      throw OptionError("--noise: '" + value + "'; there are auto, on, off");
    m_out.noise = found->second;
  }

  void samples(const std::string& value) {
    const double n = positive_number("--samples", value);
    if (n != std::floor(n) || n > 64) throw OptionError("--samples: 1 to 64, each way");
    m_out.stock.samples = static_cast<int>(n);
  }

  void bits(const std::string& value) {
    if (value != "8" && value != "16") throw OptionError("--bits: 8 or 16");
    m_out.stock.bits = value == "8" ? 8 : 16;
  }

  void lentrays(const std::string& word) {
    const std::size_t equals = word.find('=');
    if (parser::is_switch(word)) {
      on_switch(word, fs::current_path());
    } else if (equals != std::string::npos && !parser::is_scene_word(word)) {
      on_option(word.substr(0, equals), parser::unquoted(word.substr(equals + 1)),
                fs::current_path());
    } else {
      on_file(word);
      return;
    }
    if (!is_place(word)) m_out.for_lentray.push_back(word);
  }

  /// Input and output are ours to say.
  static bool is_place(const std::string& word) {
    const std::string name = core::lower_case(word.substr(0, word.find('=')));
    if (word[0] == '+' || word[0] == '-')
      return name.size() > 1 && (name[1] == 'i' || name[1] == 'o');
    return name == "input_file_name" || name == "output_file_name" || name == "output_to_file";
  }

  void on_switch(const std::string& word, const fs::path& folder) {
    const char letter = static_cast<char>(std::tolower(static_cast<unsigned char>(word[1])));
    const std::string value = parser::unquoted(word.substr(2));
    if (letter == 'i' && !value.empty()) m_out.scene = value;
    if (letter == 'o' && !value.empty()) set_prefix(value);
    if (letter == 'l') m_out.stock.library_paths.push_back((folder / value).lexically_normal());
    const std::string two = core::lower_case(word.substr(1, 2));
    const bool clock = letter == 'k' && !value.empty() &&
                       (std::isdigit(static_cast<unsigned char>(value[0])) || value[0] == '.' ||
                        value[0] == '-' || value[0] == '+');
    const bool frames = two == "kf" || two == "ki" || two == "kc" || two == "sf" || two == "ef" ||
                        core::lower_case(word.substr(1)).starts_with("stp");
    if (letter == 'q' || two == "mv" || two == "ua" || clock || frames)
      m_out.stock.arguments.push_back(word);
  }

  void on_option(const std::string& name, const std::string& value, const fs::path& folder) {
    static constexpr std::array seen_in_stock{"declare",
                                              "quality",
                                              "version",
                                              "clock",
                                              "file_gamma",
                                              "output_alpha",
                                              "initial_clock",
                                              "final_clock",
                                              "initial_frame",
                                              "final_frame",
                                              "subset_start_frame",
                                              "subset_end_frame",
                                              "frame_step",
                                              "cyclic_animation"};
    const std::string key = core::lower_case(name);
    if (key == "input_file_name") m_out.scene = value;
    if (key == "output_file_name") set_prefix(value);
    if (key == "library_path") {
      m_out.stock.library_paths.push_back((folder / value).lexically_normal());
    }
    if (key == "lens_pixels") m_out.lens_pixels = positive_number(name, value);
    if (key == "view")
      m_out.view = static_cast<std::uint32_t>(std::strtoul(value.c_str(), nullptr, 10));
    if (std::find(seen_in_stock.begin(), seen_in_stock.end(), key) != seen_in_stock.end()) {
      m_out.stock.arguments.push_back(name + "=" + value);
    }
  }

  void on_file(const std::string& word) {
    const std::string extension = core::lower_case(fs::path(word).extension().string());
    if (extension.rfind(".ini", 0) == 0) {
      m_out.for_lentray.push_back(word);
      return on_ini(word, 0);
    }
    static constexpr std::array picture_extensions{".png", ".tif", ".tiff", ".exr", ".ppm",
                                                   ".pgm", ".bmp", ".tga",  ".jpg", ".hdr"};
    if (std::find(picture_extensions.begin(), picture_extensions.end(), extension) !=
        picture_extensions.end()) {
      m_out.pictures.emplace_back(word);
    } else if (m_out.scene.empty()) {
      m_out.scene = word;
    } else {
      throw OptionError("two scenes: '" + m_out.scene.string() + "' and '" + word + "'");
    }
  }

  void on_ini(const std::string& text, int depth) {
    if (depth > 10) throw OptionError("'" + text + "' includes itself");
    const parser::IniName name = parser::ini_name(text);
    std::vector<std::string> warnings;  // lentray's own run reports them
    for (const parser::IniLine& line : parser::read_ini(name.file, name, warnings).lines) {
      switch (line.kind) {
        case parser::IniLine::Kind::kOption:
          on_option(line.text, line.value, fs::current_path());
          break;
        case parser::IniLine::Kind::kSwitch: on_switch(line.text, fs::current_path()); break;
        case parser::IniLine::Kind::kNested: on_ini(line.text, depth + 1); break;
      }
    }
  }

  void set_prefix(const std::string& picture) {
    m_out.prefix = fs::path(picture).replace_extension();
  }

  void finish() const {
    if (!m_out.pictures.empty()) {
      if (!m_out.scene.empty() || m_out.pictures.size() != 2) {
        throw OptionError("give a scene, or two pictures");
      }
      if (m_out.prefix.empty())
        m_out.prefix = fs::path(m_out.pictures[0].stem().string() + "-diff");
      return;
    }
    if (m_out.scene.empty()) throw OptionError("no scene given");
    if (m_out.ours.empty() != m_out.statistics.empty())
      throw OptionError("--ours and --statistics go together");
    if (!m_out.scene.has_extension()) m_out.scene += ".pov";
    if (!fs::is_regular_file(m_out.scene)) {
      throw OptionError("there is no scene '" + m_out.scene.string() + "'");
    }
    if (m_out.prefix.empty()) m_out.prefix = fs::path(m_out.scene.stem().string() + "-diff");
  }

  Arguments& m_out;
};

}  // namespace

Arguments parse_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  arguments.stock.processes = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  Parsing(arguments).all(words);
  return arguments;
}

std::string usage() {
  return R"(usage: lentray-diff [options] scene.pov [options of lentray]
       lentray-diff [options] picture picture [Lens_Pixels=n]

Compares pictures of lentray with stock POV-Ray's, lens by lens. Of a scene, it
renders both; or two pictures are given, and the pixels of a lens are, or stand
in a picture that lentray wrote.

All options of lentray are passed on (Lenticular=On, Declare=, +W, +H, +L,
files.ini ...); stock sees the same scene through wrapper scenes. Antialiasing
(+A, +AM, +R, +J, +AG and their long names) reaches both; without +A neither
antialiases. Jitter is random in both: -J for equal pictures. Stock cannot
antialias a mesh_camera (fractional Lens_Pixels; Snell's law at a finite
View_Distance): there the reference is the mean of many samples. With
Antialias_Angle=n it is the mean of n times as many views.

  --grade G        exact, match (default), noise or close: what the whole must
                   reach; every lens and view must reach match at least (or G,
                   if that is less)
  --noise W        auto (default), on or off: stock renders three times more, in
                   other orders, where a picture is short of match; within what
                   stock differs from itself it has the grade noise, else it
                   fails. auto: of scenes with radiosity, photons or
                   subsurface light
  --json FILE      all figures as JSON
  --output PREFIX  pictures PREFIX-ours, -stock, -heat, -side.png
                   (default: SCENE-diff)
  --no-pictures    none of them
  --all-lenses     a line for every lens, not for the worst only
  --threads N      threads of lentray, and processes of stock at a time (all)
  --samples N      samples each way over a pixel of an antialiased mesh_camera
                   (default 8: 64 a pixel)
  --bits B         8 or 16 bits a colour (default 8)
  --time-limit S   seconds for one process of stock
  --keep FOLDER    wrapper scenes and stock's pictures stay there
  --write-wrappers FOLDER  write the wrapper scenes for stock (viewJ.pov,
                   mesh.pov), do no more
  --ours PICTURE, --statistics FILE
                   what lentray made of the scene with these options before
                   (its Statistics_File): it is not rendered again, and of
                   the pictures only -stock and -heat are written
  --stock-alone    stock's picture of the scene's own camera, for where
                   lentray has none
  --scene-ini FILE an INI file that came with the scene, passed on as such
  --lentray FILE   the lentray to use (default: the one beside this program)
  --povray FILE    the stock POV-Ray to use (default: povray)

Exit status: 0 the grade is reached, 1 it is not, 2 something went wrong.
)";
}

}  // namespace lentray::diff
