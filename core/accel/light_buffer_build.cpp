// How a light buffer is built: casters by distance, grids for each face, and what each object's
// outline leaves in the cells.
#include <algorithm>
#include <cmath>
#include <limits>
#include <typeinfo>

#include "core/accel/light_buffer.h"
#include "core/accel/light_outline.h"
#include "core/geometry/box.h"
#include "core/geometry/plane.h"
#include "core/geometry/polygon.h"
#include "core/geometry/smooth_triangle.h"
#include "core/geometry/sphere.h"
#include "core/geometry/triangle.h"

namespace lentray::core {
namespace {

constexpr std::size_t kMostPerCell = 16;  ///< entries, about: beyond, a hierarchy is faster
constexpr std::uint32_t kMostInCell = 48;  ///< the same of a single one, at most 255
constexpr double kNearLight = 1e-5;  ///< of the light's coordinates: nearer, rounding counts

double distance_of(const Bounds& box) {  // from the origin
  const auto axis = [](double lo, double hi) { return std::max({lo, -hi, 0.0}); };
  const Vec3 d{axis(box.lo.x, box.hi.x), axis(box.lo.y, box.hi.y), axis(box.lo.z, box.hi.z)};
  return length(d);
}

Bounds relative(const Bounds& b, const Vec3& light) { return {b.lo - light, b.hi - light}; }

/// A float below (above) a number that is not negative.
float down(double w) { return static_cast<float>(w * (1.0 - 0x1p-22)); }
float up(double w) { return static_cast<float>(w * (1.0 + 0x1p-22)); }

/// The shape itself where it stands plainly in the world.
const Shape* plain_shape(const Object& object) {
  if (typeid(object) != typeid(Leaf)) return nullptr;
  const auto& leaf = static_cast<const Leaf&>(object);
  return leaf.transform() || !leaf.clips().empty() || !leaf.bounding().empty() ? nullptr : &leaf.shape();
}

/// Ends of the edges of a polygon's contours, relative to the light.
void edge_ends(const std::vector<Vec3>& points, const Vec3& light, std::vector<Vec3>& ends) {
  ends.clear();
  std::size_t start = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    ends.push_back(points[i - 1] - light);
    ends.push_back(points[i] - light);
    if (points[i] == points[start]) start = ++i;
  }
}

void add_face(const std::array<Vec3, 4>& corners, LightOutline& outline,
              std::vector<LightCell>& out) {
  const Vec3 normal = normalized(cross(corners[1] - corners[0], corners[3] - corners[0]));
  std::array<Vec3, 8> ends;
  for (std::size_t i = 0; i < 4; ++i) {
    ends[2 * i] = corners[i];
    ends[2 * i + 1] = corners[(i + 1) % 4];
  }
  outline.flat(ends, normal, dot(normal, corners[0]), out);
}

/// Each side's cells overlap those of its neighbours: one entry a cell, the darkest.
void add_box(const Bounds& box, LightOutline& outline, std::vector<LightCell>& out) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool high : {false, true}) {
      // Only sides that face the light: the others are behind them.
      const double at = high ? box.hi[axis] : box.lo[axis];
      if (high ? at >= 0.0 : at <= 0.0) continue;
      std::array<Vec3, 4> corners;
      for (std::size_t c = 0; c < 4; ++c) {
        corners[c][axis] = at;
        corners[c][u] = (c == 1 || c == 2) ? box.hi[u] : box.lo[u];
        corners[c][v] = c >= 2 ? box.hi[v] : box.lo[v];
      }
      add_face(corners, outline, out);
    }
  }
  std::sort(out.begin(), out.end(),
            [](const LightCell& a, const LightCell& b) { return a.cell < b.cell; });
  std::size_t kept = 0;
  for (const LightCell& next : out) {
    if (kept > 0 && out[kept - 1].cell == next.cell) {
      out[kept - 1].near_w = std::min(out[kept - 1].near_w, next.near_w);
      out[kept - 1].full_w = std::min(out[kept - 1].full_w, next.full_w);
    } else {
      out[kept++] = next;
    }
  }
  out.resize(kept);
}

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

class LightBuffer::Builder {
 public:
  explicit Builder(LightBuffer& buffer) : m_buffer(buffer) {}
  void add(const Object& object, std::size_t place_if_infinite, std::size_t place_if_finite);
  void build(std::uint32_t cells);

 private:
  /// `box` is relative to the light.
  struct Placed {
    Caster caster;
    Bounds box;
    double distance;
  };
  struct Shown {  ///< a caster on a face
    std::uint32_t caster;
    LightWindow window;
  };
  struct Found {  ///< an entry with its cell
    std::uint32_t cell;
    Entry entry;
  };
  struct Dark {  ///< of a cell
    float full_w = std::numeric_limits<float>::infinity();
    std::uint32_t cover = 0;  ///< what blocks all beyond
  };

  static Kind kind_of(const Shape* shape);
  bool is_crowd(std::uint32_t cells) const;
  void add_grids(int face, std::uint32_t cells);
  void fill(Grid& grid);
  void outline(const Shown& shown, LightOutline& outline);
  void keep(Grid& grid);
  void sort_cell(Entry* first, Entry* last) const;

  LightBuffer& m_buffer;
  std::vector<Placed> m_placed;
  // Of the face and the grid that are being filled.
  std::vector<Shown> m_shown;
  std::vector<LightCell> m_touched;
  std::vector<Found> m_found;
  std::vector<Dark> m_dark;
  std::vector<Entry> m_sorted;
  std::vector<std::uint32_t> m_next;
  std::vector<Vec3> m_points;
};

LightBuffer::Kind LightBuffer::Builder::kind_of(const Shape* shape) {
  if (!shape) return Kind::kAny;
  const std::type_info& type = typeid(*shape);
  if (type == typeid(Sphere)) return Kind::kSphere;
  if (type == typeid(Polygon)) return Kind::kPolygon;
  if (type == typeid(Triangle) || type == typeid(SmoothTriangle)) return Kind::kTriangle;
  return type == typeid(Box) ? Kind::kBox : Kind::kAny;
}

/// True if it is certain before anything is drawn: casters so small that they darken no whole cell
/// drop nothing behind them, and there are too many. Looks at some of them.
bool LightBuffer::Builder::is_crowd(std::uint32_t cells) const {
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
    const double width = whole[face].hi[0] - whole[face].lo[0], height = whole[face].hi[1] - whole[face].lo[1];
    const double per_unit = std::sqrt(cells / (width * height));
    double touched = 0.0, largest = 0.0;
    for (const LightWindow& w : looked[face]) {
      const double here = ((w.hi[0] - w.lo[0]) * per_unit + 1.0) * ((w.hi[1] - w.lo[1]) * per_unit + 1.0);
      touched += here;
      largest = std::max(largest, here);
    }
    const double all = touched / static_cast<double>(seen) * static_cast<double>(m_placed.size());
    if (largest < kLargest && all > kSure * kMostPerCell * cells) return true;
  }
  return false;
}

void LightBuffer::Builder::add(const Object& object, std::size_t place_if_infinite,
                               std::size_t place_if_finite) {
  if (object.attributes().no_shadow) return;
  const Bounds bounds = object.bounds();
  if (bounds.is_empty()) return;
  const Bounds box = relative(bounds, m_buffer.m_light);
  const double distance = bounds.is_finite() ? distance_of(box) : 0.0;
  const Shape* shape = plain_shape(object);
  const std::size_t place = bounds.is_finite() ? place_if_finite : place_if_infinite;
  const Caster caster{&object, shape, kind_of(shape), object.is_opaque(),
                      static_cast<std::uint32_t>(place), 0};
  if (shape && typeid(*shape) == typeid(Plane) && object.is_opaque()) {
    const auto& plane = static_cast<const Plane&>(*shape);
    m_buffer.m_planes.push_back({plane.unit_normal(), plane.distance(), &object});
  } else if (!(distance > 2.0 * m_buffer.m_least_distance)) {  // no number is not greater
    (object.is_opaque() ? m_buffer.m_always_opaque : m_buffer.m_always_transparent)
        .push_back(caster);
  } else {
    m_placed.push_back({caster, box, distance});
  }
}

void LightBuffer::Builder::build(std::uint32_t cells) {
  if (is_crowd(cells)) {
    m_buffer.m_crowded = true;
    return;
  }
  std::stable_sort(m_placed.begin(), m_placed.end(),
                   [](const Placed& a, const Placed& b) { return a.distance < b.distance; });
  Bounds all;
  for (const Placed& p : m_placed) {
    all.include(p.box);
    m_buffer.m_casters.push_back(p.caster);
    if (p.caster.kind != Kind::kSphere) continue;
    const auto& sphere = static_cast<const Sphere&>(*p.caster.shape);
    m_buffer.m_casters.back().sphere = static_cast<std::uint32_t>(m_buffer.m_spheres.size());
    m_buffer.m_spheres.push_back({sphere.centre(), sphere.radius2()});
  }
  for (int face = 0; face < LightFace::kFaces && !m_buffer.m_crowded; ++face) {
    if (!all.is_empty() && !window_of(all, face).is_empty()) add_grids(face, cells);
  }
}

void LightBuffer::Builder::add_grids(int face, std::uint32_t cells) {
  m_shown.clear();
  for (std::uint32_t i = 0; i < m_placed.size(); ++i) {
    const LightWindow window = window_of(m_placed[i].box, face);
    if (!window.is_empty()) m_shown.push_back({i, window});
  }
  const std::vector<LightWindow> windows = nested_windows(m_shown);
  std::vector<Grid>& grids = m_buffer.m_faces[static_cast<std::size_t>(face)];
  for (auto window = windows.rbegin(); window != windows.rend() && !m_buffer.m_crowded; ++window) {
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

void LightBuffer::Builder::outline(const Shown& shown, LightOutline& outline) {
  const Placed& placed = m_placed[shown.caster];
  const Vec3& light = m_buffer.m_light;
  const Shape* shape = placed.caster.shape;
  m_points.clear();
  switch (placed.caster.kind) {
    case Kind::kSphere: {
      const auto& sphere = static_cast<const Sphere&>(*shape);
      return outline.sphere(sphere.centre() - light, sphere.radius(), shown.window, m_touched);
    }
    case Kind::kPolygon: {
      const auto& polygon = static_cast<const Polygon&>(*shape);
      edge_ends(polygon.points(), light, m_points);
      const Vec3 normal = polygon.normal({}, {});
      return outline.flat(m_points, normal, dot(normal, m_points[0]), m_touched);
    }
    case Kind::kTriangle: {
      const auto& p = static_cast<const TriangleShape&>(*shape).vertices();
      for (std::size_t i = 0; i < 3; ++i) {
        m_points.push_back(p[i] - light);
        m_points.push_back(p[(i + 1) % 3] - light);
      }
      const Vec3 normal = normalized(cross(p[1] - p[0], p[2] - p[0]));
      return outline.flat(m_points, normal, dot(normal, m_points[0]), m_touched);
    }
    case Kind::kBox: {
      const auto& box = static_cast<const Box&>(*shape);
      const Bounds around = relative({box.lo(), box.hi()}, light);
      if (around.contains({})) return outline.box(around, shown.window, m_touched);
      return add_box(around, outline, m_touched);
    }
    case Kind::kAny: break;
  }
  // Less than its box, where it is a shape that was turned.
  if (typeid(*placed.caster.object) == typeid(Leaf)) {
    const auto& leaf = static_cast<const Leaf&>(*placed.caster.object);
    leaf.shape().hull(m_points);
    for (Vec3& p : m_points) p = (leaf.transform() ? leaf.transform()->point(p) : p) - light;
  } else {
    add_corners(placed.box, m_points);
  }
  outline.hull(m_points, placed.box, shown.window, m_touched);
}

void LightBuffer::Builder::fill(Grid& grid) {
  LightOutline drawn(grid.raster);
  m_found.clear();
  m_dark.assign(grid.cells.size(), {});
  for (const Shown& shown : m_shown) {
    m_touched.clear();
    outline(shown, drawn);
    if (m_found.size() > kMostPerCell * grid.cells.size()) {
      m_buffer.m_crowded = true;
      return;
    }
    const bool opaque = m_placed[shown.caster].caster.opaque;
    for (const LightCell& t : m_touched) {
      Dark& cell = m_dark[t.cell];
      const float near = down(t.near_w);
      if (near > cell.full_w) continue;
      m_found.push_back({t.cell, {near, shown.caster}});
      // A hit within the tolerance of the light would not count.
      if (!opaque || !(t.full_w < Bounds::kInf) || !(t.near_w > 2.0 * m_buffer.m_tolerance)) continue;
      const float full = up(t.full_w + 2.0 * m_buffer.m_tolerance);
      if (full < cell.full_w) cell = {full, shown.caster};
    }
  }
  keep(grid);
}

/// Opaque ones first, near ones first.
void LightBuffer::Builder::sort_cell(Entry* first, Entry* last) const {
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
void LightBuffer::Builder::keep(Grid& grid) {
  const auto hidden = [&](const Found& e) { return e.entry.near_w > m_dark[e.cell].full_w; };
  m_next.assign(grid.cells.size() + 1, 0);
  for (const Found& e : m_found) m_next[e.cell + 1] += !hidden(e);
  for (std::size_t i = 1; i < m_next.size(); ++i) m_next[i] += m_next[i - 1];
  m_sorted.resize(m_next.back());
  for (const Found& e : m_found) {
    if (!hidden(e)) m_sorted[m_next[e.cell]++] = e.entry;
  }
  std::vector<Entry>& entries = m_buffer.m_entries;
  entries.reserve(entries.size() + m_sorted.size() + grid.cells.size() / 4);
  std::uint32_t at = 0;
  for (std::uint32_t c = 0; c < grid.cells.size(); ++c) {
    const std::uint32_t end = m_next[c];
    if (at == end) continue;
    Cell& cell = grid.cells[c];
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

LightBuffer::LightBuffer(const Vec3& light, const std::vector<std::unique_ptr<Object>>& objects,
                         double tolerance, std::uint32_t cells)
    : m_light(light), m_tolerance(tolerance) {
  const double size = std::max({std::fabs(light.x), std::fabs(light.y), std::fabs(light.z), 1.0});
  m_least_distance = kNearLight * size;
  Builder builder(*this);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    builder.add(*objects[i], i, i + objects.size());  // as the hierarchy's
  }
  builder.build(cells);
}

}  // namespace lentray::core
