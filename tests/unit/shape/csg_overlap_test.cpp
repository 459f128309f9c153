// Intersections of many convex parts tell what they keep by where a ray enters and leaves the parts:
// the answers are those of asking every part for every crossing.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "core/object/csg.h"
#include "core/object/leaf.h"
#include "core/shape/box.h"
#include "core/shape/prism.h"
#include "core/shape/sphere.h"
#include "tests/unit/shape/plain_shapes.h"

namespace lentray::test {
namespace {

using namespace lentray::core;

std::unique_ptr<Shape> overlap_prism() {
  const Vec2 corners[] = {{-2, 0}, {1, 0}, {1, 1}, {-2, 1}};
  std::vector<CurvePiece> pieces;
  for (int i = 0; i < 4; ++i) pieces.push_back(CurvePiece::line(corners[i], corners[(i + 1) % 4]));
  return std::make_unique<Prism>("prism", std::make_shared<const Outline>(std::move(pieces)),
                                 Prism::Sweep::kAlongZ, -2.0, 2.0, false);
}

/// A column of twelve sides, cut by two balls and a turned box. No two surfaces lie in one another: which of
/// them is met there would be a matter of rounding.
std::unique_ptr<Csg> overlap_column(CsgKind kind, bool inverse_parts) {
  std::vector<std::unique_ptr<Object>> parts;
  const auto add = [&](std::unique_ptr<Shape> shape, const Transform& t) {
    parts.push_back(std::make_unique<Leaf>(std::move(shape), t));
    parts.back()->set_inverse(inverse_parts);
  };
  for (int i = 0; i < 12; ++i) {
    add(overlap_prism(), Transform::translation({0, -1e-3 * i, 0})
                             .then(Transform::scaling(Vec3(1.0 + 3e-3 * i)))
                             .then(Transform::rotation({0, 30.0 * i, 0})));
  }
  add(std::make_unique<Sphere>(Vec3{0.2, 0.5, 0}, 1.0), Transform());
  add(std::make_unique<Sphere>(Vec3{-0.1, 0.4, 0.3}, 1.1), Transform());
  add(std::make_unique<Box>(Vec3{-0.8, -0.8, -0.8}, Vec3{0.9, 0.9, 0.9}),
      Transform::rotation({20, 10, 40}));
  auto column = std::make_unique<Csg>(kind, std::move(parts));
  complete(*column);
  return column;
}

template <class Asked>
std::vector<double> sorted_distances(const Asked& object, const Ray& ray, HitLists& lists) {
  std::vector<Hit> hits;
  object.all(ray, 1e-6, 100.0, hits, {lists, RayKind::kShadow});
  std::vector<double> t;
  for (const Hit& hit : hits) t.push_back(hit.t);
  std::sort(t.begin(), t.end());
  return t;
}

void expect_overlap_answers(CsgKind kind, bool inverse_parts) {
  const auto quick = overlap_column(kind, inverse_parts);
  const auto parts = overlap_column(kind, inverse_parts);
  const PlainObject plain(*parts);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-3.0, 3.0), part(-0.7, 0.7);
  HitLists lists;
  int met = 0, from_inside = 0;
  for (int i = 0; i < 1500; ++i) {
    const bool inside = i % 4 == 0;
    const Vec3 from = inside ? Vec3{part(random), 0.5 + part(random), part(random)}
                             : Vec3{place(random), place(random), place(random)};
    const Vec3 to{part(random), 0.5 + part(random), part(random)};
    const Ray ray{from, to - from};
    const double limit = i % 3 == 0 ? 1.0 : 100.0;
    Hit a, b;
    const bool found = quick->nearest(ray, 1e-6, limit, a, {lists, RayKind::kShadow});
    ASSERT_EQ(found, plain.nearest(ray, 1e-6, limit, b, {lists, RayKind::kShadow})) << i;
    ASSERT_EQ(found, quick->any(ray, 1e-6, limit, {lists, RayKind::kShadow})) << i;
    if (found) {
      ASSERT_EQ(a.t, b.t) << i;
      ASSERT_EQ(a.shape.element, b.shape.element) << i;
      ++met;
      if (quick->inside(from)) ++from_inside;
    }
    ASSERT_EQ(sorted_distances(*quick, ray, lists), sorted_distances(plain, ray, lists)) << i;
  }
  EXPECT_GT(met, 400);
  if (!inverse_parts) {
    EXPECT_GT(from_inside, 40);
  }
}

TEST(UnitCsgOverlap, AnIntersectionOfManyConvexPartsKeepsItsCrossings) {
  expect_overlap_answers(CsgKind::kIntersection, false);
}

TEST(UnitCsgOverlap, SoDoesAMergeOfInverseParts) { expect_overlap_answers(CsgKind::kMerge, true); }

TEST(UnitCsgOverlap, OutlinesKnowWhetherTheyAreConvex) {
  const auto is_convex = [](std::vector<Vec2> corners) {
    std::vector<CurvePiece> pieces;
    for (std::size_t i = 0; i < corners.size(); ++i)
      pieces.push_back(CurvePiece::line(corners[i], corners[(i + 1) % corners.size()]));
    return Outline(pieces).is_convex();
  };
  EXPECT_TRUE(is_convex({{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
  EXPECT_TRUE(is_convex({{0, 0}, {1, 0}, {2, 0}, {1, 2}}));
  EXPECT_TRUE(is_convex({{0, 1}, {2, 1}, {2, 0}, {0, 0}}));
  EXPECT_FALSE(is_convex({{0, 0}, {2, 0}, {1, 0.5}, {2, 1}, {0, 1}}));
  EXPECT_FALSE(is_convex({{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}));  // a star turns one way
  Outline round({CurvePiece::conic({0, 0}, {2, 0}, {2, 2}), CurvePiece::line({2, 2}, {0, 0})});
  EXPECT_FALSE(round.is_convex());
}

}  // namespace
}  // namespace lentray::test
