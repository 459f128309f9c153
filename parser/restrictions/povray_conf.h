// POV-Ray's configuration files of I/O restrictions: what scenes may read and write, and whether
// INI files may run commands. Source: manual for Unix 3.7, 1.4 "I/O Restrictions".
// Errors: none thrown; what is not understood permits nothing and is a warning. Any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lentray::parser {

struct PermittedPath {
  std::string folder;  ///< absolute, links resolved
  bool below = false;  ///< its subfolders too (read*, read+write*)
  bool writing = false;
};

struct PovrayConf {
  enum class FileSecurity { kNone, kReadOnly, kRestricted };
  enum class Shellout { kUnsaid, kAllowed, kForbidden };
  std::string path;  ///< of the file itself
  FileSecurity files = FileSecurity::kNone;
  Shellout shellout = Shellout::kUnsaid;
  std::vector<PermittedPath> permitted;
  std::vector<std::string> warnings;
};

/// What %INSTALLDIR% and %HOME% mean.
struct ConfFolders {
  std::string install, home;
};

/// Relative folders are the current folder's.
PovrayConf parse_povray_conf(std::string_view text, const std::string& path,
                             const ConfFolders& folders);

/// The system's, then the user's, as far as they exist. A file that cannot be read forbids all.
std::vector<PovrayConf> installed_confs();

/// All that say something must allow it, and one must.
bool shellout_allowed(const std::vector<PovrayConf>& confs);

/// Where the system's and the user's file are, whether they exist or not.
std::vector<std::string> conf_places();

}  // namespace lentray::parser
