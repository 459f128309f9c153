#include "parser/restrictions/scene_word_rules.h"

#include <algorithm>
#include <filesystem>

#include "parser/options/scene_words.h"
#include "parser/restrictions/restricted_files.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;

bool is_scenes_own(const RenderOptions& o, std::string_view option, const std::string& value) {
  return std::ranges::any_of(o.scene_words, [&](const SceneWord& word) {
    return word.option->name == option && word.value == value;
  });
}

std::string picture_of(const RenderOptions& o) {
  core::FileType type = o.type;
  return o.output_to_file ? output_path(o, type) : "";
}

/// Where the file of this frame goes. Text files and the INI file are one for all frames.
std::vector<std::string> places_of(const RenderOptions& o, const SceneWord& word) {
  if (word.option->name == "Output_File_Name") return {picture_of(o)};
  if (word.option->name == "Statistics_File" || word.option->name == "Dependencies_File")
    return {word.value, frame_path(o, word.value)};
  return {word.value};
}

void judge_word(const RenderOptions& o, const SceneWord& word, RestrictedFiles& files) {
  if (word.option->use == FileUse::kRuns) {
    throw OptionError(word.where +
                      ": Restrict_IO: an INI file that came with a scene runs no commands");
  }
  try {
    for (const std::string& place : places_of(o, word)) {
      if (place.empty() || place == "-") continue;
      if (word.option->use == FileUse::kWrites) {
        (void)files.may_write(place);
      } else {
        (void)files.exists(place);
      }
    }
  } catch (const FileRefused& why) {
    throw OptionError(word.where + ": " + why.what());
  }
}

}  // namespace

UsersFolders users_folders(const RenderOptions& o, const std::string& scene) {
  UsersFolders out;
  out.scene = is_scenes_own(o, "Input_File_Name", o.input) ? o.scene_ini_folder
                                                           : fs::path(scene).parent_path().string();
  if (!is_scenes_own(o, "Output_File_Name", o.output)) {
    const std::string picture = picture_of(o);
    if (picture != "-") out.output = fs::path(picture).parent_path().string();
  }
  std::ranges::copy_if(
      o.library_paths, std::back_inserter(out.libraries),
      [&](const std::string& folder) { return !is_scenes_own(o, "Library_Path", folder); });
  out.installed = installed_sources().standard_libraries;
  return out;
}

void judge_scene_words(const RenderOptions& o, const FileRules& rules) {
  RestrictedFiles files(rules);
  for (const SceneWord& word : scene_words_that_hold(o)) judge_word(o, word, files);
  // The user named a folder at most: a link of the file's name may have come with the scene.
  const std::string picture = picture_of(o);
  std::error_code error;
  const bool names_folder = o.output.empty() || o.output.ends_with('/');
  if (!names_folder || !fs::is_symlink(picture, error)) return;
  try {
    (void)files.may_write(picture);
  } catch (const FileRefused& why) {
    throw OptionError(why.what());
  }
}

void drop_scene_writes(RenderOptions& o) {
  if (o.writes_to_disk) return;
  for (const SceneWord& word : scene_words_that_hold(o)) {
    if (word.option->use != FileUse::kWrites || word.option->drop == nullptr) continue;
    word.option->drop(o);
    o.warnings.push_back(
        word.where + ": not written, as with Scene_Writes=memory a scene leaves no files behind");
  }
}

}  // namespace lentray::parser
