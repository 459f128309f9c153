// An input as a file, in memory where there is such a folder: one a process at a time. It goes away with the object.
// Threads: one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lentray::test {

class InputFile {
 public:
  /// `end`: of the file's name.
  InputFile(const std::uint8_t* data, std::size_t size, std::string_view end = "");
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& path() const { return m_path; }
  /// Without `end`.
  const std::string& begin() const { return m_begin; }
  /// As scenes name it.
  std::string quoted() const { return '"' + m_path + '"'; }

 private:
  std::string m_begin, m_path;
};

}  // namespace lentray::test
