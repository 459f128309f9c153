#include "tools/session/picture_journal.h"

#include <algorithm>
#include <cstring>

namespace lentray::tool {
namespace {

constexpr FileMark kJournal{"lentray journal", 3}, kFinished{"lentray done", 3};
/// Of a pixel. A record has the columns and rows of its pixels, and then their values.
constexpr std::size_t kBytes = sizeof(core::Pixel) + core::PictureLedger::kValues * sizeof(float);

void forget_at(const std::string& path) {
  WorkFile::forget(path, kJournal);
  WorkFile::forget(path, kFinished);
}

}  // namespace

PictureJournal::PictureJournal(std::string picture, std::uint32_t width, std::uint32_t height,
                               Identity identity, std::chrono::milliseconds silence)
    : m_width(width), m_height(height), m_work(journal_path(picture), kJournal, identity, silence) {
}

std::optional<PictureJournal::Earlier> PictureJournal::earlier(const std::string& picture) {
  const std::string path = journal_path(picture);
  if (auto journal = WorkFile::earlier(path, kJournal)) return Earlier{std::move(*journal), false};
  if (auto finished = WorkFile::earlier(path, kFinished))
    return Earlier{std::move(*finished), true};
  return std::nullopt;
}

void PictureJournal::forget(const std::string& picture) { forget_at(journal_path(picture)); }

void PictureJournal::go_on() {
  m_work.go_on(m_work.path(),
               [this](std::uint32_t stage, std::uint64_t place, const std::string& bytes) {
                 return note_record(stage, place, bytes);
               });
}

bool PictureJournal::note_record(std::uint32_t stage, std::uint64_t place,
                                 const std::string& bytes) {
  const std::size_t count = bytes.size() / kBytes;
  if (stage >= kStages || bytes.size() % kBytes != 0 || count > std::size_t{m_width} * m_height)
    return false;
  if (!m_known[stage]) m_known[stage] = std::make_unique<core::PixelSet>(m_width, m_height);
  Place there{place, stage, static_cast<std::uint32_t>(count), m_height, 0};
  for (std::size_t i = 0; i < count; ++i) {
    core::Pixel pixel;
    std::memcpy(&pixel, bytes.data() + i * sizeof pixel, sizeof pixel);
    if (pixel.column >= m_width || pixel.row >= m_height) continue;
    m_known[stage]->add(pixel);
    there.first_row = std::min(there.first_row, pixel.row);
    there.last_row = std::max(there.last_row, pixel.row);
  }
  m_places.push_back(there);
  return true;
}

void PictureJournal::read(const Place& place, std::string& bytes) const {
  bytes.resize(place.count * kBytes);
  m_work.read(place.offset, bytes);
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

void PictureJournal::add(std::size_t stage, const std::vector<core::Pixel>& pixels,
                         const std::vector<float>& values) {
  if (pixels.empty()) return;
  std::string bytes(reinterpret_cast<const char*>(pixels.data()),
                    pixels.size() * sizeof(core::Pixel));
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
  const std::lock_guard lock(m_mutex);
  m_work.append(static_cast<std::uint32_t>(stage), bytes);
}

bool PictureJournal::keep() {
  const std::lock_guard lock(m_mutex);
  return m_work.keep();
}

void PictureJournal::finish(bool say_so) {
  if (say_so) return m_work.say(kFinished);
  m_work.remove();
  WorkFile::forget(m_work.path(), kFinished);
}

std::uint64_t PictureJournal::bytes() {
  const std::lock_guard lock(m_mutex);
  return m_work.room();
}

bool PictureJournal::give() {
  const std::lock_guard lock(m_mutex);
  if (m_work.is_open()) {
    for (Place& place : m_places) {
      if (place.last_row >= m_recalled[place.stage]) read(place, place.bytes);
    }
    std::erase_if(m_places, [](const Place& place) { return place.bytes.empty(); });
  }
  return m_work.give();
}

}  // namespace lentray::tool
