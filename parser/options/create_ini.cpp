#include "parser/options/create_ini.h"

#include <algorithm>
#include <filesystem>

#include "parser/options/options_table.h"

namespace lentray::parser {
namespace {

/// Of the options whose use is one of these.
template <typename... Use>
std::string lines(const RenderOptions& o, Use... uses) {
  IniLines out;
  for (const OptionRow& row : option_table()) {
    if (row.access.write && ((row.use == uses) || ...)) row.access.write(o, row.name, out);
  }
  return out.take();
}

/// A line's end, or another control character, in a value would make lines of its own.
void refuse_other_lines(std::string_view name, const std::string& text, std::size_t lines) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\t'; };
  const auto found = static_cast<std::size_t>(std::ranges::count_if(text, is_control));
  if (found == lines) return;
  throw OptionError(
      "Create_Ini: the value of " + std::string(name) +
      " has a line's end or another control character, which an INI file cannot hold: "
      "leave out Create_Ini, or give the file another name");
}

}  // namespace

using enum OptionUse;

std::string ini_text(const RenderOptions& o) {
  IniLines out;
  for (const OptionRow& row : option_table()) {
    if (!row.access.write || row.use == kNothing) continue;
    IniLines one;
    row.access.write(o, row.name, one);
    refuse_other_lines(row.name, one.take(), one.count());
    row.access.write(o, row.name, out);
  }
  return out.take();
}
std::string light_lines(const RenderOptions& o) { return lines(o, kLight); }
std::string picture_lines(const RenderOptions& o) { return lines(o, kPicture, kLight); }
std::string file_lines(const RenderOptions& o) { return lines(o, kFile); }

std::string ini_path(const RenderOptions& o) {
  if (!o.create_ini) return "";
  if (!o.ini_file.empty()) return o.ini_file;
  const std::filesystem::path scene = o.input.empty() || o.input == "-" ? "stdin" : o.input;
  return scene.stem().string() + ".ini";
}

}  // namespace lentray::parser
