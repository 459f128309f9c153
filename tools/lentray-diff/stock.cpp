#include "tools/lentray-diff/stock.h"

#include <algorithm>
#include <stdexcept>

#include "tools/lentray-diff/parallel.h"
#include "tools/lentray-diff/sampling.h"
#include "tools/lentray-diff/workshop.h"

namespace lentray::diff {

namespace fs = std::filesystem;
using core::StoredImage;

namespace {

StoredImage mesh_integral(Workshop& shop, const Sheet& sheet, const StockOptions& options) {
  const bool lag = mesh_rows_lag(options);
  const StoredImage rendered =
      shop.render_text("mesh", mesh_scene(sheet, shop.included()), mesh_shot(sheet, 1, lag));
  return mesh_picture(rendered, sheet, lag);
}

/// One picture a view.
StoredImage plain_view(const Workshop& shop, const Included& scene, const Sheet& sheet,
                       std::uint32_t view, Way way, const StockOptions& options) {
  if (is_dark(sheet, view, way))
    return core::black_rgb(sheet.view_width(view), sheet.rows, options.bits);
  return shop.render_text("view" + std::to_string(view), view_scene(sheet, view, way, scene),
                          {.width = sheet.view_width(view),
                           .height = sheet.rows,
                           .antialiased = options.antialiasing.on});
}

StoredImage plain_views(Workshop& shop, const Sheet& sheet, Way way, const StockOptions& options) {
  const Included included = shop.included();
  std::vector<StoredImage> views(std::min(sheet.views(), sheet.columns));
  in_parallel(static_cast<std::uint32_t>(views.size()), options.processes, [&](std::uint32_t j) {
    views[j] = plain_view(shop, included, sheet, j, way, options);
  });
  return interlaced(views, sheet.columns);
}

/// View j of an integral image.
StoredImage view_of(const StoredImage& integral, const Sheet& sheet, std::uint32_t view) {
  if (!sheet.has_views()) throw std::runtime_error("a sheet of fractional N has no views");
  StoredImage image = core::black_rgb(sheet.view_width(view), sheet.rows, integral.bits);
  for (std::uint32_t r = 0; r < image.height; ++r) {
    for (std::uint32_t i = 0; i < image.width; ++i) {
      for (int c = 0; c < 3; ++c) image.at(i, r, c) = integral.at(i * sheet.views() + view, r, c);
    }
  }
  return image;
}

}  // namespace

StoredImage stock_picture(const fs::path& scene, std::uint32_t width, std::uint32_t height,
                          const StockOptions& options) {
  return Workshop(scene, options)
      .render_scene({.width = width, .height = height, .antialiased = options.antialiasing.on});
}

StoredImage stock_integral(const fs::path& scene, const Sheet& sheet, Way way,
                           const StockOptions& options) {
  Workshop shop(scene, options);
  const bool is_mean = samples_a_pixel(way, options) > 1;
  if (way == Way::mesh_camera) {
    return is_mean ? mean_of_samples(shop, sheet, options) : mesh_integral(shop, sheet, options);
  }
  return is_mean ? mean_of_views(shop, sheet, way, options)
                 : plain_views(shop, sheet, way, options);
}

StoredImage stock_view(const fs::path& scene, const Sheet& sheet, std::uint32_t view,
                       const StockOptions& options) {
  const Way way = best_way(sheet);
  if (way == Way::mesh_camera) {
    return view_of(stock_integral(scene, sheet, way, options), sheet, view);
  }
  Workshop shop(scene, options);
  if (samples_a_pixel(way, options) > 1) {
    return view_of(mean_of_views(shop, sheet, way, options, view), sheet, view);
  }
  return plain_view(shop, shop.included(), sheet, view, way, options);
}

void write_wrappers(const fs::path& scene, const Sheet& sheet, const fs::path& folder) {
  StockOptions options;
  options.keep = folder;
  const Included included = Workshop(scene, options).included();
  tool::write_whole(folder / "mesh.pov", mesh_scene(sheet, included));
  const Way way = best_way(sheet);
  if (way == Way::mesh_camera) return;
  for (std::uint32_t j = 0; j < std::min(sheet.views(), sheet.columns); ++j) {
    if (is_dark(sheet, j, way)) continue;
    tool::write_whole(folder / ("view" + std::to_string(j) + ".pov"),
                      view_scene(sheet, j, way, included));
  }
}

StoredImage interlaced(const std::vector<StoredImage>& views, std::uint32_t columns) {
  if (views.empty()) throw std::invalid_argument("no views to interlace");
  StoredImage image = core::black_rgb(columns, views[0].height, views[0].bits);
  const auto count = static_cast<std::uint32_t>(views.size());
  for (std::uint32_t r = 0; r < image.height; ++r) {
    for (std::uint32_t k = 0; k < columns; ++k) {
      const StoredImage& view = views[k % count];
      for (int c = 0; c < 3; ++c) {
        image.at(k, r, c) = view.at(k / count, r, view.channels < 3 ? 0 : c);
      }
    }
  }
  return image;
}

}  // namespace lentray::diff
