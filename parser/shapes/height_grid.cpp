#include "parser/shapes/height_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "core/base/color.h"
#include "core/base/memory_limit.h"
#include "core/image/reader.h"
#include "parser/base/gamma.h"
#include "parser/files/tiff_bytes.h"

namespace lentray::parser {
namespace {

constexpr float kFull = 65535.0f;

/// 0..1 to a height, cut off as stock does it.
std::uint16_t height_of(float value) {
  return static_cast<std::uint16_t>(std::clamp(value * kFull, 0.0f, kFull));
}

/// What is no height comes in again from the other side, as in stock.
std::uint16_t wrapped(double height) {
  constexpr double kMost = 2147483647.0;
  return std::fabs(height) < kMost ? static_cast<std::uint16_t>(static_cast<std::int32_t>(height))
                                   : 0;
}

/// Values of pigments are cut to 16 bits.
std::uint16_t cut(double value) {
  return static_cast<std::uint16_t>(std::clamp(value, 0.0, 1.0) * static_cast<double>(kFull));
}

/// Of a colour each part is cut before the grey, and the grey again.
std::uint16_t cut_grey(double r, double g, double b) {
  const auto part = [](double value) { return static_cast<double>(cut(value) / kFull); };
  return cut(0.297 * part(r) + 0.589 * part(g) + 0.114 * part(b));
}

/// Rows from the top, as in pictures.
struct Heights {
  int width = 0, depth = 0;
  std::vector<std::uint16_t> values;
};

constexpr double kBytesAHeight =
    2 * sizeof(std::uint16_t);  // with what a grid keeps beside its heights

Heights of_function(const HeightFieldShape& field) {
  const core::Function& function = *field.function->function;
  if (function.parameters() != 3) {
    throw std::runtime_error("the function of a height_field has the parameters x, y, z");
  }
  core::check_room(static_cast<double>(field.width) * field.height * kBytesAHeight);
  Heights heights{field.width, field.height, {}};
  const auto step = [](int i, int count) { return static_cast<double>(i) / (count - 1); };
  std::array<double, core::kMostResults> result{};
  for (int row = 0; row < heights.depth; ++row) {
    for (int column = 0; column < heights.width; ++column) {
      const std::array<double, 3> at = {step(column, heights.width), step(row, heights.depth), 0.0};
      function.evaluate_all(at, result);
      if (function.results() == 5) {
        heights.values.push_back(cut_grey(result[0], result[1], result[2]));
      } else {
        heights.values.push_back(wrapped(result[0] * static_cast<double>(kFull)));
      }
    }
  }
  return heights;
}

/// Fractint's 16-bit files: the right half of the picture holds the low bytes of the left half.
Heights of_potentials(const core::StoredImage& stored, const std::vector<std::uint8_t>& entries) {
  Heights heights{static_cast<int>(stored.width / 2), static_cast<int>(stored.height), {}};
  for (std::uint32_t row = 0; row < stored.height; ++row) {
    const std::size_t start = std::size_t{row} * stored.width;
    for (std::uint32_t column = 0; column < stored.width / 2; ++column) {
      heights.values.push_back(static_cast<std::uint16_t>(
          256u * entries[start + column] + entries[start + column + stored.width / 2]));
    }
  }
  return heights;
}

/// Grey of 8 bits in PNG files goes through the weights of a colour, which takes some one lower.
std::uint16_t grey_byte(float value) {
  return static_cast<std::uint16_t>(257 *
                                    static_cast<int>(core::grey({value, value, value}) * 255.0f));
}

/// Palette entries count 256 each; grey, and colours of 16 bits, by their grey; the red of other colours
/// is the high byte, the green the low one. Floats beyond the full height come in again from the other side.
Heights of_picture(const HeightFieldShape& field) {
  core::StoredImage stored = core::read_image(
      {.path = field.file.handle, .name = field.file.path, .is_targa = field.file_type == "tga"});
  if (field.file_type == "tiff") make_tiff_bytes(stored, field.file.handle);
  Heights heights{static_cast<int>(stored.width), static_cast<int>(stored.height), {}};
  const std::vector<std::uint8_t>& entries = stored.entries;
  if (field.file_type == "pot" && !entries.empty()) return of_potentials(stored, entries);
  const float most = stored.bits == 8 ? 255.0f : stored.bits == 16 ? kFull : 1.0f;
  std::function<float(float)> decode;
  if (field.file_gamma) {
    decode = [from = Gamma::of(*field.file_gamma)](float v) {
      return from.recoded(v, Gamma::linear());
    };
  }
  const bool grey_png = field.file_type == "png" && stored.channels == 1 && stored.bits == 8;
  for (std::uint32_t row = 0; row < stored.height; ++row) {
    for (std::uint32_t column = 0; column < stored.width; ++column) {
      const auto channel = [&](int c) {
        const float value = stored.at(column, row, c) / most;
        return decode ? decode(value) : value;
      };
      if (!entries.empty()) {
        heights.values.push_back(static_cast<std::uint16_t>(256u * entries[heights.values.size()]));
      } else if (grey_png) {
        heights.values.push_back(grey_byte(channel(0)));
      } else if (stored.channels < 3) {
        heights.values.push_back(height_of(channel(0)));
      } else if (stored.bits == 16) {
        heights.values.push_back(height_of(core::grey({channel(0), channel(1), channel(2)})));
      } else {
        heights.values.push_back(wrapped((channel(0) * 256.0 + channel(1)) * 255.0));
      }
    }
  }
  return heights;
}

std::shared_ptr<const core::HeightGrid> build_anew(const HeightFieldShape& field) {
  Heights heights = field.function ? of_function(field) : of_picture(field);
  if (heights.width < 2 || heights.depth < 2) {
    throw std::runtime_error("a height_field needs at least 2 x 2 heights");
  }
  for (int row = 0; row < heights.depth / 2; ++row) {
    const auto top = heights.values.begin() + std::ptrdiff_t{row} * heights.width;
    const auto bottom =
        heights.values.begin() + std::ptrdiff_t{heights.depth - 1 - row} * heights.width;
    std::swap_ranges(top, top + heights.width, bottom);
  }
  return std::make_shared<const core::HeightGrid>(heights.width, heights.depth,
                                                  std::move(heights.values), field.smooth);
}

/// The grids that live. A description stays with its grid, so that no other one can have its address.
class Grids {
 public:
  std::shared_ptr<const core::HeightGrid> of(const Sparse<HeightFieldShape>& field) {
    if (auto grid = find(field)) return grid;
    auto grid = build_anew(*field);
    const std::lock_guard lock(m_mutex);
    m_known.push_back({field, grid});
    return grid;
  }

 private:
  std::shared_ptr<const core::HeightGrid> find(const Sparse<HeightFieldShape>& field) {
    const std::lock_guard lock(m_mutex);
    std::erase_if(m_known, [](const auto& known) { return known.grid.expired(); });
    for (const auto& known : m_known) {
      if (&*known.field == &*field) return known.grid.lock();
    }
    return nullptr;
  }

  struct Known {
    Sparse<HeightFieldShape> field;
    std::weak_ptr<const core::HeightGrid> grid;
  };
  std::mutex m_mutex;
  std::vector<Known> m_known;
};

}  // namespace

std::shared_ptr<const core::HeightGrid> build_height_grid(const Sparse<HeightFieldShape>& field) {
  // Process-wide: trace() and inside() of the language, before the build, and the build share what they find.
  static Grids grids;
  return grids.of(field);
}

}  // namespace lentray::parser
