// A light buffer is asked for many points at once: directions, planes and cells of four points at a time, the search
// of a cell for each point by itself. Operations and their order are those of the questions one by one.
#include "core/accel/light_caster_test.h"
#include "core/accel/light_points.h"

namespace lentray::core {

/// Four points and one light: begin(), then fetch(), then finish().
class LightLanes {
 public:
  /// Goes as far as to the cells that are to be searched.
  LENTRAY_SIMD32 void begin(const LightBuffer& buffer, const LightPoints& points, int first,
                            double tolerance, LightAnswers& answers) {
    m_buffer = &buffer;
    m_points = &points;
    m_first = first;
    m_tolerance = tolerance;
    m_answers = &answers;
    m_has_others = !buffer.m_always_opaque.empty() || !buffer.m_always_transparent.empty();
    const Double4 px = point(0), py = point(1), pz = point(2);
    const Double4 nx = normal(0), ny = normal(1), nz = normal(2);
    const Double4 x = buffer.m_light.x - px, y = buffer.m_light.y - py, z = buffer.m_light.z - pz;
    const Double4 up = nx * x + ny * y + nz * z;
    const Double4 before = front(0) * x + front(1) * y + front(2) * z;
    const Double4 length2 = x * x + y * y + z * z;
    m_asking = points.who_asks(first);
    m_behind = m_asking & simd::signs(before < Double4{});
    m_asking &= ~m_behind;
    m_to[0] = x;
    m_to[1] = y;
    m_to[2] = z;
    const Double4 slope2 = simd::double4_at(points.slope2() + first);
    m_rising = simd::signs((up > Double4{}) & (up * up > slope2 * length2));
    for (int i = 0; i < LightPoints::kLanes; ++i) {
      set(i, m_behind >> i & 1 ? LightAnswers::kBehind : LightAnswers::kUnknown);
    }
    m_unknown = 15u & ~m_behind;
    if (m_asking != 0) aim(length2);
  }
  /// The entries of the cells come to the processor's cache.
  void fetch() const {
    for (unsigned left = m_asking; left != 0; left &= left - 1) {
      const LightBuffer::Cell* const cell = m_cell[__builtin_ctz(left)];
      if (cell) __builtin_prefetch(m_buffer->m_entries.data() + cell->first);
    }
  }
  /// Answers all four.
  LENTRAY_SIMD32 void finish(HitLists& lists) {
    if (m_asking != 0) search_cells(lists);
    m_answers->unknown |= std::uint64_t{m_unknown} << m_first;
  }

 private:
  LENTRAY_SIMD32 void aim(Double4 length2) {
    const Double4 distance = simd::sqrt(length2), scale = 1.0 / distance;
    const Double4 dx = m_to[0] * scale, dy = m_to[1] * scale, dz = m_to[2] * scale;
    store(0, dx);
    store(1, dy);
    store(2, dz);
    simd::store(m_answers->distance + m_first, distance);
    const Double4 reach = distance - m_tolerance;
    m_asking &= simd::signs((distance > simd::double4(m_buffer->m_least_distance)) &
                            (reach > simd::double4(m_tolerance)));
    const unsigned dark = m_asking & behind_planes(dx, dy, dz, reach);
    for (unsigned left = dark; left != 0; left &= left - 1) {
      set(__builtin_ctz(left), LightAnswers::kForeseen);
    }
    m_asking &= ~dark;
    m_unknown &= ~dark;
    if (m_asking != 0) locate();
  }
  LENTRAY_SIMD32 Double4 point(int axis) const {
    return simd::double4_at(m_points->point(axis) + m_first);
  }
  LENTRAY_SIMD32 Double4 normal(int axis) const {
    return simd::double4_at(m_points->normal(axis) + m_first);
  }
  LENTRAY_SIMD32 Double4 front(int axis) const {
    return simd::double4_at(m_points->front(axis) + m_first);
  }
  LENTRAY_SIMD32 void store(int axis, Double4 v) {
    simd::store(m_answers->direction[axis] + m_first, v);
  }
  std::size_t place(int i) const { return static_cast<std::size_t>(m_first + i); }
  void set(int i, LightAnswers::Answer answer) { m_answers->answer[place(i)] = answer; }

  /// plane_blocker()
  LENTRAY_SIMD32 unsigned behind_planes(Double4 dx, Double4 dy, Double4 dz, Double4 reach) const {
    unsigned dark = 0;
    for (const LightBuffer::Flat& plane : m_buffer->m_planes) {
      const Vec3& n = plane.normal;
      const Double4 height = n.x * point(0) + n.y * point(1) + n.z * point(2);
      const Double4 t = (plane.distance - height) / (n.x * dx + n.y * dy + n.z * dz);
      dark |= simd::signs((t > simd::double4(m_tolerance)) & (t < reach));
    }
    return dark;
  }

  /// LightBuffer::locate() of those who ask.
  LENTRAY_SIMD32 void locate() {
    // From the light to the points.
    const Double4 v[3] = {-m_to[0], -m_to[1], -m_to[2]};
    const Double4 x = simd::abs(v[0]), y = simd::abs(v[1]), z = simd::abs(v[2]);
    const unsigned x_y = simd::signs(x >= y), x_z = simd::signs(x >= z), y_z = simd::signs(y >= z);
    const unsigned along_x = x_y & x_z & m_asking, along_y = ~x_y & y_z & m_asking;
    const int axis = along_x == m_asking ? 0 : along_y == m_asking ? 1 : 2;
    const unsigned negative = simd::signs(v[axis] < Double4{}) & m_asking;
    const bool is_one_face = (along_x | along_y) == (axis == 2 ? 0 : m_asking) &&
                             (negative == 0 || negative == m_asking);
    if (!is_one_face) return locate_one_by_one();
    const int face = 2 * axis + (negative != 0 ? 1 : 0);
    const Double4 w = axis == 0 ? x : axis == 1 ? y : z;
    const Double4 over_w = 1.0 / w;
    const Double4 u = v[LightFace::u_axis(face)] * over_w,
                  along_v = v[LightFace::v_axis(face)] * over_w;
    simd::store(m_w, w);
    for (const LightBuffer::Cell*& cell : m_cell) cell = nullptr;
    unsigned left = m_asking;
    for (const LightBuffer::Grid& grid : m_buffer->m_faces[static_cast<std::size_t>(face)]) {
      const LightRaster& raster = grid.raster;
      const Double4 column = (u - raster.least(0)) * raster.per_cell(0);
      const Double4 row = (along_v - raster.least(1)) * raster.per_cell(1);
      const Double4 zero{};
      unsigned here = left & simd::signs((column >= zero) & (row >= zero) &
                                         (column < simd::double4(raster.size(0))) &
                                         (row < simd::double4(raster.size(1))));
      const Int4 columns = simd::truncated(column), rows = simd::truncated(row);
      left &= ~here;
      for (; here != 0; here &= here - 1) {
        const int i = __builtin_ctz(here);
        m_cell[i] = &grid.cells[static_cast<std::size_t>(rows[i] * raster.size(0) + columns[i])];
        __builtin_prefetch(m_cell[i]);
      }
      if (left == 0) break;
    }
  }
  [[gnu::noinline]] void locate_one_by_one() {
    for (unsigned left = m_asking; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      LightBuffer::Spot spot;
      m_buffer->locate(point_of(i), spot);
      m_cell[i] = spot.cell;
      m_w[i] = spot.w;
    }
  }
  Vec3 point_of(int i) const {
    const int at = m_first + i;
    return {m_points->point(0)[at], m_points->point(1)[at], m_points->point(2)[at]};
  }

  /// Of each point a LightProbe.
  LENTRAY_SIMD32 void search_cells(HitLists& lists) {
    const Double4 w = simd::double4_at(m_w);
    simd::store(m_probe_x, simd::narrowed(-m_to[0]));
    simd::store(m_probe_y, simd::narrowed(-m_to[1]));
    simd::store(m_probe_z, simd::narrowed(-m_to[2]));
    LightProbe::limits(simd::narrowed(w), m_tolerance,
                       simd::signs(w < simd::double4(m_buffer->m_reach)), m_least, m_share);
    for (unsigned left = m_asking; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      const LightBuffer::Cell* const cell = m_cell[i];
      if (cell && cell->crowded) continue;
      m_unknown &= ~(1u << i);
      if (!cell && !m_has_others) {
        set(i, LightAnswers::kClear);
      } else if (!cell) {
        search_others(i, lists);
      } else if (cell->covered && m_buffer->m_entries[cell->first].near_w < m_w[i]) {
        set(i, LightAnswers::kForeseen);
      } else {
        search_cell(*cell, i, lists);
      }
    }
  }
  LENTRAY_SIMD32 LightProbe probe(int i) const {
    return LightProbe(m_probe_x + i, m_probe_y + i, m_probe_z + i, m_least + i, m_share[i]);
  }
  /// Not inlined, for the sake of its registers.
  [[gnu::noinline]] LENTRAY_AVX2 void search_cell(const LightBuffer::Cell& cell, int i,
                                                  HitLists& lists) {
    const double w = m_w[i];
    const LightBuffer::Entry* entry =
        m_buffer->m_entries.data() + cell.first + (cell.covered ? 1 : 0);
    const LightBuffer::Entry* end = entry + cell.opaque;
    const LightProbe point = probe(i);
    bool foreseen = true;
    for (; entry < end && entry->near_w < w; ++entry) {
      if (point.is_outside(m_buffer->m_volumes[entry->caster])) continue;
      const LightBuffer::Probe answer = exactly(entry->caster, i, lists);
      if (answer == LightBuffer::Probe::kBlocks) {
        return set(i, foreseen ? LightAnswers::kForeseen : LightAnswers::kBlocked);
      }
      if (answer == LightBuffer::Probe::kMisses) foreseen = false;
    }
    if (m_has_others) return search_others(i, lists);
    entry = end;
    end = entry + cell.transparent;
    for (; entry < end && entry->near_w < w; ++entry) {
      if (point.is_outside(m_buffer->m_volumes[entry->caster])) continue;
      if (m_buffer->m_casters[entry->caster].object != unmet(i)) return set_filtered(i);
    }
    set(i, LightAnswers::kClear);
  }
  const Object* unmet(int i) const {
    return m_rising >> i & 1 ? m_points->unmet(m_first + i) : nullptr;
  }
  LightBuffer::Spot spot(int i) const { return {m_cell[i], m_w[i], true, unmet(i)}; }
  Ray ray(int i) const { return {point_of(i), m_answers->direction_at(place(i))}; }
  double reach(int i) const { return m_answers->distance[place(i)] - m_tolerance; }
  [[gnu::noinline]] void set_filtered(int i) {
    set(i, LightAnswers::kFiltered);
    m_answers->filtered |= std::uint64_t{1} << place(i);
    m_answers->spot[place(i)] = spot(i);
  }
  /// Of an opaque caster whose volume holds the point. One that is not met misses.
  [[gnu::noinline]] LightBuffer::Probe exactly(std::uint32_t number, int i, HitLists& lists) const {
    const LightBuffer::Caster& caster = m_buffer->m_casters[number];
    if (caster.object == unmet(i)) return LightBuffer::Probe::kMisses;
    return m_buffer->probe(caster, ray(i), m_tolerance, reach(i), lists, NoTally());
  }
  /// What no cell holds.
  [[gnu::noinline]] void search_others(int i, HitLists& lists) {
    for (const LightBuffer::Caster& caster : m_buffer->m_always_opaque) {
      if (caster.object->any(ray(i), m_tolerance, reach(i), {lists, RayKind::kShadow})) {
        return set(i, LightAnswers::kBlocked);
      }
    }
    if (m_buffer->may_filter(spot(i))) return set_filtered(i);
    set(i, LightAnswers::kClear);
  }

  const LightBuffer* m_buffer;
  const LightPoints* m_points;
  int m_first;
  double m_tolerance;
  LightAnswers* m_answers;
  unsigned m_asking, m_behind, m_rising, m_unknown;
  // In the light's buffer.
  const LightBuffer::Cell* m_cell[LightPoints::kLanes];
  alignas(32) double m_w[LightPoints::kLanes];
  // LightProbes.
  alignas(16) float m_probe_x[LightPoints::kLanes], m_probe_y[LightPoints::kLanes];
  alignas(16) float m_probe_z[LightPoints::kLanes], m_least[LightPoints::kLanes];
  alignas(16) float m_share[LightPoints::kLanes];
  bool m_has_others;  ///< infinite casters
  Double4 m_to[3];
};

LENTRAY_AVX2 void LightBuffer::ask_together(const LightPoints& points, double tolerance,
                                            HitLists& lists, LightAnswers& answers) const {
  answers.unknown = answers.filtered = 0;
  // Stage by stage: the memory's latency is hidden behind the other points.
  LightLanes all[LightPoints::kMost / LightPoints::kLanes];
  LightLanes* end = all;
  for (int first = 0; first < points.count(); first += LightPoints::kLanes) {
    end++->begin(*this, points, first, tolerance, answers);
  }
  for (const LightLanes* lanes = all; lanes != end; ++lanes) lanes->fetch();
  for (LightLanes* lanes = all; lanes != end; ++lanes) lanes->finish(lists);
}

}  // namespace lentray::core
