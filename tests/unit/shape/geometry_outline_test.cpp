// What outlines, noise and clipped shapes know ahead or find at once is what they find step by step.
#include <gtest/gtest.h>

#include <cmath>

#include "core/accel/light_buffer.h"
#include "core/noise/noise.h"
#include "core/object/leaf.h"
#include "core/object/object.h"
#include "core/shape/poly.h"
#include "core/shape/prism.h"
#include "core/shape/sphere.h"
#include "tests/unit/shape/geometry_help.h"
#include "tests/unit/shape/plain_shapes.h"

namespace lentray::core {
namespace {

using geometry_test::Random;

/// A wavy ring: curves in the outer contour, lines in the inner one.
Outline ring(double scale, const Vec2& at) {
  constexpr int kWaves = 9;
  const auto place = [&](double angle, double r) {
    return Vec2{at.u + scale * r * std::cos(angle), at.v + scale * r * std::sin(angle)};
  };
  std::vector<CurvePiece> pieces;
  for (int i = 0; i < kWaves; ++i) {
    const double a = i * 6.283185307179586 / kWaves,
                 b = ((i + 1) % kWaves) * 6.283185307179586 / kWaves;
    const double middle = (i + 0.5) * 6.283185307179586 / kWaves;
    pieces.push_back(
        CurvePiece::conic(place(a, 1.0), place(middle, i % 2 == 0 ? 1.6 : 0.7), place(b, 1.0)));
    pieces.push_back(CurvePiece::line(place(a, 0.4), place(b, 0.4)));
  }
  return Outline(std::move(pieces));
}

TEST(UnitCoreOutline, SquaresSayWhatCountingSays) {
  Random random(3);
  for (const double scale : {1.0, 1e-3, 1e5}) {
    for (const Vec2 at : {Vec2{0, 0}, Vec2{300 * scale, -20 * scale}}) {
      const Outline outline = ring(scale, at);
      Outline plain = outline;
      PlainShapes::open(plain);
      int inside = 0;
      for (int i = 0; i < 20000; ++i) {
        const double u = at.u + scale * random.in(-1.7, 1.7),
                     v = at.v + scale * random.in(-1.7, 1.7);
        ASSERT_EQ(outline.contains(u, v), plain.contains(u, v)) << scale << ' ' << u << ' ' << v;
        inside += outline.contains(u, v);
      }
      EXPECT_GT(inside, 2000);
      EXPECT_LT(inside, 18000);
    }
  }
}

TEST(UnitCoreOutline, PrismsAnswerAnyAsNearestDoes) {
  Random random(5);
  const auto outline = std::make_shared<const Outline>(ring(1.0, {0.2, 0.1}));
  for (const auto sweep : {Prism::Sweep::kAlongY, Prism::Sweep::kConic, Prism::Sweep::kAlongZ}) {
    for (const bool open : {false, true}) {
      const Prism prism("prism", outline, sweep, 0.2, 0.9, open);
      int met = 0;
      for (int i = 0; i < 20000; ++i) {
        const Ray ray{{random.in(-2, 2), random.in(-2, 2), random.in(-2, 2)},
                      {random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)}};
        ShapeHit hit;
        ShapeHits all;
        const double from = random.in(0, 0.5), to = random.in(0.5, 3);
        const bool is_met = prism.nearest(ray, from, to, hit);
        prism.all(ray, from, to, all);
        ASSERT_EQ(prism.any(ray, from, to), is_met);
        ASSERT_EQ(all.empty(), !is_met);
        // Of those at one place that which was made first.
        for (const ShapeHit& one : all) {
          ASSERT_TRUE(one.t > hit.t || (one.t == hit.t && one.element >= hit.element));
        }
        met += is_met;
      }
      EXPECT_GT(met, 500);
    }
  }
}

TEST(UnitCoreOutline, FirstCrossingsHoldTheFirst) {
  Random random(11);
  const Outline outline = ring(1.0, {0.2, 0.1});
  int left_out = 0, met = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec2 from{random.in(-2, 2), random.in(-2, 2)}, way{random.in(-1, 1), random.in(-1, 1)};
    const double a = way.v, b = -way.u, c = from.v * way.u - from.u * way.v;
    const PlaneWay everywhere{from, {from.u + way.u, from.v + way.v}};
    const auto place = [&](std::uint32_t piece, double s) {
      const Vec2 p = outline.pieces()[piece].at(s);
      return (p.u - from.u) * way.u + (p.v - from.v) * way.v;
    };
    double first = 1e9, first_of_all = 1e9;
    int seen = 0, all = 0;
    outline.first_crossings(a, b, c, everywhere, [&](std::uint32_t piece, double s, const Vec2&) {
      ++seen;
      if (place(piece, s) <= 0.0) return false;
      first = std::min(first, place(piece, s));
      return true;
    });
    outline.crossings(a, b, c, everywhere, [&](std::uint32_t piece, double s, const Vec2&) {
      ++all;
      if (place(piece, s) > 0.0) first_of_all = std::min(first_of_all, place(piece, s));
      return true;
    });
    ASSERT_EQ(first, first_of_all);
    left_out += all - seen;
    met += first < 1e9;
  }
  EXPECT_GT(met, 2000);
  EXPECT_GT(left_out, 2000);
}

/// Ways of all lengths and directions: no crossing on them is left out.
TEST(UnitCoreOutline, NoCrossingOnTheWayIsLeftOut) {
  Random random(13);
  for (const double scale : {1.0, 1e4}) {
    const Outline outline = ring(scale, {0.2 * scale, 0.1 * scale});
    int met = 0;
    for (int i = 0; i < 20000; ++i) {
      const double reach = scale * std::pow(10.0, random.in(-4, 0.5)), lean = i % 7 == 0   ? 1e-9
                                                                              : i % 7 == 1 ? 1e-3
                                                                                           : 1.0;
      const Vec2 from{scale * random.in(-2, 2), scale * random.in(-2, 2)};
      const Vec2 to{from.u + reach * random.in(-1, 1), from.v + lean * reach * random.in(-1, 1)};
      const double a = to.v - from.v, b = from.u - to.u, c = from.v * to.u - from.u * to.v;
      const auto count = [&](const PlaneWay& way) {
        int between = 0;
        outline.crossings(a, b, c, way, [&](std::uint32_t, double, const Vec2& p) {
          const double along = (p.u - from.u) * (to.u - from.u) + (p.v - from.v) * (to.v - from.v);
          between += along > 0.0 &&
                     along < (to.u - from.u) * (to.u - from.u) + (to.v - from.v) * (to.v - from.v);
          return true;
        });
        return between;
      };
      const int crossings = count({from, to, 1e-9 * scale, true});
      ASSERT_EQ(crossings, count({}));
      // They tell apart the inside from the outside.
      ASSERT_EQ(crossings % 2 != 0,
                outline.contains(from.u, from.v) != outline.contains(to.u, to.v));
      met += crossings > 0;
    }
    EXPECT_GT(met, 1000);
  }
}

/// Every number of boxes: those that a way passes through are named, with AVX2 and without, and most others
/// are not.
TEST(UnitCorePlaneBoxes, NameWhatAWayPassesThrough) {
  Random random(17);
  for (const std::size_t count : {1u, 7u, 35u, 64u, 65u, 700u}) {
    std::vector<PlaneBox> boxes;
    PlaneBox around{{1e9, 1e9}, {-1e9, -1e9}};
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 lo{random.in(3, 5), random.in(-2, 0)};
      boxes.push_back(
          {lo, {lo.u + random.in(0, 0.1), lo.v + (i % 5 == 1 ? 0.0 : random.in(0.01, 0.1))}});
      around.lo = {std::min(around.lo.u, boxes[i].lo.u), std::min(around.lo.v, boxes[i].lo.v)};
      around.hi = {std::max(around.hi.u, boxes[i].hi.u), std::max(around.hi.v, boxes[i].hi.v)};
    }
    PlaneBoxes search, blind;
    search.fill(boxes, around, true);
    blind.fill(boxes, around, false);
    std::size_t all = 0, named = 0;
    for (int i = 0; i < 500; ++i) {
      const double reach = std::pow(10.0, random.in(-3, 1));
      const Vec2 from{random.in(3, 5), random.in(-2, 0)};
      const PlaneWay way{
          from, {from.u + reach * random.in(-1, 1), from.v + reach * random.in(-1, 1)}, 1e-9, true};
      std::vector<bool> fast(count), portable(count);
      std::size_t seen = 0;
      search.along(way, [&](std::size_t box) { return fast[box] = true; });
      search.along(
          way, [&](std::size_t box) { return portable[box] = true; }, true);
      blind.along(way, [&](std::size_t) { return ++seen > 0; });
      ASSERT_EQ(seen, count);
      for (std::size_t box = 0; box < count; ++box) {
        double first = 0.0, last = 1.0;  // of the way, where it is in the box
        const auto cut = [&](double at, double along, double lo, double hi) {
          const double a = (lo - at) / along, b = (hi - at) / along;
          first = std::max(first, std::min(a, b));
          last = std::min(last, std::max(a, b));
        };
        cut(from.u, way.end.u - from.u, boxes[box].lo.u, boxes[box].hi.u);
        cut(from.v, way.end.v - from.v, boxes[box].lo.v, boxes[box].hi.v);
        if (first <= last) {
          ASSERT_TRUE(fast[box] && portable[box]) << count << ' ' << i << ' ' << box;
        }
        named += fast[box];
      }
      all += count;
    }
    EXPECT_LT(named * 4, all) << count;
  }
}

TEST(UnitCoreOutline, ReachesAsFarAlongAnAxisAsANearbyWayDoes) {
  const Outline outline = ring(1.0, {0.2, 0.1});
  for (const Vec2 n : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
    const double turned = 6e-17, far = outline.farthest({n.u + turned * n.v, n.v - turned * n.u});
    const double more = 1e-9;
    EXPECT_NEAR(far, outline.farthest({n.u + more * n.v, n.v - more * n.u}), 3e-9);
  }
}

TEST(UnitCoreNoise, RepeatsEvery4096CellsHoweverFar) {
  constexpr double kFar = 4096.0 * (1 << 19);  // beyond what is counted in 32 bits
  for (const int generator : {1, 2}) {
    for (int i = 0; i < 64; ++i) {
      const Vec3 p{i * 0.375, i * 0.625 + 3.0, i * 0.125 + 1.0};
      EXPECT_EQ(noise(p, generator), noise({p.x, p.y, p.z + kFar}, generator)) << i;
      EXPECT_EQ(noise(p, generator), noise({p.x + kFar, p.y, p.z}, generator)) << i;
    }
  }
}

TEST(UnitGeometryClips, TheNearestOfAPolynomialIsTheFirstOfAllThatAreKept) {
  Random random(7);
  std::vector<double> c(20, 0.0);
  c[0] = 1.0;
  c[12] = -1.0;
  c[17] = -0.3;
  Leaf leaf(std::make_unique<Poly>("cubic", 3, c), Transform());
  leaf.set_clips({std::make_shared<Leaf>(std::make_unique<Sphere>(Vec3{}, 1.0), Transform())});
  leaf.search_within_clips();
  HitLists lists;
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray{{random.in(-3, 3), random.in(-3, 3), random.in(-3, 3)},
                  {random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)}};
    std::vector<Hit> all;
    leaf.all(ray, 0.0, Bounds::kInf, all, {lists, RayKind::kShadow});
    double first = Bounds::kInf;
    for (const Hit& hit : all) first = std::min(first, hit.t);
    Hit hit;
    ASSERT_EQ(leaf.nearest(ray, 0.0, Bounds::kInf, hit, {lists, RayKind::kShadow}), !all.empty());
    if (all.empty()) continue;
    ASSERT_EQ(hit.t, first);
    ++met;
  }
  EXPECT_GT(met, 200);
}

/// Searched within the clips' ball it has the crossings that it has along the whole ray.
TEST(UnitGeometryClips, APolynomialLosesNoCrossingToTheBallOfItsClips) {
  Random random(5);
  for (const int order : {3, 4, 6, 7}) {
    const auto count = static_cast<std::size_t>((order + 1) * (order + 2) * (order + 3) / 6);
    const Vec3 on{0.3, -0.2, 0.1};  // the surface goes through the middle of the clip
    std::vector<double> c;
    double sum = 0.0;
    for (int i = order; i >= 0; --i) {
      for (int j = order - i; j >= 0; --j) {
        for (int k = order - i - j; k >= 0; --k) {
          c.push_back(random.in(-1, 1));
          sum += c.back() * std::pow(on.x, i) * std::pow(on.y, j) * std::pow(on.z, k);
        }
      }
    }
    ASSERT_EQ(c.size(), count);
    c.back() -= sum;
    const Transform place =
        Transform::scaling({0.7, 1.3, 0.9}).then(Transform::translation({2, -1, 3}));
    Leaf whole(std::make_unique<Poly>("poly", order, c), place),
        clipped(std::make_unique<Poly>("poly", order, c), place);
    const auto clip =
        std::make_shared<Leaf>(std::make_unique<Sphere>(place.point(on), 0.8), Transform());
    clipped.set_clips({clip});
    clipped.search_within_clips();
    HitLists lists;
    int met = 0;
    for (int i = 0; i < 8000; ++i) {
      const Ray ray{{random.in(0, 4), random.in(-3, 1), random.in(1, 5)},
                    {random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)}};
      std::vector<Hit> all, kept;
      whole.all(ray, 1e-6, Bounds::kInf, all, {lists, RayKind::kShadow});
      clipped.all(ray, 1e-6, Bounds::kInf, kept, {lists, RayKind::kShadow});
      std::erase_if(all, [&](const Hit& hit) { return !clip->inside(ray.at(hit.t)); });
      ASSERT_EQ(kept.size(), all.size()) << order << ' ' << i;
      for (std::size_t k = 0; k < kept.size(); ++k)
        EXPECT_NEAR(kept[k].t, all[k].t, 1e-9 * (1.0 + all[k].t));
      met += !kept.empty();
    }
    EXPECT_GT(met, 200) << order;
  }
}

TEST(UnitAccelLightBuffer, ManySmallCastersAreACrowd) {
  Random random(9);
  std::vector<std::unique_ptr<Object>> objects;
  for (int i = 0; i < 20000; ++i) {
    objects.push_back(std::make_unique<Leaf>(
        std::make_unique<Sphere>(Vec3{random.in(-7, 7), random.in(-1, 1), random.in(-7, 7)}, 0.03),
        Transform()));
    objects.back()->set_opaque(true);
  }
  EXPECT_TRUE(LightBuffer({-20, 30, -25}, objects, 1e-3, 1024).crowded());
  EXPECT_FALSE(LightBuffer({-20, 30, -25}, objects, 1e-3, 60000).crowded());
}

}  // namespace
}  // namespace lentray::core
