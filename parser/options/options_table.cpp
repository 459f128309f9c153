#include "parser/options/options_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "parser/options/option_access.h"
#include "parser/options/output_options.h"
#include "parser/options/sheet_options.h"
#include "parser/options/view_options_reader.h"

namespace lentray::parser {
namespace {

using Options = RenderOptions;
using Given = GivenOption;

void ignore(Options&, const Given&) {}

constexpr bool is_not_negative(double x) { return x >= 0.0; }

/// Off is what happens anyway; on is not there yet.
template <Word what>
void only_off(Options& o, const Given& g) {
  if (truth(o, g)) not_yet(o, g, what.text);
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
/// A name; the stream's usual one for what says on, as in stock.
template <std::string Options::*file, Word usual>
void set_stream_file(Options& o, const Given& g) {
  const SwitchWord word = switch_word(g.value);
  o.*file = word.on ? usual.text : word.is_whole ? "" : g.value;
}
void set_create_ini(Options& o, const Given& g) {
  const SwitchWord word = switch_word(g.value);
  o.create_ini = g.sign != '-' && (word.on || !word.is_whole);
  o.ini_file = word.is_whole ? "" : g.value;
}

/// +A and +A0.2 turn it on, -A and -A0.2 off; the number is kept either way.
void set_antialias(Options& o, const Given& g) {
  if (g.sign != 0 && !g.value.empty()) o.antialias_threshold = cut_number(o, g, 0.0, 1.0);
  o.antialias = truth(o, g);
}
template <std::optional<double> Options::*member>
constexpr OptionAccess kEdge =
    kNumber<member, is_not_negative,
            "a column or row from 1 on, or a part from 0 to 1, is expected">;
void set_antialias_gamma(Options& o, const Given& g) {
  o.antialias_gamma = std::max(number(g), 0.0);
}
/// 3 alone is the eye's, where stock takes the like for 2.
void set_sampling_method(Options& o, const Given& g) {
  o.sampling_method = g.value == "3" ? 3 : static_cast<int>(cut_whole(o, g, 0, 2));
}
void set_jitter(Options& o, const Given& g) {
  if (g.sign != 0 && !g.value.empty()) o.jitter_amount = cut_number(o, g, 0.0, 1.0);
  o.jitter = truth(o, g);
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

/// Each folder once.
template <std::vector<std::string> Options::*folders>
void add_folder(Options& o, const Given& g) {
  if (g.value.empty() && g.sign == 0) return;
  if (g.value.empty()) refuse(g, "a folder is expected");
  if (std::ranges::find(o.*folders, g.value) == (o.*folders).end()) (o.*folders).push_back(g.value);
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
  const bool is_text = value.size() >= 2 && value.front() == '"' && value.back() == '"';
  if (!is_text) (void)number(part_of(g, value));
  std::erase_if(o.declares, [&](const auto& d) { return d.first == name; });
  o.declares.emplace_back(name, is_text ? value.substr(1, value.size() - 2) : value);
}

template <bool Options::*srgb, double Options::*power>
void set_gamma(Options& o, const Given& g) {
  constexpr double kLeast = 0.001,
                   kMost = 6250.0;  // as stock: below, by its own rule; above, by PNG's
  o.*srgb = same_word(g.value, "sRGB");
  if (o.*srgb) return;
  o.*power = number(g);
  if (!(o.*power >= kLeast && o.*power <= kMost))
    refuse(g, "a number from 0.001 to 6250, or sRGB, is expected");
}

void set_version(Options& o, const Given& g) {
  const double v = number(g);
  if (!(v >= 1.0 && v < 10.0)) refuse(g, "a language version such as 3.7 is expected");
  o.language_version = static_cast<int>(std::lround(v * 100.0));
}

void set_order(Options& o, const Given& g) {
  constexpr std::string_view kThere[] = {"auto",   "rows",  "views",      "columns", "combined",
                                         "strips", "tiles", "serpentine", "hilbert", "adaptive"};
  // combined(4), strips(4,32): the order itself judges its numbers.
  const std::size_t bracket = std::min(g.value.find('('), g.value.size());
  o.pixel_order = choice(part_of(g, g.value.substr(0, bracket)), "pixel order", kThere);
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
void set_view_size(Options& o, const Given& g) { o.views.size = size_of(g); }
void set_quilt(Options& o, const Given& g) { o.views.quilt = quilt_of(g); }
void set_view_cone(Options& o, const Given& g) {
  o.views.cone = positive(g);
  if (*o.views.cone >= 180.0) refuse(g, "an angle below 180 degrees is expected");
}
void set_view_clock(Options& o, const Given& g) { o.views.clocks = clocks_of(g); }
/// A number greater than 0 and the letters behind it, such as 1.5 GiB or 9e+06.
struct Quantity {
  double number = 0.0;
  std::string unit;
};
Quantity quantity(const Given& g) {
  std::string text = g.value;
  const auto is_digit = [&](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i]));
  };
  std::size_t letters = 0;
  for (; letters < text.size(); ++letters) {
    if (!std::isalpha(static_cast<unsigned char>(text[letters]))) continue;
    const std::size_t next = letters + 1;
    const bool has_sign = next < text.size() && (text[next] == '+' || text[next] == '-');
    const bool is_exponent =
        (text[letters] == 'e' || text[letters] == 'E') && is_digit(has_sign ? next + 1 : next);
    if (!is_exponent) break;
  }
  Quantity out;
  out.unit = text.substr(letters);
  text.erase(letters);
  while (!text.empty() && text.back() == ' ') text.pop_back();
  out.number = positive(part_of(g, text));
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
  constexpr std::pair<std::string_view, double> kTimes[] = {
      {"", 1.0}, {"s", 1.0}, {"m", 60.0}, {"h", 3600.0}};
  for (const auto& [name, seconds] : kTimes) {
    if (!same_word(unit, name)) continue;
    o.max_time = number * seconds;
    return;
  }
  refuse(g, "unknown unit '" + unit + "': there are s, m and h");
}
constexpr std::string_view kPowers[] = {"", "K", "M", "G", "T"};
[[noreturn]] void refuse_unit(const Given& g, const std::string& unit) {
  refuse(g, "unknown unit '" + unit + "': there are K, M, G and T");
}
/// Bytes, or with a unit: K, M, G or T, as B, KB and KiB, powers of 1024.
template <double Options::*member>
void set_bytes(Options& o, const Given& g) {
  constexpr double kLeast = 1024.0 * 1024.0;
  auto [bytes, unit] = quantity(g);
  for (const std::string_view row : kPowers) {
    const std::string name(row);
    if (same_word(unit, name) || same_word(unit, name + "B") ||
        (!name.empty() && same_word(unit, name + "iB"))) {
      if (bytes < kLeast) {
        refuse(g, "less than 1 MB; a unit may stand behind the number, such as 512M");
      }
      o.*member = bytes;
      return;
    }
    bytes *= 1024.0;
  }
  refuse_unit(g, unit);
}
/// A count, or with a unit: K, M, G or T, powers of 1000.
void set_pixels(Options& o, const Given& g) {
  auto [pixels, unit] = quantity(g);
  for (const std::string_view name : kPowers) {
    if (same_word(unit, name)) {
      o.max_pixels = pixels;
      return;
    }
    pixels *= 1000.0;
  }
  refuse_unit(g, unit);
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
/// `off`: no samples are left out.
void set_area_adaptive(Options& o, const Given& g) {
  o.overrides.area_light_adaptive =
      same_word(g.value, "off") ? -1 : static_cast<int>(whole_number(g, 0, 20));
}
constexpr int kMostPhotons = 1'000'000'000, kMostMediaSamples = 1'000'000;
constexpr double kAnyFloat = std::numeric_limits<float>::max();
void set_clock(Options& o, const Given& g) {
  o.clock = cut_number(o, g, -kAnyFloat, kAnyFloat);
  o.clock_given = true;
}
constexpr int kMostFrames = 2'000'000'000;
/// A frame or a part of all. Beyond what frames are counted to there is none that could be meant.
template <auto member>
constexpr OptionAccess kFrame{
    [](Options& o, const Given& g) {
      std::string_view rest;
      if (leading_number(g, rest) > kMostFrames)
        refuse(g, "a number up to " + std::to_string(kMostFrames) + " is expected");
      kCut<member, 0, kMostFrames>.apply(o, g);
    },
    write_field<member>};
template <auto member>
constexpr OptionAccess kClock{
    [](Options& o, const Given& g) { field<member>(o) = cut_number(o, g, -kAnyFloat, kAnyFloat); },
    write_field<member>};
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
// ---- lines of an INI file ------------------------------------------------------------------------

std::string text_of(double x) { return IniLines::text_of(x); }
std::string text_of(const PixelSize& s) {
  return std::to_string(s.width) + "x" + std::to_string(s.height);
}

template <std::vector<std::string> Options::*folders>
void write_folders(const Options& o, std::string_view name, IniLines& out) {
  for (const std::string& folder : o.*folders) out.add(name, folder);
}
void write_declares(const Options& o, std::string_view name, IniLines& out) {
  for (const auto& [identifier, value] : o.declares) {
    out.line(name, identifier + "=" + (number_in(value) ? value : '"' + value + '"'));
  }
}
void write_version(const Options& o, std::string_view name, IniLines& out) {
  if (o.language_version != 0) out.add(name, o.language_version / 100.0);
}
void write_clock(const Options& o, std::string_view name, IniLines& out) {
  if (o.clock_given) out.add(name, o.clock);
}
/// What follows from a lens sheet's size does so again.
void write_width(const Options& o, std::string_view name, IniLines& out) {
  if (!o.sheet_width || o.width_given) out.add(name, o.width);
}
void write_height(const Options& o, std::string_view name, IniLines& out) {
  if (!o.sheet_height || o.height_given) out.add(name, o.height);
}
template <bool Options::*srgb, double Options::*power>
void write_gamma(const Options& o, std::string_view name, IniLines& out) {
  out.line(name, o.*srgb ? "sRGB" : text_of(o.*power));
}
template <std::string Options::*word>
void write_word(const Options& o, std::string_view name, IniLines& out) {
  out.line(name, o.*word);
}
void write_area_adaptive(const Options& o, std::string_view name, IniLines& out) {
  if (o.overrides.area_light_adaptive == -1)
    out.line(name, "off");
  else
    out.add(name, o.overrides.area_light_adaptive);
}
void write_view_size(const Options& o, std::string_view name, IniLines& out) {
  if (o.views.size) out.line(name, text_of(*o.views.size));
}
void write_quilt(const Options& o, std::string_view name, IniLines& out) {
  if (o.views.quilt)
    out.line(name, text_of(PixelSize{o.views.quilt->columns, o.views.quilt->rows}));
}
void write_view_clock(const Options& o, std::string_view name, IniLines& out) {
  if (o.views.clocks)
    out.line(name, text_of(o.views.clocks->first) + ".." + text_of(o.views.clocks->second));
}
template <CommandKind kind>
void write_command(const Options& o, std::string_view name, IniLines& out) {
  const ShellCommand& command = o.commands[static_cast<std::size_t>(kind)];
  out.add(name, command.text);
}
template <CommandKind kind>
void write_return(const Options& o, std::string_view name, IniLines& out) {
  const ShellCommand& command = o.commands[static_cast<std::size_t>(kind)];
  if (!command.text.empty())
    out.line(name, std::string(command.on_success ? "-" : "") + command.action);
}
void write_scene_writes(const Options& o, std::string_view name, IniLines& out) {
  out.line(name, o.writes_to_disk ? "disk" : "memory");
}

template <std::vector<std::string> Options::*folders>
constexpr OptionAccess kFolders{add_folder<folders>, write_folders<folders>};
template <bool Options::*console, std::string Options::*file>
constexpr OptionAccess kConsole{set_console<console, file>, write_field<console>};
template <std::string Options::*file, Word usual>
constexpr OptionAccess kStreamFile{set_stream_file<file, usual>, write_field<file>};
template <CommandKind kind>
constexpr OptionAccess kCommand{set_command<kind>, write_command<kind>};
template <CommandKind kind>
constexpr OptionAccess kReturn{set_return<kind>, write_return<kind>};

constexpr bool is_positive(double x) { return x > 0.0; }
constexpr bool is_not_less_than_one(double x) { return x >= 1.0; }
constexpr bool is_angle(double x) { return x > 0.0 && x < 180.0; }
constexpr bool is_confidence(double x) { return x >= 0.0 && x < 1.0; }

using enum OptionUse;

constexpr OptionRow kTable[] = {
    // Scene.
    {"Input_File_Name", "I", kText<&Options::input>},
    {"Include_Header", "HI", kText<&Options::include_header>, kLight},
    {"Include_Ini", "", ignore, kNothing},  // whoever reads names reads it at once
    {"Library_Path", "L", kFolders<&Options::library_paths>, kWay},
    {"Declare", "", {add_declare, write_declares}, kLight},
    {"Version", "MV", {set_version, write_version}, kLight},
    {"Clock", "K", {set_clock, write_clock}, kWay},
    {"Initial_Frame", "KFI", kFrame<&AnimationOptions::initial_frame>, kWay},
    {"Final_Frame", "KFF", kFrame<&AnimationOptions::final_frame>, kWay},
    {"Initial_Clock", "KI", kClock<&AnimationOptions::initial_clock>, kWay},
    {"Final_Clock", "KF", kClock<&AnimationOptions::final_clock>, kWay},
    {"Subset_Start_Frame", "SF", kFrame<&AnimationOptions::subset_start>, kWay},
    {"Subset_End_Frame", "EF", kFrame<&AnimationOptions::subset_end>, kWay},
    {"Frame_Step", "STP", kCut<&AnimationOptions::step, 1, kMostFrames>, kWay},
    {"Cyclic_Animation", "KC", kFlag<&AnimationOptions::cyclic>, kWay},
    {"Clockless_Animation", "", only_off<"animation without a clock">, kWay},
    {"Real_Time_Raytracing", "", only_off<"real-time raytracing">, kWay},
    {"Field_Render", "UF", ignore, kNothing},
    {"Odd_Field", "UO", ignore, kNothing},
    // Picture.
    {"Width", "W", {set_width, write_width}, kPicture},
    {"Height", "H", {set_height, write_height}, kPicture},
    {"Start_Column", "SC", kEdge<&Options::start_column>, kPicture},
    {"Start_Row", "SR", kEdge<&Options::start_row>, kPicture},
    {"End_Column", "EC", kEdge<&Options::end_column>, kPicture},
    {"End_Row", "ER", kEdge<&Options::end_row>, kPicture},
    {"Continue_Trace", "C", kFlag<&Options::continues>},
    {"Create_Ini", "GI", set_create_ini},
    {"Output_to_File", "F", {output_option::to_file, write_field<&Options::output_to_file>}},
    {"Output_File_Type", "", {output_option::type, output_option::write_type}, kFile},
    {"Output_File_Name", "O", kText<&Options::output>},
    {"Output_Alpha", "UA", kFlag<&Options::alpha>, kLight},
    {"Bits_Per_Color", "", {output_option::bits, write_field<&Options::bits>}, kFile},
    {"Bits_Per_Colour", "", output_option::bits, kFile},
    {"Grayscale_Output", "", kFlag<&Options::grayscale>, kFile},
    {"Compression", "", kCut<&Options::compression, 0, 255, write_positive<&Options::compression>>,
     kFile},
    {"File_Gamma",
     "",
     {set_gamma<&Options::srgb, &Options::file_gamma>,
      write_gamma<&Options::srgb, &Options::file_gamma>},
     kFile},
    {"Display_Gamma",
     "",
     {set_gamma<&Options::display_srgb, &Options::display_gamma>,
      write_gamma<&Options::display_srgb, &Options::display_gamma>},
     kFile},
    {"Dither", "TH", {output_option::dither, write_field<&Options::dither>}, kFile},
    {"Dither_Method",
     "",
     {output_option::dither_method, output_option::write_dither_method},
     kFile},
    {"Quality", "Q", kCut<&Options::quality, 0, 11>, kLight},
    {"Work_Threads", "WT", kCut<&Options::threads, 1, 512, write_positive<&Options::threads>>},
    {"Antialias", "A", {set_antialias, write_field<&Options::antialias>}, kPicture},
    {"Sampling_Method",
     "AM",
     {set_sampling_method, write_field<&Options::sampling_method>},
     kPicture},
    {"Antialias_Threshold", "", kCut<&Options::antialias_threshold, 0, 1>, kPicture},
    {"Antialias_Depth", "R", kCut<&Options::antialias_depth, 1, 9>, kPicture},
    {"Antialias_Gamma",
     "AG",
     {set_antialias_gamma, write_field<&Options::antialias_gamma>},
     kPicture},
    {"Jitter", "J", {set_jitter, write_field<&Options::jitter>}, kPicture},
    {"Jitter_Amount", "", kCut<&Options::jitter_amount, 0, 1>, kPicture},
    {"Antialias_Angle", "", kWhole<&Options::antialias_angles, 1, 64>, kPicture},
    {"Antialias_Grid", "", kWhole<&Options::antialias_grid, 0, 64>, kPicture},
    {"Radiosity_File_Name", "RF", {set_radiosity_file, write_field<&Options::radiosity_file>}},
    {"Radiosity_From_File",
     "RFI",
     {set_radiosity_switch<&Options::radiosity_from_file>,
      write_field<&Options::radiosity_from_file>}},
    {"Radiosity_To_File",
     "RFO",
     {set_radiosity_switch<&Options::radiosity_to_file>, write_field<&Options::radiosity_to_file>}},
    {"Radiosity_Vain_Pretrace", "RVP", ignore, kNothing},
    {"High_Reproducibility", "HR", ignore, kNothing},
    // How stock works inside.
    {"Display", "D", set_display, kNothing},
    {"Video_Mode", "", ignore, kNothing},
    {"Palette", "", ignore, kNothing},
    {"Pause_When_Done", "P", ignore, kNothing},
    {"Preview_Start_Size", "SP", ignore, kNothing},
    {"Preview_End_Size", "EP", ignore, kNothing},
    {"Draw_Vistas", "UD", ignore, kNothing},
    {"Test_Abort", "X", ignore, kNothing},
    {"Test_Abort_Count", "", ignore, kNothing},
    {"Buffer_Output", "B", ignore, kNothing},
    {"Buffer_Size", "", ignore, kNothing},
    {"Max_Image_Buffer_Memory", "MI", ignore, kNothing},
    {"Render_Block_Size", "BS", ignore, kNothing},
    {"Render_Pattern", "RP", ignore, kNothing},
    {"Render_Block_Step", "RS", ignore, kNothing},
    {"Bounding", "MB", ignore, kNothing},
    {"Bounding_Threshold", "", ignore, kNothing},
    {"Bounding_Method", "BM", ignore, kNothing},
    {"BSP_MaxDepth", "", ignore, kNothing},
    {"BSP_BaseAccessCost", "", ignore, kNothing},
    {"BSP_ChildAccessCost", "", ignore, kNothing},
    {"BSP_IsectCost", "", ignore, kNothing},
    {"BSP_MissChance", "", ignore, kNothing},
    {"Vista_Buffer", "UV", ignore, kNothing},
    {"Remove_Bounds", "UR", ignore, kNothing},
    {"Split_Unions", "SU", ignore, kNothing},
    // Messages.
    {"Verbose", "V", kFlag<&Options::verbose>},
    {"Warning_Level", "WL", kCut<&Options::warning_level, 0, 10>},
    {"Stock_Messages", "", kFlag<&Options::stock_messages>},
    {"Debug_Console", "GD", kConsole<&Options::debug_console, &Options::debug_file>},
    {"Fatal_Console", "GF", kConsole<&Options::fatal_console, &Options::fatal_file>},
    {"Render_Console", "GR", kConsole<&Options::render_console, &Options::render_file>},
    {"Statistic_Console", "GS", kConsole<&Options::statistic_console, &Options::statistic_file>},
    {"Warning_Console", "GW", kConsole<&Options::warning_console, &Options::warning_file>},
    {"All_Console", "GA", {set_all_consoles, write_field<&Options::all_console>}},
    {"Debug_File", "", kStreamFile<&Options::debug_file, "debug.out">},
    {"Fatal_File", "", kStreamFile<&Options::fatal_file, "fatal.out">},
    {"Render_File", "", kStreamFile<&Options::render_file, "render.out">},
    {"Statistic_File", "", kStreamFile<&Options::statistic_file, "stats.out">},
    {"Warning_File", "", kStreamFile<&Options::warning_file, "warning.out">},
    {"All_File", "", kStreamFile<&Options::all_file, "alltext.out">},
    {"Append_File", "GP", kFlag<&Options::append_files>},
    // Programs to run.
    {"Pre_Scene_Command", "", kCommand<CommandKind::kPreScene>},
    {"Pre_Frame_Command", "", kCommand<CommandKind::kPreFrame>},
    {"Post_Scene_Command", "", kCommand<CommandKind::kPostScene>},
    {"Post_Frame_Command", "", kCommand<CommandKind::kPostFrame>},
    {"User_Abort_Command", "", kCommand<CommandKind::kUserAbort>},
    {"Fatal_Error_Command", "", kCommand<CommandKind::kFatalError>},
    {"Pre_Scene_Return", "", kReturn<CommandKind::kPreScene>},
    {"Pre_Frame_Return", "", kReturn<CommandKind::kPreFrame>},
    {"Post_Scene_Return", "", kReturn<CommandKind::kPostScene>},
    {"Post_Frame_Return", "", kReturn<CommandKind::kPostFrame>},
    {"User_Abort_Return", "", kReturn<CommandKind::kUserAbort>},
    {"Fatal_Error_Return", "", kReturn<CommandKind::kFatalError>},
    {"Restrict_IO", "", {set_restrict_io, write_field<&Options::restrict_io>}},
    {"Permitted_Path", "", kFolders<&Options::permitted_paths>},
    {"Strict", "", kFlag<&Options::strict>},
    // Lentray's own.
    {"Lenticular", "", kFlag<&Options::lenticular>, kPicture},
    {"Lens_Sheet", "", sheet_option::sheet, kPicture},
    {"Lens_Pitch", "", kLengthMm<&camera::LensRequest::pitch>, kPicture},
    {"Lens_LPI", "", kPositive<&camera::LensRequest::lpi>, kPicture},
    {"Print_LPI", "", kPositive<&camera::LensRequest::print_lpi>, kPicture},
    {"Lens_Thickness", "", kLengthMm<&camera::LensRequest::thickness>, kPicture},
    {"Lens_Radius", "", kLengthMm<&camera::LensRequest::radius>, kPicture},
    {"Lens_IOR", "",
     kNumber<&camera::LensRequest::ior, is_not_less_than_one,
             "a refractive index of at least 1 is expected">,
     kPicture},
    {"Lens_Angle", "",
     kNumber<&camera::LensRequest::angle, is_angle,
             "an angle greater than 0 and less than 180 degrees is expected">,
     kPicture},
    {"Lens_Focal_Length", "", kLengthMm<&camera::LensRequest::focal_length>, kPicture},
    {"Lens_Pixels", "",
     kNumber<&camera::LensRequest::pixels, is_not_less_than_one,
             "at least one pixel a lens is expected">,
     kPicture},
    {"Lens_Slant", "", {sheet_option::slant, sheet_option::write_slant}, kPicture},
    {"Lens_Direction", "", {sheet_option::direction, sheet_option::write_direction}, kPicture},
    {"Print_DPI", "", {sheet_option::print_dpi, sheet_option::write_print_dpi}, kPicture},
    {"Sheet_Width", "", kLengthMm<&Options::sheet_width>, kPicture},
    {"Sheet_Height", "", kLengthMm<&Options::sheet_height>, kPicture},
    {"Sheet_Size", "", sheet_option::sheet_size, kPicture},
    {"View_Distance",
     "",
     {sheet_option::view_distance, write_field<&camera::LensRequest::view_distance>},
     kPicture},
    {"Sheet_Distance",
     "",
     {sheet_option::sheet_distance, write_field<&Options::sheet_distance>},
     kPicture},
    {"Sheet_At", "", {sheet_option::sheet_at, write_field<&Options::sheet_at>}, kPicture},
    {"Depth", "", {sheet_option::depth, sheet_option::write_depth}, kPicture},
    {"Depth_Budget", "", {sheet_option::depth_budget, sheet_option::write_depth_budget}, kPicture},
    {"Lens_Front", "", {sheet_option::front, write_field<&camera::LensRequest::front>}, kPicture},
    {"Lens_Model", "", {sheet_option::model, sheet_option::write_model}, kPicture},
    {"Lens_Tolerance", "", kPositive<&camera::LensRequest::tolerance>, kPicture},
    {"Lens_Rays", "", kWhole<&camera::LensRequest::rays, 1, camera::kMostLensRays>, kPicture},
    {"View", "", kWhole<&Options::view, 0, 1'000'000>, kPicture},
    {"Views", "", kWhole<&ViewOptions::count, 1, kMostViews>, kPicture},
    {"View_Size", "", {set_view_size, write_view_size}, kPicture},
    {"View_Clock", "", {set_view_clock, write_view_clock}, kPicture},
    {"Quilt", "", {set_quilt, write_quilt}, kPicture},
    {"Quilt_Tile", "", set_view_size, kPicture},
    {"Quilt_Aspect", "", kPositive<&ViewOptions::aspect>, kPicture},
    {"View_Cone", "", {set_view_cone, write_field<&ViewOptions::cone>}, kPicture},
    {"View_Cameras", "", kText<&Options::view_cameras>},
    {"Shadow_Log", "", kFlag<&Options::shadow_log>},
    {"Pixel_Order", "", {set_order, write_word<&Options::pixel_order>}, kWay},
    {"Shadow_Cache", "", {set_cache, write_word<&Options::shadow_cache>}, kWay},
    {"Accelerator", "", {set_accelerator, write_word<&Options::accelerator>}, kWay},
    {"Area_Light_Samples", "", kWhole<&SceneOverrides::area_light_samples, 2, 1000>, kLight},
    {"Area_Light_Adaptive", "", {set_area_adaptive, write_area_adaptive}, kLight},
    {"Blur_Samples", "", kWhole<&SceneOverrides::blur_samples, 1, 65536>, kPicture},
    {"Max_Trace_Level", "", kWhole<&SceneOverrides::max_trace_level, 1, 256>, kLight},
    {"Adc_Bailout", "",
     kNumber<&SceneOverrides::adc_bailout, is_not_negative, "a number from 0 on is expected">,
     kLight},
    {"Radiosity_Count", "", kWhole<&RadiosityOverrides::count, 1, 1600>, kLight},
    {"Radiosity_Error_Bound", "",
     kNumber<&RadiosityOverrides::error_bound, is_positive, "a number greater than 0 is expected">,
     kLight},
    {"Radiosity_Nearest_Count", "", kWhole<&RadiosityOverrides::nearest_count, 1, 20>, kLight},
    {"Radiosity_Recursion_Limit", "", kWhole<&RadiosityOverrides::recursion_limit, 1, 20>, kLight},
    {"Photon_Count", "", kWhole<&PhotonOverrides::count, 1, kMostPhotons>, kLight},
    {"Photon_Gather", "", kWhole<&PhotonOverrides::gather, 1, kMostPhotons>, kLight},
    {"Subsurface_Samples", "", kWhole<&SceneOverrides::subsurface_samples, 1, 1'000'000>, kLight},
    {"Media_Method", "", kWhole<&MediaSettings::method, 1, 3>, kLight},
    {"Media_Intervals", "", kWhole<&MediaSettings::intervals, 1, kMostMediaSamples>, kLight},
    {"Media_Samples", "", kWhole<&MediaSettings::samples, 1, kMostMediaSamples>, kLight},
    {"Media_Confidence", "",
     kNumber<&MediaSettings::confidence, is_confidence,
             "a number from 0 to less than 1 is expected">,
     kLight},
    {"Radiosity_Samples", "",
     kWhole<&Options::radiosity_samples, 1, std::numeric_limits<std::int32_t>::max(),
            write_positive<&Options::radiosity_samples>>},
    {"Specialised_Paths", "", kFlag<&Options::specialised_paths>, kWay},
    {"Light_Buffer", "UL", kFlag<&Options::light_buffer>, kWay},
    {"Max_Memory", "", {set_bytes<&Options::max_memory>, write_positive<&Options::max_memory>}},
    {"Max_Pixels", "", {set_pixels, write_positive<&Options::max_pixels>}},
    {"Max_Written", "", {set_bytes<&Options::max_written>, write_positive<&Options::max_written>}},
    {"Max_Files", "",
     kWhole<&Options::max_files, 1, std::numeric_limits<std::int32_t>::max(),
            write_positive<&Options::max_files>>},
    {"Max_Time", "", {set_time, write_positive<&Options::max_time>}},
    {"Band_Height", "",
     kWhole<&Options::band_height, 1, std::numeric_limits<std::int32_t>::max(),
            write_positive<&Options::band_height>>},
    {"Statistics_File", "", kText<&Options::statistics_file>},
    {"Count_Tests", "", kFlag<&Options::count_tests>},
    {"Dependencies_File", "", kText<&Options::dependencies_file>},
    {"Scene_Writes", "", {set_scene_writes, write_scene_writes}},
};

}  // namespace

std::span<const OptionRow> option_table() { return kTable; }

}  // namespace lentray::parser
