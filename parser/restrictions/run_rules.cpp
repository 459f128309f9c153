#include "parser/restrictions/run_rules.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "parser/base/shown.h"
#include "parser/options/create_ini.h"
#include "parser/restrictions/povray_conf.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;

std::string picture_of(const RenderOptions& o) {
  core::FileType type = o.type;
  return o.output_to_file ? output_path(o, type) : "";
}

[[noreturn]] void refuse(const fs::path& name, const std::string& place, const char* what) {
  throw OptionError("Restrict_IO: '" + shown_name(name.string()) + "'" + place +
                    " is refused: " + what + " may have come with the scene; give its whole name");
}

void check_stays(const fs::path& name, const fs::path& folder) {
  std::error_code error;
  if (fs::is_symlink(name, error) && !fs::exists(name, error))
    refuse(name, "", "a link to a file that is not there");
  const fs::path base = fs::canonical(folder.empty() ? "." : folder, error);
  const fs::path place = fs::weakly_canonical(fs::absolute(name, error), error);
  // What cannot be written is told by whoever writes it.
  if (error || std::ranges::mismatch(base, place).in1 == base.end()) return;
  refuse(name, " (" + shown_name(place.string()) + ")", "a link to it");
}

bool is_of_current_folder(const std::string& name) {
  const fs::path path = name;
  return !name.empty() && name != "-" && path.is_relative() && *path.begin() != "..";
}

/// Other outputs take the place of a file, whose other names keep what they have.
std::vector<std::string> written_in_place(const RenderOptions& o) {
  return {o.debug_file, o.warning_file, o.statistic_file, o.render_file, o.fatal_file, o.all_file};
}

void check_has_one_name(const fs::path& name) {
  std::error_code error;
  if (fs::is_regular_file(name, error) && fs::hard_link_count(name, error) > 1 && !error)
    refuse(name, "", "its other name, a hard link,");
}

UsersFolders users_folders(const RenderOptions& o, const std::string& scene) {
  UsersFolders out;
  out.scene = fs::path(scene).parent_path().string();
  const std::string picture = picture_of(o);
  if (picture != "-") out.output = fs::path(picture).parent_path().string();
  out.libraries = o.users_libraries;
  out.libraries.insert(out.libraries.end(), o.permitted_paths.begin(), o.permitted_paths.end());
  out.installed = installed_sources().standard_libraries;
  return out;
}

}  // namespace

FileRules run_rules(const RenderOptions& o, const std::string& scene,
                    std::vector<std::string>& warnings) {
  std::vector<PovrayConf> confs;
  if (o.permitted_paths.empty()) confs = installed_confs();
  for (const PovrayConf& conf : confs)
    warnings.insert(warnings.end(), conf.warnings.begin(), conf.warnings.end());
  return FileRules(users_folders(o, scene), std::move(confs));
}

std::vector<std::string> outputs_of(const RenderOptions& o) {
  std::vector<std::string> out{
      picture_of(o),
      o.statistics_file.empty() ? "" : frame_path(o, o.statistics_file),
      o.dependencies_file.empty() ? "" : frame_path(o, o.dependencies_file),
      o.view_cameras,
      o.depth_view,
      o.dump_rays,
      o.radiosity_to_file ? o.radiosity_file : "",
      ini_path(o)};
  const std::vector<std::string> texts = written_in_place(o);
  out.insert(out.end(), texts.begin(), texts.end());
  return out;
}

void judge_output(const std::string& name) {
  if (is_of_current_folder(name)) check_stays(name, ".");
}

void judge_outputs(const RenderOptions& o) {
  if (!o.restrict_io) return;
  for (const std::string& name : outputs_of(o)) judge_output(name);
  for (const std::string& name : written_in_place(o)) {
    if (is_of_current_folder(name)) check_has_one_name(name);
  }
  const fs::path picture = picture_of(o);
  const bool names_folder = o.output.empty() || o.output.ends_with('/');
  if (names_folder && !picture.empty()) check_stays(picture, picture.parent_path());
}

}  // namespace lentray::parser
