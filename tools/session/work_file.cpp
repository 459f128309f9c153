#include "tools/session/work_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "core/base/byte_text.h"
#include "core/image/written_bytes.h"
#include "parser/files/watched_files.h"
#include "parser/options/options.h"

namespace lentray::tool {
namespace {

constexpr std::uint32_t kRecord = 0x4c52574b;

/// Before the bytes of a record, and of what the work depends on.
struct Piece {
  std::uint64_t size = 0, sum = 0;
};
struct Head {
  std::uint32_t mark = kRecord, number = 0;
};

bool read_at(int file, std::uint64_t offset, void* out, std::size_t size) {
  char* at = static_cast<char*>(out);
  while (size > 0) {
    const ssize_t got = ::pread(file, at, size, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    offset += static_cast<std::uint64_t>(got);
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

/// False if it is not whole. `offset` goes behind it.
bool read_piece(int file, std::uint64_t& offset, std::uint64_t end, std::string& bytes) {
  Piece piece;
  if (!read_at(file, offset, &piece, sizeof piece)) return false;
  const std::uint64_t begin = offset + sizeof piece;
  if (begin > end || piece.size > end - begin) return false;
  bytes.resize(piece.size);
  if (!read_at(file, begin, bytes.data(), bytes.size()) || parser::checksum(bytes) != piece.sum)
    return false;
  offset = begin + piece.size;
  return true;
}

int open_work(const std::string& path, int how) {
  return ::open(path.c_str(), how | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
}

struct Start {
  Identity identity;
  std::uint64_t end = 0;   ///< where records begin
  std::uint64_t size = 0;  ///< of the file
};

/// Empty if the file is none of that kind, or a part of one that says nothing yet.
std::optional<Start> read_start(int file, const FileMark& mark) {
  struct stat about {};
  FileMark there;
  if (::fstat(file, &about) != 0 || !S_ISREG(about.st_mode) ||
      !read_at(file, 0, &there, sizeof there) ||
      std::memcmp(there.kind, mark.kind, sizeof mark.kind) != 0 || there.version != mark.version) {
    return std::nullopt;
  }
  Start start;
  start.end = sizeof there;
  start.size = static_cast<std::uint64_t>(about.st_size);
  std::string text;
  if (!read_piece(file, start.end, start.size, text)) return std::nullopt;
  try {
    start.identity = Identity::of_text(text);
    return start;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::string start_text(const FileMark& mark, const Identity& identity) {
  std::string out;
  core::append_bytes(mark, out);
  append_summed(identity.text(), out);
  return out;
}

}  // namespace

WorkFile::WorkFile(std::string path, const FileMark& mark, const Identity& identity,
                   std::chrono::milliseconds silence)
    : m_path(std::move(path)), m_mark(mark), m_identity(identity),
      m_speaks(Clock::now() + silence) {}

WorkFile::~WorkFile() {
  flush();
  if (m_file >= 0) ::close(m_file);
}

std::optional<Identity> WorkFile::earlier(const std::string& path, const FileMark& mark) {
  const int file = open_work(path, O_RDONLY);
  if (file < 0) return std::nullopt;
  auto start = read_start(file, mark);
  ::close(file);
  if (!start) return std::nullopt;
  return std::move(start->identity);
}

void WorkFile::forget(const std::string& path, const FileMark& mark) {
  const int file = open_work(path, O_RDWR);
  if (file < 0) return;
  if (read_start(file, mark) && ::flock(file, LOCK_EX | LOCK_NB) == 0) (void)::unlink(path.c_str());
  ::close(file);
}

std::uint64_t WorkFile::room_of(const std::string& path) {
  constexpr std::uint64_t kBlock = 512;
  struct stat about {};
  const bool is_there = ::lstat(path.c_str(), &about) == 0 && S_ISREG(about.st_mode);
  return is_there ? static_cast<std::uint64_t>(about.st_blocks) * kBlock : 0;
}

WorkFile::Earlier WorkFile::go_on(const std::string& path, const Tell& tell) {
  const int file = open_work(path, O_RDWR);
  if (file < 0) return Earlier::none;
  const auto start = read_start(file, m_mark);
  if (!start) {
    ::close(file);
    return Earlier::none;
  }
  std::string why = difference(start->identity, m_identity);
  if (why.empty() && ::flock(file, LOCK_EX | LOCK_NB) != 0) why = "another run is at it";
  if (!why.empty()) {
    ::close(file);
    throw parser::OptionError("the picture cannot be continued: " + why + " ('" + path +
                              "' keeps what was done; without +C the picture is begun anew)");
  }
  m_file = file;
  m_path = path;
  m_goes_on = true;
  m_whole = start->end;
  std::string bytes;
  for (Head head; read_at(file, m_whole, &head, sizeof head) && head.mark == kRecord;) {
    std::uint64_t end = m_whole + sizeof head;
    if (!read_piece(file, end, start->size, bytes) ||
        !tell(head.number, end - bytes.size(), bytes)) {
      break;
    }
    m_whole = end;
  }
  if (m_whole == start->size) return Earlier::whole;
  if (::ftruncate(file, static_cast<off_t>(m_whole)) != 0) give_up(errno);
  return Earlier::cut;
}

void WorkFile::read(std::uint64_t place, std::string& bytes) const {
  if (!read_at(m_file, place, bytes.data(), bytes.size()))
    throw parser::OptionError("cannot read '" + m_path + "': " + std::strerror(errno));
}

bool WorkFile::listens() const {
  return !m_is_off.load(std::memory_order_relaxed) && (m_goes_on || Clock::now() >= m_speaks);
}

void WorkFile::append(std::uint32_t number, std::string_view bytes) {
  if (m_is_off) return;
  core::append_bytes(Head{.number = number}, m_pending);
  append_summed(bytes, m_pending);
  const Clock::time_point now = Clock::now();
  if (m_pending.size() < kMostPending && now - m_flushed < kBetweenWrites) return;
  flush();
}

/// Takes the file from an earlier run, unless that is still at it.
void WorkFile::begin() {
  m_file = open_work(m_path, O_RDWR | O_CREAT);
  m_whole = 0;
  if (const std::string why = take_file(m_file, m_path); !why.empty()) {
    m_trouble = why;
    m_is_off = true;
  } else {
    write(start_text(m_mark, m_identity));
    if (m_is_off) (void)::unlink(m_path.c_str());
  }
  if (m_is_off && m_file >= 0) {
    ::close(m_file);
    m_file = -1;
  }
}

void WorkFile::give_up(int error) {
  m_trouble = std::strerror(error);
  m_is_off = true;
}

/// All of it, or nothing.
void WorkFile::write(std::string_view bytes) {
  if (std::string why = core::count_kept(bytes.size()); !why.empty()) {
    m_trouble = std::move(why);
    m_is_off = true;
    return;
  }
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t wrote = ::pwrite(m_file, bytes.data() + done, bytes.size() - done,
                                   static_cast<off_t>(m_whole + done));
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) {
      give_up(errno);
      [[maybe_unused]] const int cut = ::ftruncate(m_file, static_cast<off_t>(m_whole));
      return;
    }
    done += static_cast<std::size_t>(wrote);
  }
  m_whole += done;
}

void WorkFile::flush() {
  if (m_pending.empty() || !listens()) return;
  m_flushed = Clock::now();
  if (m_file < 0) begin();
  if (!m_is_off) write(m_pending);
  m_pending.clear();
}

bool WorkFile::keep() {
  flush();
  return m_file >= 0;
}

void WorkFile::say(const FileMark& mark) {
  m_pending.clear();
  m_mark = mark;
  m_is_off = false;
  if (m_file < 0) return begin();
  if (::ftruncate(m_file, 0) != 0) return;
  m_whole = 0;
  write(start_text(m_mark, m_identity));
}

void WorkFile::rename(const std::string& path) {
  (void)::fsync(m_file);
  if (std::rename(m_path.c_str(), path.c_str()) != 0) return give_up(errno);
  m_path = path;
}

void WorkFile::close() {
  m_pending.clear();
  m_is_off = true;
  if (m_file >= 0) ::close(m_file);
  m_file = -1;
}

void WorkFile::remove() {
  remove_taken(m_file, m_path);
  close();
  forget(m_path, m_mark);
}

bool WorkFile::give() {
  const bool had_room = room() > 0;
  m_is_given = m_is_given || m_file >= 0;
  if (m_file >= 0 && ::ftruncate(m_file, 0) != 0) m_trouble = std::strerror(errno);
  remove();
  return had_room && room() == 0;
}

std::string WorkFile::trouble() const {
  const std::string name = "'" + m_path + "' ";
  const std::string so = ": had this run been cut off, +C would not have continued it";
  if (m_is_given) return name + "was given up, for the picture needed its room" + so;
  if (m_trouble.empty()) return "";
  if (m_whole > 0) return name + "could not be written to its end (" + m_trouble + ")";
  return name + "could not be written (" + m_trouble + ")" + so;
}

}  // namespace lentray::tool
