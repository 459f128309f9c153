#include "tools/lentray-merge/png_rows.h"

#include <bit>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "core/image/png_errors.h"
#include "core/image/writer.h"

namespace lentray::merge {

PngRows::PngRows(std::filesystem::path path, std::size_t row_bytes)
    : m_path(std::move(path)), m_row(row_bytes) {}

PngRows::~PngRows() { close(); }

void PngRows::close() {
  png_destroy_read_struct(&m_png, &m_info, nullptr);
  m_png = nullptr;
  m_info = nullptr;
  m_file.reset();
}

void PngRows::open() {
  m_file.reset(std::fopen(m_path.c_str(), "rbe"));
  if (!m_file) throw std::runtime_error(std::strerror(errno));
  m_png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, core::png_fails, core::png_warns);
  m_info = m_png ? png_create_info_struct(m_png) : nullptr;
  if (!m_info) throw std::runtime_error("out of memory");
  png_set_user_limits(m_png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // its own are a million
  png_init_io(m_png, m_file.get());
  png_read_info(m_png, m_info);
  if (png_get_bit_depth(m_png, m_info) == 16 && std::endian::native == std::endian::little)
    png_set_swap(m_png);
  if (png_get_rowbytes(m_png, m_info) != m_row.size())
    throw std::runtime_error("it has changed meanwhile");
}

void PngRows::read_to(std::uint32_t number) {
  if (!m_file) open();
  for (; m_at < number; ++m_at) png_read_row(m_png, m_row.data(), nullptr);
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
