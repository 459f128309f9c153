#include "core/bvh/wide_bvh.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>
#include <vector>

using namespace lentray::core;

namespace {

/// Collects the parts whose leaves a traversal visits.
struct Visited {
  const WideBvh& bvh;
  std::set<std::uint32_t> parts;
  bool operator()(std::uint32_t code, double&) {
    const std::uint32_t first = WideBvh::first_of(code);
    for (std::uint32_t i = 0; i < WideBvh::count_of(code); ++i) {
      parts.insert(bvh.order()[first + i]);
    }
    return false;
  }
};

struct TestBoxes {
  const char* name;
  double scale;   ///< of the boxes' places
  double detail;  ///< of their sizes
  Vec3 offset;
  double far;             ///< distance of the rays' starts
  double outliers = 1.0;  ///< one box in 30 is so many times farther away
};

class UnitCoreWideBvh : public ::testing::TestWithParam<TestBoxes> {};

class Maker {
 public:
  explicit Maker(const TestBoxes& setup) : m_setup(setup) {}
  Bounds box() {
    const double scale = ++m_boxes % 30 == 0 ? m_setup.scale * m_setup.outliers : m_setup.scale;
    const Vec3 c = m_setup.offset + point() * scale;
    Vec3 size = Vec3{unit(), unit(), unit()} * m_setup.detail;
    if (integer(4) == 0) size[integer(3)] = 0.0;  // flat
    if (integer(8) == 0) size = {};
    return {c, c + size};
  }
  /// A point of the box: within, or on a side, an edge or a corner.
  Vec3 point_of(const Bounds& b) {
    Vec3 p;
    for (int a = 0; a < 3; ++a) {
      const int where = integer(4);
      p[a] = where == 0   ? b.lo[a]
             : where == 1 ? b.hi[a]
                          : std::clamp(b.lo[a] + unit() * (b.hi[a] - b.lo[a]), b.lo[a], b.hi[a]);
    }
    return p;
  }
  /// A ray through the point, as exactly as doubles allow; along an axis or in a plane at times.
  Ray ray_through(const Vec3& p) {
    Vec3 d = point();
    const int kind = integer(6);
    if (kind < 3) d[kind] = 0.0;
    if (kind == 3) {
      d = {};
      d[integer(3)] = integer(2) ? 1.0 : -1.0;
    }
    const double far = m_setup.far * unit();
    const Vec3 origin = p - d * far;
    const double stretch = std::exp2(integer(41) - 20);  // directions need not be unit
    return {origin, kind < 4 ? d * stretch : (p - origin) * stretch};
  }
  double unit() { return std::uniform_real_distribution<double>(0, 1)(m_random); }
  Vec3 point() { return {2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1}; }
  int integer(int below) { return std::uniform_int_distribution<int>(0, below - 1)(m_random); }

 private:
  const TestBoxes& m_setup;
  int m_boxes = 0;
  std::mt19937_64 m_random{12345};
};

TEST_P(UnitCoreWideBvh, NoBoxThatARayMeetsIsLost) {
  Maker make(GetParam());
  std::vector<Bounds> boxes(300);
  for (Bounds& b : boxes) b = make.box();
  const WideBvh bvh(boxes);
  ASSERT_EQ(bvh.order().size(), boxes.size());
  std::size_t visited = 0;
  constexpr int kRays = 100000;
  for (int i = 0; i < kRays; ++i) {
    const auto target = static_cast<std::uint32_t>(make.integer(static_cast<int>(boxes.size())));
    const Vec3 p = make.point_of(boxes[target]);
    const Ray ray = make.ray_through(p);
    // Where the point lies along the ray; both limits as near as rounding allows.
    const double t = dot(p - ray.origin, ray.direction) / dot(ray.direction, ray.direction);
    const bool nearby = i % 2 == 0;
    const double t_min = nearby ? t : -Bounds::kInf, t_max = nearby ? t : Bounds::kInf;
    CountNothing nothing;
    Visited portable{bvh, {}};
    bvh.traverse_portable(ray, t_min, t_max, portable, nothing);
    ASSERT_TRUE(portable.parts.count(target)) << "portable, ray " << i;
    if (can_run_avx2()) {
      Visited ordered{bvh, {}}, any{bvh, {}};
      bvh.traverse_avx2<true>(ray, t_min, t_max, ordered, nothing);
      ASSERT_TRUE(ordered.parts.count(target)) << "AVX2, ray " << i;
      bvh.traverse_avx2<false>(ray, t_min, t_max, any, nothing);
      ASSERT_EQ(any.parts, ordered.parts);
    }
    visited += portable.parts.size();
  }
  // It must also leave most boxes out, or the test would prove nothing.
  EXPECT_LT(static_cast<double>(visited) / kRays, 0.5 * static_cast<double>(boxes.size()));
}

INSTANTIATE_TEST_SUITE_P(
    Scales, UnitCoreWideBvh,
    ::testing::Values(TestBoxes{"Plain", 10.0, 1.0, {}, 30.0},
                      TestBoxes{"Tiny", 1e-6, 1e-7, {}, 1e-5}, TestBoxes{"Huge", 1e7, 1e5, {}, 1e8},
                      TestBoxes{"DetailsOfOneAtTenMillion", 1e7, 1.0, {}, 1e7},
                      TestBoxes{"SmallAndFarFromOrigin", 10.0, 1.0, {1e7, -1e7, 5e6}, 30.0},
                      TestBoxes{"SeenFromFar", 10.0, 1.0, {}, 1e7},
                      TestBoxes{"TinyFromVeryFar", 1e-3, 1e-4, {1, 2, 3}, 1e5},
                      TestBoxes{"WideRange", 1e6, 1e-2, {}, 1e3},
                      TestBoxes{"SomeFar", 10.0, 1.0, {}, 30.0, 1e6},
                      TestBoxes{"SomeFarSeenFromBetween", 10.0, 1.0, {}, 1e5, 1e6},
                      TestBoxes{"SomeVeryFar", 10.0, 1.0, {3, 2, 1}, 30.0, 1e11}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(UnitCoreWideBvhShape, RaysInThePlanesOfFlatBoxesMeetThem) {
  // Everything on a lattice about the origin, where relative roundings are nothing.
  std::vector<Bounds> boxes;
  for (int x = -4; x < 4; ++x) {
    for (int y = -4; y < 4; ++y) {
      boxes.push_back({{x * 1.0, y * 1.0, 0}, {x + 1.0, y + 1.0, 0}});
      boxes.push_back({{x * 1.0, 0, y * 1.0}, {x + 1.0, 0, y + 1.0}});
    }
  }
  const WideBvh bvh(boxes);
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 81; ++i) {
      Ray ray;
      ray.origin[axis] = -9;
      ray.origin[(axis + 1) % 3] = i % 9 - 4;
      ray.origin[(axis + 2) % 3] = i / 9 - 4;
      ray.direction[axis] = i % 2 ? 1.0 : 1e-9;
      Visited portable{bvh, {}}, avx2{bvh, {}};
      CountNothing nothing;
      bvh.traverse_portable(ray, 0, Bounds::kInf, portable, nothing);
      if (can_run_avx2()) bvh.traverse_avx2<true>(ray, 0, Bounds::kInf, avx2, nothing);
      for (std::uint32_t b = 0; b < boxes.size(); ++b) {
        Bounds line{ray.origin, ray.origin};
        line.lo[axis] = -9;
        line.hi[axis] = 9;
        line.intersect(boxes[b]);
        if (line.is_empty()) continue;
        ASSERT_TRUE(portable.parts.count(b)) << axis << ' ' << i << ' ' << b;
        if (can_run_avx2()) {
          ASSERT_TRUE(avx2.parts.count(b)) << axis << ' ' << i;
        }
      }
    }
  }
}

TEST(UnitCoreWideBvhShape, RaysFromAfarMeetTheCornersOfFlatBoxes) {
  std::vector<Bounds> boxes;
  for (int x = -4; x < 4; ++x) {
    for (int y = -4; y < 4; ++y) boxes.push_back({{x * 1.0, y * 1.0, 0}, {x + 1.0, y + 1.0, 0}});
  }
  const WideBvh bvh(boxes);
  const TestBoxes far{"", 1, 1, {}, 1e7};
  Maker make(far);
  for (int i = 0; i < 20000; ++i) {
    const auto target = static_cast<std::uint32_t>(make.integer(64));
    const Bounds& b = boxes[target];
    const Vec3 p{make.integer(2) ? b.lo.x : b.hi.x, make.integer(2) ? b.lo.y : b.hi.y, 0.0};
    const Vec3 origin = make.point() * 1e7;
    const Ray ray{origin, normalized(p - origin)};
    const double t = length(p - origin);
    Visited portable{bvh, {}}, avx2{bvh, {}};
    CountNothing nothing;
    bvh.traverse_portable(ray, t, t, portable, nothing);
    ASSERT_TRUE(portable.parts.count(target)) << i;
    if (!can_run_avx2()) continue;
    bvh.traverse_avx2<true>(ray, t, t, avx2, nothing);
    ASSERT_TRUE(avx2.parts.count(target)) << i;
  }
}

TEST(UnitCoreWideBvhShape, NearBoxesComeFirstAndTheLimitCutsTheRest) {
  std::vector<Bounds> boxes;
  for (int i = 0; i < 1000; ++i) boxes.push_back({{i * 2.0, -1, -1}, {i * 2.0 + 1, 1, 1}});
  const WideBvh bvh(boxes);
  int leaves = 0;
  double reached = Bounds::kInf;
  bvh.traverse({{-5, 0, 0}, {1, 0, 0}}, 0.0, Bounds::kInf,
               [&](std::uint32_t first, std::uint32_t count, double& t_max) {
                 ++leaves;
                 for (std::uint32_t i = 0; i < count; ++i) {
                   const double t = boxes[bvh.order()[first + i]].lo.x + 5;
                   if (t < t_max) t_max = t;
                 }
                 reached = t_max;
                 return false;
               });
  EXPECT_EQ(reached, 5.0);
  EXPECT_LE(leaves, 2);
}

TEST(UnitCoreWideBvhShape, ALeafCanEndTheSearch) {
  std::vector<Bounds> boxes(100, Bounds{{0, 0, 0}, {1, 1, 1}});
  const WideBvh bvh(boxes);
  int leaves = 0;
  const auto end = [&](std::uint32_t, std::uint32_t, double&) { return ++leaves == 3; };
  EXPECT_TRUE(bvh.traverse({{0.5, 0.5, -1}, {0, 0, 1}}, 0.0, 10.0, end));
  EXPECT_EQ(leaves, 3);
}

TEST(UnitCoreWideBvhShape, EveryPartHasOnePlaceAndLeavesAreOfOneKind) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Bounds> boxes;
  std::vector<std::uint8_t> kinds;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p{unit(random), unit(random), unit(random)};
    boxes.push_back({p, p + Vec3(0.01)});
    kinds.push_back(static_cast<std::uint8_t>(i % 3));
  }
  boxes[77] = Bounds{};  // empty: left out
  const WideBvh::Options::Kind costs[] = {{4, 1, 4}, {4, 1, 8}, {1, 2, 2}};
  WideBvh::Options options;
  options.kinds = kinds;
  options.kind_costs = costs;
  WideBvh bvh(boxes, options);
  std::vector<int> seen(boxes.size(), 0);
  bvh.relabel([&](std::uint32_t first, std::uint32_t count) {
    const std::uint8_t kind = kinds[bvh.order()[first]];
    EXPECT_LE(count, static_cast<std::uint32_t>(costs[kind].max_leaf));
    for (std::uint32_t i = first; i < first + count; ++i) {
      EXPECT_EQ(kinds[bvh.order()[i]], kind);
      ++seen[bvh.order()[i]];
    }
    return 0u;
  });
  for (std::size_t i = 0; i < seen.size(); ++i) ASSERT_EQ(seen[i], i == 77 ? 0 : 1) << i;
  EXPECT_EQ(bvh.statistics().parts, boxes.size() - 1);
}

TEST(UnitCoreWideBvhShape, PointsFindTheBoxesThatHoldThem) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Bounds> boxes;
  for (int i = 0; i < 500; ++i) {
    const Vec3 p{1e7 + unit(random), unit(random), unit(random)};
    boxes.push_back({p, p + Vec3(0.1)});
  }
  const WideBvh bvh(boxes);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p{1e7 + unit(random), unit(random), unit(random)};
    std::set<std::uint32_t> found;
    bvh.at_point(p, [&](std::uint32_t first, std::uint32_t count) {
      for (std::uint32_t k = first; k < first + count; ++k) found.insert(bvh.order()[k]);
      return false;
    });
    for (std::uint32_t b = 0; b < boxes.size(); ++b) {
      if (boxes[b].contains(p)) {
        ASSERT_TRUE(found.count(b));
      }
    }
    EXPECT_LT(found.size(), 100u);
  }
}

TEST(UnitCoreWideBvhShape, NodesAreWellFilled) {
  std::vector<Bounds> boxes;
  for (int i = 0; i < 8000; ++i) {
    const Vec3 at(i % 20, i / 20 % 20, i / 400);
    boxes.push_back({at, at + Vec3(0.4)});
  }
  WideBvh::Options options;
  options.max_leaf = 1;
  const WideBvh bvh(boxes, options);
  EXPECT_EQ(bvh.statistics().leaves, boxes.size());
  // Each node but the root is a child too: seven leaves a node are the most.
  EXPECT_LT(bvh.statistics().nodes, boxes.size() / 4);
}

TEST(UnitCoreWideBvhShape, WhatIsNotNeededAnyMoreIsLetGo) {
  std::vector<Bounds> boxes(1000, Bounds{{0, 0, 0}, {1, 1, 1}});
  WideBvh bvh(std::move(boxes), WideBvh::Options{});
  EXPECT_EQ(boxes.capacity(), 0u);
  const std::size_t before = bvh.memory();
  bvh.drop_order();
  EXPECT_EQ(bvh.memory(), before - 1000 * sizeof(std::uint32_t));
}

TEST(UnitCoreWideBvhShape, OddInputIsHarmless) {
  const auto never = [](std::uint32_t, std::uint32_t, double&) {
    ADD_FAILURE() << "visited";
    return false;
  };
  EXPECT_FALSE(WideBvh().traverse({{0, 0, 0}, {0, 0, 1}}, 0, 1, never));
  EXPECT_FALSE(WideBvh(std::vector<Bounds>{Bounds{}}).traverse({{}, {0, 0, 1}}, 0, 1, never));
  const WideBvh bvh(std::vector<Bounds>{{{0, 0, 0}, {1, 1, 1}}});
  const double nan = std::nan("");
  EXPECT_FALSE(bvh.traverse({{0.5, 0.5, 0.5}, {0, 0, 0}}, 0, 1, never));
  EXPECT_FALSE(bvh.traverse({{nan, 0.5, 0.5}, {0, 0, 1}}, 0, 1, never));
  EXPECT_FALSE(bvh.traverse({{0.5, 0.5, 0.5}, {0, nan, 1}}, 0, 1, never));
  EXPECT_FALSE(bvh.traverse({{0.5, 0.5, Bounds::kInf}, {0, 0, -1}}, 0, 1, never));
  // Many boxes alike: the build must end, and not run deep.
  const WideBvh alike(std::vector<Bounds>(5000, Bounds{{0, 0, 0}, {1, 1, 1}}));
  EXPECT_LT(alike.statistics().depth, 16);
}

TEST(UnitCoreWideBvhShape, AFarBoxLeavesTheOthersSharp) {
  std::vector<Bounds> boxes;
  for (int i = 0; i < 10000; ++i) {
    const Vec3 at(i % 100, 0, i / 100);
    boxes.push_back({at, at + Vec3(1, i == 5050 ? 1e30 : 1, 1)});
  }
  const WideBvh bvh(boxes);
  Visited seen{bvh, {}};
  CountNothing nothing;
  bvh.traverse_portable({{20.5, 1e4, 20.5}, {0, -1, 0}}, 0.0, Bounds::kInf, seen, nothing);
  EXPECT_TRUE(seen.parts.count(2020));
  EXPECT_LT(seen.parts.size(), 40u);
}

TEST(UnitCoreWideBvhShape, UnevenlySpreadBoxesStayWithinTheStack) {
  std::vector<Bounds> boxes;
  double at = 1.0;
  for (int i = 0; i < 900; ++i) {  // each twice as far away as the one before
    boxes.push_back({Vec3(at), Vec3(at * 1.1)});
    at *= 2.0;
  }
  const WideBvh bvh(boxes);
  EXPECT_LT(bvh.statistics().depth, 80);
  Visited all{bvh, {}};
  CountNothing nothing;
  bvh.traverse_portable({{0, 0, 0}, {1, 1, 1}}, 0.0, Bounds::kInf, all, nothing);
  EXPECT_EQ(all.parts.size(), boxes.size());
}

}  // namespace
