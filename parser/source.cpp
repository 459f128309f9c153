#include "parser/source.h"

namespace lentray::parser {
namespace {

// CR LF, and the lone CR of old Macintosh files, become LF.
void unify_line_ends(std::string& text) {
  if (text.find('\r') == std::string::npos) return;
  std::size_t out = 0;
  for (std::size_t in = 0; in < text.size(); ++in) {
    if (text[in] != '\r') {
      text[out++] = text[in];
      continue;
    }
    text[out++] = '\n';
    if (in + 1 < text.size() && text[in + 1] == '\n') ++in;
  }
  text.resize(out);
}

void drop_byte_order_mark(std::string& text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
}

}  // namespace

std::optional<std::uint32_t> SourceManager::load(const std::string& path) {
  auto text = m_disk.read(path);
  if (!text) return std::nullopt;
  return add(path, std::move(*text));
}

std::uint32_t SourceManager::add(std::string name, std::string text) {
  drop_byte_order_mark(text);
  unify_line_ends(text);
  m_files.push_back({std::move(name), std::move(text), {}});
  return static_cast<std::uint32_t>(m_files.size());
}

const SourceManager::File* SourceManager::find(std::uint32_t file) const {
  return file == 0 || file > m_files.size() ? nullptr : &m_files[file - 1];
}

const std::string& SourceManager::name(std::uint32_t file) const {
  static const std::string nowhere;
  const File* found = find(file);
  return found ? found->name : nowhere;
}

std::string_view SourceManager::text(std::uint32_t file) const {
  const File* found = find(file);
  return found ? std::string_view(found->text) : std::string_view();
}

std::string_view SourceManager::line(std::uint32_t file, std::uint32_t number) const {
  const File* found = find(file);
  if (!found || number == 0) return {};
  if (found->line_starts.empty()) {
    found->line_starts.push_back(0);
    for (std::size_t i = 0; i < found->text.size(); ++i) {
      if (found->text[i] == '\n') found->line_starts.push_back(i + 1);
    }
  }
  if (number > found->line_starts.size()) return {};
  const std::size_t start = found->line_starts[number - 1];
  const std::size_t end = found->text.find('\n', start);
  return std::string_view(found->text).substr(
      start, end == std::string::npos ? std::string::npos : end - start);
}

}  // namespace lentray::parser
