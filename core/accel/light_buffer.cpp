#include "core/accel/light_buffer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <typeinfo>

#include "core/geometry/box.h"
#include "core/geometry/plane.h"
#include "core/geometry/polygon.h"
#include "core/geometry/sphere.h"
#include "core/geometry/triangle.h"

namespace lentray::core {
namespace {

constexpr std::size_t kMostPerCell = 16;  ///< entries, about: beyond, a hierarchy is faster
constexpr double kCellCost = 6.0;  ///< as Counters::test_cost has it
constexpr double kNearLight = 1e-5;  ///< of the light's coordinates: nearer, rounding counts

double distance_of(const Bounds& box) {  // from the origin
  const auto axis = [](double lo, double hi) { return std::max({lo, -hi, 0.0}); };
  const Vec3 d{axis(box.lo.x, box.hi.x), axis(box.lo.y, box.hi.y), axis(box.lo.z, box.hi.z)};
  return length(d);
}

Bounds relative(const Bounds& b, const Vec3& light) { return {b.lo - light, b.hi - light}; }

float down(double w) {
  return std::nextafter(static_cast<float>(w), -std::numeric_limits<float>::infinity());
}
float up(double w) {
  return std::nextafter(static_cast<float>(w), std::numeric_limits<float>::infinity());
}

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

void add_face(const std::array<Vec3, 4>& corners, const LightRaster& raster,
              std::vector<LightCell>& out) {
  const Vec3 normal = normalized(cross(corners[1] - corners[0], corners[3] - corners[0]));
  std::array<Vec3, 8> ends;
  for (std::size_t i = 0; i < 4; ++i) {
    ends[2 * i] = corners[i];
    ends[2 * i + 1] = corners[(i + 1) % 4];
  }
  raster.flat(ends, normal, dot(normal, corners[0]), out);
}

void add_box(const Bounds& box, const LightRaster& raster, std::vector<LightCell>& out) {
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
      add_face(corners, raster, out);
    }
  }
}

/// The cells of shapes whose own outline is known.
class Outliner {
 public:
  Outliner(const LightRaster& raster, const Vec3& light) : m_raster(raster), m_light(light) {}

  void polygon(const Polygon& shape, std::vector<LightCell>& out) {
    edge_ends(shape.points(), m_light, m_ends);
    const Vec3 normal = shape.normal({}, {});
    m_raster.flat(m_ends, normal, dot(normal, m_ends[0]), out);
  }
  void triangle(const Triangle& shape, std::vector<LightCell>& out) {
    const auto& p = shape.vertices();
    m_ends = {p[0] - m_light, p[1] - m_light, p[1] - m_light,
              p[2] - m_light, p[2] - m_light, p[0] - m_light};
    const Vec3 normal = normalized(cross(p[1] - p[0], p[2] - p[0]));
    m_raster.flat(m_ends, normal, dot(normal, m_ends[0]), out);
  }
  void sphere(const Sphere& shape, std::vector<LightCell>& out) {
    m_raster.sphere(shape.centre() - m_light, shape.radius(), out);
  }
  // Each side's cells overlap those of its neighbours: one entry a cell, the darkest.
  void box(const Box& shape, std::vector<LightCell>& out) {
    const Bounds box = relative({shape.lo(), shape.hi()}, m_light);
    if (box.contains({})) return m_raster.box(box, out);
    add_box(box, m_raster, out);
    std::sort(out.begin(), out.end(), [](const LightCell& a, const LightCell& b) {
      return a.cell < b.cell;
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
      if (kept > 0 && out[kept - 1].cell == out[i].cell) {
        out[kept - 1].near_w = std::min(out[kept - 1].near_w, out[i].near_w);
        out[kept - 1].full_w = std::min(out[kept - 1].full_w, out[i].full_w);
      } else {
        out[kept++] = out[i];
      }
    }
    out.resize(kept);
  }

 private:
  const LightRaster& m_raster;
  const Vec3& m_light;
  std::vector<Vec3> m_ends;
};

void count(Counters& counters, const Object& object) {
  counters.test_cost += object.test_cost();
  ++counters.primitive_tests;
  if (!counters.by_type) return;
  const auto at = counters.tests_by_type.find(object.name());
  if (at != counters.tests_by_type.end()) {
    ++at->second;
  } else {
    counters.tests_by_type.emplace(object.name(), 1);
  }
}

}  // namespace

LightBuffer::Kind LightBuffer::kind_of(const Shape* shape) {
  if (!shape) return Kind::kAny;
  const std::type_info& type = typeid(*shape);
  if (type == typeid(Sphere)) return Kind::kSphere;
  if (type == typeid(Polygon)) return Kind::kPolygon;
  if (type == typeid(Triangle)) return Kind::kTriangle;
  return type == typeid(Box) ? Kind::kBox : Kind::kAny;
}

struct LightBuffer::Found {
  std::uint32_t cell;
  Entry entry;
  bool opaque;
};

/// True if it is certain before anything is drawn: casters so small that they darken no whole cell
/// drop nothing behind them, and there are too many. Looks at some of them.
bool LightBuffer::is_crowd(const std::vector<Placed>& casters, std::uint32_t cells) {
  constexpr std::size_t kLooked = 2048;
  constexpr double kSure = 0.6;     // drawing touches half as many again as their windows
  constexpr double kLargest = 9.0;  // cells: what covers one has at least so many
  if (casters.size() < kLooked) return false;
  const std::size_t step = casters.size() / kLooked;
  std::array<LightWindow, LightFace::kFaces> whole;
  std::array<std::vector<LightWindow>, LightFace::kFaces> looked;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < casters.size(); i += step, ++seen) {
    for (int face = 0; face < LightFace::kFaces; ++face) {
      const LightWindow window = window_of(casters[i].box, face);
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
    const double all = touched / static_cast<double>(seen) * static_cast<double>(casters.size());
    if (largest < kLargest && all > kSure * kMostPerCell * cells) return true;
  }
  return false;
}

LightBuffer::LightBuffer(const Vec3& light, const std::vector<std::unique_ptr<Object>>& objects,
                         double tolerance, std::uint32_t cells)
    : m_light(light), m_tolerance(tolerance) {
  const double size = std::max({std::fabs(light.x), std::fabs(light.y), std::fabs(light.z), 1.0});
  m_least_distance = kNearLight * size;
  std::vector<Placed> casters;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const auto& object = objects[i];
    if (object->attributes().no_shadow) continue;
    const Bounds bounds = object->bounds();
    if (bounds.is_empty()) continue;
    const Bounds box = relative(bounds, light);
    const double distance = bounds.is_finite() ? distance_of(box) : 0.0;
    const Shape* shape = plain_shape(*object);
    const std::size_t place = bounds.is_finite() ? i + objects.size() : i;  // as the hierarchy's
    const Caster caster{object.get(), shape, kind_of(shape), object->is_opaque(),
                        static_cast<std::uint32_t>(place), 0};
    if (shape && typeid(*shape) == typeid(Plane) && object->is_opaque()) {
      const auto& plane = static_cast<const Plane&>(*shape);
      m_planes.push_back({plane.unit_normal(), plane.distance(), object.get()});
    } else if (!(distance > 2.0 * m_least_distance)) {  // no number is not greater
      (object->is_opaque() ? m_always_opaque : m_always_transparent).push_back(caster);
    } else {
      casters.push_back({caster, box, distance});
    }
  }
  if (is_crowd(casters, cells)) {
    m_crowded = true;
    return;
  }
  std::stable_sort(casters.begin(), casters.end(),
                   [](const Placed& a, const Placed& b) { return a.distance < b.distance; });
  for (const Placed& c : casters) {
    m_casters.push_back(c.caster);
    if (c.caster.kind != Kind::kSphere) continue;
    const auto& sphere = static_cast<const Sphere&>(*c.caster.shape);
    m_casters.back().sphere = static_cast<std::uint32_t>(m_spheres.size());
    m_spheres.push_back({sphere.centre(), sphere.radius2()});
  }
  Bounds all;
  for (const Placed& c : casters) all.include(c.box);
  for (int face = 0; face < LightFace::kFaces && !m_crowded; ++face) {
    if (!all.is_empty() && !window_of(all, face).is_empty()) add_grids(face, cells, casters);
  }
}

namespace {

/// The window of all casters, then ever smaller ones of those that are small in the last.
std::vector<LightWindow> nested_windows(const std::vector<LightWindow>& shown) {
  constexpr std::size_t kMostGrids = 3;
  constexpr double kSmall = 1.0 / 8.0, kWorthwhile = 1.0 / 3.0;
  std::vector<LightWindow> windows;
  LightWindow window;
  for (const LightWindow& w : shown) window.include(w);
  while (!window.is_empty() && windows.size() < kMostGrids) {
    windows.push_back(window);
    const double width = window.hi[0] - window.lo[0], height = window.hi[1] - window.lo[1];
    LightWindow inner;
    for (const LightWindow& w : shown) {
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

void LightBuffer::add_grids(int face, std::uint32_t cells, const std::vector<Placed>& casters) {
  std::vector<LightWindow> shown;
  for (const Placed& c : casters) {
    const LightWindow window = window_of(c.box, face);
    if (!window.is_empty()) shown.push_back(window);
  }
  const std::vector<LightWindow> windows = nested_windows(shown);
  std::vector<Grid>& grids = m_faces[static_cast<std::size_t>(face)];
  for (auto window = windows.rbegin(); window != windows.rend() && !m_crowded; ++window) {
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
    fill(grid, face, casters);
  }
}

void LightBuffer::fill(Grid& grid, int face, const std::vector<Placed>& casters) {
  Outliner outliner(grid.raster, m_light);
  std::vector<LightCell> touched;
  std::vector<Found> found;
  for (std::uint32_t i = 0; i < m_casters.size(); ++i) {
    const Caster& caster = m_casters[i];
    if (window_of(casters[i].box, face).is_empty()) continue;
    touched.clear();
    switch (caster.kind) {
      case Kind::kSphere: outliner.sphere(static_cast<const Sphere&>(*caster.shape), touched); break;
      case Kind::kPolygon:
        outliner.polygon(static_cast<const Polygon&>(*caster.shape), touched);
        break;
      case Kind::kTriangle:
        outliner.triangle(static_cast<const Triangle&>(*caster.shape), touched);
        break;
      case Kind::kBox: outliner.box(static_cast<const Box&>(*caster.shape), touched); break;
      case Kind::kAny: grid.raster.box(casters[i].box, touched); break;
    }
    if (found.size() > kMostPerCell * grid.cells.size()) {
      m_crowded = true;
      return;
    }
    for (const LightCell& t : touched) {
      Cell& cell = grid.cells[t.cell];
      if (t.near_w > cell.full_w) continue;
      found.push_back({t.cell, {down(t.near_w), i}, caster.opaque});
      // A hit within the tolerance of the light would not count.
      if (!caster.opaque || !(t.near_w > 2.0 * m_tolerance)) continue;
      const float full = up(t.full_w + 2.0 * m_tolerance);
      if (full < cell.full_w) {
        cell.full_w = full;
        cell.cover = i;
      }
    }
  }
  keep(grid, found);
}

/// Sorts what was found into the cells, without what lies beyond their darkness.
void LightBuffer::keep(Grid& grid, std::vector<Found>& found) {
  const auto dark = [&](const Found& e) { return e.entry.near_w > grid.cells[e.cell].full_w; };
  found.erase(std::remove_if(found.begin(), found.end(), dark), found.end());
  std::vector<std::uint32_t> next(grid.cells.size() + 1, 0);
  for (const Found& e : found) ++next[e.cell + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<Found> sorted(found.size());
  for (const Found& e : found) sorted[next[e.cell]++] = e;
  grid.entries.resize(sorted.size());
  std::uint32_t at = 0;
  for (std::uint32_t c = 0; c < grid.cells.size(); ++c) {
    const std::uint32_t end = next[c];
    std::sort(sorted.begin() + at, sorted.begin() + end, [](const Found& a, const Found& b) {
      if (a.opaque != b.opaque) return a.opaque;
      if (a.entry.near_w != b.entry.near_w) return a.entry.near_w < b.entry.near_w;
      return a.entry.caster < b.entry.caster;
    });
    Cell& cell = grid.cells[c];
    cell.first = at;
    for (; at < end; ++at) {
      std::uint16_t& number = sorted[at].opaque ? cell.opaque : cell.transparent;
      if (number == std::numeric_limits<std::uint16_t>::max()) m_crowded = true;
      ++number;
      grid.entries[at] = sorted[at].entry;
    }
  }
}

template <class Count>
const Object* LightBuffer::plane_blocker(const Ray& ray, double t_min, double t_max,
                                         Count count) const {
  for (const Flat& plane : m_planes) {
    count(plane.object);
    const double t = plane_crossing(plane.normal, plane.distance, ray);
    if (t > t_min && t < t_max) return plane.object;
  }
  return nullptr;
}

/// Not inlined, so that any_opaque() needs no frame where there are planes alone.
template <class Count>
[[gnu::noinline]] const Object* LightBuffer::other_blocker(const Spot& spot, const Ray& ray,
                                                           double t_min, double t_max,
                                                           HitArena& arena, Count count) const {
  if (const Cell* cell = spot.cell) {
    if (spot.w > cell->full_w) return m_casters[cell->cover].object;
    const double inverse_dd = 1.0 / dot(ray.direction, ray.direction);
    const Entry* entry = spot.entries + cell->first;
    for (const Entry* end = entry + cell->opaque; entry < end && entry->near_w < spot.w; ++entry) {
      const Caster& caster = m_casters[entry->caster];
      count(caster.object);
      bool blocked = false;
      ShapeHit hit;
      switch (caster.kind) {
        case Kind::kSphere: {
          const Round& sphere = m_spheres[caster.sphere];
          double t0 = 0.0, t1 = 0.0;
          if (!sphere_roots(ray, inverse_dd, sphere.centre, sphere.radius2, t0, t1)) continue;
          const double t = t0 > t_min ? t0 : t1;
          blocked = t > t_min && t < t_max;
          break;
        }
        case Kind::kPolygon:
          blocked = static_cast<const Polygon*>(caster.shape)->Polygon::nearest(ray, t_min, t_max, hit);
          break;
        case Kind::kTriangle:
          blocked = static_cast<const Triangle*>(caster.shape)->Triangle::nearest(ray, t_min, t_max, hit);
          break;
        case Kind::kBox:
          blocked = static_cast<const Box*>(caster.shape)->Box::nearest(ray, t_min, t_max, hit);
          break;
        case Kind::kAny: blocked = caster.object->any(ray, t_min, t_max, arena); break;
      }
      if (blocked) return caster.object;
    }
  }
  for (const Caster& caster : m_always_opaque) {
    count(caster.object);
    if (caster.object->any(ray, t_min, t_max, arena)) return caster.object;
  }
  return nullptr;
}

const Object* LightBuffer::any_opaque_counted(const Spot& spot, const Ray& ray, double t_min,
                                              double t_max, HitArena& arena,
                                              Counters& counters) const {
  ++counters.bounds_tests;
  counters.test_cost += kCellCost;
  const auto counted = [&counters](const Object* object) { count(counters, *object); };
  const Object* plane = plane_blocker(ray, t_min, t_max, counted);
  return plane ? plane : other_blocker(spot, ray, t_min, t_max, arena, counted);
}

const Object* LightBuffer::any_opaque(const Spot& spot, const Ray& ray, double t_min, double t_max,
                                      HitArena& arena, Counters* counters) const {
  if (counters) return any_opaque_counted(spot, ray, t_min, t_max, arena, *counters);
  const auto uncounted = [](const Object*) {};
  if (const Object* plane = plane_blocker(ray, t_min, t_max, uncounted)) return plane;
  if (!spot.cell && m_always_opaque.empty()) return nullptr;
  return other_blocker(spot, ray, t_min, t_max, arena, uncounted);
}

void LightBuffer::all_transparent(const Spot& spot, const Ray& ray, double t_min, double t_max,
                                  std::vector<Hit>& hits, HitArena& arena,
                                  Counters* counters) const {
  const auto ask = [&](const Caster& caster) {
    if (counters) count(*counters, *caster.object);
    const std::size_t before = hits.size();
    caster.object->all(ray, t_min, t_max, hits, arena);
    for (std::size_t i = before; i < hits.size(); ++i) {
      hits[i].object = caster.object;
      hits[i].place = caster.place;
    }
  };
  for (const Caster& caster : m_always_transparent) ask(caster);
  if (!spot.cell) return;
  const Entry* entry = spot.entries + spot.cell->first + spot.cell->opaque;
  for (const Entry* end = entry + spot.cell->transparent; entry < end && entry->near_w < spot.w;
       ++entry) {
    ask(m_casters[entry->caster]);
  }
}

std::size_t LightBuffer::memory() const {
  std::size_t bytes = sizeof(*this) + m_casters.capacity() * sizeof(Caster) +
                      m_planes.capacity() * sizeof(Flat) +
                      m_spheres.capacity() * sizeof(Round);
  for (const std::vector<Grid>& grids : m_faces) {
    for (const Grid& g : grids) {
      bytes += g.cells.capacity() * sizeof(Cell) + g.entries.capacity() * sizeof(Entry);
    }
  }
  return bytes;
}

LightBuffer::Statistics LightBuffer::statistics() const {
  Statistics s;
  s.always = m_planes.size() + m_always_opaque.size() + m_always_transparent.size();
  for (const std::vector<Grid>& grids : m_faces) {
    for (const Grid& g : grids) {
      s.cells += g.cells.size();
      s.entries += g.entries.size();
      for (const Cell& c : g.cells) s.dark_cells += std::isfinite(c.full_w) ? 1 : 0;
    }
  }
  return s;
}

}  // namespace lentray::core
