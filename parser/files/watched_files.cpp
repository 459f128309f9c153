#include "parser/files/watched_files.h"

#include <cstdio>
#include <memory>

namespace lentray::parser {
namespace {

/// Takes bytes in any parts.
class Sum {
 public:
  void add(const char* bytes, std::size_t size) {
    for (; size > 0; --size, ++bytes) {
      m_word = m_word << 8 | static_cast<unsigned char>(*bytes);
      if (++m_count % 8 == 0) mix();
    }
  }
  std::uint64_t end() {
    mix();
    m_word = m_count;
    mix();
    return m_value;
  }

 private:
  void mix() {
    m_value = (m_value ^ m_word) * 0x9e3779b97f4a7c15;
    m_value ^= m_value >> 29;
    m_word = 0;
  }
  std::uint64_t m_value = 0x6a09e667f3bcc908;  // any number
  std::uint64_t m_word = 0, m_count = 0;
};

}  // namespace

std::uint64_t checksum(std::string_view bytes) {
  Sum sum;
  sum.add(bytes.data(), bytes.size());
  return sum.end();
}

std::optional<std::uint64_t> file_checksum(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) return std::nullopt;
  Sum sum;
  std::string part(std::size_t{1} << 16, '\0');
  while (const std::size_t got = std::fread(part.data(), 1, part.size(), file.get())) {
    sum.add(part.data(), got);
  }
  if (std::ferror(file.get())) return std::nullopt;
  return sum.end();
}

void WatchedFiles::saw(const std::string& path, std::uint64_t sum) const {
  if (!m_written.contains(path)) m_seen[path] = sum;
}

bool WatchedFiles::exists(const std::string& path) const {
  const bool is_there = m_below.exists(path);
  if (!is_there && !m_written.contains(path)) m_missing.insert(path);
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
  return m_below.open(path, append);
}

}  // namespace lentray::parser
