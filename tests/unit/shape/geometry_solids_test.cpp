// What holds for every closed shape of the swept, implicit and revolved kinds: along any ray inside
// and outside alternate from hit to hit, normals cross the surface, bounds hold every hit.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "core/shape/blob.h"
#include "core/shape/height_field.h"
#include "core/shape/lathe.h"
#include "core/shape/poly.h"
#include "core/shape/prism.h"
#include "core/shape/superellipsoid.h"
#include "tests/unit/shape/geometry_help.h"

namespace lentray::core {
namespace {

using geometry_test::Random;
constexpr double kGeometrySolidsInf = Bounds::kInf;

struct Solid {
  const char* name;
  std::function<std::unique_ptr<Shape>()> make;
};

/// A five-pointed star with a round hole: lines, conics and cubics.
std::shared_ptr<const Outline> geometry_solids_star() {
  std::vector<Vec2> points;
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 == 0 ? 1.0 : 0.55, angle = 0.3 + i * 0.62831853071795862;
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  std::vector<CurvePiece> pieces;
  for (int i = 0; i < 10; ++i) pieces.push_back(CurvePiece::line(points[i], points[(i + 1) % 10]));
  const Vec2 a{0.3, 0.0}, b{-0.3, 0.0};
  pieces.push_back(CurvePiece::bezier(a, {0.3, 0.4}, {-0.3, 0.4}, b));
  pieces.push_back(CurvePiece::conic(b, {0.0, -0.5}, a));
  return std::make_shared<const Outline>(std::move(pieces));
}

/// (x2 + y2 + z2 + 0.84)2 - 4 (x2 + z2): a torus of the radii 1 and 0.4.
std::unique_ptr<Shape> quartic_torus() {
  std::vector<double> c(35, 0.0);
  const double k = 1.0 - 0.16;
  int next = 0;
  for (int x = 4; x >= 0; --x) {
    for (int y = 4 - x; y >= 0; --y) {
      for (int z = 4 - x - y; z >= 0; --z, ++next) {
        const int order = x + y + z;
        if (order == 4 && (x == 4 || y == 4 || z == 4)) c[next] = 1.0;
        if (order == 4 && x % 2 == 0 && y % 2 == 0 && z % 2 == 0 && c[next] == 0.0) c[next] = 2.0;
        if (order == 2 && (x == 2 || z == 2)) c[next] = 2.0 * k - 4.0;
        if (order == 2 && y == 2) c[next] = 2.0 * k;
        if (order == 0) c[next] = k * k;
      }
    }
  }
  return std::make_unique<Poly>("quartic", 4, c);
}

std::vector<Solid> geometry_solids_solids() {
  using Sweep = Prism::Sweep;
  return {
      {"prism",
       [] {
         return std::make_unique<Prism>("prism", geometry_solids_star(), Sweep::kAlongY, -0.6, 0.8,
                                        false);
       }},
      {"conic prism",
       [] {
         return std::make_unique<Prism>("prism", geometry_solids_star(), Sweep::kConic, 0.2, 1.1,
                                        false);
       }},
      {"conic prism below",
       [] {
         return std::make_unique<Prism>("prism", geometry_solids_star(), Sweep::kConic, -1.1, -0.2,
                                        false);
       }},
      {"text",
       [] {
         return std::make_unique<Prism>("text", geometry_solids_star(), Sweep::kAlongZ, 0.0, 0.7,
                                        false);
       }},
      {"superellipsoid", [] { return std::make_unique<Superellipsoid>(0.3, 0.6); }},
      {"round superellipsoid", [] { return std::make_unique<Superellipsoid>(1.0, 1.0); }},
      {"concave superellipsoid", [] { return std::make_unique<Superellipsoid>(2.7, 1.4); }},
      {"quartic", quartic_torus},
      {"blob",
       [] {
         BlobField ball{0.9, 1.0, 0.0, Transform::translation({0.3, 0.1, 0.0})};
         BlobField rod{0.7, 1.2, 1.1, Transform::rotation({20, 100, 0})};
         BlobField hole{0.5, -0.8, 0.0, Transform::scaling({1, 1.5, 1})};
         return std::make_unique<Blob>(0.35, std::vector<BlobField>{ball, rod, hole});
       }},
      {"lathe",
       [] {
         return std::make_unique<Lathe>(std::vector<CurvePiece>{
             CurvePiece::line({0.0, -0.9}, {0.7, -0.9}),
             CurvePiece::bezier({0.7, -0.9}, {0.9, 0.2}, {0.1, 0.3}, {0.5, 0.8}),
             CurvePiece::conic({0.5, 0.8}, {0.2, 1.0}, {0.0, 0.8})});
       }},
      {"lathe ring",
       [] {
         return std::make_unique<Lathe>(std::vector<CurvePiece>{
             CurvePiece::line({0.4, -0.5}, {0.9, -0.4}), CurvePiece::line({0.9, -0.4}, {0.6, 0.6}),
             CurvePiece::line({0.6, 0.6}, {0.4, -0.5})});
       }},
  };
}

class UnitCoreSolids : public ::testing::TestWithParam<std::size_t> {};

TEST_P(UnitCoreSolids, InsideAlternatesAndBoundsHold) {
  constexpr double kStart = 0.01;  // blobs are not hit before
  const Solid solid = geometry_solids_solids()[GetParam()];
  Random random(11);
  const auto shape = solid.make();
  const Bounds box = shape->bounds();
  int met = 0, odd = 0;
  for (int round = 0; round < 4000; ++round) {
    const Ray ray = random.ray(random.in(0.0, 6.0), 1.0);
    ShapeHits hits;
    shape->all(ray, kStart, kGeometrySolidsInf, hits);
    std::sort(hits.begin(), hits.end(), [](auto& a, auto& b) { return a.t < b.t; });
    ShapeHit first;
    ASSERT_EQ(shape->nearest(ray, kStart, kGeometrySolidsInf, first), !hits.empty()) << solid.name;
    if (!hits.empty()) {
      EXPECT_EQ(first.t, hits[0].t) << solid.name;
      ++met;
    }
    bool in = shape->inside(ray.at(kStart));
    double from = kStart;
    for (const ShapeHit& hit : hits) {
      const Vec3 p = ray.at(hit.t);
      EXPECT_TRUE(p.x >= box.lo.x - 1e-9 && p.y >= box.lo.y - 1e-9 && p.z >= box.lo.z - 1e-9 &&
                  p.x <= box.hi.x + 1e-9 && p.y <= box.hi.y + 1e-9 && p.z <= box.hi.z + 1e-9)
          << solid.name;
      if (hit.t - from > 1e-3) {
        EXPECT_EQ(shape->inside(ray.at(0.5 * (from + hit.t))), in) << solid.name << " " << round;
      }
      in = !in;
      from = hit.t;
    }
    odd += in;
  }
  EXPECT_EQ(odd, 0) << solid.name;
  EXPECT_GT(met, 400) << solid.name;
}

TEST_P(UnitCoreSolids, NormalsCrossTheSurface) {
  const Solid solid = geometry_solids_solids()[GetParam()];
  Random random(12);
  const auto shape = solid.make();
  int wrong = 0, met = 0;
  for (int round = 0; round < 2000; ++round) {
    const Ray ray = random.ray(4.0, 1.0);
    ShapeHit hit;
    if (!shape->nearest(ray, 0.0, kGeometrySolidsInf, hit)) continue;
    ++met;
    const Vec3 p = ray.at(hit.t), n = normalized(shape->normal(p, hit));
    wrong += shape->inside(p + n * 2e-4) == shape->inside(p - n * 2e-4);
  }
  // At edges both sides may be outside.
  EXPECT_LE(wrong, met / 100) << solid.name;
}

TEST_P(UnitCoreSolids, FarRaysMeetTheSame) {
  // A ray from 1e7 away is known to some 1e-9; silhouettes may differ by that.
  constexpr double kFar = 1e7;
  const Solid solid = geometry_solids_solids()[GetParam()];
  Random random(13);
  const auto shape = solid.make();
  int wrong = 0, met = 0;
  for (int round = 0; round < 2000; ++round) {
    const Ray ray = random.ray(4.0, 1.0);
    const Ray far{ray.origin - ray.direction * kFar, ray.direction};
    ShapeHits near_hits, far_hits;
    shape->all(ray, 0.0, kGeometrySolidsInf, near_hits);
    shape->all(far, 0.0, kGeometrySolidsInf, far_hits);
    ShapeHit a, b;
    const bool hit = shape->nearest(ray, 0.0, kGeometrySolidsInf, a);
    met += hit;
    wrong += near_hits.size() != far_hits.size() ||
             hit != shape->nearest(far, 0.0, kGeometrySolidsInf, b) ||
             (hit && std::fabs(b.t - kFar - a.t) > 1e-5);
  }
  EXPECT_GT(met, 200) << solid.name;
  EXPECT_LE(wrong, 2) << solid.name;
}

INSTANTIATE_TEST_SUITE_P(Each, UnitCoreSolids,
                         ::testing::Range(std::size_t{0}, geometry_solids_solids().size()));

TEST(UnitCoreOutline, PointsAtCornersAndOnEdgesCountOnce) {
  // A square whose corners lie exactly on the lines that are asked for.
  const Vec2 a{0, 0}, b{1, 0}, c{1, 1}, d{0, 1};
  const Outline square({CurvePiece::line(a, b), CurvePiece::line(b, c), CurvePiece::line(c, d),
                        CurvePiece::line(d, a)});
  const PlaneWay all;
  for (double v : {-0.5, 0.0, 0.25, 1.0, 1.5}) {
    int crossings = 0;
    square.crossings(0.0, 1.0, -v, all,
                     [&](std::uint32_t, double, const Vec2&) { return ++crossings > 0; });
    EXPECT_EQ(crossings % 2, 0) << v;
  }
  // Along a diagonal, through two corners.
  int crossings = 0;
  square.crossings(1.0, -1.0, 0.0, all,
                   [&](std::uint32_t, double, const Vec2&) { return ++crossings > 0; });
  EXPECT_EQ(crossings, 2);
  EXPECT_TRUE(square.contains(0.5, 0.5));
  EXPECT_FALSE(square.contains(1.5, 0.0));
  EXPECT_FALSE(square.contains(-0.5, 1.0));
}

TEST(UnitCoreHeightField, HitsLieOnItsTriangles) {
  std::vector<std::uint16_t> heights;
  Random random(3);
  for (int i = 0; i < 12 * 9; ++i)
    heights.push_back(static_cast<std::uint16_t>(random.in(0, 65535)));
  const auto grid = std::make_shared<const HeightGrid>(12, 9, heights, false);
  const HeightField field(grid, 0.0);
  int met = 0, wrong = 0;
  for (int round = 0; round < 3000; ++round) {
    const Vec3 from = random.vector(2.0) + Vec3(0.5);
    const Vec3 to{random.in(0, 1), random.in(0, 1), random.in(0, 1)};
    const Ray ray{from, normalized(to - from)};
    ShapeHits hits;
    field.all(ray, 1e-9, kGeometrySolidsInf, hits);
    ShapeHit first;
    ASSERT_EQ(field.nearest(ray, 1e-9, kGeometrySolidsInf, first), !hits.empty());
    for (const ShapeHit& hit : hits) {
      ++met;
      EXPECT_GE(hit.t, first.t);
      const Vec3 p = ray.at(hit.t);
      wrong += field.inside(p + Vec3{0, 1e-6, 0}) == field.inside(p - Vec3{0, 1e-6, 0});
    }
  }
  EXPECT_GT(met, 1000);
  EXPECT_LE(wrong, met / 500);  // triangles reach a ten-thousandth of a cell over their edges
}

/// Where the ray's line meets the plane of a triangle well within its edges, in grid space.
void geometry_solids_add_crossing(const std::array<Vec3, 3>& p, const Ray& ray,
                                  std::vector<double>& out) {
  constexpr double kWithin = 1e-3;
  const Vec3 along = p[1] - p[0], across = p[2] - p[0], n = cross(along, across);
  const double slope = dot(n, ray.direction);
  if (std::fabs(slope) < 1e-6 * length(n) * length(ray.direction)) return;
  const double t = dot(p[0] - ray.origin, n) / slope;
  const Vec3 at = ray.at(t) - p[0];
  const double u = dot(cross(at, across), n) / dot(n, n), v = dot(cross(along, at), n) / dot(n, n);
  if (t > 1e-6 && u > kWithin && v > kWithin && u + v < 1.0 - kWithin) out.push_back(t);
}

// Blocks of cells that a ray passes by are left out: every triangle is met all the same, of gentle, of rough and of
// stepped fields.
TEST(UnitCoreHeightField, BlocksLeaveNothingOut) {
  Random random(7);
  for (int kind = 0; kind < 3; ++kind) {
    constexpr int kWidth = 61, kDepth = 47;
    std::vector<std::uint16_t> heights;
    for (int z = 0; z < kDepth; ++z) {
      for (int x = 0; x < kWidth; ++x) {
        const double wave = 30000 + 20000 * std::sin(x * 0.13) * std::cos(z * 0.11);
        heights.push_back(static_cast<std::uint16_t>(kind == 0 ? wave
                                                     : kind == 1
                                                         ? random.in(0, 65535)
                                                         : (x / 9 + z / 7) % 3 * 20000 + 100));
      }
    }
    const HeightField field(std::make_shared<const HeightGrid>(kWidth, kDepth, heights, false),
                            0.0);
    const auto corner = [&](int x, int z) {
      return Vec3{x / (kWidth - 1.0), heights[static_cast<std::size_t>(z * kWidth + x)] / 65536.0,
                  z / (kDepth - 1.0)};
    };
    std::size_t met = 0, missed = 0, different = 0;
    for (int round = 0; round < 600; ++round) {
      const Vec3 to{random.in(0, 1), random.in(0, 1), random.in(0, 1)};
      Vec3 from = round % 7 == 0 ? to + random.vector(1e3) : random.vector(2.0) + Vec3(0.5);
      if (round % 5 == 0) from[round % 3] = to[round % 3];
      if (round % 11 == 0) from[(round + 1) % 3] = to[(round + 1) % 3];
      const Ray ray{from, normalized(to - from)};
      std::vector<double> expected;
      for (int z = 0; z + 1 < kDepth; ++z) {
        for (int x = 0; x + 1 < kWidth; ++x) {
          const Vec3 a = corner(x, z), b = corner(x + 1, z), c = corner(x, z + 1),
                     d = corner(x + 1, z + 1);
          geometry_solids_add_crossing({a, b, c}, ray, expected);
          geometry_solids_add_crossing({d, c, b}, ray, expected);
        }
      }
      ShapeHits hits;
      field.all(ray, 1e-9, kGeometrySolidsInf, hits);
      met += expected.size();
      for (const double t : expected) {
        missed += std::none_of(hits.begin(), hits.end(), [&](const ShapeHit& hit) {
          return std::fabs(hit.t - t) < 1e-6 * (1.0 + t);
        });
      }
      ShapeHit first;
      const bool is_met = field.nearest(ray, 1e-9, kGeometrySolidsInf, first);
      different +=
          is_met != !hits.empty() || field.any(ray, 1e-9, kGeometrySolidsInf) != !hits.empty();
      for (const ShapeHit& hit : hits) different += hit.t < first.t;
      if (!is_met) continue;
      const double t_max = first.t * random.in(0.5, 1.5);
      different += field.any(ray, 0.2 * first.t, t_max) !=
                   std::any_of(hits.begin(), hits.end(), [&](const ShapeHit& hit) {
                     return hit.t > 0.2 * first.t && hit.t < t_max;
                   });
    }
    EXPECT_GT(met, 500u);
    EXPECT_EQ(missed, 0u) << kind;
    EXPECT_EQ(different, 0u) << kind;
  }
}

}  // namespace
}  // namespace lentray::core
