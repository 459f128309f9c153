#include "tools/lentray-diff/arguments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <thread>

#include "core/base/lower_case.h"
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
      word.starts_with("--") ? own(word, words, i) : bare(word);
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
        {"--output", [&](const std::string& v) { m_prefix = v; }},
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

  void bare(const std::string& word) {
    static constexpr std::array picture_extensions{".png", ".tif", ".tiff", ".exr", ".ppm",
                                                   ".pgm", ".bmp", ".tga",  ".jpg", ".hdr"};
    const std::string extension = core::lower_case(fs::path(word).extension().string());
    const bool is_picture =
        std::ranges::find(picture_extensions, extension) != picture_extensions.end();
    if (parser::is_scene_word(word)) {
      if (is_picture) return void(m_out.pictures.emplace_back(word));
      if (!m_scene.empty()) throw OptionError("two scenes: '" + m_scene + "' and '" + word + "'");
      m_scene = word;
    }
    m_out.for_lentray.push_back(word);
  }

  void finish() {
    m_out.options = parser::read_options(m_out.for_lentray, sources());
    const parser::RenderOptions& options = m_out.options;
    m_out.prefix = m_prefix.empty() ? fs::path(options.output).replace_extension() : m_prefix;
    for (const std::string& folder : options.library_paths)
      m_out.stock.library_paths.push_back(fs::absolute(folder).lexically_normal());
    m_out.stock.arguments = seen_in_stock(options);
    if (!m_out.pictures.empty()) {
      if (!m_scene.empty() || m_out.pictures.size() != 2) {
        throw OptionError("give a scene, or two pictures");
      }
      if (m_out.prefix.empty())
        m_out.prefix = fs::path(m_out.pictures[0].stem().string() + "-diff");
      return;
    }
    m_out.scene = options.input;
    if (m_out.scene.empty()) throw OptionError("no scene given");
    if (m_out.ours.empty() != m_out.statistics.empty())
      throw OptionError("--ours and --statistics go together");
    if (!m_out.scene.has_extension()) m_out.scene += ".pov";
    if (!fs::is_regular_file(m_out.scene)) {
      throw OptionError("there is no scene '" + m_out.scene.string() + "'");
    }
    if (m_out.prefix.empty()) m_out.prefix = fs::path(m_out.scene.stem().string() + "-diff");
  }

  /// Stock has its own standard libraries.
  static parser::OptionSources sources() {
    parser::OptionSources out = parser::installed_sources();
    out.standard_libraries.clear();
    return out;
  }

  /// What changes the picture that stock makes of the scene.
  static std::vector<std::string> seen_in_stock(const parser::RenderOptions& options) {
    std::vector<std::string> out;
    for (const auto& [name, value] : options.declares)
      out.push_back("Declare=" + name + "=" + value);
    for (const char* name :
         {"Quality", "Version", "Clock", "File_Gamma", "Output_Alpha", "Initial_Frame",
          "Final_Frame", "Initial_Clock", "Final_Clock", "Subset_Start_Frame", "Subset_End_Frame",
          "Frame_Step", "Cyclic_Animation"}) {
      const auto said = options.said.find(name);
      if (said != options.said.end()) out.push_back(said->second.text);
    }
    return out;
  }

  Arguments& m_out;
  std::string m_scene;  ///< the one that is named without a switch
  fs::path m_prefix;    ///< of --output
};

}  // namespace

Arguments parse_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  if (std::ranges::find(words, "--seen") != words.end()) {
    arguments.seen = parse_seen_arguments(words);
    return arguments;
  }
  arguments.stock.processes = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  Parsing(arguments).all(words);
  return arguments;
}

std::string usage() {
  return R"(usage: lentray-diff [options] scene.pov [options of lentray]
       lentray-diff [options] picture picture [Lens_Pixels=n]
       lentray-diff --seen sheet sheet [options of --seen]

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

With --seen two integral images of one sheet are compared as an eye before it
sees them: what lens and eye blend is a mean, and the difference is of CIE L*.

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

With --seen:
  --seen           compare what an eye sees of the sheet that the pictures say they
                   are for; the options below say what they do not. --json as above
  --out FOLDER     pictures: what is seen at the middle of the lenses, first.png
                   and second.png, and the largest difference, heat.png
  --arc-minutes A  what the eye tells apart (default 1)
  --view-distance V  from the sheet to the eye: 40cm; mm without a unit
  --dpi D|DxE      pixels an inch of the print: across the lenses, and along
                   them
  --lens-pixels N  pixels a lens
  --across         the lenses lie across the upright pictures

Exit status: 0 the grade is reached, 1 it is not, 2 something went wrong.
)";
}

}  // namespace lentray::diff
