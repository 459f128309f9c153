#include "tools/session/seen.h"

#include <sys/stat.h>
#include <time.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/ignored_error.h"
#include "parser/files/files.h"
#include "parser/files/watched_files.h"
#include "tools/common/json_fields.h"

namespace lentray::tool {
namespace {

/// Two changes within it may leave one time. File systems that keep whole seconds may keep every second one.
std::int64_t grain_of(const FileStamp& stamp) {
  constexpr std::int64_t kSecond = 1'000'000'000, kOfKernel = 20'000'000;
  const bool is_coarse = stamp.modified % kSecond == 0 && stamp.changed % kSecond == 0;
  return is_coarse ? 2 * kSecond : kOfKernel;
}

std::int64_t nanoseconds(const timespec& t) {
  return std::int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec;
}

/// Without checksum.
std::optional<FileStamp> outside_of(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return FileStamp{0, static_cast<std::uint64_t>(status.st_size), status.st_ino,
                   nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
}

/// Younger than `before`, its times may be those of other contents.
FileStamp trusted(FileStamp stamp, std::int64_t before) {
  if (std::max(stamp.modified, stamp.changed) < before - grain_of(stamp)) return stamp;
  return FileStamp{stamp.sum};
}

const char* shown(const std::string& path) { return path.empty() ? "the scene" : path.c_str(); }

/// The first that one has and the other has not.
const std::string* other_than(const std::set<std::string>& one, const std::set<std::string>& two) {
  const auto at = std::ranges::find_if(one, [&](const auto& path) { return !two.contains(path); });
  return at == one.end() ? nullptr : &*at;
}

}  // namespace

void to_json(nlohmann::json& out, const FileStamp& s) {
  out = nlohmann::json::array({s.sum});
  if (s.changed != 0) out = {s.sum, s.size, s.inode, s.modified, s.changed};
}

void from_json(const nlohmann::json& from, FileStamp& s) {
  s = {whole_of<std::uint64_t>(from.at(0))};
  if (from.size() < 5) return;
  s = {s.sum, whole_of<std::uint64_t>(from.at(1)), whole_of<std::uint64_t>(from.at(2)),
       whole_of<std::int64_t>(from.at(3)), whole_of<std::int64_t>(from.at(4))};
}

std::string change_in(const Seen& seen, const std::string& scene) {
  for (const auto& [path, stamp] : seen.files) {
    const std::string& place = path.empty() ? scene : path;
    if (is_as_it_was(place, stamp)) continue;
    const bool is_gone = !std::filesystem::exists(place, core::ignored_error());
    return std::string(shown(path)) + (is_gone ? " is gone" : " has changed");
  }
  for (const std::string& path : seen.missing) {
    if (parser::disk_files().exists(path)) return path + " has come to be";
  }
  for (const std::string& path : seen.there) {
    if (!parser::disk_files().exists(path)) return path + " is gone";
  }
  return "";
}

std::string change_of(const Seen& then, const Seen& now) {
  for (const auto& [path, stamp] : now.files) {
    const auto at = then.files.find(path);
    if (at == then.files.end() || at->second.sum != stamp.sum)
      return std::string(shown(path)) + " has changed";
  }
  for (const auto& [path, stamp] : then.files) {
    if (!now.files.contains(path)) return std::string(shown(path)) + " is not read any more";
  }
  for (const auto& [one, two] :
       {std::pair{&then.missing, &now.missing}, {&now.there, &then.there}}) {
    if (const std::string* path = other_than(*one, *two)) return *path + " has come to be";
  }
  for (const auto& [one, two] :
       {std::pair{&now.missing, &then.missing}, {&then.there, &now.there}}) {
    if (const std::string* path = other_than(*one, *two)) return *path + " is gone";
  }
  if (then.name != now.name)
    return "input_file_name was '" + then.name + "' and is '" + now.name + "'";
  if (then.now != now.now) return "the scene asks for `now`, which is another";
  return "";
}

std::string change_in_common(const Seen& then, const Seen& now) {
  for (const auto& [path, stamp] : now.files) {
    const auto at = then.files.find(path);
    if (at != then.files.end() && at->second.sum != stamp.sum)
      return std::string(shown(path)) + " has changed";
    if (then.missing.contains(path)) return path + " has come to be";
  }
  for (const std::string& path : now.there) {
    if (then.missing.contains(path)) return path + " has come to be";
  }
  for (const std::string& path : now.missing) {
    if (then.files.contains(path) || then.there.contains(path)) return path + " is gone";
  }
  return "";
}

std::optional<FileStamp> stamp_of(const std::filesystem::path& path) {
  const std::int64_t before = now();
  const auto sum = parser::file_checksum(path.string());
  if (!sum) return std::nullopt;
  return stamp_read(path, *sum, before);
}

FileStamp stamp_read(const std::filesystem::path& path, std::uint64_t sum, std::int64_t since) {
  FileStamp stamp = outside_of(path).value_or(FileStamp{});
  stamp.sum = sum;
  return trusted(stamp, since);
}

void renew(const std::filesystem::path& path, FileStamp& stamp) {
  if (stamp.changed != 0) return;
  const auto now = stamp_of(path);
  if (now && now->sum == stamp.sum) stamp = *now;
}

bool is_as_it_was(const std::filesystem::path& path, const FileStamp& stamp) {
  auto outside = outside_of(path);
  if (!outside) return false;
  outside->sum = stamp.sum;
  if (stamp.changed != 0 && *outside == stamp) return true;
  return parser::file_checksum(path.string()) == stamp.sum;
}

Seen seen_in(const nlohmann::json& dependencies, const std::filesystem::path& folder,
             std::int64_t since) {
  const auto absolute = [&folder](const std::string& path) {
    return (folder / path).lexically_normal().string();
  };
  Seen seen;
  for (const auto& [path, sum] : dependencies.at("read").items())
    seen.files[absolute(path)] = stamp_read(absolute(path), whole_of<std::uint64_t>(sum), since);
  for (const auto& [member, paths] :
       {std::pair{"missing", &seen.missing}, {"there", &seen.there}}) {
    for (const auto& path : dependencies.at(member))
      paths->insert(absolute(path.get<std::string>()));
  }
  seen.name = dependencies.value("input_file_name", "");
  if (dependencies.contains("now")) seen.now = dependencies.at("now").get<double>();
  return seen;
}

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_REALTIME, &time);
  return nanoseconds(time);
}

std::int64_t modified(const std::filesystem::path& path) {
  const auto stamp = outside_of(path);
  return stamp ? stamp->modified : 0;
}

}  // namespace lentray::tool
