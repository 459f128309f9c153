#include "tools/session/scene_file.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

#include "core/base/ignored_error.h"
#include "core/image/run_files.h"

namespace lentray::tool {

namespace fs = std::filesystem;
using parser::OptionError;

namespace {

/// As it is named, with .pov or .POV added, then the same along the library paths.
std::string found(const parser::RenderOptions& options) {
  std::vector<fs::path> folders{""};
  if (fs::path(options.input).is_relative()) {
    folders.insert(folders.end(), options.library_paths.begin(), options.library_paths.end());
  }
  for (const fs::path& folder : folders) {
    for (const char* end : {"", ".pov", ".POV"}) {
      const fs::path path = folder / (options.input + end);
      const auto status = fs::status(path, core::ignored_error());
      if (!fs::exists(status) || fs::is_directory(status)) continue;
      if (::access(path.c_str(), R_OK) != 0)
        throw OptionError("cannot read the scene '" + path.string() + "'");
      core::note_input(path);
      return path.string();
    }
  }
  throw OptionError("there is no scene '" + options.input + "'");
}

}  // namespace

SceneFile::SceneFile(const parser::RenderOptions& options) {
  if (options.input.empty()) throw OptionError("no scene was named; lentray --help says how");
  if (options.input != "-") {
    m_path = found(options);
    return;
  }
  std::string folder = (fs::temp_directory_path() / "lentray-XXXXXX").string();
  if (!mkdtemp(folder.data())) throw OptionError("cannot make a temporary folder");
  m_temporary = folder;
  m_path = (m_temporary / "stdin.pov").string();
  std::ofstream out(m_path, std::ios::binary);
  if (std::cin.peek() != std::istream::traits_type::eof()) out << std::cin.rdbuf();
  out.close();
  if (!out) throw OptionError("cannot keep what standard input says");
}

SceneFile::~SceneFile() {
  if (!m_temporary.empty()) fs::remove_all(m_temporary, core::ignored_error());
}

}  // namespace lentray::tool
