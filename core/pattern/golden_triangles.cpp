#include "core/pattern/golden_triangles.h"

#include "core/pattern/golden_plane.h"

namespace lentray::core {
namespace {

using Point = GoldenPoint;

/// How many times a triangle can be cut before the numbers are too coarse to distinguish the parts.
constexpr int kMostCuts = 140;

/// Half a kite: one angle is the tip and has 36 degrees, the kite's axis goes from it to the tail.
/// Half a dart: the long side goes from the tip to the wing, the dart's axis from the tip to the tail.
struct HalfTile {
  bool kite;
  Point tip, tail, wing;
};

Point between(Point from, Point to, double part) {
  return {from.x + (to.x - from.x) * part, from.z + (to.z - from.z) * part};
}

/// Twice the area of the triangle, with its sense.
double turn(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
}

bool same_side(Point a, Point b, Point one, Point other) {
  return turn(a, b, one) * turn(a, b, other) >= 0.0;
}

double distance_to_line(Point a, Point b, Point p) {
  return std::fabs(turn(a, b, p)) / std::hypot(b.x - a.x, b.z - a.z);
}

/// A kite's half makes a dart's half at the tip and two halves of kites that meet at the wing.
HalfTile part_of_kite(const HalfTile& half, Point p) {
  const Point on_axis = between(half.tip, half.tail, kGoldenPart);
  const Point on_side = between(half.tip, half.wing, 1.0 - kGoldenPart);
  if (same_side(on_axis, on_side, p, half.tip)) return {false, half.tip, on_side, on_axis};
  const bool at_side = !same_side(half.wing, on_axis, p, half.tail);
  return {true, half.wing, on_axis, at_side ? on_side : half.tail};
}

/// A dart's half makes a kite's half at the tip and a dart's half at the wing.
HalfTile part_of_dart(const HalfTile& half, Point p) {
  const Point on_side = between(half.tip, half.wing, kGoldenPart);
  if (same_side(on_side, half.tail, p, half.tip)) return {true, half.tip, half.tail, on_side};
  return {false, half.wing, on_side, half.tail};
}

class GoldenTriangles final : public Pattern {
 public:
  explicit GoldenTriangles(GoldenTiles tiles) : m_rhombs(tiles == GoldenTiles::kRhombs) {}

  double value(const Vec3& point) const override {
    if (std::hypot(point.x, point.z) <= 1e-10) return 1.0;
    const double size = m_rhombs ? kGoldenPart : 1.0;
    const Point p = folded_in_five({point.x * size, point.z * size});
    int cuts = 0;
    HalfTile half = first(p, cuts);
    for (; cuts > 0; --cuts) half = half.kite ? part_of_kite(half, p) : part_of_dart(half, p);
    return m_rhombs ? in_rhomb(half, p) : in_half(half, p);
  }

 private:
  /// Half a kite with its tip at the origin that holds the point, and how often it has to be cut.
  static HalfTile first(Point p, int& cuts) {
    static const double cosine = cosine_of_fifths(2), sine = sine_of_fifths(2);
    static const double slope = sine_of_fifths(1) / cosine_of_fifths(1);
    const double reach = p.x + p.z * slope;
    double side = 1.0;
    bool mirrored = false;
    for (; side < reach && cuts < kMostCuts; cuts += 2) {
      side *= kGolden * kGolden;
      mirrored = !mirrored;
    }
    const Point level{side, 0.0}, slanted{side * cosine, side * sine};
    return mirrored ? HalfTile{true, {}, slanted, level} : HalfTile{true, {}, level, slanted};
  }

  static double in_half(const HalfTile& half, Point p) {
    return half.kite ? between_edges(0, half.wing, half.tip, half.tail, p, 4.46)
                     : between_edges(1, half.wing, half.tip, half.tail, p, 4.46);
  }

  /// A kite's half makes halves of a wide and a narrow rhomb, a dart's is half a wide one.
  static double in_rhomb(const HalfTile& half, Point p) {
    constexpr double kSteepness = 5.55;
    if (!half.kite) return between_edges(0, half.tail, half.tip, half.wing, p, kSteepness);
    const Point middle = between(half.tip, half.tail, kGoldenPart);
    return same_side(half.wing, middle, p, half.tail)
               ? between_edges(1, half.wing, middle, half.tail, p, kSteepness)
               : between_edges(0, middle, half.tip, half.wing, p, kSteepness);
  }

  /// Of the tile's two edges that meet at the corner; the triangle's third side is its axis.
  static double between_edges(int level, Point corner, Point one, Point other, Point p,
                              double steepness) {
    const double nearest =
        std::min(distance_to_line(corner, one, p), distance_to_line(corner, other, p));
    return golden_value(level, 2, nearest * steepness);
  }

  bool m_rhombs;
};

}  // namespace

PatternPtr make_golden_triangles(GoldenTiles tiles) {
  return std::make_unique<GoldenTriangles>(tiles);
}

}  // namespace lentray::core
