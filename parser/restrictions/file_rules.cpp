#include "parser/restrictions/file_rules.h"

#include <algorithm>
#include <utility>

#include "core/base/lower_case.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;

bool lies_below(const fs::path& place, const fs::path& folder) {
  const auto [in_folder, in_place] =
      std::mismatch(folder.begin(), folder.end(), place.begin(), place.end());
  return in_folder == folder.end() && in_place != place.end();
}

void add_folder(std::vector<fs::path>& folders, const std::string& folder) {
  std::error_code error;
  fs::path real = fs::canonical(folder.empty() ? "." : folder, error);
  if (!error) folders.push_back(std::move(real));
}

/// No link is on the way to it from the current folder.
bool is_where_it_says(const std::string& folder) {
  if (fs::path(folder).is_absolute()) return true;
  std::error_code error;
  fs::path said = (fs::canonical(".", error) / folder).lexically_normal();
  if (!said.has_filename()) said = said.parent_path();
  return fs::canonical(folder, error) == said;
}

/// What later runs or other programs obey: INI files, journals, radiosity, a batch's and a chart's rows, povray.conf,
/// and what begins with a dot.
bool is_own_name(const std::string& name) {
  const std::string low = core::lower_case(name);
  const auto ends = [&low](std::string_view end) { return low.ends_with(end); };
  return low.starts_with('.') || low == "povray.conf" || low == "manifest.jsonl" ||
         low == "state.json" || low.find(".lentray-") != low.npos || ends(".ini") || ends(".rca");
}

bool has_own_name(const fs::path& place, const fs::path& folder) {
  const fs::path rest = place.lexically_relative(folder);
  return std::any_of(rest.begin(), rest.end(),
                     [](const fs::path& part) { return is_own_name(part.string()); });
}

/// Of a file that stands for all of a folder.
constexpr const char* kAnyName = "x";

constexpr const char* kOwnNames =
    "a scene does not write what later runs obey: INI files, povray.conf, journals, radiosity, "
    "manifests, names that begin with a dot";

/// Debian's include folder has links to fonts.
void add_links(std::vector<fs::path>& files, const std::string& folder) {
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code no_file;
    if (!it->is_symlink(no_file) || !it->is_regular_file(no_file)) continue;
    files.push_back(fs::canonical(it->path(), no_file));
  }
}

}  // namespace

FileRules::FileRules(const UsersFolders& folders, std::vector<PovrayConf> confs) {
  add_folder(m_reading, folders.scene);
  add_folder(m_reading, ".");
  for (const std::string& library : folders.libraries) {
    if (is_where_it_says(library)) add_folder(m_reading, library);
  }
  for (const std::string& installed : folders.installed) {
    add_folder(m_reading, installed);
    add_links(m_installed, installed);
  }
  add_folder(m_writing, ".");
  add_folder(m_writing, folders.output);
  for (PovrayConf& conf : confs) {
    if (conf.files != PovrayConf::FileSecurity::kNone) m_confs.push_back(std::move(conf));
  }
}

/// As the manual says, the strictest holds: each file must permit it.
bool FileRules::conf_permits(const fs::path& place, bool writing) const {
  const auto permits = [&](const PovrayConf& conf) {
    if (!writing && conf.files == PovrayConf::FileSecurity::kReadOnly) return true;
    return std::any_of(
        conf.permitted.begin(), conf.permitted.end(), [&](const PermittedPath& path) {
          if (writing && !path.writing) return false;
          if (!path.below) return place.parent_path() == path.folder;
          return lies_below(place, path.folder) && !(writing && has_own_name(place, path.folder));
        });
  };
  return !m_confs.empty() && std::all_of(m_confs.begin(), m_confs.end(), permits);
}

std::string FileRules::conf_names() const {
  std::string names;
  for (const PovrayConf& conf : m_confs)
    names += (names.empty() ? "; not permitted by " : " and by ") + conf.path;
  return names;
}

std::string FileRules::against_reading(const fs::path& place) const {
  for (const fs::path& folder : m_reading) {
    if (lies_below(place, folder)) return {};
  }
  // What a scene may write, it may read.
  if (against_writing(place).empty()) return {};
  if (std::find(m_installed.begin(), m_installed.end(), place) != m_installed.end()) return {};
  if (conf_permits(place, false)) return {};
  return "a scene reads only below its folder, the current folder and the library paths" +
         conf_names();
}

std::string FileRules::against_writing(const fs::path& place) const {
  for (const fs::path& folder : m_writing) {
    if (lies_below(place, folder)) return has_own_name(place, folder) ? kOwnNames : "";
  }
  if (conf_permits(place, true)) return is_own_name(place.filename().string()) ? kOwnNames : "";
  return "a scene writes only below the current folder and the output's folder" + conf_names();
}

std::vector<fs::path> FileRules::readable() const {
  std::vector<fs::path> out = m_reading;
  if (conf_permits(fs::path("/") / kAnyName, false)) out.emplace_back("/");
  out.insert(out.end(), m_installed.begin(), m_installed.end());
  for (const PovrayConf& conf : m_confs) {
    for (const PermittedPath& path : conf.permitted) {
      if (conf_permits(fs::path(path.folder) / kAnyName, false)) out.emplace_back(path.folder);
    }
  }
  return out;
}

std::vector<fs::path> FileRules::writable() const {
  std::vector<fs::path> out = m_writing;
  for (const PovrayConf& conf : m_confs) {
    for (const PermittedPath& path : conf.permitted) {
      if (conf_permits(fs::path(path.folder) / kAnyName, true)) out.emplace_back(path.folder);
    }
  }
  return out;
}

}  // namespace lentray::parser
