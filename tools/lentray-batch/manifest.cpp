#include "tools/lentray-batch/manifest.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "tools/common/json_text.h"
#include "tools/common/process.h"

namespace lentray::batch {

namespace {

std::string line_of(const Row& row) { return tool::json_text(json_of(row)) + "\n"; }

}  // namespace

Manifest::Manifest(const std::filesystem::path& out, StateFolder& state)
    : m_path(out / "manifest.jsonl"), m_state(state), m_rows(rows_in(m_path, &m_is_cut)) {}

const Row* Manifest::find(const std::string& name) const {
  for (const auto* rows : {&m_waiting, &m_rows}) {
    if (const auto at = rows->find(name); at != rows->end()) return &at->second;
  }
  return nullptr;
}

std::map<std::string, std::string> Manifest::names() const {
  std::map<std::string, std::string> out;
  for (const auto& [name, row] : m_rows)
    out[row.source] = name.substr(0, row.frame ? name.rfind('#') : name.size());
  return out;
}

void Manifest::reserve(std::size_t rows) const {
  constexpr std::size_t kRow = 2048;  ///< bytes of a row, about
  const int file = ::open(m_path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) return;
  struct stat status {};
  if (::fstat(file, &status) == 0) {
    ::fallocate(file, FALLOC_FL_KEEP_SIZE, status.st_size, static_cast<off_t>(rows * kRow));
  }
  ::close(file);
}

void Manifest::put(Row row) {
  m_pending += line_of(row);
  m_waiting.erase(row.name);
  m_rows[row.name] = std::move(row);
  if (append(m_pending) || (m_state.free_reserve() && append(m_pending))) {
    m_pending.clear();
    m_trouble.clear();
  }
}

void Manifest::await(Row row) {
  row.state = State::waiting;
  row.reason = "not rendered yet";
  row.picture.clear();
  m_waiting[row.name] = std::move(row);
}

bool Manifest::append(const std::string& lines) {
  const int file = ::open(m_path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  const std::string text = (m_is_cut ? "\n" : "") + lines;
  const ssize_t put = file < 0 ? -1 : ::write(file, text.data(), text.size());
  const int error = errno;
  if (file >= 0) (void)::fdatasync(file);
  if (file >= 0) ::close(file);
  m_is_cut = put > 0 ? text[static_cast<std::size_t>(put) - 1] != '\n' : m_is_cut;
  if (put == static_cast<ssize_t>(text.size())) return true;
  m_trouble = put < 0 ? std::strerror(error) : "no space left on the device";
  return false;
}

void Manifest::tidy() {
  std::string all;
  for (const auto& [name, row] : m_waiting) m_rows[name] = row;
  for (const auto& [name, row] : m_rows) all += line_of(row);
  tool::write_whole(m_path, all);
  m_pending.clear();
  m_trouble.clear();
  m_is_cut = false;
}

}  // namespace lentray::batch
