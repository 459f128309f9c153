// Where a stranger's scene may read and write (Restrict_IO=On). Reading: below the scene's folder, the
// current folder, the library paths, in POV-Ray's include folder, and where povray.conf permits it.
// Writing: below the current folder and the output's, and where povray.conf permits it.
// The places judged are real ones: absolute, links and dots resolved. A library path that is relative counts only
// where no link is on the way to it: links of the current folder may have come with the scene.
// Source: manual for Unix 3.7, 1.4 "I/O Restrictions". Immutable; any thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "parser/restrictions/povray_conf.h"

namespace lentray::parser {

/// The folders that the user's own command line names; "" is the current folder.
struct UsersFolders {
  std::string scene, output;
  std::vector<std::string> libraries;  ///< library and permitted paths
  std::vector<std::string> installed;  ///< of these, links to files elsewhere count as files here
};

class FileRules {
 public:
  FileRules(const UsersFolders& folders, std::vector<PovrayConf> confs);

  /// The rule that forbids it, as the end of a sentence; empty: it is permitted.
  std::string against_reading(const std::filesystem::path& place) const;
  std::string against_writing(const std::filesystem::path& place) const;

  /// Folders and files that hold all that may be read or written, and perhaps more: a sandbox has no finer rules.
  std::vector<std::filesystem::path> readable() const;
  std::vector<std::filesystem::path> writable() const;

 private:
  bool conf_permits(const std::filesystem::path& place, bool writing) const;
  std::string conf_names() const;

  std::vector<std::filesystem::path> m_reading, m_writing;  ///< folders, with what lies below
  std::vector<std::filesystem::path> m_installed;           ///< files
  std::vector<PovrayConf> m_confs;                          ///< those that restrict
};

}  // namespace lentray::parser
