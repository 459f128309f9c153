// A folder in which stock POV-Ray renders a scene, or wrapper scenes of it. Scenes may write files
// while they are parsed: several processes at once do not meet there, nor litter the user's folder.
// One thread a process, without display.
// Errors: std::runtime_error with the last lines stock said. Threads: render_*() any number, on
// different names.
#pragma once

#include <filesystem>
#include <string>

#include "core/image/reader.h"
#include "tools/common/process.h"
#include "tools/lentray-diff/stock.h"
#include "tools/lentray-diff/wrapper.h"

namespace lentray::diff {

/// How stock renders a picture.
struct Shot {
  std::uint32_t width = 0, height = 0;
  bool antialiased = false;  ///< as the options ask for
  bool as_light = false;     ///< OpenEXR, linear light; else PNG as the options ask for
};

class Workshop {
 public:
  /// The options outlive it.
  Workshop(const std::filesystem::path& scene, const StockOptions& options);

  /// For wrappers: the scene, or a copy without lenticular cameras if there are any. Include files
  /// that hold one get a copy too, which stock finds before the file itself.
  Included included();
  /// A wrapper scene.
  core::StoredImage render_text(const std::string& name, const std::string& text,
                                const Shot& shot) const;
  /// The scene itself.
  core::StoredImage render_scene(const Shot& shot) const;

 private:
  void copy_includes(const std::string& text, int depth);
  core::StoredImage render(const std::filesystem::path& folder, const std::filesystem::path& scene,
                           const Shot& shot) const;

  const StockOptions& m_options;
  tool::TemporaryFolder m_temporary;
  std::filesystem::path m_scene, m_root;
  std::filesystem::path m_named,
      m_folder;  ///< the scene and its folder, by names that stock can read
};

/// The output's lines that say what went wrong.
std::string last_words(const std::string& output);

}  // namespace lentray::diff
