// The light buffer of one point light (Haines & Greenberg 1986): directions from the light in
// cells, and for each cell the objects that may darken something there, near ones first. Beyond
// what wholly covers a cell nothing is kept: all is dark there, whatever else stands in it.
// Only where to look is taken from it; what blocks a ray is decided by the objects' own tests, or
// is certain by a margin far above rounding, so that answers are those of the hierarchy.
// World space. Immutable once built; any number of threads.
// Held to the hierarchy's answers by tests/unit/accel_light_buffer_test.cpp.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "core/accel/light_raster.h"
#include "core/base/counters.h"
#include "core/geometry/object.h"

namespace lentray::core {

class LightBuffer {
 public:
  /// Borrows the objects, whose opacity and no_shadow are taken now. `tolerance`: hits nearer to
  /// an end of a shadow ray than this do not count (kShadowTolerance). `cells`: at most about so
  /// many in all.
  LightBuffer(const Vec3& light, const std::vector<std::unique_ptr<Object>>& objects,
              double tolerance, std::uint32_t cells);

  /// True if so much stands behind one another that the hierarchy is the better choice.
  bool crowded() const { return m_crowded; }
  /// True where the buffer may answer for a point: not too near to the light for its rounding.
  bool serves(double distance) const { return distance > m_least_distance; }

  struct Cell;   ///< of a face
  struct Entry;  ///< an object that may darken something in a cell
  /// Where a point lies in the buffer. Asking for it ahead hides the memory's latency.
  struct Spot {
    const Cell* cell = nullptr;     ///< null: nothing finite can darken the point
    const Entry* entries = nullptr;
    double w = 0.0;
    bool known = false;  ///< it was asked for
  };
  /// Written in place: who copied it at once would wait for it.
  void locate(const Vec3& point, Spot& spot) const;

  /// As Hierarchy::any_opaque, for a ray from the point of `spot` to the light: t_min is the
  /// tolerance, t_max the way to the light less the tolerance.
  const Object* any_opaque(const Spot& spot, const Ray& to_light, double t_min, double t_max,
                           HitArena& arena, Counters* counters) const;
  /// As Hierarchy::all_transparent.
  void all_transparent(const Spot& spot, const Ray& to_light, double t_min, double t_max,
                       std::vector<Hit>& hits, HitArena& arena, Counters* counters) const;

  std::size_t memory() const;
  struct Statistics { std::size_t cells = 0, entries = 0, dark_cells = 0, always = 0; };
  Statistics statistics() const;

 private:
  struct Grid {
    LightRaster raster;
    std::vector<Cell> cells;
    std::vector<Entry> entries;
  };
  enum class Kind : std::uint8_t { kAny, kSphere, kPolygon, kTriangle, kBox };
  struct Caster {
    const Object* object;
    const Shape* shape;    ///< asked without a detour where the kind is known
    Kind kind;
    bool opaque;
    std::uint32_t place;   ///< as Hit::place
    std::uint32_t sphere;  ///< place in m_spheres
  };
  struct Round {
    Vec3 centre;
    double radius2;
  };
  struct Flat {  ///< an opaque plane
    Vec3 normal;
    double distance;
    const Object* object;
  };
  /// A caster while the buffer is built; `box` is relative to the light.
  struct Placed {
    Caster caster;
    Bounds box;
    double distance;
  };
  struct Found;  ///< an entry with its cell, while a face is filled

  template <class Count>
  const Object* plane_blocker(const Ray& to_light, double t_min, double t_max, Count count) const;
  template <class Count>
  const Object* other_blocker(const Spot& spot, const Ray& to_light, double t_min, double t_max,
                              HitArena& arena, Count count) const;
  const Object* any_opaque_counted(const Spot& spot, const Ray& to_light, double t_min,
                                   double t_max, HitArena& arena, Counters& counters) const;
  static Kind kind_of(const Shape* shape);
  static bool is_crowd(const std::vector<Placed>& casters, std::uint32_t cells);
  void add_grids(int face, std::uint32_t cells, const std::vector<Placed>& casters);
  void fill(Grid& grid, int face, const std::vector<Placed>& casters);
  void keep(Grid& grid, std::vector<Found>& found);

  Vec3 m_light;
  bool m_crowded = false;
  double m_tolerance, m_least_distance;
  std::vector<Caster> m_casters;        ///< by distance
  std::vector<Round> m_spheres;
  std::vector<Flat> m_planes;
  std::vector<Caster> m_always_opaque, m_always_transparent;  ///< other infinite ones, near ones
  /// Of each face the grids, one within the other, the finest first: where few large objects
  /// stand about many small ones, these get cells of their own size.
  std::array<std::vector<Grid>, LightFace::kFaces> m_faces;
};

struct LightBuffer::Entry {
  float near_w;  ///< what lies nearer to the light, along the face's axis, is not reached by it
  std::uint32_t caster;
};

struct alignas(16) LightBuffer::Cell {
  std::uint32_t first = 0;  ///< entry; opaque casters, then the others
  std::uint16_t opaque = 0, transparent = 0;
  float full_w = std::numeric_limits<float>::infinity();
  std::uint32_t cover = 0;  ///< what blocks all beyond full_w
};

inline void LightBuffer::locate(const Vec3& point, Spot& spot) const {
  const Vec3 v = point - m_light;
  const int side = LightFace::of(v);
  spot.known = true;
  spot.w = std::fabs(v[side / 2]);
  spot.cell = nullptr;
  for (const Grid& grid : m_faces[static_cast<std::size_t>(side)]) {
    const std::int64_t index = grid.raster.cell_of(v, spot.w);
    if (index < 0) continue;
    spot.cell = &grid.cells[static_cast<std::size_t>(index)];
    spot.entries = grid.entries.data();
    __builtin_prefetch(spot.cell);
    break;
  }
}

}  // namespace lentray::core
