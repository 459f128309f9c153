#include "tools/lentray-chart/errors.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "core/image/compare.h"
#include "core/image/display.h"

namespace lentray::chart {

core::StoredImage shown_picture(const std::filesystem::path& file) {
  core::StoredImage image = core::read_image(file);
  return core::is_shown_as_stored(image) ? image : core::displayed(image);
}

bool is_picture(const std::filesystem::path& file) {
  try {
    // By another name: what the chart makes itself is no input that an output must not replace.
    (void)core::read_image(core::NamedFile{.path = file, .name = file.filename()});
    return true;
  } catch (const core::ImageError&) {
    return false;
  }
}

Error error_of(const core::StoredImage& a, const core::StoredImage& b) {
  const core::Comparison c = core::compare(a, b, core::Columns::all(a.width));
  Error e;
  e.psnr = c.psnr;
  e.rms = std::isinf(c.psnr) ? 0.0 : 255.0 * std::pow(10.0, -c.psnr / 20.0);
  e.share = c.share_beyond_1();
  e.largest = c.largest;
  return e;
}

core::StoredImage difference_of(const core::StoredImage& a, const core::StoredImage& b) {
  if (a.width != b.width || a.height != b.height) {
    throw std::invalid_argument("the pictures differ in size");
  }
  core::StoredImage out = core::black_rgb(a.width, a.height, 8);
  for (std::uint32_t row = 0; row < a.height; ++row) {
    for (std::uint32_t column = 0; column < a.width; ++column) {
      const auto p = core::level(a, column, row), q = core::level(b, column, row);
      for (std::size_t c = 0; c < 3; ++c) {
        out.at(column, row, static_cast<int>(c)) =
            static_cast<float>(std::min(255.0, std::round(8.0 * std::abs(p[c] - q[c]))));
      }
    }
  }
  return out;
}

std::optional<double> perceived_in(const std::string& output) {
  const std::string label = "3-norm: ";
  const std::size_t at = output.find(label);
  if (at == std::string::npos) return std::nullopt;
  const char* const begin = output.c_str() + at + label.size();
  char* end = nullptr;
  const double value = std::strtod(begin, &end);
  if (end == begin || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace lentray::chart
