#include "core/image/byte_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

namespace lentray::core {
namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 18;
constexpr std::size_t kMostHeld = std::size_t{64} << 20;

[[noreturn]] void fail(int error = errno) { throw std::runtime_error(std::strerror(error)); }

bool is_lack_of_room(int error) { return error == ENOSPC || error == EDQUOT; }

}  // namespace

ByteFile::ByteFile(const std::filesystem::path& path, SpareRoom* spare, CountBytes count)
    : m_spare(spare), m_count(count) {
  m_file = ::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (m_file < 0) fail();
  m_buffer.reserve(kBuffer);
}

ByteFile::~ByteFile() {
  if (m_file >= 0) ::close(m_file);
}

void ByteFile::write(const void* bytes, std::size_t size) {
  const char* const from = static_cast<const char*>(bytes);
  if (m_buffer.size() + size > kBuffer) flush();
  if (size < kBuffer) {
    m_buffer.insert(m_buffer.end(), from, from + size);
  } else {
    put(m_start, from, size);
    m_start += size;
  }
}

void ByteFile::flush() {
  put(m_start, m_buffer.data(), m_buffer.size());
  m_start += m_buffer.size();
  m_buffer.clear();
}

std::size_t ByteFile::read(void* bytes, std::size_t size) {
  const std::uint64_t all = this->size();
  size = m_start < all ? std::min<std::uint64_t>(size, all - m_start) : 0;
  char* const to = static_cast<char*>(bytes);
  std::memset(to, 0, size);
  for (std::size_t done = 0; done < size;) {
    const ssize_t got = ::pread(m_file, to + done, size - done, static_cast<off_t>(m_start + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail();
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  for (const Piece& piece : m_pieces) {
    const std::uint64_t from = std::max(piece.place, m_start);
    const std::uint64_t end = std::min(piece.end(), m_start + size);
    if (from < end)
      std::memcpy(to + (from - m_start), piece.bytes.data() + (from - piece.place), end - from);
  }
  m_start += size;
  return size;
}

void ByteFile::seek(std::uint64_t place) {
  flush();
  m_start = place;
}

std::uint64_t ByteFile::size() {
  flush();
  struct stat about {};
  if (::fstat(m_file, &about) != 0) fail();
  auto end = static_cast<std::uint64_t>(about.st_size);
  for (const Piece& piece : m_pieces) end = std::max(end, piece.end());
  return end;
}

void ByteFile::close() {
  flush();
  settle();
  const int file = m_file;
  m_file = -1;
  if (::close(file) != 0) fail();
}

void ByteFile::put(std::uint64_t place, const char* bytes, std::size_t size) {
  if (const std::string why = m_count ? m_count(size) : ""; !why.empty())
    throw std::runtime_error(why);
  const bool is_held = std::ranges::any_of(m_pieces, [&](const Piece& piece) {
    return piece.place < place + size && place < piece.end();
  });
  const std::size_t done = is_held ? 0 : put_on_disk(place, bytes, size);
  if (done == size) return;
  if (!is_held) {
    if (!m_spare || !is_lack_of_room(errno)) fail();
    m_why = errno;
  }
  hold(place + done, bytes + done, size - done);
}

/// How many bytes found room; errno says why there are not more.
std::size_t ByteFile::put_on_disk(std::uint64_t place, const char* bytes, std::size_t size) const {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t wrote =
        ::pwrite(m_file, bytes + done, size - done, static_cast<off_t>(place + done));
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) break;
    done += static_cast<std::size_t>(wrote);
  }
  return done;
}

void ByteFile::hold(std::uint64_t place, const char* bytes, std::size_t size) {
  if (m_pieces.empty() || m_pieces.back().end() != place) m_pieces.push_back({place, {}});
  m_pieces.back().bytes.append(bytes, size);
  m_held += size;
  if (m_held > room_to_be_had()) fail(m_why);
  if (m_held > kMostHeld) settle();
}

/// A quota does not say what is left of it.
std::uint64_t ByteFile::room_to_be_had() const {
  struct statvfs disk {};
  const bool is_known = m_why == ENOSPC && ::fstatvfs(m_file, &disk) == 0;
  const auto blocks = ::geteuid() == 0 ? disk.f_bfree : disk.f_bavail;
  return m_spare->bytes() + (is_known ? std::uint64_t{blocks} * disk.f_frsize : 0);
}

/// What is held goes to the disk, which may have room by now without any that is given up.
void ByteFile::settle() {
  for (const Piece& piece : m_pieces) {
    std::size_t done = 0;
    for (;;) {
      done += put_on_disk(piece.place + done, piece.bytes.data() + done, piece.bytes.size() - done);
      if (done == piece.bytes.size()) break;
      const int why = errno;
      if (!is_lack_of_room(why) || !m_spare->give()) fail(why);
    }
  }
  m_pieces.clear();
  m_held = 0;
}

void put_little(std::vector<std::uint8_t>& to, std::uint64_t number, int size) {
  for (int i = 0; i < size; ++i, number >>= 8) to.push_back(static_cast<std::uint8_t>(number));
}

}  // namespace lentray::core
