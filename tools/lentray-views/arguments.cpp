#include "tools/lentray-views/arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "camera/lens_sheet.h"
#include "camera/slanted_sheet.h"
#include "parser/options/ini.h"
#include "parser/options/option_access.h"
#include "parser/options/own_option.h"
#include "tools/lentray-views/lens_words.h"
#include "tools/lentray-views/moving.h"

namespace lentray::views {

using parser::GivenOption;
using parser::OptionError;

namespace {

std::uint32_t whole(const GivenOption& given, std::uint32_t least) {
  return static_cast<std::uint32_t>(parser::whole_number(given, least, 1'000'000));
}

/// Two whole numbers with something between them.
std::optional<std::array<std::uint32_t, 2>> two_numbers(std::string_view text,
                                                        std::string_view mark) {
  std::array<std::uint32_t, 2> out{};
  const std::size_t at = text.find(mark);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view parts[] = {text.substr(0, at), text.substr(at + mark.size())};
  for (std::size_t i = 0; i < 2; ++i) {
    const char* const end = parts[i].data() + parts[i].size();
    const auto [stop, error] = std::from_chars(parts[i].data(), end, out[i]);
    if (error != std::errc() || stop != end || out[i] > 1'000'000) return std::nullopt;
  }
  return out;
}

Range range_in(const GivenOption& given) {
  const auto ends = two_numbers(given.value, "..");
  if (!ends || (*ends)[1] < (*ends)[0]) {
    parser::refuse(given, "a first and a last view are expected, such as 0..14");
  }
  return {(*ends)[0], (*ends)[1]};
}

Range pair_in(const GivenOption& given) {
  const auto both = two_numbers(given.value, ",");
  if (!both) parser::refuse(given, "the left and the right eye's view are expected, such as 9,5");
  return {(*both)[0], (*both)[1]};
}

Size sides_in(const GivenOption& given, std::uint32_t most, const char* expected) {
  const auto both = two_numbers(given.value, "x");
  if (!both || std::ranges::min(*both) == 0 || std::ranges::max(*both) > most) {
    parser::refuse(given, expected);
  }
  return {(*both)[0], (*both)[1]};
}

/// Pixels, or of a lens sheet with its unit.
void take_size(Arguments& a, const GivenOption& given) {
  a.size.reset();
  a.size_mm.reset();
  if (given.value.find_first_not_of("0123456789x") != std::string::npos &&
      given.value.find('x') != std::string::npos && !two_numbers(given.value, "x")) {
    a.size_mm = parser::extent_mm(given);
    return;
  }
  a.size = sides_in(given, 1'000'000, "a size such as 420x560 is expected");
}

void set_quilt(Arguments& a, const GivenOption& given) {
  const Size grid = sides_in(given, 1000, "columns x rows of views are expected, such as 8x6");
  a.columns = grid.width;
  a.rows = grid.height;
}

Eye eye_in(const GivenOption& given) {
  const std::size_t comma = given.value.find(',');
  const auto part = [&](std::string text) {
    return parser::number(parser::part_of(given, std::move(text)));
  };
  Eye eye;
  eye.angle = part(given.value.substr(0, comma));
  if (!(std::fabs(eye.angle) < 90.0)) {
    parser::refuse(given, "an angle between -90 and 90 degrees is expected");
  }
  if (comma != std::string::npos) eye.distance = part(given.value.substr(comma + 1));
  if (comma != std::string::npos && !(eye.distance > 0.0)) {
    parser::refuse(given, "the eye's distance must be greater than 0 mm");
  }
  return eye;
}

Filter filter_in(const GivenOption& given) {
  const auto filter = filter_named(given.value);
  if (!filter) parser::refuse(given, "there are " + std::string(kFilterNames));
  return *filter;
}

camera::LensModel lens_model_in(const GivenOption& given) {
  const auto model = camera::model_named(given.value);
  if (!model) parser::refuse(given, "there are paraxial, pinhole and thick");
  return *model;
}

double distance_in(const GivenOption& given) {
  const double distance = given.value == "inf" ? 0.0 : parser::length_mm(given);
  if (distance < 0.0) parser::refuse(given, "a distance of 0 or more is expected");
  return distance;
}

double slant_in(const GivenOption& given) {
  const auto slant = camera::tangent_of_slant(given.value);
  if (!slant) parser::refuse(given, camera::kSlantExpected);
  return *slant;
}

double pixels_in(const GivenOption& given) {
  const double pixels = parser::number(given);
  if (pixels < 1.0) parser::refuse(given, "at least one pixel a lens is expected");
  return pixels;
}

bool is_loop_in(const GivenOption& given) { return parser::is_second(given, "sway", "loop"); }

bool is_given_order(const GivenOption& given) {
  return parser::is_second(given, "natural", "given");
}

/// What the words say, and which of them chose the task.
struct Words : Arguments {
  std::string task_word{};
  bool some_views = false;

  void choose(Task chosen, const std::string& name) {
    if (!task_word.empty() && task_word != name) {
      throw OptionError(task_word + " and " + name + " are two tasks: give one of them");
    }
    task_word = name;
    task = chosen;
  }
};

/// What an option of lentray does that goes by its first name there, or by another here.
template <parser::Word name>
constexpr auto kLensWord =
    [](Words& w, const GivenOption& g) { take_lens_word(w.lens_words, name.text, g); };

using parser::set;
template <auto Member>
constexpr auto of_sheet = parser::of_member<&Words::sheet, Member>;

constexpr parser::OwnOption<Words> kOptions[] = {
    {"View",
     [](Words& w, const GivenOption& g) {
       w.choose(Task::kViews, "--view");
       const std::uint32_t view = whole(g, 0);
       w.range = Range{view, view};
     }},
    {"Views",
     [](Words& w, const GivenOption& g) {
       w.range = range_in(g);
       w.some_views = true;
     }},
    {"Lens",
     [](Words& w, const GivenOption& g) {
       w.choose(Task::kLens, "--lens");
       w.lens = whole(g, 0);
     }},
    {"Quilt",
     [](Words& w, const GivenOption& g) {
       w.choose(Task::kQuilt, "--quilt");
       set_quilt(w, g);
     }},
    {"Eye", set<&Words::eye, eye_in>},
    {"Eyes", set<&Words::eyes, parser::positive>},
    {"Pair", set<&Words::pair, pair_in>},
    {"Wiggle",
     [](Words& w, const GivenOption& g) {
       w.choose(Task::kWiggle, "--wiggle");
       w.out = parser::file_name(g);
     }},
    {"Delay", set<&Words::delay, parser::whole_number, 10, kLongestDelay>},
    {"Out", set<&Words::out, parser::any_file>},
    {"Count", set<&Words::count, whole, 1u>},
    {"Size", [](Words& w, const GivenOption& g) { take_size(w, g); }},
    {"Filter", set<&Words::filter, filter_in>},
    {"Like", set<&Words::like, parser::any_file>},
    {"Aspect", set<of_sheet<&SheetOptions::aspect>, parser::positive>},
    {"Lens_Pixels", set<of_sheet<&SheetOptions::pixels>, pixels_in>},
    {"Lens_Pitch", set<of_sheet<&SheetOptions::pitch>, parser::positive_length_mm>},
    {"Lens_Focal_Length", set<of_sheet<&SheetOptions::focal_length>, parser::positive_length_mm>},
    {"Lens_IOR", set<of_sheet<&SheetOptions::ior>, parser::positive>},
    {"Lens_Model", set<of_sheet<&SheetOptions::model>, lens_model_in>},
    {"View_Distance", set<of_sheet<&SheetOptions::view_distance>, distance_in>},
    {"Lens_Slant", set<of_sheet<&SheetOptions::slant>, slant_in>},
    {"Lens_Sheet",
     [](Words& w, const GivenOption& g) {
       take_lens_word(w.lens_words, "Lens_Sheet", g);
       if (w.lens_words.list_lens_sheets) w.choose(Task::kListSheets, "--lens-sheet list");
     }},
    {"Lpi", kLensWord<"Lens_LPI">},
    {"Lens_LPI", kLensWord<"Lens_LPI">},
    {"Print_LPI", kLensWord<"Print_LPI">},
    {"Lens_Thickness", kLensWord<"Lens_Thickness">},
    {"Lens_Radius", kLensWord<"Lens_Radius">},
    {"Lens_Angle", kLensWord<"Lens_Angle">},
    {"Dpi", kLensWord<"Print_DPI">},
    {"Print_DPI", kLensWord<"Print_DPI">},
    {"Motion", set<&Words::is_loop, is_loop_in>},
    {"Preview",
     [](Words& w, const GivenOption& g) {
       w.choose(Task::kPreview, "--preview");
       w.out = parser::file_name(g);
     }},
    {"Page_Limit", set<&Words::page_limit, parser::positive>},
    {"Profile", set<&Words::profiles, tool::profiles_in>},
    {"Order", set<&Words::given_order, is_given_order>},
};

constexpr std::pair<std::string_view, Task> kTasks[] = {
    {"--all", Task::kViews}, {"--stereo", Task::kStereo}, {"--interlace", Task::kInterlace}};
constexpr std::pair<std::string_view, bool Arguments::*> kFlags[] = {
    {"--between", &Arguments::between},     {"--one-zone", &Arguments::one_zone},
    {"--from-left", &Arguments::from_left}, {"--from-top", &Arguments::from_left},
    {"--square", &Arguments::square},       {"--take-any", &Arguments::takes_any}};

bool take_anaglyph(Words& w, const std::string& word) {
  w.choose(Task::kAnaglyph, "--anaglyph");
  if (word == "--anaglyph" || word == "--anaglyph=dubois") return true;
  if (word != "--anaglyph=plain") {
    throw OptionError("'" + word + "': there are --anaglyph=dubois and --anaglyph=plain");
  }
  w.anaglyph = Anaglyph::kPlain;
  return true;
}

bool take_flag(Words& w, const std::string& word) {
  for (const auto& [name, task] : kTasks) {
    if (word != name) continue;
    w.choose(task, word);
    return true;
  }
  for (const auto& [name, member] : kFlags) {
    if (word == name) return w.*member = true;
  }
  if (word == "--across") return w.sheet.across = true;
  return word.starts_with("--anaglyph") && take_anaglyph(w, word);
}

/// A lens sheet, in the words that say its pitch.
bool says_lens(const Arguments& a) {
  return !a.lens_words.lens_sheet.empty() || says_pitch(a.lens_words) || a.sheet.pitch;
}

void check_interlace(const Arguments& a) {
  const bool one = a.task == Task::kViews || a.task == Task::kLens || a.task == Task::kEye ||
                   a.task == Task::kDescribe || a.task == Task::kPreview;
  if (one && a.pictures.size() > 1) {
    throw OptionError("'" + a.pictures[1].string() + "': one integral image is expected");
  }
  if (a.task != Task::kInterlace) {
    if (!a.like.empty()) throw OptionError("--like is of --interlace");
    if (a.takes_any) throw OptionError("--take-any is of --interlace");
    if (a.size_mm) throw OptionError("a --size in mm is that of the lens sheet of --interlace");
    return;
  }
  if (a.pictures.size() < 2) throw OptionError("--interlace wants two pictures or more");
  if (a.like.empty() && !a.sheet.pixels && !(says_lens(a) && a.lens_words.lens.print_dpi)) {
    throw OptionError(
        "--interlace wants --like IMAGE, or --lens-pixels N, or --lens-sheet NAME (or --lpi L) "
        "with "
        "--dpi D");
  }
  if (!a.like.empty() && (says_lens(a) || a.lens_words.lens.print_dpi)) {
    throw OptionError(
        "--like says which lens sheet it is: leave out --lens-sheet, --lpi and --dpi");
  }
  if (a.like.empty() && !a.sheet.pixels && !a.size && !a.size_mm) {
    throw OptionError("--size gives how large the lens sheet is, such as --size 100x75mm");
  }
  if (a.size_mm && !says_lens(a) && !a.sheet.pitch && !a.lens_words.lens.print_dpi) {
    throw OptionError("a --size in mm needs --lens-sheet, --lpi or --dpi");
  }
  if (a.square) throw OptionError("--square is of views, not of --interlace");
}

/// What the options can only be judged on together.
void check(Words& a) {
  if (a.task == Task::kListSheets) return;
  if (a.pictures.empty()) {
    throw OptionError("no picture is given; lentray-views --help lists all options");
  }
  if (a.some_views && a.task == Task::kDescribe) a.task = Task::kViews;
  if (a.some_views && (a.task_word == "--view" || a.task_word == "--all")) {
    throw OptionError("--views and " + a.task_word + " contradict each other: give one of them");
  }
  if (a.some_views && a.task != Task::kViews && a.task != Task::kWiggle) {
    throw OptionError("--views does not go with " + a.task_word);
  }
  if (a.eye && a.task == Task::kDescribe) a.task = Task::kEye;
  const bool has_eyes = a.task == Task::kStereo || a.task == Task::kAnaglyph;
  if (a.eye && !has_eyes && a.task != Task::kEye && a.task != Task::kPreview) {
    throw OptionError("--eye does not go with " + a.task_word);
  }
  if (a.pair && !has_eyes) throw OptionError("--pair is of --stereo and --anaglyph");
  if (a.one_zone && (!has_eyes || a.pair)) {
    throw OptionError("--one-zone is of --stereo and --anaglyph, of eyes before a sheet");
  }
  if (a.pair && a.eye) throw OptionError("--pair and --eye contradict each other");
  if (a.is_loop && a.task != Task::kWiggle && a.task != Task::kInterlace) {
    throw OptionError("--motion is of --wiggle and --interlace");
  }
  if (a.square && a.size) throw OptionError("--square and --size contradict each other");
  const bool is_for_screens = a.task == Task::kWiggle || a.task == Task::kPreview;
  if (a.profiles == tool::Profiles::kKeep && is_for_screens) {
    throw OptionError("--profile keep does not go with " + a.task_word + ", which has sRGB alone");
  }
  check_interlace(a);
}

}  // namespace

Arguments parse_arguments(const std::vector<std::string>& words) {
  Words out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (take_flag(out, words[i]) || parser::take_own_option(words, i, kOptions, out)) continue;
    if (words[i].starts_with("-")) {
      throw OptionError("unknown option '" + words[i].substr(0, words[i].find('=')) +
                        "'; lentray-views --help lists all options");
    }
    out.pictures.emplace_back(words[i]);
  }
  check(out);
  return out;
}

}  // namespace lentray::views
