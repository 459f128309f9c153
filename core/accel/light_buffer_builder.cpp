// How a light buffer is built: casters by distance, grids for each face, and what each object's
// outline leaves in the cells.
#include "core/accel/light_buffer_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/accel/light_outline.h"
#include "core/shape/plane.h"
#include "core/shape/sphere.h"

namespace lentray::core {
namespace {

constexpr std::size_t kMostPerCell = 16;   ///< entries, about: beyond, a hierarchy is faster
constexpr std::uint32_t kMostInCell = 48;  ///< the same of a single one, at most 255

double distance_of(const Bounds& box) {  // from the origin
  const auto axis = [](double lo, double hi) { return std::max({lo, -hi, 0.0}); };
  const Vec3 d{axis(box.lo.x, box.hi.x), axis(box.lo.y, box.hi.y), axis(box.lo.z, box.hi.z)};
  return length(d);
}

double farthest_of(const Bounds& box) {
  const auto axis = [](double lo, double hi) { return std::max(-lo, hi); };
  return length(Vec3{axis(box.lo.x, box.hi.x), axis(box.lo.y, box.hi.y), axis(box.lo.z, box.hi.z)});
}

/// A float below (above) a number that is not negative.
float down(double w) { return static_cast<float>(w * (1.0 - 0x1p-22)); }
float up(double w) { return static_cast<float>(w * (1.0 + 0x1p-22)); }

/// The window of all casters, then ever smaller ones of those that are small in the last.
template <class Shown>
std::vector<LightWindow> nested_windows(const std::vector<Shown>& shown) {
  constexpr std::size_t kMostGrids = 3;
  constexpr double kSmall = 1.0 / 8.0, kWorthwhile = 1.0 / 3.0;
  std::vector<LightWindow> windows;
  LightWindow window;
  for (const Shown& s : shown) window.include(s.window);
  while (!window.is_empty() && windows.size() < kMostGrids) {
    windows.push_back(window);
    const double width = window.hi[0] - window.lo[0], height = window.hi[1] - window.lo[1];
    LightWindow inner;
    for (const Shown& s : shown) {
      const LightWindow& w = s.window;
      if (w.hi[0] - w.lo[0] > kSmall * width || w.hi[1] - w.lo[1] > kSmall * height) continue;
      inner.include(w);
    }
    const double inner_area = (inner.hi[0] - inner.lo[0]) * (inner.hi[1] - inner.lo[1]);
    if (inner.is_empty() || !(inner_area < kWorthwhile * width * height)) break;
    window = inner;
  }
  return windows;
}

}  // namespace

/// True if it is certain before anything is drawn: casters so small that they darken no whole cell
/// drop nothing behind them, and there are too many. Looks at some of them.
bool LightBufferBuilder::is_crowd(std::uint32_t cells) const {
  constexpr std::size_t kLooked = 2048;
  constexpr double kSure = 0.6;     // drawing touches half as many again as their windows
  constexpr double kLargest = 9.0;  // cells: what covers one has at least so many
  if (m_placed.size() < kLooked) return false;
  const std::size_t step = m_placed.size() / kLooked;
  std::array<LightWindow, LightFace::kFaces> whole;
  std::array<std::vector<LightWindow>, LightFace::kFaces> looked;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < m_placed.size(); i += step, ++seen) {
    for (int face = 0; face < LightFace::kFaces; ++face) {
      const LightWindow window = window_of(m_placed[i].box, face);
      if (window.is_empty()) continue;
      whole[static_cast<std::size_t>(face)].include(window);
      looked[static_cast<std::size_t>(face)].push_back(window);
    }
  }
  for (std::size_t face = 0; face < looked.size(); ++face) {
    if (looked[face].empty()) continue;
    const double width = whole[face].hi[0] - whole[face].lo[0],
                 height = whole[face].hi[1] - whole[face].lo[1];
    const double per_unit = std::sqrt(cells / (width * height));
    double touched = 0.0, largest = 0.0;
    for (const LightWindow& w : looked[face]) {
      const double here =
          ((w.hi[0] - w.lo[0]) * per_unit + 1.0) * ((w.hi[1] - w.lo[1]) * per_unit + 1.0);
      touched += here;
      largest = std::max(largest, here);
    }
    const double all = touched / static_cast<double>(seen) * static_cast<double>(m_placed.size());
    if (largest < kLargest && all > kSure * kMostPerCell * cells) return true;
  }
  return false;
}

void LightBufferBuilder::place(const LightCaster& from) {
  const Bounds box = relative(from.bounds, m_buffer->m_light);
  const double distance = from.bounds.is_finite() ? distance_of(box) : 0.0;
  const LightBuffer::Caster caster{from.object, from.shape, from.kind, from.opaque, from.place, 0};
  if (from.plane) {
    m_buffer->m_planes.push_back({from.plane->unit_normal(), from.plane->distance(), from.object});
  } else if (!(distance > 2.0 * m_buffer->m_least_distance)) {  // no number is not greater
    (from.opaque ? m_buffer->m_always_opaque : m_buffer->m_always_transparent).push_back(caster);
  } else {
    m_placed.push_back({caster, box, distance});
  }
}

void LightBufferBuilder::build(LightBuffer& buffer, std::uint32_t cells) {
  m_buffer = &buffer;
  m_drawing = LightDrawing(buffer.m_light);
  m_placed.clear();
  for (const LightCaster& caster : m_all) place(caster);
  if (is_crowd(cells)) {
    m_buffer->m_crowded = true;
    return;
  }
  std::stable_sort(m_placed.begin(), m_placed.end(),
                   [](const Placed& a, const Placed& b) { return a.distance < b.distance; });
  Bounds all;
  m_buffer->m_casters.reserve(m_placed.size());
  for (const Placed& p : m_placed) {
    all.include(p.box);
    m_buffer->m_casters.push_back(p.caster);
    if (p.caster.kind != CasterKind::kSphere) continue;
    const auto& sphere = static_cast<const Sphere&>(*p.caster.shape);
    m_buffer->m_casters.back().sphere = static_cast<std::uint32_t>(m_buffer->m_spheres.size());
    m_buffer->m_spheres.push_back({sphere.centre(), sphere.radius2()});
  }
  m_entries.clear();
  m_drawn.assign(m_placed.size(), 0);
  m_buffer->m_volumes.resize(m_placed.size());
  m_buffer->m_reach = all.is_empty() ? 0.0 : 2.0 * farthest_of(all);
  for (int face = 0; face < LightFace::kFaces && !m_buffer->m_crowded; ++face) {
    if (!all.is_empty() && !window_of(all, face).is_empty()) add_grids(face, cells);
  }
  m_buffer->m_entries.assign(m_entries.begin(), m_entries.end());
}

void LightBufferBuilder::add_grids(int face, std::uint32_t cells) {
  m_shown.clear();
  for (std::uint32_t i = 0; i < m_placed.size(); ++i) {
    const LightWindow window = window_of(m_placed[i].box, face);
    if (!window.is_empty()) m_shown.push_back({i, window});
  }
  const std::vector<LightWindow> windows = nested_windows(m_shown);
  std::vector<Grid>& grids = m_buffer->m_faces[static_cast<std::size_t>(face)];
  grids.reserve(windows.size());
  for (auto window = windows.rbegin(); window != windows.rend() && !m_buffer->m_crowded; ++window) {
    // Cells about square; the outer grids hold little.
    constexpr double kOuter = 0.25;
    const double width = std::max(window->hi[0] - window->lo[0], 1e-6);
    const double height = std::max(window->hi[1] - window->lo[1], 1e-6);
    const double side = std::sqrt(grids.empty() ? cells : kOuter * cells);
    const auto along = [&](double own, double other) {
      return static_cast<int>(std::clamp(side * std::sqrt(own / other), 1.0, 4096.0));
    };
    Grid& grid = grids.emplace_back();
    grid.raster = LightRaster(face, *window, along(width, height), along(height, width));
    grid.cells.resize(grid.raster.cells());
    fill(grid);
  }
}

void LightBufferBuilder::fill(Grid& grid) {
  LightOutline drawn(grid.raster);
  const LightVolumes volumes(m_buffer->m_reach);
  m_found.clear();
  m_found.reserve(kMostPerCell * grid.cells.size());  // what is not touched costs nothing
  m_dark.assign(grid.cells.size(), {});
  for (const Shown& shown : m_shown) {
    m_touched.clear();
    const LightDrawing::Subject subject = subject_of(m_placed[shown.caster]);
    m_drawing.outline(subject, shown.window, drawn, m_touched);
    if (m_touched.empty()) continue;
    if (!std::exchange(m_drawn[shown.caster], 1)) {
      m_buffer->m_volumes[shown.caster] = m_drawing.volume(subject, volumes);
    }
    if (m_found.size() > kMostPerCell * grid.cells.size()) {
      m_buffer->m_crowded = true;
      return;
    }
    const bool opaque = m_placed[shown.caster].caster.opaque;
    for (const LightCell& t : m_touched) {
      Dark& cell = m_dark[t.cell];
      const float near = down(t.near_w);
      if (near > cell.full_w) continue;
      m_found.push_back({t.cell, {near, shown.caster}});
      // A hit within the tolerance of the light would not count.
      if (!opaque || !(t.full_w < Bounds::kInf) || !(t.near_w > 2.0 * m_tolerance)) continue;
      const float full = up(t.full_w + 2.0 * m_tolerance);
      if (full < cell.full_w) cell = {full, shown.caster};
    }
  }
  keep(grid);
}

/// Opaque ones first, near ones first.
void LightBufferBuilder::sort_cell(Entry* first, Entry* last) const {
  const auto before = [&](const Entry& a, const Entry& b) {
    const bool opaque = m_placed[a.caster].caster.opaque;
    if (opaque != m_placed[b.caster].caster.opaque) return opaque;
    return a.near_w != b.near_w ? a.near_w < b.near_w : a.caster < b.caster;
  };
  // They come by distance, so that few are out of place.
  for (Entry* i = first; i < last; ++i) {
    const Entry entry = *i;
    Entry* at = i;
    for (; at > first && before(entry, at[-1]); --at) *at = at[-1];
    *at = entry;
  }
}

/// Sorts what was found into the cells, without what lies beyond their darkness.
void LightBufferBuilder::keep(Grid& grid) {
  const auto hidden = [&](const Found& e) { return e.entry.near_w > m_dark[e.cell].full_w; };
  m_next.assign(grid.cells.size() + 1, 0);
  for (const Found& e : m_found) m_next[e.cell + 1] += !hidden(e);
  for (std::size_t i = 1; i < m_next.size(); ++i) m_next[i] += m_next[i - 1];
  m_sorted.resize(m_next.back());
  for (const Found& e : m_found) {
    if (!hidden(e)) m_sorted[m_next[e.cell]++] = e.entry;
  }
  std::vector<Entry>& entries = m_entries;
  std::uint32_t at = 0;
  for (std::uint32_t c = 0; c < grid.cells.size(); ++c) {
    const std::uint32_t end = m_next[c];
    if (at == end) continue;
    LightBuffer::Cell& cell = grid.cells[c];
    cell.crowded = end - at > kMostInCell;
    if (cell.crowded) {
      at = end;
      continue;
    }
    sort_cell(m_sorted.data() + at, m_sorted.data() + end);
    cell.first = static_cast<std::uint32_t>(entries.size());
    cell.covered = !std::isinf(m_dark[c].full_w);
    if (cell.covered) entries.push_back({m_dark[c].full_w, m_dark[c].cover});
    for (; at < end; ++at) {
      const Entry& entry = m_sorted[at];
      ++(m_placed[entry.caster].caster.opaque ? cell.opaque : cell.transparent);
      entries.push_back(entry);
    }
  }
}

}  // namespace lentray::core
