// What an INI file that came with a scene may ask for: with Restrict_IO=On no more than the scene itself. What it
// names is judged as if the scene named it, after all options are known. Errors: OptionError with the line of the INI
// file. One thread.
#pragma once

#include <vector>

#include "parser/options/options.h"
#include "parser/restrictions/file_rules.h"
#include "parser/restrictions/povray_conf.h"

namespace lentray::parser {

/// The folders that the user named, without what a scene's INI file did. `scene`: where the scene was found.
UsersFolders users_folders(const RenderOptions& options, const std::string& scene);

/// Throws if a word of the scene's INI file, or the picture's usual place, is against the rules. Of a frame: its files.
void judge_scene_words(const RenderOptions& options, const FileRules& rules);

/// With Scene_Writes=memory nothing that the scene's INI file names is written: a warning names it.
void drop_scene_writes(RenderOptions& options);

}  // namespace lentray::parser
