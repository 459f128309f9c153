// What libpng calls when something is wrong: its functions must not return, and exceptions leave its frames,
// which hold nothing of their own. One place for writing and reading; errors: std::runtime_error.
#pragma once

#include <png.h>

#include <stdexcept>
#include <string>

namespace lentray::core {

/// The error pointer is null or a std::string: if that says more than libpng, it is what is thrown.
[[noreturn]] inline void png_fails(png_structp png, png_const_charp message) {
  const auto* complaint = static_cast<const std::string*>(png_get_error_ptr(png));
  throw std::runtime_error(complaint && !complaint->empty() ? *complaint : message);
}
inline void png_warns(png_structp, png_const_charp) {}

/// What libpng reads a file with.
struct PngInput {
  explicit PngInput(std::FILE* file) {
    if (!info) {
      png_destroy_read_struct(&png, nullptr, nullptr);
      throw std::runtime_error("out of memory");
    }
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // its own are a million
    png_init_io(png, file);
  }
  ~PngInput() { png_destroy_read_struct(&png, &info, nullptr); }
  PngInput(const PngInput&) = delete;
  PngInput& operator=(const PngInput&) = delete;

  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, png_fails, png_warns);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
};

}  // namespace lentray::core
