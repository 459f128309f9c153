#include "tools/lentray-merge/png_rows.h"

#include <bit>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "core/image/writer.h"

namespace lentray::merge {

PngRows::PngRows(std::filesystem::path path, std::size_t row_bytes)
    : m_path(std::move(path)), m_row(row_bytes) {}

void PngRows::close() {
  m_input.reset();
  m_file.reset();
}

void PngRows::open() {
  m_file.reset(std::fopen(m_path.c_str(), "rbe"));
  if (!m_file) throw std::runtime_error(std::strerror(errno));
  m_input.emplace(m_file.get());
  const png_structp png = m_input->png;
  const png_infop info = m_input->info;
  png_read_info(png, info);
  if (png_get_bit_depth(png, info) == 16 && std::endian::native == std::endian::little)
    png_set_swap(png);
  if (png_get_rowbytes(png, info) != m_row.size())
    throw std::runtime_error("it has changed meanwhile");
}

void PngRows::read_to(std::uint32_t number) {
  if (!m_input) open();
  for (; m_at < number; ++m_at) png_read_row(m_input->png, m_row.data(), nullptr);
}

std::span<const png_byte> PngRows::row(std::uint32_t number) {
  try {
    read_to(number);
  } catch (const std::exception& e) {
    throw core::ImageError("cannot read '" + m_path.string() + "': " + e.what());
  }
  return m_row;
}

}  // namespace lentray::merge
