// The light buffer of one point light (Haines & Greenberg 1986): directions from the light in
// cells, and for each cell the objects that may darken something there, near ones first. Beyond
// an object that covers a whole cell nothing is stored: all is dark there.
// Only where to look is taken from it; what blocks a ray is decided by the objects' own tests, or
// is certain by a margin far above rounding, so that answers are those of the hierarchy.
// World space. Immutable once built; any number of threads.
// Test: tests/unit/accel/accel_light_buffer_test.cpp.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/accel/light_casters.h"
#include "core/accel/light_drawing.h"
#include "core/accel/light_raster.h"
#include "core/accel/light_volume.h"
#include "core/base/counters.h"
#include "core/object/object.h"

namespace lentray::core {

class LightPoints;
struct LightAnswers;

class LightBuffer {
 public:
  /// Borrows the objects of the casters. `tolerance`: hits nearer to an end of a shadow ray than this
  /// do not count (kShadowTolerance). `cells`: at most about so many in all.
  LightBuffer(const Vec3& light, const LightCasters& casters, double tolerance,
              std::uint32_t cells);
  /// To be built: nothing else may be asked for before.
  explicit LightBuffer(const Vec3& light);

  /// True if so many objects lie behind one another that the hierarchy is faster.
  bool crowded() const { return m_crowded; }
  struct Cell;   ///< of a face
  struct Entry;  ///< an object that may darken something in a cell
  /// Where a point lies in the buffer. Asking for it ahead hides the memory's latency.
  struct Spot {
    const Cell* cell = nullptr;  ///< null: nothing finite can darken the point
    double w = 0.0;
    bool known = false;  ///< it was asked for
    /// A convex object that no ray from there to the light hits, since the point is on its lit side; or null.
    const Object* unmet = nullptr;
  };
  /// Fills `spot`, but for `unmet`. It is filled in place, since a copy right after the stores would stall.
  void locate(const Vec3& point, Spot& spot) const;
  /// True where the buffer may answer for a point at that distance from the light: not too near for its
  /// rounding, nor where so many objects lie behind one another that the hierarchy is faster.
  bool serves(const Spot& spot, double distance) const;

  struct Answer {
    const Object* blocker = nullptr;
    /// The blocker is the first object of the cell whose shadow volume (for spheres: cone) contains the point, or a
    /// plane, or what covers the whole cell.
    bool foreseen = false;
  };
  /// As Hierarchy::any_opaque, for a ray from the point of `spot` to the light: t_min is the
  /// tolerance, t_max the way to the light less the tolerance.
  Answer any_opaque(const Spot& spot, const Ray& to_light, double t_min, double t_max,
                    HitLists& lists, Counters* counters) const;
  /// The same of many points whose rays go to the light's position, and that nothing filters it: four at a time,
  /// with the bits of any_opaque() and may_filter(). `tolerance`: of shadows. Needs AVX2
  /// (core/base/processor.h).
  void ask_together(const LightPoints& points, double tolerance, HitLists& lists,
                    LightAnswers& answers) const;
  /// False: nothing there filters the light.
  bool may_filter(const Spot& spot) const;
  /// As Hierarchy::all_transparent. The ray may begin nearer to the light than the point of `spot`.
  void all_transparent(const Spot& spot, const Ray& to_light, double t_min, double t_max,
                       bool nearest, std::vector<Hit>& hits, HitLists& lists,
                       Counters* counters) const;

  std::size_t memory() const;
  struct Statistics {
    std::size_t cells = 0, entries = 0, dark_cells = 0, always = 0;
  };
  Statistics statistics() const;

 private:
  struct Grid {
    LightRaster raster;
    std::vector<Cell> cells;
  };
  struct Caster {
    const Object* object;
    const Shape* shape;  ///< asked without a detour where the kind is known
    CasterKind kind;
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
  friend class LightBufferBuilder;
  friend class LightLanes;
  /// Outside: the ray's line does not come near, as with a volume.
  enum class Probe : std::uint8_t { kOutside, kMisses, kBlocks };

  template <class Count>
  const Object* plane_blocker(const Ray& to_light, double t_min, double t_max, Count count) const;
  template <class Count>
  Answer other_blocker(const Spot& spot, const Ray& to_light, double t_min, double t_max,
                       HitLists& lists, Count count) const;
  template <class Count>
  Probe probe(const Caster& caster, const Ray& to_light, double t_min, double t_max,
              HitLists& lists, Count count) const;
  Answer any_opaque_counted(const Spot& spot, const Ray& to_light, double t_min, double t_max,
                            HitLists& lists, Counters& counters) const;
  static void add_all(const Caster& caster, const Ray& to_light, double t_min, double t_max,
                      bool nearest, std::vector<Hit>& hits, HitLists& lists);
  const Entry* first_transparent(const Cell& cell) const;

  Vec3 m_light;
  bool m_crowded = false;
  double m_least_distance;
  std::vector<Caster> m_casters;       ///< by distance
  std::vector<LightVolume> m_volumes;  ///< of the casters
  double m_reach = 0.0;                ///< of the volumes
  std::vector<Round> m_spheres;
  std::vector<Flat> m_planes;
  std::vector<Caster> m_always_opaque, m_always_transparent;  ///< other infinite ones, near ones
  std::vector<Entry> m_entries;                               ///< of all cells
  /// Of each face the grids, one within the other, the finest first: where few large objects
  /// stand about many small ones, these get cells of their own size.
  std::array<std::vector<Grid>, LightFace::kFaces> m_faces;
};

struct LightBuffer::Entry {
  float near_w;  ///< what lies nearer to the light, along the face's axis, is not reached by it
  std::uint32_t caster;
};

struct alignas(8) LightBuffer::Cell {
  std::uint32_t first = 0;  ///< entry: what covers it, if anything; opaque casters; the others
  std::uint8_t opaque = 0, transparent = 0;
  bool covered = false;  ///< the first entry blocks all beyond its near_w
  bool crowded = false;  ///< nothing is kept here: the hierarchy is the better choice
};

inline bool LightBuffer::serves(const Spot& spot, double distance) const {
  return distance > m_least_distance && !(spot.cell && spot.cell->crowded);
}

inline const LightBuffer::Entry* LightBuffer::first_transparent(const Cell& cell) const {
  return m_entries.data() + cell.first + (cell.covered ? 1 : 0) + cell.opaque;
}

inline bool LightBuffer::may_filter(const Spot& spot) const {
  if (!m_always_transparent.empty()) return true;
  return spot.cell && spot.cell->transparent != 0 && first_transparent(*spot.cell)->near_w < spot.w;
}

inline void LightBuffer::locate(const Vec3& point, Spot& spot) const {
  const Vec3 v = point - m_light;
  const int side = LightFace::of(v);
  spot.known = true;
  spot.w = std::fabs(v[side / 2]);
  spot.cell = nullptr;
  for (const Grid& grid : m_faces[static_cast<std::size_t>(side)]) {
    const std::int64_t cell = grid.raster.cell_of(v, spot.w);
    if (cell < 0) continue;
    spot.cell = &grid.cells[static_cast<std::size_t>(cell)];
    __builtin_prefetch(spot.cell);
    break;
  }
}

}  // namespace lentray::core
