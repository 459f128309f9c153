// Which scenes a batch has: those that were named, and in folders every *.pov that makes a picture of its own.
// Errors: parser::OptionError where an input is no scene and no folder. One thread.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lentray::batch {

struct Scene {
  std::filesystem::path source;  ///< absolute
  std::string name;              ///< unique: the path below the folder, without the extension
  std::string part_of;           ///< the scene that includes it, if it makes no picture of its own
  std::filesystem::path ini;     ///< scene.ini beside it; empty: there is none
};

struct Scan {
  std::vector<Scene> scenes;          ///< by name
  std::vector<std::string> warnings;  ///< folders that cannot be read
};

/// `out` and what lies in it is passed over. `known`: names that sources got in earlier runs, which they keep.
Scan find_scenes(const std::vector<std::filesystem::path>& inputs, const std::filesystem::path& out,
                 const std::map<std::string, std::string>& known);

/// Files that a text of a scene includes by name, comments apart; and whether a camera stands in it.
struct SceneText {
  std::vector<std::string> includes;
  bool has_camera = false;
};
SceneText look_at(std::string_view text);

}  // namespace lentray::batch
