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

}  // namespace lentray::core
