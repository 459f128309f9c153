#include "tools/session/scene_disk.h"

#include <nlohmann/json.hpp>

#include "parser/files/counted_files.h"
#include "parser/files/memory_writes.h"
#include "parser/restrictions/restricted_files.h"
#include "parser/restrictions/run_rules.h"
#include "tools/common/json_fields.h"

namespace lentray::tool {
SceneDisk::SceneDisk(const parser::RenderOptions& options, const std::string& scene)
    : m_scene(scene), m_files(&parser::disk_files()) {
  if (options.restrict_io) {
    m_restricted =
        std::make_unique<parser::RestrictedFiles>(parser::run_rules(options, scene, m_warnings));
    m_files = m_restricted.get();
  }
  if (options.parse_only || options.dump || !options.writes_to_disk) {
    m_memory = std::make_unique<parser::MemoryWrites>(*m_files);
    m_files = m_memory.get();
  }
  if (options.max_files > 0) {
    m_counted = std::make_unique<parser::CountedFiles>(*m_files, options.max_files);
    m_files = m_counted.get();
  }
  m_watched.emplace(*m_files);
}

Seen SceneDisk::seen() const {
  Seen out;
  for (const auto& [file, sum] : m_watched->seen())
    out.files[file == m_scene ? "" : file].sum = sum;
  out.missing = m_watched->missing();
  out.there = m_watched->there();
  return out;
}

nlohmann::json SceneDisk::dependencies(const nlohmann::json& program, const Seen& seen) const {
  nlohmann::json out{{"program", program},
                     {"read", m_watched->seen()},
                     {"missing", seen.missing},
                     {"there", seen.there},
                     {"written", m_watched->written()}};
  put(out, "input_file_name", seen.name);
  put(out, "now", seen.now);
  return out;
}

}  // namespace lentray::tool
