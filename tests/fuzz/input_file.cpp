#include "tests/fuzz/input_file.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace lentray::test {

InputFile::InputFile(const std::uint8_t* data, std::size_t size, std::string_view end) {
  const std::string folder = std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : "/tmp";
  m_begin = folder + "/lentray-fuzz-" + std::to_string(::getpid());
  m_path = m_begin + std::string(end);
  std::ofstream(m_path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
}

InputFile::~InputFile() { std::remove(m_path.c_str()); }

}  // namespace lentray::test
