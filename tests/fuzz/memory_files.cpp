#include "tests/fuzz/memory_files.h"

#include <cctype>

namespace lentray::test {
namespace {

// What a scene writes beyond this fails: a loop can write without end.
constexpr std::size_t kMostBytes = 1 << 20;

class MemoryWriter final : public parser::FileWriter {
 public:
  explicit MemoryWriter(std::string& text) : m_text(text) {}
  std::string write(std::string_view bytes) override {
    if (m_text.size() + bytes.size() > kMostBytes) return "no space left";
    m_text += bytes;
    return {};
  }

 private:
  std::string& m_text;
};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

bool MemoryFiles::exists(const std::string& path) const {
  return m_own.count(path) > 0 || m_library.count(path) > 0;
}

std::optional<std::string> MemoryFiles::find_loosely(const std::string& folder,
                                                     const std::string& name) const {
  const std::string wanted = lower(folder.empty() ? name : folder + "/" + name);
  for (const auto* files : {&m_own, &m_library}) {
    for (const auto& [path, text] : *files) {
      if (lower(path) == wanted) return path;
    }
  }
  return std::nullopt;
}

std::optional<std::string> MemoryFiles::read(const std::string& path) const {
  for (const auto* files : {&m_own, &m_library}) {
    if (const auto found = files->find(path); found != files->end()) return found->second;
  }
  return std::nullopt;
}

std::unique_ptr<parser::FileWriter> MemoryFiles::open(const std::string& path, bool append) {
  if (path.empty()) return nullptr;
  std::string& text = m_own[path];
  if (!append) text.clear();
  return std::make_unique<MemoryWriter>(text);
}

}  // namespace lentray::test
