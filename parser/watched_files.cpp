#include "parser/watched_files.h"

#include <cstdio>
#include <cstring>
#include <memory>

namespace lentray::parser {
namespace {

struct Sum {
  std::uint64_t value = 0x6a09e667f3bcc908;  // any number
  void add(const char* bytes, std::size_t size) {
    for (; size >= 8; bytes += 8, size -= 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes, 8);
      mix(word);
    }
    std::uint64_t rest = 0;
    std::memcpy(&rest, bytes, size);
    mix(rest ^ (size + 1) << 56);
  }
  void mix(std::uint64_t word) {
    value = (value ^ word) * 0x9e3779b97f4a7c15;
    value ^= value >> 29;
  }
};

}  // namespace

std::uint64_t checksum(std::string_view bytes) {
  Sum sum;
  sum.add(bytes.data(), bytes.size());
  return sum.value;
}

std::optional<std::uint64_t> file_checksum(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return std::nullopt;
  std::string bytes;
  std::string part(std::size_t{1} << 16, '\0');
  while (const std::size_t got = std::fread(part.data(), 1, part.size(), file.get())) bytes.append(part, 0, got);
  if (std::ferror(file.get())) return std::nullopt;
  return checksum(bytes);
}

void WatchedFiles::saw(const std::string& path, std::uint64_t sum) const {
  if (!m_written.contains(path)) m_seen[path] = sum;
}

std::optional<std::string> WatchedFiles::read(const std::string& path) const {
  std::optional<std::string> text = m_below.read(path);
  if (text) saw(path, checksum(*text));
  return text;
}

std::optional<std::string> WatchedFiles::read_scene(const std::string& path) const {
  std::optional<std::string> text = m_below.read_scene(path);
  if (text) saw(path, checksum(*text));
  return text;
}

std::string WatchedFiles::hold(const std::string& path) {
  std::string handle = m_below.hold(path);
  if (const auto sum = file_checksum(handle)) saw(path, *sum);
  return handle;
}

std::unique_ptr<FileWriter> WatchedFiles::open(const std::string& path, bool append) {
  m_written.insert(path);
  m_seen.erase(path);
  return m_below.open(path, append);
}

}  // namespace lentray::parser
