#include "tools/lentray-diff/sampling.h"

#include <algorithm>
#include <mutex>

#include "tools/lentray-diff/parallel.h"

namespace lentray::diff {

using core::StoredImage;

namespace {

/// Stock looks for a pixel's mesh from the first mesh on.
constexpr std::uint32_t kColumnsOfMesh = 2000;

double part(int i, int parts) { return (i + 0.5) / parts - 0.5; }

}  // namespace

int samples_a_pixel(Way way, const StockOptions& options) {
  const bool is_sampled = way == Way::mesh_camera && options.antialiasing.on;
  return (is_sampled ? options.samples * options.samples : 1) * options.antialiasing.angles;
}

bool is_dark(const Sheet& sheet, std::uint32_t view, Way way) {
  return way == Way::orthographic_views && !sheet.slope(view);
}

bool mesh_rows_lag(const StockOptions& options) {
  const std::string said = tool::run_program({options.povray, "--version"}).output;
  const std::size_t at = said.find("POV-Ray ");
  return at == std::string::npos || said.compare(at + 8, 3, "3.7") == 0;
}

Shot mesh_shot(const Sheet& sheet, std::size_t offsets, bool lag) {
  return {.width = sheet.rows,
          .height = sheet.columns * static_cast<std::uint32_t>(offsets) + (lag ? 1 : 0)};
}

std::vector<std::vector<PixelOffset>> sample_places(const Sheet& sheet, int n, int m,
                                                    std::uint32_t most_columns) {
  const std::size_t most = std::max(1u, most_columns / sheet.columns);
  std::vector<std::vector<PixelOffset>> lists;
  for (int down = 0; down < n; ++down) {
    lists.emplace_back();
    for (int across = 0; across < n; ++across) {
      for (int turn = 0; turn < m; ++turn) {
        if (lists.back().size() == most) lists.emplace_back();
        lists.back().push_back({part(across, n), part(down, n), part(turn, m)});
      }
    }
  }
  return lists;
}

StoredImage mean_of_views(Workshop& shop, const Sheet& sheet, Way way, const StockOptions& options,
                          std::optional<std::uint32_t> only) {
  const int angles = options.antialiasing.angles;
  const Sheet finer = sheet.finer(angles);
  const Included included = shop.included();
  Mean mean(sheet.columns, sheet.rows, options.colours);
  std::mutex guard;
  in_parallel(std::min(finer.views(), finer.columns), options.processes, [&](std::uint32_t j) {
    const std::uint32_t view = j / static_cast<std::uint32_t>(angles);
    if ((only && view != *only) || is_dark(finer, j, way)) return;
    const StoredImage light =
        shop.render_text("view" + std::to_string(j), view_scene(finer, j, way, included),
                         {.width = finer.view_width(j),
                          .height = finer.rows,
                          .antialiased = options.antialiasing.on,
                          .as_light = true});
    const std::lock_guard<std::mutex> lock(guard);
    for (std::uint32_t r = 0; r < light.height; ++r) {
      for (std::uint32_t i = 0; i < light.width; ++i) {
        mean.add(i * sheet.views() + view, r, light, i, r);
      }
    }
  });
  return mean.picture(angles, options.bits);
}

StoredImage mean_of_samples(Workshop& shop, const Sheet& sheet, const StockOptions& options) {
  const bool lag = mesh_rows_lag(options);
  const auto lists = sample_places(sheet, options.antialiasing.on ? options.samples : 1,
                                   options.antialiasing.angles, kColumnsOfMesh);
  const Included included = shop.included();
  Mean mean(sheet.columns, sheet.rows, options.colours);
  std::mutex guard;
  in_parallel(static_cast<std::uint32_t>(lists.size()), options.processes, [&](std::uint32_t i) {
    const std::vector<PixelOffset>& offsets = lists[i];
    Shot shot = mesh_shot(sheet, offsets.size(), lag);
    shot.as_light = true;
    const StoredImage light =
        shop.render_text("mesh" + std::to_string(i), mesh_scene(sheet, included, offsets), shot);
    const std::lock_guard<std::mutex> lock(guard);
    std::uint32_t at = lag ? 1 : 0;
    for (const PixelOffset& offset : offsets) {
      for (std::uint32_t k = 0; k < sheet.columns; ++k, ++at) {
        if (!sheet.slope(k, offset)) continue;  // shows nothing
        for (std::uint32_t r = 0; r < sheet.rows; ++r) mean.add(k, r, light, r, at);
      }
    }
  });
  return mean.picture(samples_a_pixel(Way::mesh_camera, options), options.bits);
}

}  // namespace lentray::diff
