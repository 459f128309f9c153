#include "parser/restrictions/povray_conf.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/base/trimmed.h"
#include "parser/files/files.h"
#include "parser/options/ini.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;

std::string home_folder() {
  const char* home = std::getenv("HOME");
  return home ? home : "";
}

void replace(std::string& text, std::string_view what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size()) {
    text.replace(at, what.size(), by);
  }
}

std::string without_remark(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote != 0)
      quote = line[i] == quote ? 0 : quote;
    else if (line[i] == '"' || line[i] == '\'')
      quote = line[i];
    else if (line[i] == ';')
      return std::string(line.substr(0, i));
  }
  return std::string(line);
}

std::string stripped(std::string_view text) { return std::string(core::trimmed(text, " \t\r")); }

class ConfReader {
 public:
  ConfReader(PovrayConf& conf, const ConfFolders& folders) : m_conf(conf), m_folders(folders) {}

  void line(std::string_view text) {
    ++m_number;
    const std::string line = stripped(without_remark(text));
    if (line.empty()) return;
    if (line.front() == '[')
      m_section = line;
    else if (in("[File I/O Security]"))
      file_security(line);
    else if (in("[Shellout Security]"))
      shellout(line);
    else if (in("[Permitted Paths]"))
      permitted_path(line);
  }

 private:
  bool in(std::string_view section) const { return m_section.starts_with(section); }

  void file_security(const std::string& word) {
    using Security = PovrayConf::FileSecurity;
    const bool known = word == "none" || word == "read-only" || word == "restricted";
    if (!known) warn("'" + word + "' is none of none, read-only, restricted: taken as restricted");
    m_conf.files = word == "none"        ? Security::kNone
                   : word == "read-only" ? Security::kReadOnly
                                         : Security::kRestricted;
  }

  void shellout(const std::string& word) {
    using Shellout = PovrayConf::Shellout;
    const bool allowed = word == "allowed";
    if (!allowed && word != "forbidden")
      warn("'" + word + "' is neither allowed nor forbidden: taken as forbidden");
    const bool forbidden = !allowed || m_conf.shellout == Shellout::kForbidden;
    m_conf.shellout = forbidden ? Shellout::kForbidden : Shellout::kAllowed;
  }

  void permitted_path(const std::string& line) {
    const std::size_t equals = line.find('=');
    std::string kind = stripped(std::string_view(line).substr(0, equals));
    PermittedPath path;
    path.below = kind.ends_with('*');
    if (path.below) kind = stripped(std::string_view(kind).substr(0, kind.size() - 1));
    path.writing = kind == "read+write";
    std::string folder = equals == line.npos ? "" : unquoted(line.substr(equals + 1));
    if ((kind != "read" && !path.writing) || folder.empty()) {
      warn(
          "expected read, read*, read+write or read+write*, = and a folder: the line permits "
          "nothing");
      return;
    }
    for (const auto& [word, meaning] :
         {std::pair{"%INSTALLDIR%", &m_folders.install}, std::pair{"%HOME%", &m_folders.home}}) {
      if (folder.find(word) == folder.npos) continue;
      if (meaning->empty()) return;  // a folder that is not there
      replace(folder, word, *meaning);
    }
    std::error_code error;
    path.folder = fs::canonical(folder, error).string();
    if (!error) m_conf.permitted.push_back(std::move(path));
  }

  void warn(const std::string& what) {
    m_conf.warnings.push_back(m_conf.path + ":" + std::to_string(m_number) + ": " + what);
  }

  PovrayConf& m_conf;
  const ConfFolders& m_folders;
  std::string m_section;
  int m_number = 0;
};

ConfFolders installed_folders() {
  ConfFolders folders{"", home_folder()};
  for (const char* install : {"/usr/local/share/povray-3.7", "/usr/share/povray-3.7"}) {
    std::error_code error;
    if (folders.install.empty() && fs::is_directory(install, error)) folders.install = install;
  }
  return folders;
}

}  // namespace

PovrayConf parse_povray_conf(std::string_view text, const std::string& path,
                             const ConfFolders& folders) {
  PovrayConf conf;
  conf.path = path;
  ConfReader reader(conf, folders);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return conf;
}

std::vector<std::string> conf_places() {
  std::error_code error;
  constexpr const char* kLocal = "/usr/local/etc/povray/3.7/povray.conf";
  std::vector<std::string> places{fs::exists(kLocal, error) ? kLocal
                                                            : "/etc/povray/3.7/povray.conf"};
  if (!home_folder().empty()) places.push_back(home_folder() + "/.povray/3.7/povray.conf");
  return places;
}

std::vector<PovrayConf> installed_confs() {
  const ConfFolders folders = installed_folders();
  std::vector<PovrayConf> confs;
  for (const std::string& place : conf_places()) {
    std::error_code error;
    const auto kind = fs::status(place, error).type();
    if (kind == fs::file_type::not_found) continue;
    if (kind == fs::file_type::regular) {
      if (fs::file_size(place, error) == 0 && !error) continue;
      if (const auto text = disk_files().read(place)) {
        confs.push_back(parse_povray_conf(*text, place, folders));
        continue;
      }
    }
    PovrayConf closed;
    closed.path = place;
    closed.files = PovrayConf::FileSecurity::kRestricted;
    closed.shellout = PovrayConf::Shellout::kForbidden;
    closed.warnings.push_back(place + ": it cannot be read, so it permits nothing");
    confs.push_back(std::move(closed));
  }
  return confs;
}

bool shellout_allowed(const std::vector<PovrayConf>& confs) {
  const auto says = [&](PovrayConf::Shellout what) {
    return std::any_of(confs.begin(), confs.end(),
                       [&](const PovrayConf& c) { return c.shellout == what; });
  };
  return says(PovrayConf::Shellout::kAllowed) && !says(PovrayConf::Shellout::kForbidden);
}

}  // namespace lentray::parser
