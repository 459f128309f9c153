#include "parser/restrictions/run_rules.h"

#include <filesystem>
#include <utility>

#include "parser/restrictions/povray_conf.h"
#include "parser/restrictions/restricted_files.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;

UsersFolders users_folders(const RenderOptions& o, const std::string& scene) {
  UsersFolders out;
  out.scene = fs::path(scene).parent_path().string();
  core::FileType type = o.type;
  const std::string picture = o.output_to_file ? output_path(o, type) : "";
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

void judge_picture(const RenderOptions& o, const std::string& picture) {
  std::error_code error;
  const bool names_folder = o.output.empty() || o.output.ends_with('/');
  if (!o.restrict_io || !names_folder || !fs::is_symlink(picture, error)) return;
  try {
    std::vector<std::string> said_elsewhere;
    (void)RestrictedFiles(run_rules(o, o.input, said_elsewhere)).may_write(picture);
  } catch (const FileRefused& why) {
    throw OptionError(why.what());
  }
}

}  // namespace lentray::parser
