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
  std::vector<std::string> warnings;  ///< folders that cannot be read, links that are not followed
};

/// Where scenes are looked for, and which are let in.
struct ScanOptions {
  std::filesystem::path out;  ///< it and what lies in it is passed over
  bool follows_links = true;  ///< of files; else only those that stay in the folder
};

/// `known`: names that sources got in earlier runs, which they keep.
Scan find_scenes(const std::vector<std::filesystem::path>& inputs, const ScanOptions& options,
                 const std::map<std::string, std::string>& known);

/// Whether that place, where it really lies, is of the inputs: links on the way to these are the user's.
bool lies_in(const std::vector<std::filesystem::path>& inputs, const std::filesystem::path& place);

/// The folders of the inputs that the scene lies in, its own if it was named itself; absolute. None: it is no scene of
/// theirs.
std::vector<std::filesystem::path> folders_of(const std::vector<std::filesystem::path>& inputs,
                                              const std::filesystem::path& source);

/// Files that a text of a scene includes by name, comments apart; and whether a camera stands in it.
struct SceneText {
  std::vector<std::string> includes;
  bool has_camera = false;
};
SceneText look_at(std::string_view text);

}  // namespace lentray::batch
