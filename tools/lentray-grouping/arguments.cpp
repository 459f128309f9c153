#include "tools/lentray-grouping/arguments.h"

#include "parser/ini.h"
#include "parser/options_table.h"
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
  for (const std::string& name : out) {
    if (name.empty()) parser::refuse(given, "a list of names is expected, such as rows,columns");
  }
  if (out.empty()) parser::refuse(given, "a list of names is expected, such as rows,columns");
  return out;
}

std::filesystem::path place(const GivenOption& given) {
  if (given.value.empty()) parser::refuse(given, "the name of a file is expected");
  return given.value;
}

struct Row {
  const char* name;
  void (*apply)(Arguments&, const GivenOption&);
};

constexpr Row kOptions[] = {
    {"Orders", [](Arguments& a, const GivenOption& g) { a.orders = names(g); }},
    {"Caches", [](Arguments& a, const GivenOption& g) { a.caches = names(g); }},
    {"Accelerators", [](Arguments& a, const GivenOption& g) { a.accelerators = names(g); }},
    {"Sizes", [](Arguments& a, const GivenOption& g) { a.sizes = names(g); }},
    {"Repeats", [](Arguments& a, const GivenOption& g) {
       a.repeats = static_cast<int>(parser::whole_number(g, 0, 1000)); }},
    {"CSV", [](Arguments& a, const GivenOption& g) { a.csv = place(g); }},
    {"HTML", [](Arguments& a, const GivenOption& g) { a.html = place(g); }},
    {"Gains", [](Arguments& a, const GivenOption& g) { a.gains = place(g); }},
    {"Lentray", [](Arguments& a, const GivenOption& g) { a.lentray = place(g); }},
};

/// True if the word was an option of ours.
bool own(Arguments& arguments, const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) return false;
  const std::string_view name = std::string_view(word).substr(0, equals);
  for (const char* ours : kOurs) {
    if (parser::same_word(name, ours)) {
      throw OptionError(std::string(ours) +
                        " is this program's to say: Orders=, Caches=, Accelerators=");
    }
  }
  for (const Row& row : kOptions) {
    if (!parser::same_word(name, row.name)) continue;
    GivenOption given;
    given.shown = word;
    given.value = parser::unquoted(word.substr(equals + 1));
    row.apply(arguments, given);
    return true;
  }
  return false;
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
  for (const std::string& word : words) {
    if (word == "--help" || word == "-?") {
      arguments.help = true;
    } else if (own(arguments, word)) {
      continue;
    } else if (word.rfind("--", 0) == 0) {
      throw OptionError("unknown option '" + word + "'; there is --help");
    } else if (word[0] == '+' || word[0] == '-' || word.find('=') != std::string::npos ||
               word.find(".ini") != std::string::npos) {
      arguments.for_lentray.push_back(word);
    } else {
      arguments.scenes.push_back(word);
    }
  }
  if (arguments.help) return arguments;
  if (arguments.scenes.empty()) throw OptionError("no scene given");
  for (const std::string& scene : arguments.scenes) {
    if (!std::filesystem::is_regular_file(scene)) {
      throw OptionError("there is no scene '" + scene + "'");
    }
  }
  return arguments;
}

std::string usage() {
  return R"(usage: lentray-grouping scene.pov ... [Name=Value ...] [options of lentray]

Measures pixel orders, shadow caches and accelerators on scenes: one thread,
what each costs and how often the cache was right. Every picture is compared
with the first: they must be the same, bit for bit.

  Orders=rows,columns,...  also combined(w), strips(w,h); all, as Pixel_Order=
                         of lentray has them
  Caches=off,last,...    all, as Shadow_Cache= has them
  Accelerators=bvh,...   without light buffers: bvh, grid, list; buffer: bvh
                         with them (bvh)
  Sizes=2,3,4            the scenes in these sizes (Declare=Size=), as the SPD
                         scenes have them
  Repeats=n              timed runs of each, interleaved; the median counts; 0:
                         counts alone (5)
  CSV=file               the table
  HTML=file              the table with charts, which need gnuplot
  Gains=file             CSV of what columns save against rows and views, with
                         Cm/Ch and equation 2
  Lentray=file           the program to run; the one beside this one

All else goes to lentray: +W +H Declare= Lenticular=On Lens_Pixels= +L ...

Exit status: 0 done, 1 something went wrong, 2 pictures differ.
)";
}

}  // namespace lentray::grouping
