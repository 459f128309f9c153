#include "parser/files/counted_files.h"

#include "parser/base/shown.h"

namespace lentray::parser {

void CountedFiles::count(const std::string& path) const {
  if (m_count >= m_most) {
    throw FileRefused("'" + shown_name(path) + "' is refused: the scene may open " +
                      std::to_string(m_most) + (m_most == 1 ? " file" : " files") + " (Max_Files)");
  }
  ++m_count;
}

std::optional<std::string> CountedFiles::read(const std::string& path) const {
  count(path);
  return m_below.read(path);
}

std::string CountedFiles::hold(const std::string& path) {
  count(path);
  return m_below.hold(path);
}

std::unique_ptr<FileWriter> CountedFiles::open(const std::string& path, bool append) {
  count(path);
  return m_below.open(path, append);
}

}  // namespace lentray::parser
