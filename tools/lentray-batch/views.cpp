#include "tools/lentray-batch/views.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <numeric>

#include "core/base/formed.h"
#include "core/image/orientation.h"
#include "core/image/photo_tags.h"
#include "core/image/thumbnail.h"

namespace lentray::batch {

namespace fs = std::filesystem;

std::uint32_t view_count(double lens_pixels) {
  return static_cast<std::uint32_t>(std::max(1.0, std::floor(lens_pixels)));
}

core::StoredImage view_of(const core::StoredImage& integral, double lens_pixels,
                          std::uint32_t view) {
  std::vector<std::uint32_t> rows(integral.height);
  std::iota(rows.begin(), rows.end(), 0u);
  return core::rearranged(integral, core::view_columns(integral.width, lens_pixels, view), rows);
}

std::vector<std::string> view_names(const std::string& picture, double lens_pixels) {
  const fs::path folder = fs::path(picture).replace_extension().string() + "-views";
  std::vector<std::string> names;
  for (std::uint32_t j = 0; j < view_count(lens_pixels); ++j) {
    const int digits = view_count(lens_pixels) > 100 ? 3 : 2;
    names.push_back((folder / core::formed("view%0*u.png", digits, j)).string());
  }
  return names;
}

int write_views(const fs::path& picture, double lens_pixels, const fs::path& folder,
                const std::vector<std::string>& names) try {
  const core::StoredImage integral = core::read_image(picture);
  const int orientation = core::photo_tags(picture).orientation;
  for (std::size_t j = 0; j < names.size(); ++j) {
    const fs::path place = folder / names[j];
    fs::create_directories(place.parent_path());
    core::StoredImage view = view_of(integral, lens_pixels, static_cast<std::uint32_t>(j));
    core::write_stored(core::upright(std::move(view), orientation), place);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}

}  // namespace lentray::batch
