#include "core/shape/height_field.h"

#include <algorithm>
#include <cmath>

#include "core/base/pair_math.h"
#include "core/numeric/bounds_help.h"

namespace lentray::core {
namespace {

constexpr double kFullHeight = 65536.0;
constexpr double kMargin = 0.001;      ///< of the box above and below the heights
constexpr double kHeightSlack = 1e-6;  ///< as wide as the heights' own rounding
constexpr double kEdge = 1e-4;         ///< how far triangles reach beyond their edges, in cells

/// The part of the ray within the box.
bool clip(const Bounds& box, const Ray& ray, double& lo, double& hi) {
  for (int axis = 0; axis < 3; ++axis) {
    const double p = ray.origin[axis], d = ray.direction[axis];
    if (d == 0.0) {
      if (p < box.lo[axis] || p > box.hi[axis]) return false;
      continue;
    }
    const double a = (box.lo[axis] - p) / d, b = (box.hi[axis] - p) / d;
    lo = std::max(lo, std::min(a, b));
    hi = std::min(hi, std::max(a, b));
  }
  return lo <= hi;
}

/// Steps along one axis, from block to block and, within one, from cell to cell.
struct Stepper {
  int cell = 0, step = 0;
  double next = Bounds::kInf,
         delta = Bounds::kInf;  ///< t of the next cell's border, t from one to the next
  int block = 0;                ///< its first cell
  double end = Bounds::kInf;    ///< t where the block ends

  /// Numbers below 0 are clamped all the same: there is no need to round them down.
  Stepper(double p, double d, double from, int cells) : m_p(p), m_d(d), m_cells(cells) {
    const int first = std::clamp(static_cast<int>(p + d * from), 0, cells - 1);
    m_inverse = 1.0 / d;
    delta = std::fabs(m_inverse);
    if (delta < Bounds::kInf) step = d > 0.0 ? 1 : -1;
    set(first);
    take_block();
  }
  double t_of(int border) const { return (border - m_p) * m_inverse; }
  /// How many cells there are in the block.
  int block_cells() const { return std::min(HeightGrid::kBlock, m_cells - block); }
  /// To the block that the cell is in, or out of the grid.
  void take_block() { set_block(cell < m_cells ? cell & ~(HeightGrid::kBlock - 1) : m_cells); }
  /// To the next block; the cell stays behind.
  void leave_block() { set_block(block + step * HeightGrid::kBlock); }
  /// To the cell where a ray comes into the block, or to that at t.
  void go_to_border() { set(step > 0 ? block : block + HeightGrid::kBlock - 1); }
  void go_within_block(double t) {
    set(std::clamp(static_cast<int>(m_p + m_d * t), block, block + HeightGrid::kBlock - 1));
  }
  bool is_within() const { return static_cast<unsigned>(block) < static_cast<unsigned>(m_cells); }
  void advance() {
    cell += step;
    next += delta;
  }

 private:
  void set(int to) {
    cell = to;
    if (step != 0) next = t_of(cell + (step > 0 ? 1 : 0));
  }
  void set_block(int to) {
    block = to;
    if (step != 0) end = t_of(block + (step > 0 ? HeightGrid::kBlock : 0));
  }

  double m_p, m_d, m_inverse;
  int m_cells;
};

/// Where a ray is within a block's slab, or may be: as far beside it as triangles reach and numbers are rounded.
class SlabTest {
 public:
  /// `cell`: t from one border to the next, along the axis where that is least.
  SlabTest(const Ray& ray, double cell)
      : m_ray(ray), m_beyond(cell < Bounds::kInf ? 2.0 * kEdge * cell : 0.0),
        m_rounding(kRounding * (std::fabs(ray.origin.x) + std::fabs(ray.origin.z))),
        m_rounding_up(kRounding * std::fabs(ray.origin.y)) {}

  struct Part {
    bool is_met;
    double from, to;  ///< `to` is infinite where it is not left before the end
  };
  Part part(const HeightGrid::Slab& slab, double from, double end) const {
    const double along_x = slab.along_x, along_z = slab.along_z;
    const double above = m_ray.origin.y - (along_x * m_ray.origin.x + along_z * m_ray.origin.z);
    const double rate =
        m_ray.direction.y - (along_x * m_ray.direction.x + along_z * m_ray.direction.z);
    const double more = m_beyond * std::fabs(rate) +
                        m_rounding * (std::fabs(along_x) + std::fabs(along_z)) + m_rounding_up;
    const double low = slab.low - more, high = slab.high + more;
    const double first = above + from * rate, last = above + end * rate;
    Part part{std::max(first, last) >= low && std::min(first, last) <= high, from, Bounds::kInf};
    if (!part.is_met) return part;
    if (first > high) part.from = (high - above) / rate;
    if (first < low) part.from = (low - above) / rate;
    if (last > high) part.to = (high - above) / rate;
    if (last < low) part.to = (low - above) / rate;
    return part;
  }

 private:
  static constexpr double kRounding = 1e-14;
  const Ray& m_ray;
  double m_beyond, m_rounding, m_rounding_up;
};

}  // namespace

HeightGrid::HeightGrid(int width, int depth, std::vector<std::uint16_t> heights, bool smooth)
    : m_width(width), m_depth(depth), m_heights(std::move(heights)) {
  for (const std::uint16_t height : m_heights) {
    m_lowest = std::min(m_lowest, static_cast<double>(height));
    m_highest = std::max(m_highest, static_cast<double>(height));
  }
  find_blocks();
  if (!smooth) return;
  constexpr double kScale = 32767.0;
  for (int z = 0; z < depth; ++z) {
    for (int x = 0; x < width; ++x) {
      const Vec3 n = mean_normal(x, z);
      m_normals.push_back({static_cast<std::int16_t>(kScale * n.x),
                           static_cast<std::int16_t>(kScale * n.y),
                           static_cast<std::int16_t>(kScale * n.z)});
    }
  }
}

void HeightGrid::find_blocks() {
  m_blocks_across = (m_width - 2) / kBlock + 1;
  const int down = (m_depth - 2) / kBlock + 1;
  for (int z = 0; z < down; ++z) {
    for (int x = 0; x < m_blocks_across; ++x) m_blocks.push_back(slab(x * kBlock, z * kBlock));
  }
}

/// Of the block that begins there, along the plane that its heights are nearest to.
HeightGrid::Slab HeightGrid::slab(int x, int z) const {
  constexpr double kBeyond = 4.0 * kEdge, kRounding = 1e-6;
  const int x_end = std::min(x + kBlock, m_width - 1), z_end = std::min(z + kBlock, m_depth - 1);
  const double x_middle = 0.5 * (x + x_end), z_middle = 0.5 * (z + z_end);
  double rise_x = 0.0, rise_z = 0.0, size_x = 0.0, size_z = 0.0;
  for (int j = z; j <= z_end; ++j) {
    for (int i = x; i <= x_end; ++i) {
      const double dx = i - x_middle, dz = j - z_middle, y = height(i, j);
      rise_x += dx * y;
      rise_z += dz * y;
      size_x += dx * dx;
      size_z += dz * dz;
    }
  }
  Slab slab{static_cast<float>(rise_x / size_x), static_cast<float>(rise_z / size_z), 0.0F, 0.0F};
  double low = Bounds::kInf, high = -Bounds::kInf;
  for (int j = z; j <= z_end; ++j) {
    for (int i = x; i <= x_end; ++i) {
      const double above = height(i, j) - (double(slab.along_x) * i + double(slab.along_z) * j);
      low = std::min(low, above);
      high = std::max(high, above);
    }
  }
  const double more = kHeightSlack + kBeyond * (high - low);
  slab.low = static_cast<float>(low - more - kRounding * std::fabs(low));
  slab.high = static_cast<float>(high + more + kRounding * std::fabs(high));
  return slab;
}

/// Of the four triangles between a corner and its neighbours along the grid's lines; where there are less,
/// of those.
Vec3 HeightGrid::mean_normal(int x, int z) const {
  const bool is_inside = x > 0 && z > 0 && x + 1 < m_width && z + 1 < m_depth;
  const double y = height(x, z);
  // Slopes towards greater and towards smaller x and z.
  const double after_x = x + 1 < m_width ? height(x + 1, z) - y : 0.0,
               before_x = x > 0 ? y - height(x - 1, z) : 0.0;
  const double after_z = z + 1 < m_depth ? height(x, z + 1) - y : 0.0,
               before_z = z > 0 ? y - height(x, z - 1) : 0.0;
  if (is_inside) {
    // The triangles in order, two at a time.
    const Pair xs[2] = {Pair{after_x, before_x}, Pair{before_x, after_x}};
    const Pair zs[2] = {Pair{after_z, after_z}, Pair{before_z, before_z}};
    Vec3 sum;
    for (int i = 0; i < 2; ++i) {
      const Pair scale = 1.0 / sqrt(xs[i] * xs[i] + 1.0 + zs[i] * zs[i]);
      const Pair along_x = -xs[i] * scale, along_z = -zs[i] * scale;
      for (int lane = 0; lane < 2; ++lane) sum += Vec3(along_x[lane], scale[lane], along_z[lane]);
    }
    return normalized(sum);
  }
  Vec3 sum;
  const auto add = [&](bool is_there, double along_x, double along_z) {
    if (is_there) sum += normalized(Vec3(-along_x, 1.0, -along_z));
  };
  const bool right = x + 1 < m_width, left = x > 0, far = z + 1 < m_depth, near = z > 0;
  add(right && far, after_x, after_z);
  add(left && far, before_x, after_z);
  add(left && near, before_x, before_z);
  add(right && near, after_x, before_z);
  return normalized(sum);
}

Vec3 HeightGrid::corner_normal(int x, int z) const {
  const auto& n = m_normals[index(x, z)];
  return {double(n[0]), double(n[1]), double(n[2])};
}

HeightField::HeightField(std::shared_ptr<const HeightGrid> grid, double water_level)
    : m_grid(std::move(grid)) {
  const double width = m_grid->width() - 1, depth = m_grid->depth() - 1;
  m_box = {{0.0, std::max(m_grid->lowest(), kFullHeight * water_level) - kMargin, 0.0},
           {width, m_grid->highest() + kMargin, depth}};
  m_to_space = Transform::scaling({1.0 / width, 1.0 / kFullHeight, 1.0 / depth});
  m_reach = own_box();
}

/// Where the box is turned: of the solid's floor and of the points above it.
Bounds HeightField::own_box() const {
  if (keeps_axes(m_to_space)) return padded(transformed(m_box, m_to_space));
  Bounds b;
  for (int z = 0; z < m_grid->depth(); ++z) {
    for (int x = 0; x < m_grid->width(); ++x) {
      const double y = m_grid->height(x, z) + kMargin;
      const bool corner =
          (x == 0 || x + 1 == m_grid->width()) && (z == 0 || z + 1 == m_grid->depth());
      if (corner) b.include(m_to_space.point({double(x), m_box.lo.y, double(z)}));
      if (y > m_box.lo.y) b.include(m_to_space.point({double(x), y, double(z)}));
    }
  }
  return padded(b);
}

std::unique_ptr<Shape> HeightField::baked(const Transform& t) const {
  auto copy = std::make_unique<HeightField>(*this);
  copy->m_to_space = m_to_space.then(t);
  copy->m_reach = copy->own_box();
  return copy;
}

namespace {

/// Both of a cell's triangles that a line meets, near enough: visit(t, 0 or 1).
template <class Visit>
inline void for_triangles(int x, int z, double y1, double y2, double y3, double y4, const Ray& ray,
                          Visit&& visit) {
  const auto triangle = [&](const Vec3& n, const Vec3& corner, double outwards,
                            std::uint32_t which) {
    const double slope = dot(n, ray.direction);
    if (slope == 0.0) return;
    const double t = dot(n, corner - ray.origin) / slope;
    const double u = outwards * (ray.origin.x + t * ray.direction.x - corner.x);
    const double v = outwards * (ray.origin.z + t * ray.direction.z - corner.z);
    if (u >= -kEdge && v >= -kEdge && u + v <= 1.0 + kEdge) visit(t, which);
  };
  triangle({y1 - y2, 1.0, y1 - y3}, {double(x), y1, double(z)}, 1.0, 0);
  triangle({y3 - y4, 1.0, y2 - y4}, {double(x + 1), y4, double(z + 1)}, -1.0, 1);
}

}  // namespace

/// Whether it passes between y_from and y_to. `corner`: the cell's first height.
template <class Visit>
[[gnu::always_inline]] inline void HeightField::cell(int x, int z, const std::uint16_t* corner,
                                                     const Ray& ray, double y_from, double y_to,
                                                     Visit&& visit) const {
  const std::uint16_t* const beyond = corner + m_grid->width();
  const double y1 = corner[0], y2 = corner[1], y3 = beyond[0], y4 = beyond[1];
  if (std::max({y1, y2, y3, y4}) < std::min(y_from, y_to) - kHeightSlack) return;
  if (std::min({y1, y2, y3, y4}) > std::max(y_from, y_to) + kHeightSlack) return;
  for_triangles(x, z, y1, y2, y3, y4, ray, [&](double t, std::uint32_t which) {
    const auto number =
        static_cast<std::uint32_t>(z) * static_cast<std::uint32_t>(m_grid->width()) +
        static_cast<std::uint32_t>(x);
    visit(t, 2 * number + which);
  });
}

/// Looks through all cells for those over which the ray passes between `first` and `last`.
template <class Visit, class GoOn>
void HeightField::walk(const Ray& ray, double t_min, double t_max, Visit&& visit,
                       GoOn&& go_on) const {
  const Ray in_grid{m_to_space.inverse_point(ray.origin), m_to_space.inverse_vector(ray.direction)};
  double lo = -Bounds::kInf, hi = Bounds::kInf;
  if (!clip(m_box, in_grid, lo, hi)) return;
  const double first = std::max(lo, t_min), last = hi;
  if (!(first <= std::min(hi, t_max))) return;
  const auto within_box = [&](double t, std::uint32_t element) {
    if (t >= lo && t <= hi && t > t_min && t < t_max) visit(t, element);
  };
  const auto height_at = [&](double t) { return in_grid.origin.y + t * in_grid.direction.y; };
  Stepper x(in_grid.origin.x, in_grid.direction.x, first, m_grid->width() - 1);
  Stepper z(in_grid.origin.z, in_grid.direction.z, first, m_grid->depth() - 1);
  const std::ptrdiff_t row = z.step * static_cast<std::ptrdiff_t>(m_grid->width());
  // Triangles reach a little into the cells beside their own: one more cell is looked at.
  const SlabTest test(in_grid, std::min(x.delta, z.delta));
  double from = first;
  // Along whose axis the ray came into the block; null: its cell there is known.
  const Stepper* entered = nullptr;
  while (x.is_within() && z.is_within()) {
    const double end = std::min({x.end, z.end, last});
    const auto within = test.part(
        m_grid->block(x.block / HeightGrid::kBlock, z.block / HeightGrid::kBlock), from, end);
    if (within.is_met) {
      if (within.from > from) {
        from = within.from;
        x.go_within_block(from);
        z.go_within_block(from);
      } else if (entered) {
        x.go_within_block(from);
        z.go_within_block(from);
        (entered == &x ? x : z).go_to_border();
      }
      double y_from = height_at(from);
      const auto columns = static_cast<unsigned>(x.block_cells()),
                 rows = static_cast<unsigned>(z.block_cells());
      const std::uint16_t* corner = m_grid->corner(x.cell, z.cell);
      bool is_in_block = true;
      do {
        const double to = std::min({x.next, z.next, last}), y_to = height_at(to);
        cell(x.cell, z.cell, corner, in_grid, y_from, y_to, within_box);
        if (to >= last || !go_on(from)) return;
        from = to;
        y_from = y_to;
        if (x.next < z.next) {
          x.advance();
          corner += x.step;
          is_in_block = static_cast<unsigned>(x.cell - x.block) < columns;
        } else {
          z.advance();
          corner += row;
          is_in_block = static_cast<unsigned>(z.cell - z.block) < rows;
        }
      } while (is_in_block && from <= within.to);
      if (!is_in_block) {
        x.take_block();
        z.take_block();
        entered = nullptr;
        continue;
      }
    }
    if (end >= last || !go_on(from)) return;
    Stepper& leaves = x.end < z.end ? x : z;
    leaves.leave_block();
    entered = &leaves;
    from = end;
  }
}

bool HeightField::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  double best = t_max;
  const auto visit = [&](double t, std::uint32_t element) {
    if (t >= best) return;
    best = t;
    hit = {t, element, 0.0, 0.0};
  };
  walk(ray, t_min, t_max, visit, [&](double before) { return before < best; });
  return best < t_max;
}

bool HeightField::any(const Ray& ray, double t_min, double t_max) const {
  bool found = false;
  walk(
      ray, t_min, t_max, [&](double, std::uint32_t) { found = true; },
      [&](double before) { return !found && before < t_max; });
  return found;
}

void HeightField::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  walk(
      ray, t_min, t_max,
      [&](double t, std::uint32_t element) {
        hits.push_back({t, element, 0.0, 0.0});
      },
      [&](double before) { return before < t_max; });
}

bool HeightField::within(const Vec3& p) const {
  const Vec3 at = m_to_space.inverse_point(p);
  if (!(at.x >= 0.0 && at.x < m_box.hi.x && at.z >= 0.0 && at.z < m_box.hi.z)) return false;
  if (at.y >= m_box.hi.y) return false;
  const double water = m_box.lo.y;
  if (at.y < water) return true;
  const int x = static_cast<int>(at.x), z = static_cast<int>(at.z);
  const double u = at.x - x, v = at.z - z;
  const auto height = [&](int i, int j) { return std::max(m_grid->height(i, j), water); };
  const double y2 = height(x + 1, z), y3 = height(x, z + 1);
  if (u + v < 1.0) {
    const double y1 = height(x, z);
    return at.y < y1 + u * (y2 - y1) + v * (y3 - y1);
  }
  const double y4 = height(x + 1, z + 1);
  return at.y < y4 + (1.0 - u) * (y3 - y4) + (1.0 - v) * (y2 - y4);
}

Vec3 HeightField::flat_normal(std::uint32_t element) const {
  const int number = static_cast<int>(element / 2);
  const int x = number % m_grid->width(), z = number / m_grid->width();
  const double y2 = m_grid->height(x + 1, z), y3 = m_grid->height(x, z + 1);
  if (element % 2 == 0) {
    const double y1 = m_grid->height(x, z);
    return {y1 - y2, 1.0, y1 - y3};
  }
  const double y4 = m_grid->height(x + 1, z + 1);
  return {y3 - y4, 1.0, y2 - y4};
}

Vec3 HeightField::normal(const Vec3& p, const ShapeHit& hit) const {
  if (!m_grid->is_smooth()) return m_to_space.normal(flat_normal(hit.element));
  const Vec3 at = m_to_space.inverse_point(p);
  const int x = std::clamp(static_cast<int>(at.x), 0, m_grid->width() - 2);
  const int z = std::clamp(static_cast<int>(at.z), 0, m_grid->depth() - 2);
  const double u = at.x - x, v = at.z - z;
  const auto corner = [&](int i, int j) {
    return normalized(m_to_space.normal(m_grid->corner_normal(i, j)));
  };
  return (corner(x, z) * (1.0 - u) + corner(x + 1, z) * u) * (1.0 - v) +
         (corner(x, z + 1) * (1.0 - u) + corner(x + 1, z + 1) * u) * v;
}

}  // namespace lentray::core
