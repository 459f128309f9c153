// The rows of a PNG file one after another, as core::PictureEncoder takes them: samples
// side by side, of 16 bits in the machine's order of bytes. One row is in memory.
// The file is open from the first row that is asked for until close().
// Errors: core::ImageError with the path and the reason. One thread an object.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "core/image/open_file.h"
#include "core/image/png_errors.h"

namespace lentray::merge {

class PngRows {
 public:
  /// A row has so many bytes.
  PngRows(std::filesystem::path path, std::size_t row_bytes);

  /// Counted from 1; not above the one before. Until the next call.
  std::span<const png_byte> row(std::uint32_t number);
  void close();

 private:
  void open();
  void read_to(std::uint32_t number);

  const std::filesystem::path m_path;
  core::OpenFile m_file;
  std::optional<core::PngInput> m_input;
  std::uint32_t m_at = 0;  ///< row that is in memory; 0: none
  std::vector<png_byte> m_row;
};

}  // namespace lentray::merge
