// What an INI file that came with a scene (--scene-ini) says of files, folders and commands: of every option that
// names some, what it named and where that stands. Each word is compared before and after, so that it does not matter
// which option or switch it was; whoever restricts the scene judges the words that hold in the end.
// Errors: none. Threads: options of its own each.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lentray::parser {

struct RenderOptions;

/// What is done with what an option names.
enum class FileUse { kReads, kWrites, kSearches, kRuns };

/// An option that names files, folders or commands.
struct FileOption {
  std::string_view name;
  FileUse use;
  std::vector<std::string> (*values)(const RenderOptions&);  ///< as given
  void (*drop)(RenderOptions&) = nullptr;                    ///< it names none; null: it must
};
std::span<const FileOption> file_options();

/// A name that a scene's INI file gave.
struct SceneWord {
  const FileOption* option = nullptr;
  std::string value;
  std::string where;  ///< "a.ini:3: option Debug_File=x", for messages
};

/// All that the options name, by row of file_options().
using FileNames = std::vector<std::vector<std::string>>;
FileNames file_names(const RenderOptions& options);

/// Adds what a word at `where` named anew since `before`.
void add_scene_words(RenderOptions& options, const FileNames& before, const std::string& where);

/// Those that hold: no later word of the user's took their place.
std::vector<SceneWord> scene_words_that_hold(const RenderOptions& options);

}  // namespace lentray::parser
