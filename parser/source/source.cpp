#include "parser/source/source.h"

#include <algorithm>

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

std::size_t SourceManager::File::line_at(std::size_t offset) const {
  if (line_starts.empty()) {
    line_starts.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') line_starts.push_back(i + 1);
    }
  }
  const auto next = std::upper_bound(line_starts.begin(), line_starts.end(), offset);
  return static_cast<std::size_t>(next - line_starts.begin()) - 1;
}

Position SourceManager::position(const Location& where) const {
  const File* found = find(where.file);
  if (!found) return {};
  const std::size_t line = found->line_at(where.offset);
  const std::size_t column = where.offset - found->line_starts[line];
  return {static_cast<std::uint32_t>(line + 1), static_cast<std::uint32_t>(column + 1)};
}

std::string SourceManager::place(const Location& where) const {
  if (!find(where.file)) return {};
  const Position at = position(where);
  return name(where.file) + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
}

std::string_view SourceManager::line(const Location& where) const {
  const File* found = find(where.file);
  if (!found) return {};
  const std::size_t number = found->line_at(where.offset);
  const std::size_t start = found->line_starts[number];
  const std::size_t end = found->text.find('\n', start);
  return std::string_view(found->text)
      .substr(start, end == std::string::npos ? std::string::npos : end - start);
}

}  // namespace lentray::parser
