// What a scene got from outside while it was read: the files that it read, and the answers to its questions. It is written
// once, with each journal, pass, row and chart, and compared here.
//
// The checksum of a file's contents decides. Size, times and inode only save computing it: they are not trusted of a file
// that changed, or came, after `since`, for then nobody knows which contents they belong to.
// Errors: none; a file that cannot be read is gone. Threads: any number.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>

namespace lentray::tool {

struct FileStamp {
  std::uint64_t sum = 0;
  // The quick check; `changed` 0: there is none.
  std::uint64_t size = 0, inode = 0;
  std::int64_t modified = 0, changed = 0;  ///< ns since 1970, of contents and of anything
  bool operator==(const FileStamp&) const = default;
};
/// [sum] or [sum, size, inode, modified, changed].
void to_json(nlohmann::json& out, const FileStamp& stamp);
void from_json(const nlohmann::json& from, FileStamp& stamp);

struct Seen {
  std::map<std::string, FileStamp> files{};  ///< that were read, by path
  std::set<std::string> missing{};           ///< paths that were looked for in vain
  std::set<std::string> there{};             ///< paths of files that were found, and not read
  std::string name{};                        ///< input_file_name, if the scene asked for it
  std::optional<double> now{};               ///< the same
  bool operator==(const Seen&) const = default;
};
/// What differs on the disk from what was seen, as "a.inc has changed"; empty: nothing. `scene`: the file that stands
/// under "".
std::string change_in(const Seen& seen, const std::string& scene = "");
/// What another reading saw otherwise.
std::string change_of(const Seen& then, const Seen& now);
/// The same, but only of paths that both asked for: frames of one animation read what they need.
std::string change_in_common(const Seen& then, const Seen& now);

/// Of a file as it is. Empty if it cannot be read.
std::optional<FileStamp> stamp_of(const std::filesystem::path& path);
/// Of a file whose contents had that checksum when it was read, `since` or later.
FileStamp stamp_read(const std::filesystem::path& path, std::uint64_t sum, std::int64_t since);
/// Gives a file that is as it was the quick check that it could not have yet.
void renew(const std::filesystem::path& path, FileStamp& stamp);
bool is_as_it_was(const std::filesystem::path& path, const FileStamp& stamp);

/// What a Dependencies_File says, with absolute paths: those there are relative to `folder`. `since`: when the scene's
/// reading began.
Seen seen_in(const nlohmann::json& dependencies, const std::filesystem::path& folder,
             std::int64_t since);

std::int64_t now();
/// Of a file, as FileStamp::modified; 0 if there is none.
std::int64_t modified(const std::filesystem::path& path);

}  // namespace lentray::tool
