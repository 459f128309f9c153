#include "core/pattern/golden_pentagons.h"

#include <array>
#include <initializer_list>
#include <limits>

#include "core/pattern/golden_plane.h"

namespace lentray::core {
namespace {

using Point = GoldenPoint;

/// Some tiles split differently by where in the larger tile they lie: in a wedge at its corner or
/// along its sides.
enum Kind {
  kFirstPentagon,
  kSecondPentagon,
  kSecondPentagonInWedge,
  kThirdPentagon,
  kThirdPentagonInWedge,
  kStar,
  kBoat,
  kBoatInWedge,
  kFirstDiamond,
  kSecondDiamond,
  kKinds
};

constexpr std::array<int, kKinds> kLevels = {0, 1, 1, 2, 2, 3, 4, 4, 5, 5};

// Angles are whole numbers of fifths of a right angle.
struct Part {
  /// The points that lie beyond a line: its direction away from the origin, and its distance.
  int cut_angle;
  double cut_distance;
  Kind kind;
  /// From the tile's coordinates to the part's, in units of the larger tile.
  int turn;
  Point shift;
};

struct Motion {
  Point cut;
  double cut_distance;
  Kind kind;
  Point turn, shift;  ///< already in units of the part
};

constexpr int kMostParts = 3;
using Motions = std::array<Motion, kMostParts>;

class GoldenPentagons final : public Pattern {
 public:
  GoldenPentagons() {
    // In each row the first part whose cut lets the point through counts; the last has none.
    const Point none{};
    const double edge = m_edge, corner = m_corner, g = kGoldenPart;
    const double near = g * g * edge;
    const auto rest = [](Kind kind, int turn, Point shift) {
      return Part{0, -std::numeric_limits<double>::infinity(), kind, turn, shift};
    };
    const Point slanted{-near, corner * sine_of_fifths(4)};
    row(kFirstPentagon, {{-2, near, kSecondPentagon, 0, {-corner, 0}}, rest(kStar, -2, none)});
    row(kSecondPentagon,
        {{-4, -near, kSecondDiamond, 0, {g * corner, 0}}, rest(kThirdPentagon, 8, slanted)});
    row(kSecondPentagonInWedge, {{-2, near, kFirstPentagon, 0, {-corner, 0}},
                                 {-6, -g * g * near, kFirstDiamond, 10, none},
                                 rest(kSecondPentagonInWedge, 6, {g * corner, 0})});
    row(kThirdPentagon, {{10, near, kSecondPentagon, -8, {-corner, 0}},
                         {2, near, kThirdPentagon, 12, slanted},
                         rest(kBoat, 0, none)});
    row(kThirdPentagonInWedge,
        {{0, g * g * near, kSecondPentagonInWedge, 10, {g * g * near + g * edge, 0}},
         rest(kBoatInWedge, 0, none)});
    row(kStar, {{10, -g * edge, kFirstPentagon, 0, none},
                rest(kThirdPentagonInWedge, 10, {2 * g * edge, 0})});
    row(kBoat, {rest(kThirdPentagonInWedge, 4, {corner, 0})});
    row(kBoatInWedge,
        {{0, -g * edge, kFirstPentagon, 10, none}, rest(kThirdPentagonInWedge, 0, {corner, 0})});
    row(kFirstDiamond, {rest(kFirstPentagon, 0, none)});
    row(kSecondDiamond, {rest(kThirdPentagonInWedge, 0, none)});
  }

  double value(const Vec3& point) const override {
    if (std::hypot(point.x, point.z) <= 1e-10) return 1.0;
    constexpr double kStep = kGolden * kGolden * kGolden * kGolden;
    Point p = folded_in_five({point.x, point.z});
    int cuts = 0;
    // Four cuts make pentagons of the same kind and place as the one they began with.
    for (; p.x > m_edge && cuts < kMostCuts; cuts += 4) p = {p.x / kStep, p.z / kStep};
    Kind kind = kFirstPentagon;
    for (; cuts > 0; --cuts) {
      p = kind == kFirstPentagon ? folded_in_five(p) : Point{p.x, std::fabs(p.z)};
      kind = step(m_motions[kind], p);
    }
    return golden_value(kLevels[kind], 6, depth_in(kind, {p.x, std::fabs(p.z)}) * kSteepness);
  }

 private:
  static constexpr int kMostCuts = 140;
  static constexpr double kSteepness = 5.55 / kGolden;

  void row(Kind kind, std::initializer_list<Part> parts) {
    Motion* motion = m_motions[kind].data();
    for (const Part& part : parts) {
      *motion++ = {{cosine_of_fifths(part.cut_angle), sine_of_fifths(part.cut_angle)},
                   part.cut_distance,
                   part.kind,
                   {kGolden * cosine_of_fifths(part.turn), kGolden * sine_of_fifths(part.turn)},
                   {kGolden * part.shift.x, kGolden * part.shift.z}};
    }
  }

  static Kind step(const Motions& motions, Point& p) {
    const Motion* motion = motions.data();
    while (motion->cut.x * p.x + motion->cut.z * p.z < motion->cut_distance) ++motion;
    p = {motion->turn.x * p.x - motion->turn.z * p.z + motion->shift.x,
         motion->turn.z * p.x + motion->turn.x * p.z + motion->shift.z};
    return motion->kind;
  }

  /// The distance from the nearest edge.
  double depth_in(Kind kind, Point p) const {
    static const double sine = sine_of_fifths(1), cosine = cosine_of_fifths(1);
    const auto to_star = [&](Point q) {
      return std::fabs(sine * (q.x - kGolden * m_corner) + cosine * q.z);
    };
    switch (kind) {
      case kStar: return to_star(p);
      case kBoat:
      case kBoatInWedge: {
        const double to_keel = std::fabs(p.x - m_edge / (kGolden * kGolden * kGolden));
        return std::min(to_keel, to_star(folded_in_five({-p.x, p.z})));
      }
      case kFirstDiamond:
      case kSecondDiamond: return std::fabs(sine * (p.x + kGoldenPart * m_corner) - cosine * p.z);
      default: return std::fabs(folded_in_five(p).x - m_edge);
    }
  }

  // From the middle of a pentagon with sides of length 1 to its edge and corner.
  const double m_corner = 0.5 / sine_of_fifths(2);
  const double m_edge = m_corner * cosine_of_fifths(2);
  std::array<Motions, kKinds> m_motions{};
};

}  // namespace

PatternPtr make_golden_pentagons() { return std::make_unique<GoldenPentagons>(); }

}  // namespace lentray::core
