// Where the scene's text is: a file, found as stock finds it, or standard input.
// Errors: parser::OptionError. One thread.
#pragma once

#include <filesystem>
#include <string>

#include "parser/options/options.h"

namespace lentray::tool {

/// A file to open; removes what it had to make of standard input.
class SceneFile {
 public:
  explicit SceneFile(const parser::RenderOptions& options);
  ~SceneFile();
  SceneFile(const SceneFile&) = delete;
  SceneFile& operator=(const SceneFile&) = delete;
  const std::string& path() const { return m_path; }

 private:
  std::string m_path;
  std::filesystem::path m_temporary;
};

}  // namespace lentray::tool
