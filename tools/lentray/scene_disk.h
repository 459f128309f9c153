// The disk as a run's scene sees it: all of it, or what the rules of Restrict_IO permit; and for runs that
// render nothing and leave nothing behind, with what the scene writes kept in memory. One thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "parser/files.h"
#include "parser/options.h"

namespace lentray::tool {

class SceneDisk {
 public:
  /// `warnings` gets what is wrong with povray.conf.
  SceneDisk(const parser::RenderOptions& options, const std::string& scene, std::vector<std::string>& warnings);
  /// Must outlive whatever reads the scene's pictures and fonts.
  parser::Files& files() const { return *m_files; }

 private:
  std::unique_ptr<parser::Files> m_restricted, m_memory;
  parser::Files* m_files;
};

}  // namespace lentray::tool
