#include "tools/lentray-grouping/arguments.h"

#include <algorithm>

#include "parser/options/ini.h"
#include "parser/options/options.h"
#include "parser/options/own_option.h"
#include "shadow/pixel_orders.h"
#include "shadow/tester_factory.h"

namespace lentray::grouping {

using parser::GivenOption;
using parser::OptionError;

namespace {

/// Options of lentray that this program says itself.
constexpr const char* kOurs[] = {"Pixel_Order",     "Shadow_Cache", "Accelerator", "Light_Buffer",
                                 "Statistics_File", "Shadow_Log",   "Work_Threads"};

std::vector<std::string> names(const GivenOption& given) {
  std::vector<std::string> out = list_of(given.value);
  if (out.empty() || std::ranges::count(out, "") > 0) {
    parser::refuse(given, "a list of names is expected, such as rows,columns");
  }
  return out;
}

using parser::set;
constexpr parser::OwnOption<Arguments> kOptions[] = {
    {"Orders", set<&Arguments::orders, names>},
    {"Caches", set<&Arguments::caches, names>},
    {"Accelerators", set<&Arguments::accelerators, names>},
    {"Sizes", set<&Arguments::sizes, names>},
    {"Repeats", set<&Arguments::repeats, parser::whole_number, 0, 1000>},
    {"CSV", set<&Arguments::csv, parser::any_file>},
    {"HTML", set<&Arguments::html, parser::any_file>},
    {"Gains", set<&Arguments::gains, parser::any_file>},
    {"Lentray", set<&Arguments::lentray, parser::any_file>},
};

/// What this program says to lentray itself.
void refuse_ours(const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  for (const char* ours : kOurs) {
    if (!parser::same_word(name, ours)) continue;
    throw OptionError(std::string(ours) +
                      " is this program's to say: --orders, --caches, --accelerators");
  }
}

}  // namespace

std::vector<std::string> list_of(const std::string& text) {
  std::vector<std::string> out;
  int depth = 0;
  bool begins = true;
  for (const char c : text) {
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (begins) out.emplace_back();
    begins = c == ',' && depth == 0;
    if (!begins) out.back() += c;
  }
  if (begins && !text.empty()) out.emplace_back();
  return out;
}

Arguments parse_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  arguments.orders.assign(shadow::order_names().begin(), shadow::order_names().end());
  arguments.caches.assign(shadow::tester_names().begin(), shadow::tester_names().end());
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    arguments.command += " " + word;
    refuse_ours(word);
    if (parser::take_own_option(words, i, kOptions, arguments)) continue;
    if (word.rfind("--", 0) == 0) {
      throw OptionError("unknown option '" + word + "'; --help lists all");
    } else if (!parser::is_scene_word(word)) {
      arguments.for_lentray.push_back(word);
    } else {
      arguments.scenes.push_back(word);
    }
  }
  if (arguments.scenes.empty()) throw OptionError("no scene given");
  for (const std::string& scene : arguments.scenes) {
    if (!std::filesystem::is_regular_file(scene)) {
      throw OptionError("there is no scene '" + scene + "'");
    }
  }
  return arguments;
}

std::string usage() {
  return R"(usage: lentray-grouping scene.pov ... [options] [options of lentray]

Measures pixel orders, shadow caches and accelerators on scenes: one thread,
what each costs and how often the cache was right. Every picture is compared
with the first: they must be the same, bit for bit.

  --orders rows,columns,...  also combined(w), strips(w,h); all, as
                         Pixel_Order= of lentray has them
  --caches off,last,...  all, as Shadow_Cache= has them
  --accelerators bvh,... without light buffers: bvh, grid, list; buffer: bvh
                         with them (bvh)
  --sizes 2,3,4          the scenes in these sizes (Declare=Size=), as the SPD
                         scenes have them
  --repeats n            timed runs of each, interleaved; the median counts; 0:
                         counts alone (5)
  --csv file             the table
  --html file            the table with charts, which need gnuplot
  --gains file           CSV of what columns save against rows and views, with
                         Cm/Ch and equation 2
  --lentray file         the program to run; the one beside this one
  --help, --version

All else goes to lentray: +W +H Declare= Lenticular=On Lens_Pixels= +L ...

Exit status: 0 done, 1 something went wrong, 2 pictures differ.
)";
}

}  // namespace lentray::grouping
