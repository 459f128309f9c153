#include "parser/options/sheet_options.h"

#include <algorithm>

#include "camera/slanted_sheet.h"
#include "parser/options/length.h"
#include "parser/options/paper.h"

namespace lentray::parser::sheet_option {

using Options = RenderOptions;
using Given = GivenOption;

void sheet(Options& o, const Given& g) {
  if (same_word(g.value, "list")) {
    o.list_lens_sheets = true;
    return;
  }
  if (g.value.empty())
    refuse(g, "the name of a lens sheet is expected; Lens_Sheet=list shows them");
  o.lens_sheet = g.value;
}

void slant(Options& o, const Given& g) {
  o.lens.slant = camera::tangent_of_slant(g.value);
  if (!o.lens.slant) refuse(g, camera::kSlantExpected);
}

void direction(Options& o, const Given& g) {
  constexpr std::string_view kThere[] = {"up", "across"};
  o.lens.across = choice(g, "direction of lenses", kThere) == kThere[1];
}

void sheet_size(Options& o, const Given& g) {
  const Extent size = paper_extent(g);
  o.sheet_width = size.width;
  o.sheet_height = size.height;
}

namespace {

double dots_an_inch(const Given& g) {
  const auto value = number_in(g.value);
  if (!value || !(*value > 0.0)) {
    refuse(g, "the printer's pixels an inch are expected, greater than 0, such as 600 or 1440x720");
  }
  return *value;
}

}  // namespace

void print_dpi(Options& o, const Given& g) {
  const std::size_t times = g.value.find_first_of("xX");
  o.lens.print_dpi = dots_an_inch(part_of(g, g.value.substr(0, times)));
  o.print_dpi_down.reset();
  if (times == std::string::npos) return;
  o.print_dpi_down = dots_an_inch(part_of(g, g.value.substr(times + 1)));
}

void view_distance(Options& o, const Given& g) {
  const bool infinite =
      same_word(g.value, "inf") || same_word(g.value, "infinity") || same_word(g.value, "infinite");
  const double v = infinite ? 0.0 : length_mm(g);
  if (v < 0.0) refuse(g, "a distance in mm, 0 or inf is expected");
  o.lens.view_distance = v;
}

void sheet_distance(Options& o, const Given& g) {
  o.sheet_distance = scene_length(g, "View_Distance");
}

void depth(Options& o, const Given& g) {
  using camera::DepthMode;
  constexpr std::string_view kThere[] = {"print", "scene", "viewer"};
  const std::string_view name = choice(g, "kind of depth", kThere);
  for (const DepthMode mode : {DepthMode::kPrint, DepthMode::kScene, DepthMode::kViewer})
    if (name == camera::name_of(mode)) o.lens.depth = mode;
}

void sheet_at(Options& o, const Given& g) {
  if (g.value.empty())
    refuse(g, "an object's name, or its place FILE:LINE:COLUMN, is expected; --depth lists them");
  o.sheet_at = g.value;
}

void depth_budget(Options& o, const Given& g) {
  constexpr double kMostPixels = 1e6;
  std::string_view unit;
  const double value = leading_number(g, unit);
  if (!(value > 0.0)) {
    refuse(g,
           "a parallax greater than 0 is expected: pixels a view, or with a unit mm on the print");
  }
  unit.remove_prefix(std::min(unit.find_first_not_of(" \t"), unit.size()));
  const bool is_mm = !unit.empty() && !same_word(unit, "px");
  if (!is_mm && value > kMostPixels) refuse(g, "at most a million pixels a view are expected");
  o.lens.depth_budget = camera::DepthBudget{is_mm ? positive_size_mm(g) : value, is_mm};
}

void front(Options& o, const Given& g) { o.lens.front = scene_length(g, "View_Distance"); }

void model(Options& o, const Given& g) {
  constexpr std::string_view kThere[] = {"paraxial", "pinhole", "thick", "auto"};
  const std::string_view name = choice(g, "lens model", kThere);
  o.lens.automatic_model = name == "auto";
  o.lens.model = camera::model_named(name);
}

void write_slant(const Options& o, std::string_view name, IniLines& out) {
  if (o.lens.slant) out.line(name, IniLines::text_of(*o.lens.slant) + "/1");
}

void write_direction(const Options& o, std::string_view name, IniLines& out) {
  if (o.lens.across) out.line(name, *o.lens.across ? "across" : "up");
}

void write_print_dpi(const Options& o, std::string_view name, IniLines& out) {
  if (o.print_dpi_down)
    out.line(name,
             IniLines::text_of(*o.lens.print_dpi) + "x" + IniLines::text_of(*o.print_dpi_down));
  else
    out.add(name, o.lens.print_dpi);
}

void write_depth_budget(const Options& o, std::string_view name, IniLines& out) {
  if (!o.lens.depth_budget) return;
  const camera::DepthBudget& budget = *o.lens.depth_budget;
  out.line(name, IniLines::text_of(budget.value) + (budget.is_mm ? "mm" : ""));
}

void write_depth(const Options& o, std::string_view name, IniLines& out) {
  if (o.lens.depth) out.line(name, camera::name_of(*o.lens.depth));
}

void write_model(const Options& o, std::string_view name, IniLines& out) {
  if (o.lens.model) out.line(name, camera::name_of(*o.lens.model));
  if (o.lens.automatic_model) out.line(name, "auto");
}

}  // namespace lentray::parser::sheet_option
