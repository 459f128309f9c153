#include "parser/options/lens_sheets.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>

#include "camera/text.h"
#include "core/base/joined.h"
#include "core/base/lower_case.h"
#include "parser/options/options_table.h"
#include "parser/options/said_options.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;
using camera::LensProfile;

constexpr std::string_view kDataOptions[] = {"Lens_Pitch",     "Lens_LPI",    "Lens_Focal_Length",
                                             "Lens_Thickness", "Lens_Radius", "Lens_IOR",
                                             "Lens_Angle"};

void apply_line(RenderOptions& scratch, const std::string& path, const IniLine& line) {
  GivenOption given;
  given.where = path + ":" + std::to_string(line.line) + ": ";
  given.shown = line.text + "=" + line.value;
  given.value = line.value;
  for (const std::string_view name : kDataOptions) {
    if (line.kind == IniLine::Kind::kOption && same_word(name, line.text)) {
      return std::ranges::find(option_table(), name, &OptionRow::name)
          ->access.apply(scratch, given);
    }
  }
  throw OptionError(given.where + "'" + line.text + "' says nothing of a lens sheet: there are " +
                    core::joined(kDataOptions));
}

void append_file(const std::string& path, std::vector<LensProfile>& out) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return;
  const std::string text = ini_file_text(path);
  (void)ini_lines(text, path, {path, "", false});  // says which labels are none
  std::vector<std::string> labels;
  for (std::string& label : ini_labels(text)) {
    const auto same = [&label](const std::string& known) { return same_word(known, label); };
    if (std::ranges::none_of(labels, same)) labels.push_back(std::move(label));
  }
  for (const std::string& label : labels) {
    RenderOptions scratch;
    for (const IniLine& line : ini_lines(text, path, {path, label, true}).lines) {
      apply_line(scratch, path, line);
    }
    out.push_back({label, scratch.lens, false, path});
  }
}

/// In the order in which they are looked into.
std::vector<std::string> all_files(const RenderOptions& o, std::span<const std::string> files) {
  std::vector<std::string> out;
  if (!o.restrict_io) out.emplace_back(kLensSheetFile);
  for (const std::string& folder : o.restrict_io ? o.users_libraries : o.library_paths)
    out.push_back((fs::path(folder) / kLensSheetFile).string());
  out.insert(out.end(), files.begin(), files.end());
  return out;
}

std::string cell(const std::optional<double>& value) { return value ? camera::brief(*value) : "-"; }

/// Columns as wide as these, all but the first to the right.
std::string row(std::initializer_list<std::string> cells, const std::string& source) {
  constexpr std::size_t kWidths[] = {16, 8, 10, 8, 7, 7};
  std::string out;
  for (std::size_t i = 0; const std::string& cell : cells) {
    const std::string blanks(kWidths[i] - std::min(kWidths[i], cell.size()), ' ');
    out += i++ == 0 ? cell + blanks : blanks + cell;
  }
  return out + "  " + source + "\n";
}

double lpi_of(const camera::LensData& d) { return d.pitch ? 25.4 / *d.pitch : d.lpi.value_or(0.0); }

/// What may be meant by a name that is none: of a number the sheets on both sides, else one of a like name, else any.
std::string instead_of(std::string name, const std::vector<LensProfile>& sheets) {
  std::vector<std::string_view> names;
  for (const LensProfile& sheet : sheets) names.emplace_back(sheet.name);
  if (core::lower_case(name).ends_with("lpi")) name.resize(name.size() - 3);
  const auto lpi = number_in(name);
  if (!lpi || !(*lpi > 0.0)) {
    const std::string_view near = near_name(name, names);
    return near.empty() ? "there are " + core::joined(names)
                        : "did you mean " + std::string(near) + "?";
  }
  const auto distance = [&](const LensProfile& sheet) {
    return std::fabs(lpi_of(sheet.data) / *lpi - 1.0);
  };
  const LensProfile& nearest = *std::ranges::min_element(sheets, {}, distance);
  return nearest.name + " is the nearest; Lens_LPI=" + camera::format(*lpi) +
         " takes any, and Lens_Thickness says how thick it is";
}

}  // namespace

std::vector<std::string> installed_lens_sheet_files() {
  std::vector<std::string> out;
  const std::string name = std::string("/") + kLensSheetFile;
  if (const char* home = std::getenv("HOME")) {
    out.push_back(std::string(home) + "/.config/lentray" + name);
    out.push_back(std::string(home) + "/.povray/3.7" + name);
  }
  out.push_back("/usr/local/etc/povray/3.7" + name);
  out.push_back("/etc/povray/3.7" + name);
  return out;
}

std::vector<LensProfile> lens_sheets(std::span<const std::string> files) {
  std::vector<LensProfile> out;
  for (const std::string& path : files) append_file(path, out);
  for (LensProfile& profile : camera::common_lens_sheets()) out.push_back(std::move(profile));
  return out;
}

void apply_lens_sheet(RenderOptions& o, std::span<const std::string> files) {
  if (o.lens_sheet.empty()) return;
  const std::vector<LensProfile> sheets = lens_sheets(all_files(o, files));
  const auto named = [&](const std::string& name) {
    return std::ranges::find_if(
        sheets, [&](const LensProfile& sheet) { return same_word(sheet.name, name); });
  };
  auto found = named(o.lens_sheet);
  if (found == sheets.end()) found = named(o.lens_sheet + "lpi");
  if (found == sheets.end()) {
    throw OptionError(with_said("there is no lens sheet '" + o.lens_sheet +
                                    "': " + instead_of(o.lens_sheet, sheets) +
                                    " (Lens_Sheet=list shows all)",
                                o, {"Lens_Sheet"}));
  }
  camera::LensRequest lens;
  static_cast<camera::LensData&>(lens) = found->data;
  lens.override_by(o.lens);
  o.lens = lens;
  o.lens.sheet_name = found->name;
  o.lens.sheet_is_nominal = found->nominal;
}

std::string lens_sheet_list(const RenderOptions& o, std::span<const std::string> files) {
  std::string out = row({"Lens_Sheet=", "LPI", "thickness", "radius", "index", "angle"}, "from");
  for (const LensProfile& sheet : lens_sheets(all_files(o, files))) {
    const camera::LensData& d = sheet.data;
    const std::optional<double> lpi = d.pitch || d.lpi ? std::optional(lpi_of(d)) : std::nullopt;
    const auto& thickness = d.thickness ? d.thickness : d.focal_length;
    out += row({sheet.name, cell(lpi), cell(thickness), cell(d.radius), cell(d.ior), cell(d.angle)},
               sheet.source);
  }
  return out +
         "Thickness and radius in mm, the viewing angle in degrees. Measure your sheet: its pitch "
         "differs\nfrom what is written on it. Own sheets go into " +
         kLensSheetFile + " (docs/print.md).\n";
}

}  // namespace lentray::parser
