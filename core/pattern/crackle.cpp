#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/thread_table.h"
#include "core/base/tiny.h"
#include "core/pattern/organic.h"

namespace lentray::core {
namespace {

/// The random points of cells of the lattice, one a cell. A ray's samples in a medium, and neighbouring
/// pixels, ask for the same cells again.
class CellPoints {
 public:
  /// Of the thread.
  static CellPoints& of_thread() { return table_of_thread<CellPoints>(); }

  const Vec3& of(int x, int y, int z) {
    const auto place = [](int i) { return static_cast<unsigned>(i) % kSide; };
    Entry& entry = m_entries[(place(z) * kSide + place(y)) * kSide + place(x)];
    if (!entry.used || entry.x != x || entry.y != y || entry.z != z) fill(entry, x, y, z);
    return entry.point;
  }

 private:
  struct Entry {
    int x, y, z;
    bool used;
    Vec3 point;
  };
  [[gnu::noinline]] static void fill(Entry& entry, int x, int y, int z) {
    entry = {x, y, z, true, Vec3(x, y, z) + cell_randoms(x, y, z)};
  }
  static constexpr unsigned kSide = 16;
  std::array<Entry, kSide * kSide * kSide> m_entries;
};

/// The three least distances from a point, as powers of the metric, and the nearest point.
struct NearestThree {
  std::array<double, 3> d{1e300, 1e300, 1e300};
  Vec3 first;

  void take(double distance, const Vec3& point) {
    if (distance < d[0]) {
      d = {distance, d[0], d[1]};
      first = point;
    } else if (distance < d[1]) {
      d = {d[0], distance, d[1]};
    } else {
      d[2] = distance;
    }
  }
};

/// A cell beside that of a point: along each axis 0 for the point's own, 1 for the next one on the side
/// that the point is nearer to, 2 for that on the other side, 3 and 4 for those behind these two.
struct Neighbour {
  std::uint8_t x, y, z;
};

/// Those that touch the cell of the point; on the whole the nearer ones first.
constexpr auto kTouching = [] {
  std::array<Neighbour, 27> cells{};
  std::size_t count = 0;
  constexpr int kFar[] = {0, 1, 9};  // squares of distances from a quarter of the cell, in quarters
  for (int far = 0; far <= 27; ++far) {
    for (std::uint8_t x = 0; x < 3; ++x) {
      for (std::uint8_t y = 0; y < 3; ++y) {
        for (std::uint8_t z = 0; z < 3; ++z) {
          if (kFar[x] + kFar[y] + kFar[z] == far) cells[count++] = {x, y, z};
        }
      }
    }
  }
  return cells;
}();

class CracklePattern final : public Pattern {
 public:
  CracklePattern(const Crackle& crackle, int generator)
      : m_crackle(crackle), m_generator(generator) {}

  double value(const Vec3& p) const override {
    const NearestThree nearest = search(p);
    if (m_crackle.solid) return std::clamp(noise(nearest.first, m_generator), 0.0, 1.0);
    const double offset = m_crackle.metric == 1.0 ? m_crackle.offset : powered(m_crackle.offset);
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += m_crackle.form[static_cast<int>(i)] * rooted(nearest.d[i] + offset);
    }
    return std::clamp(sum, 0.0, 1.0);
  }

 private:
  /// Along one axis: the cells of a Neighbour, and the metric's power of the least distance to them.
  struct Axis {
    Axis(const CracklePattern& pattern, double p) {
      const int own = static_cast<int>(whole_below(p - kTiny));
      const double below = p - own, above = 1.0 - below;
      const int side = below < above ? -1 : 1;
      const double near = std::min(below, above), far = std::max(below, above);
      cell = {own, own + side, own - side, own + 2 * side, own - 2 * side};
      reach = {0.0, pattern.powered(std::max(near, 0.0)), pattern.powered(far),
               pattern.powered(near + 1.0), pattern.powered(far + 1.0)};
    }
    std::array<int, 5> cell;
    std::array<double, 5> reach;
  };

  /// Leaves out cells none of whose points can be near enough.
  NearestThree search(const Vec3& p) const {
    constexpr double kSlack = 1.0 + 1e-12;  // of rounding
    const Axis x(*this, p.x), y(*this, p.y), z(*this, p.z);
    CellPoints& points = CellPoints::of_thread();
    NearestThree nearest;
    const auto ask = [&](Neighbour n) {
      if (x.reach[n.x] + y.reach[n.y] + z.reach[n.z] >= nearest.d[2] * kSlack) return;
      const Vec3& point = points.of(x.cell[n.x], y.cell[n.y], z.cell[n.z]);
      const Vec3 away = point - p;
      const double d = powered(away.x) + powered(away.y) + powered(away.z);
      if (d < nearest.d[2]) nearest.take(d, point);
    };
    for (const Neighbour n : kTouching) ask(n);
    // Two cells away along one axis.
    const auto ask_faces = [&](const Axis& axis, auto neighbour) {
      for (std::uint8_t far = 3; far < 5; ++far) {
        if (axis.reach[far] >= nearest.d[2] * kSlack) return;
        for (std::uint8_t a = 0; a < 3; ++a) {
          for (std::uint8_t b = 0; b < 3; ++b) ask(neighbour(far, a, b));
        }
      }
    };
    using Step = std::uint8_t;
    ask_faces(x, [](Step far, Step a, Step b) { return Neighbour{far, a, b}; });
    ask_faces(y, [](Step far, Step a, Step b) { return Neighbour{a, far, b}; });
    ask_faces(z, [](Step far, Step a, Step b) { return Neighbour{a, b, far}; });
    return nearest;
  }

  /// Distances are compared as their metric's power: no roots until the end.
  double powered(double d) const {
    if (m_crackle.metric == 2.0) return d * d;
    return m_crackle.metric == 1.0 ? std::fabs(d) : std::pow(std::fabs(d), m_crackle.metric);
  }
  double rooted(double sum) const {
    if (m_crackle.metric == 2.0) return std::sqrt(sum);
    return m_crackle.metric == 1.0 ? sum : std::pow(sum, 1.0 / m_crackle.metric);
  }
  Crackle m_crackle;
  int m_generator;
};

}  // namespace

PatternPtr make_crackle(const Crackle& crackle, int generator) {
  return std::make_unique<CracklePattern>(crackle, generator);
}

}  // namespace lentray::core
