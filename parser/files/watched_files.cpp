#include "parser/files/watched_files.h"

#include <cstdio>
#include <memory>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace lentray::parser {

std::uint64_t checksum(std::string_view bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

std::optional<std::uint64_t> file_checksum(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) return std::nullopt;
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> sum(XXH3_createState(),
                                                                            &XXH3_freeState);
  if (!sum || XXH3_64bits_reset(sum.get()) == XXH_ERROR) return std::nullopt;
  std::string part(std::size_t{1} << 16, '\0');
  while (const std::size_t got = std::fread(part.data(), 1, part.size(), file.get())) {
    XXH3_64bits_update(sum.get(), part.data(), got);
  }
  if (std::ferror(file.get())) return std::nullopt;
  return XXH3_64bits_digest(sum.get());
}

void WatchedFiles::saw(const std::string& path, std::uint64_t sum) const {
  if (m_written.contains(path)) return;
  m_seen[path] = sum;
  m_there.erase(path);
}

bool WatchedFiles::exists(const std::string& path) const {
  const bool is_there = m_below.exists(path);
  if (!m_written.contains(path) && !m_seen.contains(path))
    (is_there ? m_there : m_missing).insert(path);
  return is_there;
}

std::optional<std::string> WatchedFiles::read(const std::string& path) const {
  std::optional<std::string> text = m_below.read(path);
  if (text) {
    saw(path, checksum(*text));
  } else if (!m_written.contains(path)) {
    m_missing.insert(path);
  }
  return text;
}

std::optional<std::string> WatchedFiles::read_scene(const std::string& path) const {
  std::optional<std::string> text = m_below.read_scene(path);
  if (text) saw(path, checksum(*text));
  return text;
}

std::string WatchedFiles::hold(const std::string& path) {
  std::string handle = m_below.hold(path);
  if (m_seen.contains(path)) return handle;
  if (const auto sum = file_checksum(handle)) saw(path, *sum);
  return handle;
}

std::unique_ptr<FileWriter> WatchedFiles::open(const std::string& path, bool append) {
  m_written.insert(path);
  m_seen.erase(path);
  m_there.erase(path);
  m_missing.erase(path);
  return m_below.open(path, append);
}

}  // namespace lentray::parser
