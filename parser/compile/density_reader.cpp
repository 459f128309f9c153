#include "parser/compile/density_reader.h"

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "core/base/memory_limit.h"
#include "parser/files/opened_file.h"

namespace lentray::parser {
namespace {

constexpr std::size_t kHeader = 6;

/// A whole number of so many bytes.
double number_at(std::string_view bytes, std::size_t from, std::size_t count) {
  double number = 0.0;
  for (std::size_t i = 0; i < count; ++i)
    number = number * 256.0 + static_cast<unsigned char>(bytes[from + i]);
  return number;
}

}  // namespace

std::shared_ptr<const core::DensityGrid> read_density_file(const FoundFile& found) {
  std::error_code error;
  core::check_room(2.0 * static_cast<double>(std::filesystem::file_size(found.handle, error)));
  const std::optional<std::string> read = read_held(found);
  if (!read || read->size() < kHeader) {
    throw std::runtime_error("cannot read the density file \"" + found.path + "\"");
  }
  const std::string& bytes = *read;
  auto grid = std::make_shared<core::DensityGrid>();
  std::size_t voxels = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid->size[axis] = static_cast<std::size_t>(number_at(bytes, 2 * axis, 2));
    voxels *= grid->size[axis];
  }
  const std::size_t length = bytes.size() - kHeader;
  const std::size_t width = voxels == 0 ? 0 : length / voxels;
  if (voxels == 0 || width * voxels != length || (width != 1 && width != 2 && width != 4)) {
    throw std::runtime_error("the density file \"" + found.path + "\" has " +
                             std::to_string(length) + " bytes for " + std::to_string(voxels) +
                             " voxels: expected 1, 2 or 4 a voxel");
  }
  const double full = width == 1 ? 255.0 : width == 2 ? 65535.0 : 4294967295.0;
  core::check_room(static_cast<double>(voxels) * sizeof(float));
  grid->values.reserve(voxels);
  for (std::size_t i = 0; i < voxels; ++i) {
    grid->values.push_back(static_cast<float>(number_at(bytes, kHeader + i * width, width) / full));
  }
  return grid;
}

}  // namespace lentray::parser
