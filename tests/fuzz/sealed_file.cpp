#include "tests/fuzz/sealed_file.h"

#include <cstdint>
#include <cstring>

#include "parser/files/watched_files.h"

namespace lentray::test {
namespace {

// Where things are in the files: tools/session/summed_bytes.h, work_file.cpp.
constexpr std::size_t kKind = 16;         ///< bytes of a file's kind
constexpr std::size_t kMark = kKind + 8;  ///< and its version
constexpr std::size_t kRecordHead = 8;

template <typename T>
T value_at(const std::string& bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// Of the piece behind its length and the checksum, which is mended. False: it is not whole.
bool seal_piece(std::string& bytes, std::size_t& at) {
  if (at > bytes.size() || bytes.size() - at < 16) return false;
  const auto size = value_at<std::uint64_t>(bytes, at);
  if (size > bytes.size() - at - 16) return false;
  const std::uint64_t sum = parser::checksum(std::string_view(bytes).substr(at + 16, size));
  std::memcpy(bytes.data() + at + 8, &sum, sizeof sum);
  at += 16 + size;
  return true;
}

}  // namespace

OwnFile own_file(const std::string& bytes) {
  if (bytes.starts_with("lentray journal") || bytes.starts_with("lentray done"))
    return OwnFile::journal;
  if (bytes.starts_with("lentray passes")) return OwnFile::passes;
  return bytes.starts_with("lentray light") ? OwnFile::light : OwnFile::samples;
}

std::string sealed(std::string bytes) {
  const OwnFile kind = own_file(bytes);
  std::size_t at = kMark;
  if (kind == OwnFile::samples || !seal_piece(bytes, at)) return bytes;
  switch (kind) {
    case OwnFile::journal:
    case OwnFile::passes:
      while (seal_piece(bytes, at += kRecordHead)) continue;
      break;
    case OwnFile::light:
      for (std::size_t inner = at + 16; seal_piece(bytes, inner);) continue;
      seal_piece(bytes, at);
      break;
    case OwnFile::samples: break;
  }
  return bytes;
}

std::string identity_text(const std::string& bytes) {
  if (own_file(bytes) == OwnFile::samples || bytes.size() < kMark + 16) return {};
  return bytes.substr(kMark + 16, value_at<std::uint64_t>(bytes, kMark));
}

}  // namespace lentray::test
