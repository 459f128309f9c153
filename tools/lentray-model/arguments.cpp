#include "tools/lentray-model/arguments.h"

#include <array>
#include <cmath>
#include <sstream>

#include "core/base/lower_case.h"
#include "parser/options/ini.h"
#include "parser/options/own_option.h"
#include "tools/lentray-model/figures.h"

namespace lentray::model {

using parser::GivenOption;
using parser::OptionError;

namespace {

constexpr double kMostValues = 1e5, kMostPoints = 1e6;
constexpr std::int64_t kMostPixels = 1'000'000;  // a side

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  if (!text.empty() && text.back() == at) parts.emplace_back();
  return parts;
}

Range range_of(const GivenOption& given, bool may_be_zero) {
  const std::vector<std::string> parts = split(given.value, ':');
  if (parts.empty() || parts.size() > 3) {
    parser::refuse(given, "first:last:step is expected, in mm");
  }
  Range range;
  range.first = parser::number(parser::part_of(given, parts[0]));
  range.last = parts.size() > 1 ? parser::number(parser::part_of(given, parts[1])) : range.first;
  range.step = parts.size() > 2 ? parser::positive(parser::part_of(given, parts[2])) : 1.0;
  if (range.last < range.first) parser::refuse(given, "the last value is less than the first");
  if (may_be_zero ? range.first < 0.0 : range.first <= 0.0) {
    parser::refuse(given, may_be_zero ? "a distance of 0 mm or more is expected"
                                      : "a shadow larger than 0 mm is expected");
  }
  if ((range.last - range.first) / range.step > kMostValues) {
    parser::refuse(given, "that is more than 100000 values");
  }
  return range;
}

std::vector<std::uint32_t> whole_numbers(const GivenOption& given) {
  std::vector<std::uint32_t> out;
  for (const std::string& part : split(given.value, ',')) {
    out.push_back(static_cast<std::uint32_t>(
        parser::whole_number(parser::part_of(given, part), 1, kMostPixels)));
  }
  return out;
}

/// The choice's number.
std::size_t choice(const GivenOption& given, const std::vector<std::string>& choices) {
  std::string known;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (core::lower_case(given.value) == choices[i]) return i;
    known += (i > 0 ? ", " : "") + choices[i];
  }
  parser::refuse(given, "there are " + known);
}

void set_figures(Arguments& a, const GivenOption& given) {
  a.figures.clear();
  for (const std::string& part : split(given.value, ',')) {
    if (core::lower_case(part) == "all") {
      a.figures = figure_names();
      return;
    }
    a.figures.push_back(figure_names()[choice(parser::part_of(given, part), figure_names())]);
  }
}

constexpr std::array kModels{"paraxial", "pinhole"}, kAlphas{"printed", "refracted"};
template <const auto& kNames>  // in the order of the values
std::size_t one_of(const GivenOption& given) {
  return choice(given, {kNames.begin(), kNames.end()});
}

void set_pixels(Arguments& a, const GivenOption& g) {
  a.lens.pixels = parser::number(g);
  if (a.lens.pixels < 1.0) parser::refuse(g, "at least one pixel a lens is expected");
}

void set_ior(Arguments& a, const GivenOption& g) {
  a.lens.ior = parser::number(g);
  if (a.lens.ior < 1.0) parser::refuse(g, "a refractive index of at least 1 is expected");
}

void set_format(Arguments& a, const GivenOption& g) {
  a.format = choice(g, {"png", "svg"}) == 0 ? "png" : "svg";
}

using A = Arguments;
using G = GivenOption;
using parser::set;
constexpr parser::OwnOption<A> kOptions[] = {
    {"Lens_Pitch", [](A& a, const G& g) { a.lens.pitch = parser::positive(g); }},
    {"Lens_LPI", [](A& a, const G& g) { a.lens.pitch = 25.4 / parser::positive(g); }},
    {"Lens_Focal_Length", [](A& a, const G& g) { a.lens.focal_length = parser::positive(g); }},
    {"Lens_IOR", set_ior},
    {"Lens_Pixels", set_pixels},
    {"Lens_Model",
     set<parser::of_member<&A::lens, &camera::LensParameters::model>, one_of<kModels>>},
    {"Lenses", set<&A::lenses, parser::whole_number, 1, kMostPixels>},
    {"Rows", set<&A::rows, parser::whole_number, 1, kMostPixels>},
    {"A", [](A& a, const G& g) { a.a = range_of(g, false); }},
    {"D", [](A& a, const G& g) { a.d = range_of(g, true); }},
    {"Xstart", [](A& a, const G& g) { a.x = parser::number(g); }},
    {"Ystart", [](A& a, const G& g) { a.y = parser::number(g); }},
    {"Slice_A", [](A& a, const G& g) { a.slice_a = parser::positive(g); }},
    {"Slice_D", [](A& a, const G& g) { a.slice_d = parser::positive(g); }},
    {"Strip_Width", [](A& a, const G& g) { a.strip_widths = whole_numbers(g); }},
    {"Strip_Height", [](A& a, const G& g) { a.strip_heights = whole_numbers(g); }},
    {"Alpha", set<&A::alpha, one_of<kAlphas>>},
    {"CSV", [](A& a, const G& g) { a.csv = parser::file_name(g); }},
    {"Deviations", [](A& a, const G& g) { a.deviations = parser::file_name(g); }},
    {"Figures", set_figures},
    {"Folder", [](A& a, const G& g) { a.folder = parser::file_name(g); }},
    {"Format", set_format},
    {"Threads", set<&A::threads, parser::whole_number, 1, 512>},
};

[[noreturn]] void unknown(const std::string& word) {
  std::string known;
  for (const auto& [name, apply] : kOptions) {
    known += " " + (name.starts_with("Lens_") ? std::string(name) : parser::long_name(name));
  }
  throw OptionError("unknown option '" + word.substr(0, word.find('=')) + "'; there are" + known +
                    " --measure --help --version");
}

/// What the options can only be judged on together.
void check(const Arguments& a) {
  if (const std::string why = camera::complaint(a.lens); !why.empty()) throw OptionError(why);
  if (!a.strip_heights.empty() && a.strip_widths.empty()) {
    throw OptionError("--strip-height needs a --strip-width");
  }
  const double columns = std::round(a.lenses * a.lens.pixels);
  if (columns > kMostPixels) {
    throw OptionError("a sheet of more than 1000000 columns of pixels is too large");
  }
  const double points =
      static_cast<double>(a.a.values().size()) * static_cast<double>(a.d.values().size());
  if (points > kMostPoints) throw OptionError("--a and --d make more than 1000000 points");
}

}  // namespace

std::vector<double> Range::values() const {
  std::vector<double> out;
  const double steps = std::floor((last - first) / step + 1e-9);
  for (double i = 0.0; i <= steps; ++i) out.push_back(first + i * step);
  return out;
}

std::vector<shadow::Style> Arguments::styles() const {
  using Kind = shadow::Style::Kind;
  std::vector<shadow::Style> styles = shadow::paper_styles();
  for (const std::uint32_t w : strip_widths) styles.push_back({Kind::kCombined, w, 1});
  for (const std::uint32_t w : strip_widths) {
    for (const std::uint32_t h : strip_heights) styles.push_back({Kind::kStrips, w, h});
  }
  return styles;
}

Arguments parse_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--measure") {
      arguments.measure = true;
    } else if (!parser::take_own_option(words, i, kOptions, arguments)) {
      unknown(word);
    }
  }
  check(arguments);
  return arguments;
}

std::string usage() {
  return R"(usage: lentray-model [options]

Models the shadow cache in integral ray tracing, after Youssef, Aggoun, Wolf
and McCormick: how many shadow rays of successive pixels hit the cache when one
square shadow lies on a plane behind a lens sheet. By the paper's equations, by
enumeration, and (--measure) by rendering. Lengths are mm.

  Lens_Pitch=n | Lens_LPI=n  pitch of the lenses (1.124)
  Lens_Focal_Length=n    (3.03)
  Lens_IOR=n             (1.6)
  Lens_Pixels=n          pixels a lens (15)
  Lens_Model=paraxial|pinhole  (pinhole)
  --lenses n             lenses of the sheet, seen from infinity (133)
  --rows n               rows of square pixels (as many as there are columns)
  --a first:last:step    size of the shadow (0.5:40:1)
  --d first:last:step    how far behind the sheet it is (0:40:1)
  --xstart n             its left edge, right of the sheet's middle (0.3)
  --ystart n             its upper edge, below the middle; as --xstart. The
                         shadow is [xstart, xstart+a] x [ystart, ystart+a]
  --alpha printed|refracted  equation 6 as it is printed, or with the
                         refractive index in it (printed)
  --strip-width w,...    besides the strips that fit the shadow: combined(w)
  --strip-height h,...   and with these strips(w,h)
  --measure              renders the shadow, pixels in each order, and logs the
                         hits

  --csv file             style,A,D,xstart,closed_form,enumerated,measured; - is
                         standard output
  --deviations file      CSV of where the equations fail, and by how much
  --figures 10,11,...    charts of the paper's figures: 10 to 17, 23, 24a to 24e
                         (rendered); and of where the equations fail: near,
                         theta, small, wide, edges; or all
  --folder folder        where the charts go, as figure-10.png and so on (.)
  --format png|svg       (png)
  --slice-a n            where figures cut the surfaces (20)
  --slice-d n            (13)
  --threads n            all of the machine's
  --help, --version

Without --csv, --deviations and --figures the table of deviations
is shown. Charts need gnuplot.

Exit status: 0 done, 1 something is wrong with what was asked for or could not
be written, 2 measured and enumerated differ.
)";
}

}  // namespace lentray::model
