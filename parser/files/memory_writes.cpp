#include "parser/files/memory_writes.h"

#include <fcntl.h>
#include <sys/mman.h>

#include <algorithm>
#include <filesystem>

#include "core/base/lower_case.h"
#include "parser/base/shown.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{1} << 30;

class MemoryWriter final : public FileWriter {
 public:
  explicit MemoryWriter(std::shared_ptr<std::string> text) : m_text(std::move(text)) {}
  std::string write(std::string_view bytes) override {
    if (m_text->size() + bytes.size() > kMostBytes)
      return "more than 1 GB, which stays in memory here";
    *m_text += bytes;
    return {};
  }

 private:
  std::shared_ptr<std::string> m_text;
};

std::string key(const std::string& path) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);
  const fs::path place = fs::weakly_canonical(whole, error);
  return error ? whole.string() : place.string();
}

}  // namespace

std::shared_ptr<std::string> MemoryWrites::find(const std::string& path) const {
  if (m_texts.empty()) return nullptr;
  const auto found = m_texts.find(key(path));
  return found == m_texts.end() ? nullptr : found->second;
}

bool MemoryWrites::exists(const std::string& path) const {
  return find(path) || m_below.exists(path);
}

std::optional<std::string> MemoryWrites::find_loosely(const std::string& folder,
                                                      const std::string& name) const {
  if (auto found = m_below.find_loosely(folder, name)) return found;
  std::string slashes = name;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  const std::string wanted = core::lower_case(key((fs::path(folder) / slashes).string()));
  for (const auto& [path, text] : m_texts) {
    if (core::lower_case(path) == wanted) return path;
  }
  return std::nullopt;
}

std::optional<std::string> MemoryWrites::read(const std::string& path) const {
  const auto text = find(path);
  return text ? *text : m_below.read(path);
}

std::optional<std::string> MemoryWrites::read_scene(const std::string& path) const {
  return m_below.read_scene(path);
}

std::string MemoryWrites::hold(const std::string& path) {
  const auto text = find(path);
  if (!text) return m_below.hold(path);
  for (const Held& held : m_held) {
    if (held.text == text && held.size == text->size()) return handle_of(held.file);
  }
  Descriptor file(::memfd_create("lentray", MFD_CLOEXEC));
  const auto writer = make_writer(file ? reopen(file, O_WRONLY) : Descriptor());
  if (!writer || !writer->write(*text).empty() || !writer->close().empty()) {
    throw FileRefused("'" + shown_name(path) + "', which is in memory, cannot be opened");
  }
  m_held.push_back({text, text->size(), std::move(file)});
  return handle_of(m_held.back().file);
}

bool MemoryWrites::may_write(const std::string& path) const { return m_below.may_write(path); }

std::unique_ptr<FileWriter> MemoryWrites::open(const std::string& path, bool append) {
  if (!may_write(path)) return nullptr;
  const std::string place = key(path);
  auto text = std::make_shared<std::string>();
  if (append) {
    struct stat status {};
    const bool plain = ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
    if (const auto written = find(path))
      *text = *written;
    else if (plain)
      *text = m_below.read(path).value_or("");
  }
  m_texts[place] = text;
  return std::make_unique<MemoryWriter>(std::move(text));
}

}  // namespace lentray::parser
