#include "parser/options/create_ini.h"

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

}  // namespace

using enum OptionUse;

std::string ini_text(const RenderOptions& o) {
  IniLines out;
  for (const OptionRow& row : option_table()) {
    if (!row.access.write || row.use == kNothing) continue;
    row.access.write(o, row.name, out);
    if (out.are_held()) continue;
    throw OptionError(
        "Create_Ini: the value of " + std::string(row.name) +
        " has characters which an INI file cannot hold, such as a line's end, or "
        "quotes of both kinds beside ; or #: leave out Create_Ini, or say it otherwise");
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
