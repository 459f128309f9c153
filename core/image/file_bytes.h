// Little-endian numbers of a file that is in memory. Errors: std::runtime_error beyond its end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace lentray::core {

/// `file` must outlive it.
class Bytes {
 public:
  explicit Bytes(std::string_view file) : m_file(file) {}
  std::size_t byte(std::size_t at) const {
    if (at >= m_file.size()) throw std::runtime_error("the file ends early");
    return static_cast<std::uint8_t>(m_file[at]);
  }
  std::size_t size() const { return m_file.size(); }
  std::size_t word(std::size_t at) const { return byte(at) + 256 * byte(at + 1); }
  std::int32_t number(std::size_t at) const {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(word(at) + 65536 * word(at + 2)));
  }

 private:
  std::string_view m_file;
};

}  // namespace lentray::core
