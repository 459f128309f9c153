#include "tools/session/pass_file.h"

#include "tools/common/companion.h"

namespace lentray::tool {
namespace {

constexpr FileMark kPasses{"lentray passes", 3};
constexpr std::uint32_t kMostPasses = 64;

std::string passes_path(const std::string& picture) {
  return companion_path(picture, ".lentray-passes");
}

}  // namespace

PassFile::PassFile(const std::string& picture, const Identity& identity,
                   std::chrono::milliseconds silence)
    : m_path(passes_path(picture)), m_work(m_path + ".part", kPasses, identity, silence) {}

std::optional<Identity> PassFile::earlier(const std::string& picture) {
  const std::string path = passes_path(picture);
  auto whole = WorkFile::earlier(path, kPasses);
  return whole ? whole : WorkFile::earlier(path + ".part", kPasses);
}

void PassFile::forget() {
  m_work.remove();
  for (const char* end : {"", ".part"}) WorkFile::forget(m_path + end, kPasses);
}

void PassFile::go_on() {
  const WorkFile::Tell tell = [this](std::uint32_t pass, std::uint64_t, const std::string& record) {
    if (pass >= kMostPasses) return false;
    if (m_earlier.size() <= pass) m_earlier.resize(pass + 1);
    m_earlier[pass].push_back(record);
    return true;
  };
  const std::string part = m_work.path();
  switch (m_work.go_on(m_path, tell)) {
    case WorkFile::Earlier::whole: m_is_whole = true; break;
    // It lost its end, or has more behind it: what it holds is in order.
    case WorkFile::Earlier::cut: m_work.rename(part); break;
    case WorkFile::Earlier::none: m_work.go_on(part, tell); break;
  }
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
  if (!m_is_whole) m_work.append(m_pass, record);
}

void PassFile::finish() {
  if (!m_work.keep()) return m_work.close();  // quick passes are made again sooner than read
  if (!m_is_whole && m_work.is_good()) m_work.rename(m_path);
}

std::uint64_t PassFile::bytes() {
  return WorkFile::room_of(m_path) + WorkFile::room_of(m_path + ".part");
}

bool PassFile::give() {
  const bool had_room = bytes() > 0;
  m_work.give();
  WorkFile::forget(m_path, kPasses);
  return had_room && bytes() == 0;
}

}  // namespace lentray::tool
