#include "tools/lentray/scene_disk.h"

#include <filesystem>

#include "parser/files/memory_writes.h"
#include "parser/restrictions/povray_conf.h"
#include "parser/restrictions/restricted_files.h"

namespace lentray::tool {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<parser::Files> restricted(const parser::RenderOptions& o, const std::string& scene,
                                          Warnings& warnings) {
  parser::UsersFolders folders;
  folders.scene = fs::path(scene).parent_path().string();
  core::FileType type = o.type;
  const std::string output = o.output_to_file ? parser::output_path(o, type) : "";
  if (output != "-") folders.output = fs::path(output).parent_path().string();
  folders.libraries = o.library_paths;
  folders.installed = parser::installed_sources().standard_libraries;
  std::vector<parser::PovrayConf> confs = parser::installed_confs();
  for (const parser::PovrayConf& conf : confs) {
    for (const std::string& text : conf.warnings) warnings.tell(text);
  }
  return std::make_unique<parser::RestrictedFiles>(parser::FileRules(folders, std::move(confs)));
}

}  // namespace

SceneDisk::SceneDisk(const parser::RenderOptions& options, const std::string& scene,
                     Warnings& warnings)
    : m_files(&parser::disk_files()) {
  if (options.restrict_io) {
    m_restricted = restricted(options, scene, warnings);
    m_files = m_restricted.get();
  }
  if (options.parse_only || options.dump || !options.writes_to_disk) {
    m_memory = std::make_unique<parser::MemoryWrites>(*m_files);
    m_files = m_memory.get();
  }
  m_watched.emplace(*m_files);
}

}  // namespace lentray::tool
