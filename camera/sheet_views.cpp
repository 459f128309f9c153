#include "camera/sheet_views.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lentray::camera {
SizedView::SizedView(const Lenticular& sheet, std::uint32_t view, std::uint32_t views,
                     std::uint32_t width, std::uint32_t height)
    : CameraOfOthers(sheet, sheet.name(), width, height), m_sheet(sheet), m_view(view),
      m_views(views), m_offset((view + 0.5) / views - 0.5),
      m_lenses_a_column(sheet.sheet().lenses() / width),
      m_rows_a_row(static_cast<double>(sheet.height()) / height) {}

SizedView::Found SizedView::find(const core::PixelPlace& place) const {
  core::PixelPlace out = m_sheet.place_at((place.column + 0.5 + place.across) * m_lenses_a_column,
                                          (place.row + 0.5 + place.down) * m_rows_a_row, m_offset);
  out.turn += place.turn * m_sheet.sheet().lens().pixels / m_views;
  return {m_sheet, out};
}

bool SizedView::one_ray_at(const core::PixelPlace& place, const core::PlaceRay& which,
                           core::Ray& out) const {
  core::PlaceRay of_sheet = which;
  of_sheet.through.down *= m_rows_a_row;
  return CameraOfOthers::one_ray_at(place, of_sheet, out);
}

Properties SizedView::describe() const {
  Properties out = m_sheet.describe();
  out.emplace_back("lens.view", static_cast<double>(m_view));
  out.emplace_back("lens.view_count", static_cast<double>(m_views));
  out.emplace_back("lens.view_offset_mm", print_offset());
  return out;
}

std::shared_ptr<const Camera> make_view(const Lenticular& sheet, std::uint32_t view,
                                        std::uint32_t views, std::uint32_t width,
                                        std::uint32_t height) {
  if (sheet.sheet().views() == views && sheet.sheet().lenses() == width &&
      sheet.height() == height) {
    return std::make_shared<SheetView>(sheet, view);
  }
  return std::make_shared<SizedView>(sheet, view, views, width, height);
}

Quilt::Quilt(std::vector<std::shared_ptr<const Camera>> tiles, std::uint32_t columns,
             Properties about)
    : CameraOfOthers(*tiles[0], "quilt", columns * tiles[0]->width(),
                     static_cast<std::uint32_t>(tiles.size()) / columns * tiles[0]->height()),
      m_tiles(std::move(tiles)), m_columns(columns),
      m_rows(static_cast<std::uint32_t>(m_tiles.size()) / columns),
      m_tile_width(m_tiles[0]->width()), m_tile_height(m_tiles[0]->height()),
      m_about(std::move(about)) {}

Quilt::Found Quilt::find(const core::PixelPlace& place) const {
  const auto width = static_cast<std::int32_t>(m_tile_width),
             height = static_cast<std::int32_t>(m_tile_height);
  const auto last = static_cast<std::int32_t>(m_columns) - 1;
  // Column -1 - t is the one beyond the left edge of tile t (lattice()).
  const std::int32_t across =
      place.column < 0 ? std::min(-1 - place.column, last) : std::min(place.column / width, last);
  const std::int32_t down =
      std::clamp(place.row < 0 ? 0 : place.row / height, 0, static_cast<std::int32_t>(m_rows) - 1);
  core::PixelPlace out = place;
  out.column = place.column < 0 ? -1 : place.column - across * width;
  out.row = place.row - down * height;
  const auto up = m_rows - 1 - static_cast<std::uint32_t>(down);
  return {*m_tiles[up * m_columns + static_cast<std::uint32_t>(across)], out};
}

core::PixelLattice Quilt::lattice(std::uint32_t width) const {
  core::PixelLattice out;
  out.step = 0;
  for (std::uint32_t k = 0; k < width; ++k) {
    const std::uint32_t tile = k / m_tile_width, inside = k % m_tile_width;
    out.left.push_back(inside > 0 ? static_cast<std::int32_t>(k) - 1
                                  : -1 - static_cast<std::int32_t>(tile));
    if (inside % core::PixelLattice::kTile == 0) out.tiles.push_back(k);
  }
  out.tiles.push_back(width);
  return out;
}

Properties Quilt::describe() const {
  Properties out = m_about;
  out.emplace_back("quilt.columns", static_cast<double>(m_columns));
  out.emplace_back("quilt.rows", static_cast<double>(m_rows));
  return out;
}

LensParameters lens_of_cone(double degrees, std::uint32_t views, double pitch, double distance) {
  const double slope = std::tan(0.5 * degrees * std::numbers::pi / 180.0);
  LensParameters lens;
  lens.model = LensModel::kParaxial;
  lens.ior = 1.0;
  lens.pitch = pitch;
  lens.pixels = views;
  lens.view_distance = distance;
  // The outermost offset is (M - 1)/(2M) P', and P' = P (1 + f/V).
  const double reach = pitch * (views - 1.0) / (2.0 * views * slope);
  lens.focal_length = lens.is_finite() ? reach / (1.0 - reach / distance) : reach;
  return lens;
}

}  // namespace lentray::camera
