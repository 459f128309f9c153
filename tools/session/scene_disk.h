// The disk as a run's scene sees it: all of it, or what the rules of Restrict_IO permit; and for
// runs that render nothing and leave nothing behind, with what the scene writes kept in memory. No more files than
// Max_Files. One thread.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "parser/files/files.h"
#include "parser/files/watched_files.h"
#include "parser/options/options.h"
#include "tools/session/seen.h"

namespace lentray::tool {

class SceneDisk {
 public:
  SceneDisk(const parser::RenderOptions& options, const std::string& scene);
  /// What is wrong with povray.conf.
  const std::vector<std::string>& warnings() const { return m_warnings; }
  /// Must outlive whatever reads the scene's pictures and fonts.
  parser::Files& files() { return *m_watched; }
  /// With checksums alone, the scene's own under "", as identities have it.
  Seen seen() const;
  /// Paths that the scene wrote.
  const std::set<std::string>& written() const { return m_watched->written(); }
  /// What a Dependencies_File says: read, missing, found and written files, and what the scene asked for besides.
  /// `program`: its checksum.
  nlohmann::json dependencies(const nlohmann::json& program, const Seen& seen) const;

 private:
  const std::string m_scene;
  std::vector<std::string> m_warnings;
  std::unique_ptr<parser::Files> m_restricted, m_memory, m_counted;
  parser::Files* m_files;
  std::optional<parser::WatchedFiles> m_watched;
};

}  // namespace lentray::tool
