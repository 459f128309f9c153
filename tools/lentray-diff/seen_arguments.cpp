#include "tools/lentray-diff/seen_arguments.h"

#include <algorithm>

#include "parser/options/ini.h"
#include "parser/options/option_access.h"
#include "parser/options/options_table.h"
#include "parser/options/own_option.h"

namespace lentray::diff {
namespace {

using parser::GivenOption;
using parser::OptionError;
using parser::set;

/// Does what the option of lentray does that has this name.
template <parser::Word name>
constexpr auto kSeenLensWord = [](SeenArguments& a, const GivenOption& given) {
  std::ranges::find(parser::option_table(), std::string_view(name.text), &parser::OptionRow::name)
      ->access.apply(a.lens_words, given);
};

constexpr parser::OwnOption<SeenArguments> kSeenOptions[] = {
    {"Out", set<&SeenArguments::out, parser::any_file>},
    {"Json", set<&SeenArguments::json, parser::any_file>},
    {"Arc_Minutes", set<&SeenArguments::arc_minutes, parser::positive>},
    {"Lens_Pixels", kSeenLensWord<"Lens_Pixels">},
    {"Dpi", kSeenLensWord<"Print_DPI">},
    {"Print_DPI", kSeenLensWord<"Print_DPI">},
    {"View_Distance", kSeenLensWord<"View_Distance">},
};

}  // namespace

std::optional<double> SeenArguments::rows_an_inch() const {
  return lens_words.print_dpi_down ? lens_words.print_dpi_down : lens_words.lens.print_dpi;
}

SeenArguments parse_seen_arguments(const std::vector<std::string>& words) {
  SeenArguments out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--seen") continue;
    if (words[i] == "--across") {
      out.across = true;
    } else if (parser::take_own_option(words, i, kSeenOptions, out)) {
      continue;
    } else if (words[i].starts_with("-")) {
      throw OptionError("'" + words[i] +
                        "' is no option of --seen; there are --out --json --arc-minutes "
                        "--lens-pixels --dpi --view-distance --across");
    } else {
      out.pictures.emplace_back(words[i]);
    }
  }
  if (out.pictures.size() != 2) {
    throw OptionError("--seen compares two integral images, and " +
                      std::to_string(out.pictures.size()) +
                      (out.pictures.size() == 1 ? " is" : " are") + " given");
  }
  constexpr double kMostMinutes = 60.0;
  if (out.arc_minutes > kMostMinutes) {
    throw OptionError("--arc-minutes: an eye tells apart 60 minutes of arc or less, as a rule 1");
  }
  if (const auto& distance = out.lens_words.lens.view_distance; distance && *distance <= 0.0) {
    throw OptionError(
        "--view-distance: how far before the sheet the eye is is expected, such as 40cm");
  }
  return out;
}

}  // namespace lentray::diff
