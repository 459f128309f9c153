#include "tools/lentray-print/arguments.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "camera/text.h"
#include "parser/options/ini.h"
#include "parser/options/own_option.h"
#include "parser/options/paper.h"
#include "tools/lentray-print/page.h"

namespace lentray::print {

using camera::format;
using parser::GivenOption;
using parser::OptionError;

namespace {

constexpr unsigned kPitch = 1, kPhase = 2, kEye = 4, kSheet = 8;
constexpr unsigned kTests = kPitch | kPhase | kEye, kAll = kTests | kSheet;

struct CommandName {
  std::string_view name;
  Command command;
  unsigned bit;
};
constexpr CommandName kCommands[] = {{"pitch-test", Command::pitch_test, kPitch},
                                     {"phase-test", Command::phase_test, kPhase},
                                     {"eye-test", Command::eye_test, kEye},
                                     {"sheet", Command::sheet, kSheet}};

double number_within(const GivenOption& given, double least, double most) {
  const double value = parser::number(given);
  if (!(value >= least && value <= most)) {
    parser::refuse(given,
                   "a number from " + format(least) + " to " + format(most) + " is expected");
  }
  return value;
}

double length_within(const GivenOption& given, double least, double most) {
  const double value = parser::size_mm(given);
  if (!(value >= least && value <= most)) {
    parser::refuse(given,
                   "a length from " + format(least) + " to " + format(most) + " mm is expected");
  }
  return value;
}

constexpr double kLeastLpi = 1.0, kMostLpi = 1000.0;

double pitch_of_lpi(const GivenOption& given) {
  return kInch / number_within(given, kLeastLpi, kMostLpi);
}

double lens_pitch(const GivenOption& given) {
  return length_within(given, kInch / kMostLpi, kInch / kLeastLpi);
}

/// "39.87lpi" or "0.637mm".
double pitch_of(const GivenOption& given) {
  constexpr std::string_view kUnit = "lpi";
  if (!given.value.ends_with(kUnit)) {
    if (given.value.find_first_not_of("0123456789.+- ") == std::string::npos) {
      parser::refuse(given, "a pitch with its unit is expected, such as 39.87lpi or 0.637mm");
    }
    return lens_pitch(given);
  }
  GivenOption lpi = given;
  lpi.value.resize(lpi.value.size() - kUnit.size());
  while (lpi.value.ends_with(' ')) lpi.value.pop_back();
  return pitch_of_lpi(lpi);
}

Colour colour_of(const GivenOption& given) {
  if (given.value == "white") return kWhite;
  if (given.value == "black") return {};
  unsigned value = 0;
  const char* const begin = given.value.data();
  const auto [end, error] =
      std::from_chars(begin + 1, begin + given.value.size(), value, given.value.empty() ? 10 : 16);
  if (given.value.size() != 7 || given.value[0] != '#' || error != std::errc() ||
      end != begin + given.value.size()) {
    parser::refuse(given, "white, black or a colour such as #c0c0c0 is expected");
  }
  return {(value >> 16) / 255.0, (value >> 8 & 255u) / 255.0, (value & 255u) / 255.0};
}

Marks marks_of(const GivenOption& given) {
  if (given.value == "all") return Marks::all;
  if (given.value == "crop") return Marks::crop;
  if (given.value != "none") parser::refuse(given, "there are all, crop and none");
  return Marks::none;
}

struct ValueOption {
  std::string_view name;  ///< of two words: Lens_Pitch
  unsigned commands;
  void (*apply)(Arguments& a, const GivenOption& given);
};

constexpr double kMostDpi = 50000.0;

double dpi_of(const GivenOption& given) { return number_within(given, 10.0, kMostDpi); }

/// "720", or "1440x720": across the lenses, and along them. As Print_DPI of lentray has it.
void take_dpi(Arguments& a, const GivenOption& given) {
  const std::size_t times = given.value.find_first_of("xX");
  a.lens.dpi_x = dpi_of(parser::part_of(given, given.value.substr(0, times)));
  a.dpi_says_both = times != std::string::npos;
  if (!a.dpi_says_both) return;
  a.lens.dpi_y = dpi_of(parser::part_of(given, given.value.substr(times + 1)));
}

constexpr int kMostPictures = 1000;

/// "3x4": columns and rows.
LayoutGrid grid_of(const GivenOption& given) {
  const std::size_t times = given.value.find_first_of("xX");
  if (times == std::string::npos) {
    parser::refuse(given, "columns x rows of pictures are expected, such as 3x4");
  }
  const GivenOption columns = parser::part_of(given, given.value.substr(0, times)),
                    rows = parser::part_of(given, given.value.substr(times + 1));
  const LayoutGrid grid{
      .columns = static_cast<int>(parser::whole_number(columns, 1, kMostPictures)),
      .rows = static_cast<int>(parser::whole_number(rows, 1, kMostPictures))};
  if (grid.places() > kMostPictures) parser::refuse(given, "1000 pictures are possible");
  return grid;
}

/// "8", or "3x4".
void take_copies(Arguments& a, const GivenOption& given) {
  a.copies_grid.reset();
  if (given.value.find_first_of("xX") != std::string::npos) {
    a.copies_grid = grid_of(given);
  } else {
    a.copies = static_cast<int>(parser::whole_number(given, 1, kMostPictures));
  }
}

double lpi_of(const GivenOption& given) { return number_within(given, 1e-4, kMostLpi); }
double focal_length_of(const GivenOption& given) { return length_within(given, 1e-3, 1000.0); }
bool are_hard(const GivenOption& given) { return parser::is_second(given, "grey", "hard"); }
bool is_together(const GivenOption& given) { return parser::is_second(given, "apart", "together"); }
bool is_of_picture(const GivenOption& given) { return parser::is_second(given, "edge", "picture"); }

using A = Arguments;
using parser::of_member;
using parser::set;

constexpr ValueOption kValues[] = {
    {"Out", kAll, set<&A::out, parser::any_file>},
    {"Lpi", kAll, set<of_member<&A::lens, &GivenLensData::lens_pitch>, pitch_of_lpi>},
    {"Lens_Pitch", kAll, set<of_member<&A::lens, &GivenLensData::lens_pitch>, lens_pitch>},
    {"Dpi", kAll, take_dpi},
    {"Size", kTests, set<&A::size, parser::paper_extent>},
    {"Span", kPitch | kPhase, set<&A::span, lpi_of>},
    {"Step", kPitch | kPhase, set<&A::step, lpi_of>},
    {"Bands", kPitch | kPhase, set<&A::bands, parser::whole_number, 1, 200>},
    {"Edges", kTests, set<&A::hard_edges, are_hard>},
    {"Phases", kPhase, set<&A::phases, parser::whole_number, 2, 64>},
    {"Distance", kEye, set<&A::distance, length_within, 10, 100000>},
    {"Eyes", kEye, set<&A::separation, length_within, 1, 1000>},
    {"Focal_Length", kEye, set<&A::focal_length, focal_length_of>},
    {"Ior", kEye, set<&A::ior, number_within, 1, 4>},
    {"Pixels", kSheet, set<of_member<&A::lens, &GivenLensData::pixels>, number_within, 1, 100000>},
    {"Dpi_Y", kAll,
     [](Arguments& a, const GivenOption& g) {
       a.lens.dpi_y = dpi_of(g);
       a.has_dpi_y = true;
     }},
    {"Copies", kSheet, take_copies},
    {"Grid", kSheet, set<&A::grid, grid_of>},
    {"Gap", kSheet, set<of_member<&A::style, &SheetStyle::gap>, length_within, 0, 1000>},
    {"Seen", kSheet, set<of_member<&A::style, &SheetStyle::is_seen_together>, is_together>},
    {"Paper", kSheet, set<of_member<&A::style, &SheetStyle::paper>, parser::paper_extent>},
    {"Margin", kSheet, set<&A::margin, length_within, 0, 1000>},
    {"Bleed", kSheet, set<of_member<&A::style, &SheetStyle::bleed>, length_within, 0, 200>},
    {"Bleed_From", kSheet, set<of_member<&A::style, &SheetStyle::bleed_of_picture>, is_of_picture>},
    {"Marks", kSheet, set<of_member<&A::style, &SheetStyle::marks>, marks_of>},
    {"Background", kSheet, set<of_member<&A::style, &SheetStyle::background>, colour_of>},
    {"Overlap", kSheet, set<&A::overlap, length_within, 0, 1000>},
    {"Pitch", kSheet, set<&A::print_pitch, pitch_of>},
    {"Bits", kSheet,
     [](Arguments& a, const GivenOption& g) {
       a.bits = static_cast<int>(parser::whole_number(g, 8, 16));
       if (a.bits != 8 && a.bits != 16) parser::refuse(g, "there are 8 and 16");
     }},
    {"Profile", kSheet, set<&A::profiles, tool::profiles_in>},
};

struct Switch {
  std::string_view name;
  unsigned commands;
  bool Arguments::*member;
};
constexpr Switch kSwitches[] = {{"--fine", kPitch | kPhase, &Arguments::fine},
                                {"--mirror", kAll, &Arguments::mirror},
                                {"--horizontal", kAll, &Arguments::horizontal},
                                {"--across", kAll, &Arguments::across},
                                {"--tiles", kSheet, &Arguments::tiles}};

std::string options_of(unsigned command) {
  std::string all;
  for (const ValueOption& row : kValues) {
    if (row.commands & command) all += " " + parser::long_name(row.name);
  }
  for (const Switch& row : kSwitches) {
    if (row.commands & command) all += " " + std::string(row.name);
  }
  return all + " --help --version";
}

/// The words behind the command.
class Reading {
 public:
  Reading(Arguments& arguments, const CommandName& command)
      : m_out(arguments), m_command(command) {}

  void word(const std::vector<std::string>& words, std::size_t& at) {
    const std::string& text = words[at];
    if (!text.starts_with("--")) {
      picture(text);
      return;
    }
    for (const Switch& row : kSwitches) {
      if (text != row.name) continue;
      check_command(text, row.commands);
      m_out.*row.member = true;
      return;
    }
    for (const ValueOption& row : kValues) {
      if (const auto given = parser::own_option(words, at, row.name)) return apply(row, *given);
    }
    throw OptionError("unknown option '" + text.substr(0, text.find('=')) + "'; " +
                      std::string(m_command.name) + " has" + options_of(m_command.bit));
  }

 private:
  void apply(const ValueOption& row, const GivenOption& given) {
    const std::string name = parser::long_name(row.name);
    check_command(name, row.commands);
    row.apply(m_out, given);
    if (row.name != "Lpi" && row.name != "Lens_Pitch") return;
    if (!m_pitch_by.empty() && m_pitch_by != name) {
      throw OptionError("--lpi and --lens-pitch say the same thing: give one of them");
    }
    m_pitch_by = name;
  }

  void picture(const std::string& text) {
    if (m_command.bit != kSheet) {
      throw OptionError(std::string(m_command.name) + " takes no picture, but '" + text +
                        "' is given");
    }
    m_out.images.push_back(text);
  }

  void check_command(const std::string& name, unsigned commands) const {
    if (commands & m_command.bit) return;
    throw OptionError(name + " is no option of " + std::string(m_command.name) + ", which has" +
                      options_of(m_command.bit));
  }

  Arguments& m_out;
  const CommandName& m_command;
  std::string m_pitch_by;
};

void check_pictures(const Arguments& a) {
  if (a.grid && a.copies_grid) {
    throw OptionError("--copies CxR gives the grid already: leave --grid out");
  }
  if (a.images.size() * static_cast<std::size_t>(a.copies) > kMostPictures) {
    throw OptionError(std::to_string(a.images.size()) + " pictures " + std::to_string(a.copies) +
                      " times each: 1000 are possible");
  }
}

/// What the options can only be judged on together.
void check_together(Arguments& a) {
  if (a.out.empty()) throw OptionError("--out FILE is missing: a .pdf, .tif or .png");
  if (a.dpi_says_both && a.has_dpi_y) {
    throw OptionError("--dpi has two numbers, across the lenses and along them: leave --dpi-y out");
  }
  if (a.command == Command::sheet) {
    check_pictures(a);
    if (a.images.empty())
      throw OptionError("sheet needs a picture: lentray-print sheet PICTURE --out FILE");
    if (a.tiles && !a.style.paper) throw OptionError("--tiles needs --paper");
    a.style.margin = a.margin.value_or(a.style.margin);
    return;
  }
  if (a.across && a.command == Command::eye_test) {
    throw OptionError(
        "eye-test is of upright lenses: two eyes see the same of lenses that lie across");
  }
  a.horizontal |= a.across;
  if (!a.lens.lens_pitch)
    throw OptionError("--lpi L is missing, or --lens-pitch: the lenses of the sheet");
  if (a.command == Command::eye_test && a.focal_length == 0.0) {
    throw OptionError(
        "--focal-length F is missing: of the lens in its material, about the sheet's thickness");
  }
  if (a.bands && a.step) throw OptionError("--bands and --step exclude each other");
  if (a.fine && (a.bands || a.step || a.span)) {
    throw OptionError("--fine stands for --span 0.1 --step 0.01: leave these and --bands out");
  }
}

}  // namespace

Arguments parse_arguments(const std::vector<std::string>& words) {
  Arguments a;
  const CommandName* command = nullptr;
  std::optional<Reading> reading;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (command) {
      reading->word(words, i);
    } else {
      for (const CommandName& row : kCommands) {
        if (word == row.name) command = &row;
      }
      if (!command) {
        throw OptionError("unknown command '" + word +
                          "'; there are pitch-test, phase-test, eye-test and sheet");
      }
      a.command = command->command;
      reading.emplace(a, *command);
    }
  }
  if (!command) throw OptionError("no command is given; lentray-print --help lists all");
  check_together(a);
  return a;
}

std::string usage() {
  return R"(usage: lentray-print pitch-test --lpi L [--dpi D] --out FILE
       lentray-print phase-test --lpi L [--dpi D] --out FILE
       lentray-print eye-test --lpi L --focal-length F --distance V --out FILE
       lentray-print sheet PICTURE... --out FILE

Brings integral images to paper, and measures lens sheets. The file is a .pdf,
.tif or .png of exact size: print it at 100 %, without fitting it to the page,
at the resolution that was asked for.

pitch-test draws gratings of lines about the lenses' pitch, each with its
number. Seen through the lens sheet from the final distance, the one that turns
dark or light as a whole has the pitch that sheet, printer and distance have
together. phase-test draws them in cells whose lines are shifted, which shows
where the lenses stand. eye-test draws rows that are black to the left eye and
white to the right from the distance beside them.

sheet puts integral images of lentray on a page, with marks for laying the
lens sheet on and for cutting. Strips are printed as they are, never resampled,
unless --pitch asks for it. Several pictures, or copies, lie on one lens sheet:
each stands at whole lenses of it. Where these are no whole pixels, its pixels
are the mean of two.

Lengths have a unit: mm, cm, m or in.

Of all commands:
  --out FILE           what is written: .pdf, .tif or .png. It appears when it
                       is whole, and what stood there before stays until then
  --lpi L              lenses an inch
  --lens-pitch P       the same as a length: 0.635mm
  --dpi D|DxE          the printer's pixels an inch: of tests (600), or where a
                       picture does not say. DxE: D across the lenses, where
                       the views lie, and E along them, as Print_DPI has it
  --dpi-y E            the same as that E
  --mirror             as seen from behind, for prints on the lens sheet's back
  --horizontal         the page, turned by 90 degrees clockwise
  --across             the lenses lie across the page: of tests the same as
                       --horizontal. Of sheets the picture stays upright and its
                       strips are rows; pictures of lentray say it themselves
  --help, --version

Of tests:
  --size WxH           the page, or its paper's name (200x100mm; A4, letter)
  --span S, --step T   gratings from L - S to L + S by T lines an inch (0.5 by
                       0.1; of phase-test 0.2 by 0.1)
  --bands N            as many gratings over the span, instead of a step
  --fine               the second print: --span 0.1 --step 0.01
  --edges grey|hard    pixels that an edge crosses are grey, by their share (the
                       default), or black or white
  --phases N           shifts of phase-test, of a lens (8)
  --distance V         from the sheet to the eyes, of eye-test (500mm)
  --eyes E             between the eyes (65mm)
  --focal-length F     of the lens, in its material: about the sheet's thickness
  --ior N              its refractive index (1.56)

Of sheets:
  --copies N|CxR       of each picture; CxR: as many columns and rows of places,
                       which the pictures fill in turn (1)
  --grid CxR           columns and rows of pictures (as few as it takes, and as
                       the paper has room)
  --gap G              between pictures, at least; up to 1 mm more where they
                       then stand at whole pixels (5mm, or what bleed takes)
  --seen apart|together
                       pictures are cut apart, and each is right for an eye
                       before its own middle (the default); or the sheet stays
                       whole, and one eye sees all of it
  --paper NAME         the page: A0 to A6, A3+, letter, legal, tabloid, or WxH;
                       A4-landscape lies on its side
                       such as 300x200mm, upright or across; without it as large
                       as it takes
  --margin M           blank border of the page (5mm)
  --bleed B            what is printed beyond the cut, at the sides whole lenses
                       (0mm)
  --bleed-from edge|picture
                       it goes on from the picture's edge, view by view (the
                       default), or is the outer part of the picture itself
  --marks all|crop|none
                       gratings of the strips' pitch and bars round the picture,
                       crop marks and label; crop marks alone; nothing (all)
  --background C       white, black or #rrggbb; marks are black or white, as
                       shows better (white)
  --tiles              cuts a sheet that is larger than the paper into pages,
                       between lenses; .tif and .png have a file for each page
  --overlap O          of neighbouring tiles (10mm)
  --pitch P            the pitch that a test has measured: 39.87lpi or 0.637mm.
                       The strips are made of the views that the picture has.
                       That is not exact: the error is given, and the options of
                       lentray that render it exactly
  --pixels N           pixels a lens, where the picture does not say
  --bits 8|16          a channel (as the picture has)
  --profile srgb|keep  a picture with a colour profile is converted to sRGB (the
                       default), or stays as it is, and the profile goes into
                       the file

Examples:
  lentray-print pitch-test --lpi 40 --dpi 600 --size A4 --out pitch.pdf
  lentray-print pitch-test --lpi 39.9 --fine --dpi 600 --size A4 --out fine.pdf
  lentray a.pov +W3000 +H2400 Lenticular=On Lens_LPI=40 Print_DPI=600 +Os.png
  lentray-print sheet s.png --bleed 3mm --paper A4 --out s.pdf
  lentray-print sheet s.png --pitch 39.87lpi --paper A4 --out s.pdf

Exit status: 0 done, 1 something is wrong with the options or the picture, or
the file could not be written.
)";
}

}  // namespace lentray::print
