#include "tools/session/picture_journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "core/image/written_bytes.h"
#include "parser/files/watched_files.h"
#include "parser/options/options.h"
#include "tools/session/summed_bytes.h"

namespace lentray::tool {
namespace {

constexpr std::uint32_t kRecord = 0x4c525031;

/// Before a record's pixels, which are their columns and rows and then their values.
struct RecordHead {
  std::uint32_t mark = kRecord, stage = 0, count = 0, unused = 0;
  std::uint64_t sum = 0;
};
constexpr std::size_t kBytes =
    sizeof(core::Pixel) + core::PictureLedger::kValues * sizeof(float);  ///< a pixel

/// How a journal begins. Its length makes it whole or not.
struct Start {
  char magic[16] = "lentray journal";
  std::uint32_t version = 2, is_finished = 0;
  std::uint64_t size = 0, sum = 0;  ///< of the identity's text
};

std::string bytes_of(const void* data, std::size_t size) {
  return {static_cast<const char*>(data), size};
}

std::string start_text(const Identity& identity, bool is_finished) {
  const std::string text = identity.text();
  Start start;
  start.is_finished = is_finished ? 1 : 0;
  start.size = text.size();
  start.sum = parser::checksum(text);
  return bytes_of(&start, sizeof start) + text;
}

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

/// Empty if the file is no journal, or a part of one that says nothing yet.
std::optional<PictureJournal::Earlier> read_start(int file, std::uint64_t& end) {
  constexpr std::uint64_t kLongest = 1 << 26;
  Start start;
  if (!read_at(file, 0, &start, sizeof start) ||
      std::memcmp(start.magic, Start{}.magic, sizeof start.magic) != 0 ||
      start.version != Start{}.version || start.size > kLongest) {
    return std::nullopt;
  }
  std::string text(start.size, '\0');
  if (!read_at(file, sizeof start, text.data(), text.size()) || parser::checksum(text) != start.sum)
    return std::nullopt;
  end = sizeof start + text.size();
  try {
    return PictureJournal::Earlier{Identity::of_text(text), start.is_finished != 0};
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

int open_journal(const std::string& path, int how) {
  return ::open(path.c_str(), how | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
}

bool is_regular(int file) {
  struct stat about {};
  return ::fstat(file, &about) == 0 && S_ISREG(about.st_mode);
}

void forget_at(const std::string& path) {
  const int file = open_journal(path, O_RDWR);
  if (file < 0) return;
  std::uint64_t end = 0;
  if (is_regular(file) && read_start(file, end) && ::flock(file, LOCK_EX | LOCK_NB) == 0)
    (void)::unlink(path.c_str());
  ::close(file);
}

}  // namespace

PictureJournal::PictureJournal(std::string picture, std::uint32_t width, std::uint32_t height,
                               Identity identity, std::chrono::milliseconds silence)
    : m_path(journal_path(picture)), m_width(width), m_height(height),
      m_identity(std::move(identity)), m_speaks(Clock::now() + silence) {}

PictureJournal::~PictureJournal() {
  flush();
  if (m_file >= 0) ::close(m_file);
}

std::optional<PictureJournal::Earlier> PictureJournal::earlier(const std::string& picture) {
  const int file = open_journal(journal_path(picture), O_RDONLY);
  if (file < 0) return std::nullopt;
  std::uint64_t end = 0;
  auto out = is_regular(file) ? read_start(file, end) : std::nullopt;
  ::close(file);
  return out;
}

void PictureJournal::go_on() {
  const int file = open_journal(m_path, O_RDWR);
  if (file < 0) return;
  std::uint64_t end = 0;
  const auto found = is_regular(file) ? read_start(file, end) : std::nullopt;
  if (!found || found->is_finished) {
    ::close(file);
    return;
  }
  std::string why = difference(found->identity, m_identity);
  if (why.empty() && ::flock(file, LOCK_EX | LOCK_NB) != 0) why = "another run is at it";
  if (!why.empty()) {
    ::close(file);
    throw parser::OptionError("the picture cannot be continued: " + why + " ('" + m_path +
                              "' keeps what was done; without +C the picture is begun anew)");
  }
  m_file = file;
  m_goes_on = true;
  read_records(end);
}

/// Up to the first one that is not whole; what follows is cut off.
void PictureJournal::read_records(std::uint64_t offset) {
  std::string bytes;
  for (RecordHead head; read_at(m_file, offset, &head, sizeof head);) {
    if (head.mark != kRecord || head.stage >= kStages ||
        head.count > std::uint64_t{m_width} * m_height)
      break;
    bytes.resize(head.count * kBytes);
    if (!read_at(m_file, offset + sizeof head, bytes.data(), bytes.size()) ||
        parser::checksum(bytes) != head.sum)
      break;
    if (!m_known[head.stage])
      m_known[head.stage] = std::make_unique<core::PixelSet>(m_width, m_height);
    Place place{offset + sizeof head, head.stage, head.count, m_height, 0};
    for (std::uint32_t i = 0; i < head.count; ++i) {
      core::Pixel pixel;
      std::memcpy(&pixel, bytes.data() + i * sizeof pixel, sizeof pixel);
      if (pixel.column >= m_width || pixel.row >= m_height) continue;
      m_known[head.stage]->add(pixel);
      place.first_row = std::min(place.first_row, pixel.row);
      place.last_row = std::max(place.last_row, pixel.row);
    }
    m_places.push_back(place);
    offset += sizeof head + bytes.size();
  }
  m_whole = offset;
  if (::ftruncate(m_file, static_cast<off_t>(offset)) != 0) m_is_off = true;
}

void PictureJournal::read(const Place& place, std::string& bytes) const {
  bytes.resize(place.count * kBytes);
  if (!read_at(m_file, place.offset, bytes.data(), bytes.size())) {
    throw parser::OptionError("cannot read '" + m_path + "': " + std::strerror(errno));
  }
}

void PictureJournal::recall(std::size_t stage, std::uint32_t top, std::uint32_t bottom,
                            const std::function<void(const core::Pixel&, const float*)>& tell) {
  const std::lock_guard lock(m_mutex);
  m_recalled[stage] = std::max(m_recalled[stage], bottom);
  std::string read_now;
  for (const Place& place : m_places) {
    if (place.stage != stage || place.last_row < top || place.first_row >= bottom) continue;
    if (place.bytes.empty()) read(place, read_now);
    const std::string& bytes = place.bytes.empty() ? read_now : place.bytes;
    const char* const values = bytes.data() + place.count * sizeof(core::Pixel);
    for (std::uint32_t i = 0; i < place.count; ++i) {
      core::Pixel pixel;
      std::memcpy(&pixel, bytes.data() + i * sizeof pixel, sizeof pixel);
      if (pixel.row < top || pixel.row >= bottom || pixel.column >= m_width) continue;
      float value[kValues];
      std::memcpy(value, values + i * sizeof value, sizeof value);
      tell(pixel, value);
    }
  }
}

bool PictureJournal::listens() const {
  return !m_is_off.load(std::memory_order_relaxed) && (m_goes_on || Clock::now() >= m_speaks);
}

void PictureJournal::add(std::size_t stage, const std::vector<core::Pixel>& pixels,
                         const std::vector<float>& values) {
  if (pixels.empty()) return;
  RecordHead head;
  head.stage = static_cast<std::uint32_t>(stage);
  head.count = static_cast<std::uint32_t>(pixels.size());
  std::string bytes = bytes_of(pixels.data(), pixels.size() * sizeof(core::Pixel));
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
  head.sum = parser::checksum(bytes);
  const std::lock_guard lock(m_mutex);
  m_pending.append(reinterpret_cast<const char*>(&head), sizeof head).append(bytes);
  const Clock::time_point now = Clock::now();
  if (m_pending.size() < kMostPending && now - m_flushed < kBetweenWrites) return;
  m_flushed = now;
  flush();
}

/// Takes the file from an earlier run, unless that is still at it.
void PictureJournal::begin() {
  m_file = open_journal(m_path, O_RDWR | O_CREAT);
  m_whole = 0;
  if (const std::string why = take_file(m_file, m_path); !why.empty()) {
    give_up(why);
  } else {
    write(start_text(m_identity, false));
    if (m_is_off) (void)::unlink(m_path.c_str());
  }
  if (m_is_off && m_file >= 0) {
    ::close(m_file);
    m_file = -1;
  }
}

void PictureJournal::give_up(const std::string& why) {
  m_trouble = why;
  m_is_off = true;
}

/// All of it, or nothing.
void PictureJournal::write(const std::string& bytes) {
  if (const std::string why = core::count_kept(bytes.size()); !why.empty()) return give_up(why);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t wrote = ::pwrite(m_file, bytes.data() + done, bytes.size() - done,
                                   static_cast<off_t>(m_whole + done));
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) {
      give_up(std::strerror(errno));
      [[maybe_unused]] const int cut = ::ftruncate(m_file, static_cast<off_t>(m_whole));
      return;
    }
    done += static_cast<std::size_t>(wrote);
  }
  m_whole += done;
}

void PictureJournal::flush() {
  if (m_pending.empty() || m_is_off) return;
  if (m_file < 0) begin();
  if (!m_is_off) write(m_pending);
  m_pending.clear();
}

bool PictureJournal::keep() {
  const std::lock_guard lock(m_mutex);
  flush();
  return m_file >= 0;
}

void PictureJournal::finish(bool say_so) {
  m_pending.clear();
  if (say_so && m_file < 0) begin();
  if (say_so && m_file >= 0 && ::ftruncate(m_file, 0) == 0) {
    m_whole = 0;
    write(start_text(m_identity, true));
  }
  if (!say_so) remove_taken(m_file, m_path);
  if (m_file >= 0) ::close(m_file);
  m_file = -1;
  m_is_off = true;
  if (!say_so) forget_at(m_path);
}

std::uint64_t PictureJournal::bytes() {
  constexpr std::uint64_t kBlock = 512;
  const std::lock_guard lock(m_mutex);
  struct stat about {};
  const bool is_there =
      m_file >= 0 ? ::fstat(m_file, &about) == 0 : ::lstat(m_path.c_str(), &about) == 0;
  return is_there && S_ISREG(about.st_mode) ? static_cast<std::uint64_t>(about.st_blocks) * kBlock
                                            : 0;
}

void PictureJournal::give() {
  const std::lock_guard lock(m_mutex);
  m_pending.clear();
  m_is_off = true;
  if (m_file < 0) return forget_at(m_path);
  for (Place& place : m_places) {
    if (place.last_row >= m_recalled[place.stage]) read(place, place.bytes);
  }
  std::erase_if(m_places, [](const Place& place) { return place.bytes.empty(); });
  m_is_given = true;
  if (::ftruncate(m_file, 0) != 0) m_trouble = std::strerror(errno);
  (void)::unlink(m_path.c_str());
  ::close(m_file);
  m_file = -1;
}

std::string PictureJournal::trouble() const {
  const std::string name = "'" + m_path + "' ";
  const std::string so = ": had this run been cut off, +C would not have continued it";
  if (m_is_given) return name + "was given up, for the picture needed its room" + so;
  if (m_trouble.empty()) return "";
  if (m_whole > 0) return name + "could not be written to its end (" + m_trouble + ")";
  return name + "could not be written (" + m_trouble + ")" + so;
}

void PictureJournal::forget(const std::string& picture) { forget_at(journal_path(picture)); }

}  // namespace lentray::tool
