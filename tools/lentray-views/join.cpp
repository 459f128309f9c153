#include "tools/lentray-views/join.h"

#include "camera/text.h"
#include "core/image/writer.h"
#include "tools/lentray-views/picture.h"

namespace lentray::views {
namespace {

using core::StoredImage;
using Matrix = ColourMatrix;

constexpr Matrix kDuboisLeft = {
    {{0.437f, 0.449f, 0.164f}, {-0.062f, -0.062f, -0.024f}, {-0.048f, -0.050f, -0.017f}}};
constexpr Matrix kDuboisRight = {
    {{-0.011f, -0.032f, -0.007f}, {0.377f, 0.761f, 0.009f}, {-0.026f, -0.093f, 1.234f}}};
constexpr Matrix kPlainLeft = {{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
constexpr Matrix kPlainRight = {{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// Red, green and blue of a pixel over black.
std::array<float, 3> colour_of(const Light& light, std::uint32_t column, std::uint32_t row) {
  const float* const pixel = light.pixel(column, row);
  return light.channels < 3 ? std::array{pixel[0], pixel[0], pixel[0]}
                            : std::array{pixel[0], pixel[1], pixel[2]};
}

}  // namespace

void check_alike(const StoredImage& a, const StoredImage& b) {
  if (const std::string how = other_kind(a, b); !how.empty()) {
    throw core::ImageError("these views do not go together: they have " + how);
  }
}

StoredImage quilt_of(const std::vector<StoredImage>& views, std::uint32_t columns) {
  const std::uint32_t width = views[0].width, height = views[0].height,
                      rows = static_cast<std::uint32_t>(views.size()) / columns;
  StoredImage out = blank_like(views[0], columns * width, rows * height);
  for (std::uint32_t i = 0; i < rows * columns; ++i) {
    check_alike(views[0], views[i]);
    copy_pixels(views[i], {0, 0, width, height}, out, i % columns * width,
                (rows - 1 - i / columns) * height);
  }
  return out;
}

std::string quilt_suffix(std::uint32_t columns, std::uint32_t rows, double aspect) {
  return "_qs" + std::to_string(columns) + "x" + std::to_string(rows) + "a" +
         camera::format(aspect);
}

StoredImage side_by_side(const StoredImage& left, const StoredImage& right) {
  check_alike(left, right);
  StoredImage out = blank_like(left, 2 * left.width, left.height);
  copy_pixels(left, {0, 0, left.width, left.height}, out, 0, 0);
  copy_pixels(right, {0, 0, left.width, left.height}, out, left.width, 0);
  return out;
}

const ColourMatrix& matrix_of(Anaglyph way, bool is_left) {
  if (way == Anaglyph::kDubois) return is_left ? kDuboisLeft : kDuboisRight;
  return is_left ? kPlainLeft : kPlainRight;
}

StoredImage anaglyph(const StoredImage& left, const StoredImage& right, Anaglyph way) {
  check_alike(left, right);
  const Matrix &of_left = matrix_of(way, true), &of_right = matrix_of(way, false);
  const Light a = light_of(left), b = light_of(right);
  Light out{left.width, left.height, 3, {}};
  out.values.reserve(std::size_t{3} * left.width * left.height);
  for (std::uint32_t row = 0; row < left.height; ++row) {
    for (std::uint32_t column = 0; column < left.width; ++column) {
      const auto l = colour_of(a, column, row), r = colour_of(b, column, row);
      for (std::size_t c = 0; c < 3; ++c) {
        float sum = 0.0f;
        for (std::size_t k = 0; k < 3; ++k) sum += of_left[c][k] * l[k] + of_right[c][k] * r[k];
        out.values.push_back(std::max(sum, 0.0f));
      }
    }
  }
  StoredImage like = blank_like(left, 0, 0);
  like.premultiplied = false;
  return stored(out, like);
}

}  // namespace lentray::views
