#include "parser/options/options_table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "parser/options/option_values.h"
#include "parser/options/sheet_options.h"
#include "parser/options/view_options_reader.h"

namespace lentray::parser {
namespace {

using Options = RenderOptions;
using Given = GivenOption;

void ignore(Options&, const Given&) {}

/// Off is what happens anyway; on is not there yet.
template <int N>
struct Word {
  char text[N]{};
  constexpr Word(const char (&t)[N]) { std::copy_n(t, N, text); }
};
template <Word what>
void only_off(Options& o, const Given& g) {
  if (truth(o, g)) not_yet(o, g, what.text);
}

template <bool Options::*member>
void set_bool(Options& o, const Given& g) {
  o.*member = truth(o, g);
}

/// On stays on, whoever says what later.
void set_restrict_io(Options& o, const Given& g) {
  if (truth(o, g)) {
    o.restrict_io = true;
  } else if (o.restrict_io) {
    o.warnings.push_back(g.where + "option " + g.shown +
                         ": it stays on, since it was turned on before");
  }
}

/// Switches of text streams may name a file that the text goes to, whether the console is on or off.
template <bool Options::*console, std::string Options::*file>
void set_console(Options& o, const Given& g) {
  if (g.sign != 0 && !g.value.empty()) o.*file = g.value;
  o.*console = truth(o, g);
}
void set_all_consoles(Options& o, const Given& g) {
  if (g.sign != 0 && !g.value.empty()) o.all_file = g.value;
  o.all_console = truth(o, g);
}
/// A name; `true` for the stream's usual one.
template <std::string Options::*file, Word usual>
void set_stream_file(Options& o, const Given& g) {
  o.*file = g.value;
  for (const char* word : {"false", "no", "off", "0"}) {
    if (same_word(g.value, word)) o.*file = "";
  }
  for (const char* word : {"true", "yes", "on", "1", ""}) {
    if (same_word(g.value, word)) o.*file = usual.text;
  }
}
void set_stock_messages(Options& o, const Given& g) { o.stock_messages = truth(o, g); }
void set_create_ini(Options& o, const Given& g) {
  o.create_ini = g.sign != '-';
  o.ini_file = g.value;
  for (const char* word : {"false", "no", "off", "0"}) {
    if (same_word(g.value, word)) o.create_ini = false;
  }
  for (const char* word : {"true", "yes", "on", "1"}) {
    if (same_word(g.value, word)) o.ini_file = "";
  }
}

/// +A and +A0.2 turn it on, -A and -A0.2 off; the number is kept either way.
void set_antialias(Options& o, const Given& g) {
  if (g.sign != 0 && !g.value.empty()) o.antialias_threshold = cut_number(o, g, 0.0, 1.0);
  o.antialias = truth(o, g);
}
void set_threshold(Options& o, const Given& g) {
  o.antialias_threshold = cut_number(o, g, 0.0, 1.0);
}
void set_sampling(Options& o, const Given& g) {
  o.sampling_method = static_cast<int>(cut_whole(o, g, 0, 2));
}
void set_antialias_gamma(Options& o, const Given& g) {
  o.antialias_gamma = std::max(number(g), 0.0);
}
void set_depth(Options& o, const Given& g) {
  o.antialias_depth = static_cast<int>(cut_whole(o, g, 1, 9));
}
void set_jitter(Options& o, const Given& g) {
  if (g.sign != 0 && !g.value.empty()) o.jitter_amount = cut_number(o, g, 0.0, 1.0);
  o.jitter = truth(o, g);
}
void set_jitter_amount(Options& o, const Given& g) { o.jitter_amount = cut_number(o, g, 0.0, 1.0); }
void set_angles(Options& o, const Given& g) {
  o.antialias_angles = static_cast<int>(whole_number(g, 1, 64));
}
void set_grid(Options& o, const Given& g) {
  o.antialias_grid = static_cast<int>(whole_number(g, 0, 64));
}
template <std::optional<double> Options::*member>
void set_edge(Options& o, const Given& g) {
  o.*member = number(g);
  if (*(o.*member) < 0.0)
    refuse(g, "a column or row from 1 on, or a part from 0 to 1, is expected");
}
struct DitherWord {
  std::string_view word;
  core::DitherMethod method;
};
constexpr DitherWord kMethods[] = {
    {"B2", core::DitherMethod::bayer2}, {"B3", core::DitherMethod::bayer3},
    {"B4", core::DitherMethod::bayer4}, {"D1", core::DitherMethod::line},
    {"D2", core::DitherMethod::plane},  {"FS", core::DitherMethod::floyd_steinberg}};

void set_dither_type(Options& o, const Given& g) {
  for (const auto& [word, method] : kMethods) {
    if (!same_word(word, g.value)) continue;
    o.dither_type = method;
    return;
  }
  refuse(g, "unknown way of dithering: there are B2, B3, B4, D1, D2 and FS");
}
/// +THxx turns it on, -THxx off; the method is kept either way.
void set_dither(Options& o, const Given& g) {
  if (g.sign != 0 && !g.value.empty()) set_dither_type(o, g);
  o.dither = truth(o, g);
}

/// As the manual has it: a command line names no commands.
void only_in_ini(const Given& g) {
  if (g.where.empty()) refuse(g, "commands to run and what they lead to stand in INI files only");
}
template <CommandKind kind>
void set_command(Options& o, const Given& g) {
  only_in_ini(g);
  o.commands[static_cast<std::size_t>(kind)].text = g.value;
}
/// A letter, perhaps after - or !, which turn the meaning of the exit status round.
template <CommandKind kind>
void set_return(Options& o, const Given& g) {
  only_in_ini(g);
  const bool turned = g.value.starts_with('-') || g.value.starts_with('!');
  const char letter =
      g.value.size() > turned
          ? static_cast<char>(std::toupper(static_cast<unsigned char>(g.value[turned])))
          : ' ';
  if (std::string_view("ISAQUF").find(letter) == std::string_view::npos) {
    refuse(g, "I, S, A, Q, U or F, perhaps after - or !, is expected");
  }
  ShellCommand& command = o.commands[static_cast<std::size_t>(kind)];
  command.action = letter;
  command.on_success = turned;
}

void add_library(Options& o, const Given& g) {
  if (g.value.empty() && g.sign == 0) return;
  if (g.value.empty()) refuse(g, "a folder is expected");
  if (std::find(o.library_paths.begin(), o.library_paths.end(), g.value) == o.library_paths.end()) {
    o.library_paths.push_back(g.value);
  }
}

void add_declare(Options& o, const Given& g) {
  const std::size_t equals = g.value.find('=');
  if (equals == std::string::npos) refuse(g, "Declare=NAME=VALUE is expected");
  const std::string name = unquoted(g.value.substr(0, equals));
  const std::string value = g.value.substr(equals + 1);
  const bool is_name = !name.empty() && !std::isdigit(static_cast<unsigned char>(name.front())) &&
                       std::all_of(name.begin(), name.end(),
                                   [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (!is_name) refuse(g, "'" + name + "' cannot be the name of an identifier");
  Given only = g;
  only.value = value;
  const bool is_text = value.size() >= 2 && value.front() == '"' && value.back() == '"';
  if (!is_text) (void)number(only);
  std::erase_if(o.declares, [&](const auto& d) { return d.first == name; });
  o.declares.emplace_back(name, is_text ? value.substr(1, value.size() - 2) : value);
}

struct TypeWord {
  std::string_view word;
  core::FileType type;
};
/// Stock knows the letters alone and takes PNG for P, TIFF for T; those words are ours. The first
/// word of a type is the one that is written.
constexpr TypeWord kTypes[] = {{"N", core::FileType::png},
                               {"PNG", core::FileType::png},
                               {"TIFF", core::FileType::tiff},
                               {"TIF", core::FileType::tiff},
                               {"E", core::FileType::exr},
                               {"EXR", core::FileType::exr},
                               {"T", core::FileType::targa},
                               {"TGA", core::FileType::targa},
                               {"C", core::FileType::compressed_targa},
                               {"J", core::FileType::jpeg},
                               {"JPG", core::FileType::jpeg},
                               {"JPEG", core::FileType::jpeg},
                               {"P", core::FileType::ppm},
                               {"PPM", core::FileType::ppm},
                               {"B", core::FileType::bmp},
                               {"BMP", core::FileType::bmp},
                               {"H", core::FileType::radiance},
                               {"HDR", core::FileType::radiance}};

constexpr int kFloatBits = 32;

void set_bits(Options& o, const Given& g, std::string_view digits) {
  Given only = g;
  only.value = std::string(digits);
  std::from_chars(digits.data(), digits.data() + digits.size(), o.bits);
  if (o.bits != kFloatBits) o.bits = static_cast<int>(cut_whole(o, only, 5, 16));
}

/// A type, and behind it bits or, of some, g for grey: N16, Pg.
void set_type(Options& o, const Given& g) {
  std::string_view text = g.value;
  const std::size_t letters =
      std::find_if(text.begin(), text.end(), [](unsigned char c) { return !std::isalpha(c); }) -
      text.begin();
  std::string_view word = text.substr(0, letters);
  const std::string_view digits = text.substr(letters);
  if (!word.empty()) {
    if (same_word(word, "Ng") || same_word(word, "Pg")) {
      o.grayscale = true;
      word = word.substr(0, 1);
    }
    const auto* row = std::find_if(std::begin(kTypes), std::end(kTypes),
                                   [&](const TypeWord& t) { return same_word(t.word, word); });
    if (row == std::end(kTypes)) {
      refuse(g,
             "unknown output type: there are N (PNG), P (PPM), T and C (Targa), J (JPEG), B (BMP), "
             "E (OpenEXR), "
             "H (Radiance) and TIFF; g for grey stands behind N and P");
    }
    o.type = row->type;
    o.type_given = !g.from_defaults;
  }
  if (!digits.empty()) set_bits(o, g, digits);
}

void set_compression(Options& o, const Given& g) {
  o.compression = static_cast<int>(cut_whole(o, g, 0, 255));
}

void set_output(Options& o, const Given& g) {
  if (g.sign == 0) {
    o.output_to_file = truth(o, g);
    return;
  }
  o.output_to_file = g.sign == '+';
  set_type(o, g);
}

template <bool Options::*srgb, double Options::*power>
void set_gamma(Options& o, const Given& g) {
  o.*srgb = same_word(g.value, "sRGB");
  if (!(o.*srgb)) o.*power = positive(g);
}

void set_version(Options& o, const Given& g) {
  const double v = number(g);
  if (!(v >= 1.0 && v < 10.0)) refuse(g, "a language version such as 3.7 is expected");
  o.language_version = static_cast<int>(std::lround(v * 100.0));
}

/// As in stock, `Include_Header=` says that there is none.
template <std::string Options::*member>
void set_text(Options& o, const Given& g) {
  if (g.value.empty() && g.sign != 0) refuse(g, "a name is expected");
  o.*member = g.value;
}

void set_order(Options& o, const Given& g) {
  constexpr std::string_view kThere[] = {"auto",   "rows",  "views",      "columns", "combined",
                                         "strips", "tiles", "serpentine", "hilbert", "adaptive"};
  // combined(4), strips(4,32): the order itself judges its numbers.
  const std::size_t bracket = std::min(g.value.find('('), g.value.size());
  Given name = g;
  name.value = g.value.substr(0, bracket);
  o.pixel_order = choice(name, "pixel order", kThere);
  o.pixel_order += g.value.substr(bracket);
}
void set_cache(Options& o, const Given& g) {
  constexpr std::string_view kThere[] = {"auto", "off",           "last", "depth",
                                         "tree", "neighbourhood", "grid", "cascade"};
  o.shadow_cache = choice(g, "shadow cache", kThere);
}
void set_accelerator(Options& o, const Given& g) {
  constexpr std::string_view kThere[] = {"bvh", "grid", "list"};
  o.accelerator = choice(g, "accelerator", kThere);
}
void set_views(Options& o, const Given& g) {
  o.views.count = static_cast<std::uint32_t>(whole_number(g, 1, kMostViews));
}
void set_view_size(Options& o, const Given& g) { o.views.size = size_of(g); }
void set_quilt(Options& o, const Given& g) { o.views.quilt = quilt_of(g); }
void set_quilt_aspect(Options& o, const Given& g) { o.views.aspect = positive(g); }
void set_view_cone(Options& o, const Given& g) {
  o.views.cone = positive(g);
  if (*o.views.cone >= 180.0) refuse(g, "an angle below 180 degrees is expected");
}
void set_view_clock(Options& o, const Given& g) { o.views.clocks = clocks_of(g); }
/// A number greater than 0 and the letters behind it, such as 1.5 GiB.
struct Quantity {
  double number = 0.0;
  std::string unit;
};
Quantity quantity(const Given& g) {
  std::string text = g.value;
  const std::size_t letters =
      std::find_if(text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c); }) -
      text.begin();
  Quantity out;
  out.unit = text.substr(letters);
  text.erase(letters);
  while (!text.empty() && text.back() == ' ') text.pop_back();
  Given only = g;
  only.value = text;
  out.number = positive(only);
  return out;
}
void set_scene_writes(Options& o, const Given& g) {
  if (!same_word(g.value, "disk") && !same_word(g.value, "memory"))
    refuse(g, "disk or memory is expected");
  if (g.from_scene && same_word(g.value, "disk")) return;  // the user's to say
  o.writes_to_disk = same_word(g.value, "disk");
}
/// Seconds, or with a unit: s, m or h.
void set_time(Options& o, const Given& g) {
  const auto [number, unit] = quantity(g);
  constexpr std::pair<std::string_view, double> kUnits[] = {
      {"", 1.0}, {"s", 1.0}, {"m", 60.0}, {"h", 3600.0}};
  for (const auto& [name, seconds] : kUnits) {
    if (!same_word(unit, name)) continue;
    o.max_time = number * seconds;
    return;
  }
  refuse(g, "unknown unit '" + unit + "': there are s, m and h");
}
/// Bytes, or with a unit: K, M, G or T, as B, KB and KiB, powers of 1024.
void set_memory(Options& o, const Given& g) {
  constexpr std::string_view kUnits[] = {"", "K", "M", "G", "T"};
  constexpr double kLeast = 1024.0 * 1024.0;
  auto [bytes, unit] = quantity(g);
  for (const std::string_view row : kUnits) {
    const std::string name(row);
    if (same_word(unit, name) || same_word(unit, name + "B") ||
        (!name.empty() && same_word(unit, name + "iB"))) {
      if (bytes < kLeast) {
        refuse(g, "less than 1 MB; a unit may stand behind the number, such as 512M");
      }
      o.max_memory = bytes;
      return;
    }
    bytes *= 1024.0;
  }
  refuse(g, "unknown unit '" + unit + "': there are K, M, G and T");
}
void set_band(Options& o, const Given& g) {
  o.band_height = static_cast<std::uint32_t>(whole_number(g, 1, 2'147'483'647));
}
/// A size of less than a pixel is no size, and one that does not fit is not meant.
std::int64_t size(Options& o, const Given& g) {
  const std::int64_t value =
      cut_whole(o, g, std::numeric_limits<std::int32_t>::min(), std::int64_t{1} << 40);
  if (value < 1 || value > std::numeric_limits<std::int32_t>::max()) {
    refuse(g, "a whole number from 1 to 2147483647 is expected");
  }
  return value;
}
void set_width(Options& o, const Given& g) {
  o.width = size(o, g);
  o.width_given = o.width_given || !g.from_defaults;
}
void set_height(Options& o, const Given& g) {
  o.height = size(o, g);
  o.height_given = o.height_given || !g.from_defaults;
}
void set_quality(Options& o, const Given& g) {
  o.quality = static_cast<int>(cut_whole(o, g, 0, 11));
}
template <std::optional<int> SceneOverrides::*member, int kLeast, int kMost>
void set_override(Options& o, const Given& g) {
  o.overrides.*member = static_cast<int>(whole_number(g, kLeast, kMost));
}
/// `off`: no samples are left out.
void set_area_adaptive(Options& o, const Given& g) {
  o.overrides.area_light_adaptive =
      same_word(g.value, "off") ? -1 : static_cast<int>(whole_number(g, 0, 20));
}
void set_bailout(Options& o, const Given& g) {
  o.overrides.adc_bailout = number(g);
  if (!(*o.overrides.adc_bailout >= 0.0)) refuse(g, "a number from 0 on is expected");
}
template <std::optional<int> RadiosityOverrides::*member, int kMost>
void set_radiosity(Options& o, const Given& g) {
  o.overrides.radiosity.*member = static_cast<int>(whole_number(g, 1, kMost));
}
template <std::optional<int> PhotonOverrides::*member>
void set_photons(Options& o, const Given& g) {
  constexpr int kMost = 1'000'000'000;
  o.overrides.photons.*member = static_cast<int>(whole_number(g, 1, kMost));
}
void set_error_bound(Options& o, const Given& g) {
  o.overrides.radiosity.error_bound = number(g);
  if (!(*o.overrides.radiosity.error_bound > 0.0)) refuse(g, "a number greater than 0 is expected");
}
constexpr int kMostMediaSamples = 1'000'000;
template <std::optional<int> MediaSettings::*member, int kMost>
void set_media(Options& o, const Given& g) {
  o.overrides.media.*member = static_cast<int>(whole_number(g, 1, kMost));
}
void set_media_confidence(Options& o, const Given& g) {
  const double confidence = number(g);
  o.overrides.media.confidence = confidence;
  if (!(confidence >= 0.0 && confidence < 1.0)) {
    refuse(g, "a number from 0 to less than 1 is expected");
  }
}
void set_threads(Options& o, const Given& g) {
  o.threads = static_cast<int>(cut_whole(o, g, 1, 512));
}
constexpr double kAnyFloat = std::numeric_limits<float>::max();
void set_clock(Options& o, const Given& g) {
  o.clock = cut_number(o, g, -kAnyFloat, kAnyFloat);
  o.clock_given = true;
}
constexpr int kMostFrames = 2'000'000'000;
template <std::optional<int> AnimationOptions::*member>
void set_frame(Options& o, const Given& g) {
  o.animation.*member = static_cast<int>(cut_whole(o, g, 0, kMostFrames));
}
template <std::optional<double> AnimationOptions::*member>
void set_clock_of(Options& o, const Given& g) {
  o.animation.*member = cut_number(o, g, -kAnyFloat, kAnyFloat);
}
template <std::optional<double> AnimationOptions::*member>
void set_subset(Options& o, const Given& g) {
  o.animation.*member = cut_number(o, g, 0.0, kMostFrames);
}
void set_frame_step(Options& o, const Given& g) {
  o.animation.step = static_cast<int>(cut_whole(o, g, 1, kMostFrames));
}
void set_cyclic(Options& o, const Given& g) { o.animation.cyclic = truth(o, g); }
void set_level(Options& o, const Given& g) {
  o.warning_level = static_cast<int>(cut_whole(o, g, 0, 10));
}
void set_file_bits(Options& o, const Given& g) { set_bits(o, g, g.value); }
void set_display(Options&, const Given& g) {
  if (g.sign != 0 && g.value.size() > 2) refuse(g, "unknown switch");
}

void set_radiosity_file(Options& o, const Given& g) {
  if (g.value.empty()) refuse(g, "the name of a file or folder is expected");
  o.radiosity_file = g.value;
}
/// The name of +RFobject.rca begins as the switch +RFO does.
template <bool Options::*member>
void set_radiosity_switch(Options& o, const Given& g) {
  if (g.sign == 0 || g.value.empty()) {
    o.*member = truth(o, g);
  } else {
    o.radiosity_file = g.shown.substr(3);
  }
}
void set_radiosity_samples(Options& o, const Given& g) {
  o.radiosity_samples =
      static_cast<std::uint64_t>(whole_number(g, 1, std::numeric_limits<std::int32_t>::max()));
}

constexpr OptionRow kTable[] = {
    // Scene.
    {"Input_File_Name", "I", set_text<&Options::input>},
    {"Include_Header", "HI", set_text<&Options::include_header>},
    {"Include_Ini", "", ignore},  // whoever reads names reads it at once
    {"Library_Path", "L", add_library},
    {"Declare", "", add_declare},
    {"Version", "MV", set_version},
    {"Clock", "K", set_clock},
    {"Initial_Frame", "KFI", set_frame<&AnimationOptions::initial_frame>},
    {"Final_Frame", "KFF", set_frame<&AnimationOptions::final_frame>},
    {"Initial_Clock", "KI", set_clock_of<&AnimationOptions::initial_clock>},
    {"Final_Clock", "KF", set_clock_of<&AnimationOptions::final_clock>},
    {"Subset_Start_Frame", "SF", set_subset<&AnimationOptions::subset_start>},
    {"Subset_End_Frame", "EF", set_subset<&AnimationOptions::subset_end>},
    {"Frame_Step", "STP", set_frame_step},
    {"Cyclic_Animation", "KC", set_cyclic},
    {"Clockless_Animation", "", only_off<"animation without a clock">},
    {"Real_Time_Raytracing", "", only_off<"real-time raytracing">},
    {"Field_Render", "UF", ignore},
    {"Odd_Field", "UO", ignore},
    // Picture.
    {"Width", "W", set_width},
    {"Height", "H", set_height},
    {"Start_Column", "SC", set_edge<&Options::start_column>},
    {"Start_Row", "SR", set_edge<&Options::start_row>},
    {"End_Column", "EC", set_edge<&Options::end_column>},
    {"End_Row", "ER", set_edge<&Options::end_row>},
    {"Continue_Trace", "C", set_bool<&Options::continues>},
    {"Create_Ini", "GI", set_create_ini},
    {"Output_to_File", "F", set_output},
    {"Output_File_Type", "", set_type},
    {"Output_File_Name", "O", set_text<&Options::output>},
    {"Output_Alpha", "UA", set_bool<&Options::alpha>},
    {"Bits_Per_Color", "", set_file_bits},
    {"Bits_Per_Colour", "", set_file_bits},
    {"Grayscale_Output", "", set_bool<&Options::grayscale>},
    {"Compression", "", set_compression},
    {"File_Gamma", "", set_gamma<&Options::srgb, &Options::file_gamma>},
    {"Display_Gamma", "", set_gamma<&Options::display_srgb, &Options::display_gamma>},
    {"Dither", "TH", set_dither},
    {"Dither_Method", "", set_dither_type},
    {"Quality", "Q", set_quality},
    {"Work_Threads", "WT", set_threads},
    {"Antialias", "A", set_antialias},
    {"Sampling_Method", "AM", set_sampling},
    {"Antialias_Threshold", "", set_threshold},
    {"Antialias_Depth", "R", set_depth},
    {"Antialias_Gamma", "AG", set_antialias_gamma},
    {"Jitter", "J", set_jitter},
    {"Jitter_Amount", "", set_jitter_amount},
    {"Antialias_Angle", "", set_angles},
    {"Antialias_Grid", "", set_grid},
    {"Radiosity_File_Name", "RF", set_radiosity_file},
    {"Radiosity_From_File", "RFI", set_radiosity_switch<&Options::radiosity_from_file>},
    {"Radiosity_To_File", "RFO", set_radiosity_switch<&Options::radiosity_to_file>},
    {"Radiosity_Vain_Pretrace", "RVP", ignore},
    {"High_Reproducibility", "HR", ignore},
    // How stock works inside: no such things here, and no effect on the picture.
    {"Display", "D", set_display},
    {"Video_Mode", "", ignore},
    {"Palette", "", ignore},
    {"Pause_When_Done", "P", ignore},
    {"Preview_Start_Size", "SP", ignore},
    {"Preview_End_Size", "EP", ignore},
    {"Draw_Vistas", "UD", ignore},
    {"Test_Abort", "X", ignore},
    {"Test_Abort_Count", "", ignore},
    {"Buffer_Output", "B", ignore},
    {"Buffer_Size", "", ignore},
    {"Max_Image_Buffer_Memory", "MI", ignore},
    {"Render_Block_Size", "BS", ignore},
    {"Render_Pattern", "RP", ignore},
    {"Render_Block_Step", "RS", ignore},
    {"Bounding", "MB", ignore},
    {"Bounding_Threshold", "", ignore},
    {"Bounding_Method", "BM", ignore},
    {"BSP_MaxDepth", "", ignore},
    {"BSP_BaseAccessCost", "", ignore},
    {"BSP_ChildAccessCost", "", ignore},
    {"BSP_IsectCost", "", ignore},
    {"BSP_MissChance", "", ignore},
    {"Vista_Buffer", "UV", ignore},
    {"Remove_Bounds", "UR", ignore},
    {"Split_Unions", "SU", ignore},
    // Messages.
    {"Verbose", "V", set_bool<&Options::verbose>},
    {"Warning_Level", "WL", set_level},
    {"Stock_Messages", "", set_stock_messages},
    {"Debug_Console", "GD", set_console<&Options::debug_console, &Options::debug_file>},
    {"Fatal_Console", "GF", set_console<&Options::fatal_console, &Options::fatal_file>},
    {"Render_Console", "GR", set_console<&Options::render_console, &Options::render_file>},
    {"Statistic_Console", "GS", set_console<&Options::statistic_console, &Options::statistic_file>},
    {"Warning_Console", "GW", set_console<&Options::warning_console, &Options::warning_file>},
    {"All_Console", "GA", set_all_consoles},
    {"Debug_File", "", set_stream_file<&Options::debug_file, "debug.out">},
    {"Fatal_File", "", set_stream_file<&Options::fatal_file, "fatal.out">},
    {"Render_File", "", set_stream_file<&Options::render_file, "render.out">},
    {"Statistic_File", "", set_stream_file<&Options::statistic_file, "stats.out">},
    {"Warning_File", "", set_stream_file<&Options::warning_file, "warning.out">},
    {"All_File", "", set_stream_file<&Options::all_file, "alltext.out">},
    {"Append_File", "GP", set_bool<&Options::append_files>},
    // Programs to run.
    {"Pre_Scene_Command", "", set_command<CommandKind::kPreScene>},
    {"Pre_Frame_Command", "", set_command<CommandKind::kPreFrame>},
    {"Post_Scene_Command", "", set_command<CommandKind::kPostScene>},
    {"Post_Frame_Command", "", set_command<CommandKind::kPostFrame>},
    {"User_Abort_Command", "", set_command<CommandKind::kUserAbort>},
    {"Fatal_Error_Command", "", set_command<CommandKind::kFatalError>},
    {"Pre_Scene_Return", "", set_return<CommandKind::kPreScene>},
    {"Pre_Frame_Return", "", set_return<CommandKind::kPreFrame>},
    {"Post_Scene_Return", "", set_return<CommandKind::kPostScene>},
    {"Post_Frame_Return", "", set_return<CommandKind::kPostFrame>},
    {"User_Abort_Return", "", set_return<CommandKind::kUserAbort>},
    {"Fatal_Error_Return", "", set_return<CommandKind::kFatalError>},
    {"Restrict_IO", "", set_restrict_io},
    {"Strict", "", set_bool<&Options::strict>},
    // Lentray's own.
    {"Lenticular", "", set_bool<&Options::lenticular>},
    {"Lens_Sheet", "", sheet_option::sheet},
    {"Lens_Pitch", "", sheet_option::pitch},
    {"Lens_LPI", "", sheet_option::lpi},
    {"Print_LPI", "", sheet_option::print_lpi},
    {"Lens_Thickness", "", sheet_option::thickness},
    {"Lens_Radius", "", sheet_option::radius},
    {"Lens_IOR", "", sheet_option::ior},
    {"Lens_Angle", "", sheet_option::angle},
    {"Lens_Focal_Length", "", sheet_option::focal_length},
    {"Lens_Pixels", "", sheet_option::pixels},
    {"Lens_Slant", "", sheet_option::slant},
    {"Print_DPI", "", sheet_option::print_dpi},
    {"Sheet_Width", "", sheet_option::width},
    {"Sheet_Height", "", sheet_option::height},
    {"View_Distance", "", sheet_option::view_distance},
    {"Sheet_Distance", "", sheet_option::sheet_distance},
    {"Depth_Budget", "", sheet_option::depth_budget},
    {"Lens_Front", "", sheet_option::front},
    {"Lens_Model", "", sheet_option::model},
    {"Lens_Tolerance", "", sheet_option::tolerance},
    {"Lens_Rays", "", sheet_option::rays},
    {"View", "", sheet_option::view},
    {"Views", "", set_views},
    {"View_Size", "", set_view_size},
    {"View_Clock", "", set_view_clock},
    {"Quilt", "", set_quilt},
    {"Quilt_Tile", "", set_view_size},
    {"Quilt_Aspect", "", set_quilt_aspect},
    {"View_Cone", "", set_view_cone},
    {"View_Cameras", "", set_text<&Options::view_cameras>},
    {"Shadow_Log", "", set_bool<&Options::shadow_log>},
    {"Pixel_Order", "", set_order},
    {"Shadow_Cache", "", set_cache},
    {"Accelerator", "", set_accelerator},
    {"Area_Light_Samples", "", set_override<&SceneOverrides::area_light_samples, 2, 1000>},
    {"Area_Light_Adaptive", "", set_area_adaptive},
    {"Blur_Samples", "", set_override<&SceneOverrides::blur_samples, 1, 65536>},
    {"Max_Trace_Level", "", set_override<&SceneOverrides::max_trace_level, 1, 256>},
    {"Adc_Bailout", "", set_bailout},
    {"Radiosity_Count", "", set_radiosity<&RadiosityOverrides::count, 1600>},
    {"Radiosity_Error_Bound", "", set_error_bound},
    {"Radiosity_Nearest_Count", "", set_radiosity<&RadiosityOverrides::nearest_count, 20>},
    {"Radiosity_Recursion_Limit", "", set_radiosity<&RadiosityOverrides::recursion_limit, 20>},
    {"Photon_Count", "", set_photons<&PhotonOverrides::count>},
    {"Photon_Gather", "", set_photons<&PhotonOverrides::gather>},
    {"Subsurface_Samples", "", set_override<&SceneOverrides::subsurface_samples, 1, 1'000'000>},
    {"Media_Method", "", set_media<&MediaSettings::method, 3>},
    {"Media_Intervals", "", set_media<&MediaSettings::intervals, kMostMediaSamples>},
    {"Media_Samples", "", set_media<&MediaSettings::samples, kMostMediaSamples>},
    {"Media_Confidence", "", set_media_confidence},
    {"Radiosity_Samples", "", set_radiosity_samples},
    {"Specialised_Paths", "", set_bool<&Options::specialised_paths>},
    {"Light_Buffer", "UL", set_bool<&Options::light_buffer>},
    {"Max_Memory", "", set_memory},
    {"Max_Time", "", set_time},
    {"Band_Height", "", set_band},
    {"Statistics_File", "", set_text<&Options::statistics_file>},
    {"Count_Tests", "", set_bool<&Options::count_tests>},
    {"Dependencies_File", "", set_text<&Options::dependencies_file>},
    {"Scene_Writes", "", set_scene_writes},
};

}  // namespace

std::span<const OptionRow> option_table() { return kTable; }

std::string_view word_of(core::FileType type) {
  return std::ranges::find(kTypes, type, &TypeWord::type)->word;
}

std::string_view word_of(core::DitherMethod method) {
  return std::ranges::find(kMethods, method, &DitherWord::method)->word;
}

}  // namespace lentray::parser
