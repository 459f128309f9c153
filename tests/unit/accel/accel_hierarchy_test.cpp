#include "core/accel/hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>
#include <string>
#include <vector>

#include "core/object/leaf.h"
#include "core/shape/box.h"
#include "core/shape/cylinder.h"
#include "core/shape/packs.h"
#include "core/shape/plane.h"
#include "core/shape/polygon.h"
#include "core/shape/sphere.h"
#include "core/shape/triangle.h"
#include "tests/unit/shape/random_objects.h"

using namespace lentray::core;
using namespace lentray::test;

namespace {

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

class UnitCoreHierarchy : public ::testing::TestWithParam<TestScene> {};

void expect_same(const Hierarchy& list, const Hierarchy& tree, const Ray& ray, double t_min,
                 double t_max, HitLists& lists, int& found) {
  for (const RayKind kind :
       {RayKind::kCamera, RayKind::kTransmitted, RayKind::kReflection, RayKind::kShadow}) {
    Hit a, b;
    const bool hit = list.nearest(ray, t_min, t_max, kind, a, lists, nullptr);
    ASSERT_EQ(tree.nearest(ray, t_min, t_max, kind, b, lists, nullptr), hit);
    if (!hit) continue;
    ++found;
    ASSERT_TRUE(same_bits(a.t, b.t)) << a.t << " " << b.t;
    ASSERT_EQ(a.object, b.object);
    ASSERT_EQ(a.leaf, b.leaf);
    ASSERT_EQ(a.shape.element, b.shape.element);
    ASSERT_TRUE(same_bits(a.shape.t, b.shape.t) && same_bits(a.shape.u, b.shape.u) &&
                same_bits(a.shape.v, b.shape.v));
  }
  const Object* blocker = tree.any_opaque(ray, t_min, t_max, lists, nullptr);
  ASSERT_EQ(list.any_opaque(ray, t_min, t_max, lists, nullptr) != nullptr, blocker != nullptr);
  if (blocker) {
    ASSERT_TRUE(blocker->is_opaque());
    ASSERT_FALSE(blocker->attributes().no_shadow);
    ASSERT_TRUE(blocker->any(ray, t_min, t_max, {lists, RayKind::kShadow}));
  }
  std::vector<Hit> all_list, all_tree;
  list.all_transparent(ray, t_min, t_max, false, all_list, lists, nullptr);
  tree.all_transparent(ray, t_min, t_max, false, all_tree, lists, nullptr);
  const auto before = [](const Hit& x, const Hit& y) {
    return x.t != y.t ? x.t < y.t : std::less<>()(x.object, y.object);
  };
  std::sort(all_list.begin(), all_list.end(), before);
  std::sort(all_tree.begin(), all_tree.end(), before);
  ASSERT_EQ(all_list.size(), all_tree.size());
  for (std::size_t i = 0; i < all_list.size(); ++i) {
    ASSERT_TRUE(same_bits(all_list[i].t, all_tree[i].t));
    ASSERT_EQ(all_list[i].object, all_tree[i].object);
    ASSERT_FALSE(all_list[i].object->is_opaque());
  }
}

TEST_P(UnitCoreHierarchy, AnswersAsThePlainListDoes) {
  const TestScene& setup = GetParam();
  SceneMaker make(setup);
  const Objects objects = make.objects(150);
  const Hierarchy list(objects, Accelerator::kList), tree(objects),
      portable(objects, Accelerator::kBvh, true), grid(objects, Accelerator::kGrid);
  HitLists lists;
  int found = 0;
  constexpr int kRays = 10000;
  for (int i = 0; i < kRays; ++i) {
    const Ray ray = make.ray();
    const double way = length(ray.direction);
    const double t_min = i % 4 == 0 ? 1e-4 * setup.detail / way : 0.0;
    const double t_max = i % 4 == 1 ? setup.scale * make.unit() / way : Bounds::kInf;
    SCOPED_TRACE("ray " + std::to_string(i));
    expect_same(list, tree, ray, t_min, t_max, lists, found);
    if (HasFatalFailure()) return;
    expect_same(list, grid, ray, t_min, t_max, lists, found);
    if (HasFatalFailure()) return;
    if (i % 4 == 0) expect_same(list, portable, ray, t_min, t_max, lists, found);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(found, kRays / 20);  // the scene is not missed
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, UnitCoreHierarchy,
    ::testing::Values(TestScene{"Plain", 10, 2, {}, 20, false, false},
                      TestScene{"Flags", 10, 2, {}, 20, true, true},
                      TestScene{"Infinite", 10, 2, {}, 20, false, true},
                      TestScene{"Tiny", 1e-6, 2e-7, {}, 2e-6, true, false},
                      TestScene{"Huge", 1e7, 2e6, {}, 2e7, true, false},
                      TestScene{"FarFromOrigin", 10, 2, {1e7, 1e6, -1e7}, 20, true, false},
                      TestScene{"SeenFromFar", 10, 2, {}, 1e5, true, false}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(UnitCoreHierarchyRules, EqualDistancesGoToTheObjectFirstInTheScene) {
  // The same sphere many times among others of another kind that touch the same point.
  for (int swap = 0; swap < 2; ++swap) {
    Objects objects;
    for (int i = 0; i < 40; ++i) {
      std::unique_ptr<Shape> shape;
      if ((i + swap) % 2 == 0) {
        shape = std::make_unique<Sphere>(Vec3{0, 0, 5}, 1);
      } else {
        shape = std::make_unique<Box>(Vec3{-1, -1, 4}, Vec3{1, 1, 6});
      }
      objects.push_back(std::make_unique<Leaf>(std::move(shape), Transform()));
    }
    for (const bool portable : {false, true}) {
      const Hierarchy tree(objects, Accelerator::kBvh, portable);
      HitLists lists;
      Hit hit;
      ASSERT_TRUE(
          tree.nearest({{0, 0, 0}, {0, 0, 1}}, 0, 100, RayKind::kCamera, hit, lists, nullptr));
      EXPECT_EQ(hit.t, 4.0);
      EXPECT_EQ(hit.object, objects.front().get());
      // The limit itself is not reached.
      EXPECT_FALSE(
          tree.nearest({{0, 0, 0}, {0, 0, 1}}, 0, 4.0, RayKind::kCamera, hit, lists, nullptr));
      for (auto& o : objects) o->set_opaque(true);
      const Hierarchy opaque(objects, Accelerator::kBvh, portable);
      EXPECT_EQ(opaque.any_opaque({{0, 0, 0}, {0, 0, 1}}, 0, 4.0, lists, nullptr), nullptr);
      EXPECT_NE(opaque.any_opaque({{0, 0, 0}, {0, 0, 1}}, 0, 4.1, lists, nullptr), nullptr);
      EXPECT_NE(opaque.any_opaque({{0, 0, 0}, {0, 0, 1}}, 4.0, 6.1, lists, nullptr), nullptr);
    }
  }
}

TEST(UnitCoreHierarchyRules, CountsBoxesAndTestsByType) {
  Objects objects;
  for (int i = 0; i < 30; ++i) {
    objects.push_back(
        std::make_unique<Leaf>(std::make_unique<Sphere>(Vec3{i * 3.0, 0, 0}, 1), Transform()));
  }
  objects.push_back(
      std::make_unique<Leaf>(std::make_unique<Plane>(Vec3{0, 1, 0}, -2), Transform()));
  const Hierarchy tree(objects), list(objects, Accelerator::kList);
  HitLists lists;
  Hit hit;
  Counters counted, in_list;
  const Ray ray{{0, 5, 0}, {0, -1, 0}};
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(tree.nearest(ray, 0, 100, RayKind::kCamera, hit, lists, &counted));
  }
  ASSERT_TRUE(list.nearest(ray, 0, 100, RayKind::kCamera, hit, lists, &in_list));
  EXPECT_EQ(counted.tests_by_type.at("plane"), 2u);
  EXPECT_GE(counted.tests_by_type.at("sphere"), 2u);
  EXPECT_LE(counted.tests_by_type.at("sphere"), 2u * 4);
  EXPECT_EQ(counted.primitive_tests,
            counted.tests_by_type.at("plane") + counted.tests_by_type.at("sphere"));
  EXPECT_GE(counted.bounds_tests, 2u * 2);
  EXPECT_LT(counted.bounds_tests, 2u * 30);
  EXPECT_EQ(in_list.bounds_tests, 30u);  // each object's own
  EXPECT_EQ(in_list.tests_by_type.at("sphere"), 1u);
  EXPECT_EQ(in_list.tests_by_type.at("plane"), 1u);
}

/// Bare planes are asked without their objects, clipped ones as other infinite objects.
TEST(UnitCoreHierarchyRules, PlanesTieAndEndAsOtherObjectsDo) {
  const auto plane = [](double side, bool clipped) {
    const auto leaf_of = [](const Vec3& normal, double distance) {
      return std::make_unique<Leaf>(std::make_unique<Plane>(normal, distance), Transform());
    };
    auto leaf = leaf_of({0, side, 0}, -2 * side);
    if (clipped) leaf->set_clips({leaf_of({1, 0, 0}, 9)});
    leaf->set_opaque(true);
    return leaf;
  };
  for (const auto accelerator : {Accelerator::kBvh, Accelerator::kGrid, Accelerator::kList}) {
    for (const bool clipped_first : {false, true}) {
      Objects objects;
      objects.push_back(plane(1, clipped_first));
      objects.push_back(plane(-1, !clipped_first));
      objects.push_back(plane(-1, false));
      objects.push_back(plane(-1, true));
      const Hierarchy tree(objects, accelerator);
      HitLists lists;
      Hit hit;
      const Ray down{{0, 0, 0}, {0, -1, 0}};
      ASSERT_TRUE(tree.nearest(down, 0, 3, RayKind::kCamera, hit, lists, nullptr));
      EXPECT_EQ(hit.t, 2.0);
      EXPECT_EQ(hit.object, objects.front().get());
      EXPECT_EQ(hit.leaf, objects.front().get());
      EXPECT_FALSE(tree.nearest(down, 0, 2, RayKind::kCamera, hit, lists, nullptr));
      EXPECT_FALSE(tree.nearest(down, 2, 9, RayKind::kCamera, hit, lists, nullptr));
      const Ray along{{0, 0, 0}, {1, 0, 0}};
      EXPECT_FALSE(tree.nearest(along, 0, Bounds::kInf, RayKind::kCamera, hit, lists, nullptr));
      EXPECT_EQ(tree.any_opaque(down, 0, 2, lists, nullptr), nullptr);
      EXPECT_NE(tree.any_opaque(down, 0, 2.1, lists, nullptr), nullptr);
    }
  }
}

TEST(UnitCoreHierarchyRules, AGridWalksAlongTheRay) {
  Objects objects;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 place{i % 10 * 3.0, i / 10 % 10 * 3.0, i / 100 * 3.0};
    objects.push_back(std::make_unique<Leaf>(std::make_unique<Sphere>(place, 1), Transform()));
  }
  const Hierarchy grid(objects, Accelerator::kGrid), list(objects, Accelerator::kList);
  EXPECT_GT(grid.statistics().cells, 1000u);
  EXPECT_EQ(list.statistics().cells, 0u);
  HitLists lists;
  Hit hit;
  Counters through, beside, all;
  ASSERT_TRUE(
      grid.nearest({{-5, 3, 3}, {1, 0, 0}}, 0, 100, RayKind::kCamera, hit, lists, &through));
  EXPECT_EQ(hit.t, 4.0);
  EXPECT_LT(through.bounds_tests, 20u);  // it ends in the cell of the hit
  ASSERT_FALSE(
      grid.nearest({{-5, 4.5, 4.5}, {1, 0, 0}}, 0, 100, RayKind::kCamera, hit, lists, &beside));
  EXPECT_GT(beside.bounds_tests, through.bounds_tests);
  EXPECT_LT(beside.bounds_tests, 200u);
  ASSERT_FALSE(
      list.nearest({{-5, 4.5, 4.5}, {1, 0, 0}}, 0, 100, RayKind::kCamera, hit, lists, &all));
  EXPECT_EQ(all.bounds_tests, 1000u);
}

TEST(UnitCoreHierarchyRules, StatisticsTellTheParts) {
  Objects objects;
  objects.push_back(std::make_unique<Leaf>(std::make_unique<Sphere>(Vec3{}, 1), Transform()));
  objects.push_back(
      std::make_unique<Leaf>(std::make_unique<Plane>(Vec3{0.3, 1, 0.1}, -2), Transform()));
  const Hierarchy tree(objects);
  EXPECT_EQ(tree.statistics().objects, 2u);
  EXPECT_EQ(tree.statistics().infinite, 1u);
  EXPECT_EQ(tree.statistics().nodes, 1u);
  EXPECT_GT(tree.memory(), sizeof(WideNode));
}

/// The tests of packs are inlined, which the caller's instruction set must allow.
template <class Pack>
LENTRAY_AVX2 unsigned met_with_avx2(const Pack& pack, const PackRay& ray, double t_min,
                                    double t_max, PackHits& hits) {
  return intersect_avx2(pack, ray, t_min, t_max, hits);
}

/// Packs against the scalar formulae, bit for bit, over 12 orders of magnitude.
class UnitCorePacks : public ::testing::Test {
 protected:
  double wide() { return (2 * unit() - 1) * std::exp2(40 * unit() - 20); }
  double unit() { return std::uniform_real_distribution<double>(0, 1)(m_random); }
  Vec3 vector() { return {wide(), wide(), wide()}; }
  Ray ray_towards(const Vec3& p) {
    const Vec3 from = vector();
    Vec3 d = p - from;
    if (unit() < 0.2) d = normalized(d);
    if (unit() < 0.2) d.y = 0.0;
    return {from, d};
  }
  template <class Pack>
  void compare(const Pack& pack, const Ray& ray, int& found) {
    const PackRay packed(ray, true);
    const double t_min = unit() < 0.5 ? 0.0 : wide(), t_max = unit() < 0.5 ? 1e300 : 1.0;
    PackHits a, b;
    const unsigned mask = intersect_portable(pack, packed, t_min, t_max, a);
    ASSERT_EQ(met_with_avx2(pack, packed, t_min, t_max, b), mask);
    for (int i = 0; i < kPack; ++i) {
      if ((mask >> i & 1) == 0) continue;
      ++found;
      ASSERT_TRUE(same_bits(a.t[i], b.t[i]) && same_bits(a.u[i], b.u[i]) &&
                  same_bits(a.v[i], b.v[i]));
    }
  }

 private:
  std::mt19937_64 m_random{4};
};

TEST_F(UnitCorePacks, SpheresHaveTheBitsOfTheFormula) {
  if (!can_run_avx2()) GTEST_SKIP() << "needs AVX2";
  int found = 0;
  for (int n = 0; n < 100000; ++n) {
    SpherePack pack;
    for (int i = 0; i < kPack - n % 2; ++i) {
      for (auto& axis : pack.centre) axis[i] = wide();
      const double r = std::fabs(wide());
      pack.radius2[i] = r * r;
    }
    compare(pack, ray_towards({pack.centre[0][0], pack.centre[1][0], pack.centre[2][0]}), found);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(found, 50000);
}

TEST_F(UnitCorePacks, TrianglesHaveTheBitsOfTheFormula) {
  if (!can_run_avx2()) GTEST_SKIP() << "needs AVX2";
  int found = 0;
  for (int n = 0; n < 100000; ++n) {
    TrianglePack pack;
    for (int i = 0; i < kPack - n % 2; ++i) {
      for (auto& corner : pack.corner) {
        for (auto& axis : corner) axis[i] = wide();
      }
    }
    Vec3 middle;
    const double edge = unit() < 0.3 ? 0.0 : 1.0;  // through a corner or an edge at times
    for (int a = 0; a < 3; ++a) {
      const auto& c = pack.corner;
      middle[a] = c[0][a][0] + edge * (c[1][a][0] - c[0][a][0]) * 0.5 +
                  edge * (c[2][a][0] - c[0][a][0]) * (n % 3 == 0 ? 0.5 : 0.25);
    }
    compare(pack, ray_towards(middle), found);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(found, 50000);
}

TEST_F(UnitCorePacks, PolygonsHaveTheBitsOfTheShape) {
  int found = 0, edge = 0;
  for (int n = 0; n < 50000; ++n) {
    PolygonPack pack;
    std::vector<Polygon> polygons;
    for (int i = 0; i < kPack - n % 2; ++i) {
      // A parallelogram or a triangle; on the lattice at times, where rays meet edges exactly.
      const bool lattice = n % 4 == 0;
      const auto corner = [&] {
        return lattice ? Vec3{std::floor(unit() * 5), std::floor(unit() * 5), 1.0 + n % 3}
                       : vector();
      };
      const Vec3 a = corner(), b = corner(), c = corner();
      polygons.push_back(unit() < 0.5 ? Polygon({a, b, c, a}) : Polygon({a, b, b + (c - a), c, a}));
      if (polygons.back().is_degenerate()) {
        polygons.pop_back();
        break;
      }
      ASSERT_TRUE(PolygonPack::fits(polygons.back()));
      pack.set(i, polygons.back());
    }
    if (polygons.empty()) continue;
    const auto& p = polygons[0].points();
    const double s = unit(), w = unit() * (1 - s);
    Ray ray = ray_towards(p[0] + (p[1] - p[0]) * s + (p[2] - p[0]) * w);
    if (n % 4 == 0) ray = {{std::floor(unit() * 5), std::floor(unit() * 5), -1}, {0, 0, 1}};
    edge += n % 4 == 0;
    const PackRay packed(ray, false);
    const double t_min = unit() < 0.5 ? 0.0 : wide(), t_max = unit() < 0.5 ? 1e300 : 1.5;
    PackHits portable, avx2;
    const unsigned mask = intersect_portable(pack, packed, t_min, t_max, portable);
    if (can_run_avx2()) {
      ASSERT_EQ(met_with_avx2(pack, packed, t_min, t_max, avx2), mask);
    }
    for (int i = 0; i < kPack; ++i) {
      ShapeHit hit;
      const bool met = static_cast<std::size_t>(i) < polygons.size() &&
                       polygons[static_cast<std::size_t>(i)].nearest(ray, t_min, t_max, hit);
      ASSERT_EQ((mask >> i & 1) != 0, met) << n;
      if (!met) continue;
      ++found;
      ASSERT_TRUE(same_bits(portable.t[i], hit.t));
      if (can_run_avx2()) {
        ASSERT_TRUE(same_bits(avx2.t[i], hit.t));
      }
    }
  }
  EXPECT_GT(found, 10000);
  EXPECT_GT(edge, 1000);
}

}  // namespace
