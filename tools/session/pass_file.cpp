#include "tools/session/pass_file.h"

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
#include "parser/options/options.h"
#include "tools/common/companion.h"
#include "tools/common/process.h"
#include "tools/session/summed_bytes.h"

namespace lentray::tool {
namespace {

constexpr std::uint32_t kMostPasses = 64;

/// Of the file.
constexpr FileMark kMark{"lentray passes", 2};
/// Before a record.
struct Head {
  std::uint32_t mark = 0x4c525041, pass = 0;
};

std::string passes_path(const std::string& picture) {
  return companion_path(picture, ".lentray-passes");
}

bool take_start(std::string_view& bytes, std::string_view& identity) {
  return take_mark(bytes, kMark) && take_summed(bytes, identity);
}

void forget_passes(const std::string& path) {
  struct stat about {};
  if (::lstat(path.c_str(), &about) != 0 || !S_ISREG(about.st_mode)) return;
  const std::string bytes = file_bytes(path);
  std::string_view rest = bytes, identity;
  if (take_start(rest, identity)) (void)::unlink(path.c_str());
}

}  // namespace

PassFile::PassFile(const std::string& picture, const Identity& identity,
                   std::chrono::milliseconds silence)
    : m_path(passes_path(picture)), m_part(m_path + ".part"), m_identity(identity.text()),
      m_speaks(Clock::now() + silence) {}

PassFile::~PassFile() {
  flush();
  if (m_file >= 0) ::close(m_file);
}

std::optional<Identity> PassFile::earlier(const std::string& picture) {
  for (const char* end : {"", ".part"}) {
    struct stat about {};
    const std::string path = passes_path(picture) + end;
    if (::lstat(path.c_str(), &about) != 0 || !S_ISREG(about.st_mode)) continue;
    const std::string bytes = file_bytes(path);
    std::string_view rest = bytes, identity;
    try {
      if (take_start(rest, identity)) return Identity::of_text(std::string(identity));
    } catch (const std::invalid_argument&) {
      continue;
    }
  }
  return std::nullopt;
}

void PassFile::forget() const {
  for (const std::string& path : {m_path, m_part}) {
    remove_taken(m_file, path);
    forget_passes(path);
  }
}

void PassFile::go_on() {
  m_is_whole = read(m_path, false);
  if (m_is_whole) return;
  // One that lost its end, or has more behind it, is a part: what it holds is in order.
  struct stat about {};
  if (!m_earlier.empty() && ::lstat(m_part.c_str(), &about) != 0)
    (void)std::rename(m_path.c_str(), m_part.c_str());
  m_earlier.clear();
  read(m_part, true);
}

bool PassFile::read(const std::string& path, bool is_part) {
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  struct stat about {};
  if (file < 0) return false;
  std::string bytes;
  if (::fstat(file, &about) == 0 && S_ISREG(about.st_mode)) bytes = file_bytes(path);
  std::string_view rest = bytes, identity;
  if (!take_start(rest, identity)) {
    ::close(file);
    return false;
  }
  std::string why;
  try {
    why = difference(Identity::of_text(std::string(identity)), Identity::of_text(m_identity));
  } catch (const std::invalid_argument&) {
    why = "another version of the program began it";
  }
  if (why.empty() && is_part && ::flock(file, LOCK_EX | LOCK_NB) != 0) why = "another run is at it";
  if (!why.empty()) {
    ::close(file);
    throw parser::OptionError("the passes of the picture cannot be continued: " + why + " ('" +
                              path + "' keeps what was done; without +C they are begun anew)");
  }
  std::size_t whole = bytes.size() - rest.size();
  Head head;
  for (std::string_view record; core::take_bytes(rest, head); whole = bytes.size() - rest.size()) {
    if (head.mark != Head{}.mark || head.pass >= kMostPasses || !take_summed(rest, record)) break;
    if (m_earlier.size() <= head.pass) m_earlier.resize(head.pass + 1);
    m_earlier[head.pass].emplace_back(record);
  }
  if (!is_part) {
    ::close(file);
    return whole == bytes.size();
  }
  m_file = file;
  if (::ftruncate(file, static_cast<off_t>(whole)) != 0 || ::lseek(file, 0, SEEK_END) < 0)
    give_up(std::strerror(errno));
  return true;
}

void PassFile::begin(std::size_t pass) {
  m_pass = static_cast<std::uint32_t>(pass);
  m_recalled = 0;
}

bool PassFile::recall(std::string& record) {
  if (m_pass >= m_earlier.size() || m_recalled >= m_earlier[m_pass].size()) return false;
  record = std::move(m_earlier[m_pass][m_recalled++]);
  return true;
}

void PassFile::keep(std::string_view record) {
  if (m_is_off || m_is_whole) return;
  core::append_bytes(Head{.pass = m_pass}, m_pending);
  append_summed(record, m_pending);
  const Clock::time_point now = Clock::now();
  if (now < m_speaks || (m_pending.size() < kMostPending && now - m_flushed < kBetweenWrites))
    return;
  m_flushed = now;
  flush();
}

void PassFile::finish() {
  if (m_file < 0 || m_is_off) {  // quick passes are made again sooner than read
    m_pending.clear();
    return;
  }
  flush();
  if (m_file >= 0) (void)::fsync(m_file);
  if (!m_is_off && std::rename(m_part.c_str(), m_path.c_str()) != 0) give_up(std::strerror(errno));
}

bool PassFile::write() {
  flush();
  return m_file >= 0 && !m_is_off;
}

void PassFile::give_up(const std::string& why) {
  m_trouble = "'" + m_part + "' could not be written (" + why + ")";
  m_is_off = true;
}

void PassFile::flush() {
  if (m_pending.empty() || m_is_off || (m_file < 0 && Clock::now() < m_speaks)) return;
  if (const std::string why = core::count_kept(m_pending.size()); !why.empty()) return give_up(why);
  if (m_file < 0) {
    m_file = ::open(m_part.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    if (const std::string why = take_file(m_file, m_part); !why.empty()) return give_up(why);
    std::string start;
    core::append_bytes(kMark, start);
    append_summed(m_identity, start);
    m_pending.insert(0, start);
  }
  for (std::string_view rest = m_pending; !rest.empty();) {
    const ssize_t wrote = ::write(m_file, rest.data(), rest.size());
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) return give_up(std::strerror(errno));
    rest.remove_prefix(static_cast<std::size_t>(wrote));
  }
  m_pending.clear();
}

}  // namespace lentray::tool
