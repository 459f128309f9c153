// The rays of a bundle meet what each meets alone, bit for bit: rays side by side, from a point, at random, along
// sides of boxes, with ties and objects that some rays do not see, far from the origin and from far away.
#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <vector>

#include "core/accel/bundle_tree.h"
#include "core/accel/hierarchy.h"
#include "core/object/csg.h"
#include "core/object/gated.h"
#include "tests/unit/shape/random_objects.h"

using namespace lentray::core;
using namespace lentray::test;

namespace {

bool equal_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Counts of what was compared.
struct Compared {
  int bundles = 0, together = 0, met = 0, unknown = 0;
};

void compare(const Hierarchy& tree, const std::vector<Ray>& rays, double t_min, RayKind kind,
             Compared& counts) {
  RayBundle bundle;
  for (const Ray& ray : rays) bundle.add(ray);
  bundle.fill_up();
  BundleHits hits;
  HitLists lists;
  ++counts.bundles;
  if (!tree.nearest(bundle, t_min, kind, hits, lists)) return;
  ++counts.together;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    Hit alone;
    const bool meets = tree.nearest(rays[i], t_min, Bounds::kInf, kind, alone, lists, nullptr);
    if (hits.answer[i] == BundleHits::Answer::kUnknown) {
      ++counts.unknown;
      continue;
    }
    ASSERT_EQ(hits.answer[i] == BundleHits::Answer::kMet, meets) << "ray " << i;
    if (!meets) continue;
    ++counts.met;
    const Hit& hit = hits.hit[i];
    ASSERT_TRUE(equal_bits(hit.t, alone.t)) << hit.t << " " << alone.t;
    ASSERT_EQ(hit.object, alone.object);
    ASSERT_EQ(hit.leaf, alone.leaf);
    ASSERT_EQ(hit.shape.element, alone.shape.element);
    ASSERT_TRUE(equal_bits(hit.shape.t, alone.shape.t) && equal_bits(hit.shape.u, alone.shape.u) &&
                equal_bits(hit.shape.v, alone.shape.v));
  }
}

/// Bundles of rays about the rays of a SceneMaker.
class BundleMaker {
 public:
  explicit BundleMaker(const TestScene& setup, SceneMaker& make) : m_setup(setup), m_make(make) {}

  std::vector<Ray> rays(int number) {
    const Ray about = m_make.ray();
    const Vec3 d = normalized(about.direction);
    const Vec3 u = normalized(cross(d, {0.31, 0.2, 0.93})), v = cross(u, d);
    const double step = m_setup.detail * std::pow(10.0, -m_make.integer(4));
    const int count = 1 + m_make.integer(RayBundle::kMost);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
      const double x = i % 8, y = i / 8;
      Ray ray{about.origin, d};
      switch (number % 5) {
        case 0: ray.origin += v * (i * step); break;  // a column, parallel
        case 1: ray.direction = normalized(d + u * (0.004 * x) + v * (0.004 * y)); break;
        case 2: ray.origin += u * (x * step) + v * (y * step); break;  // a tile, parallel
        case 3:                                                        // from an eye before it
          ray.direction = normalized(d + v * (0.01 * i));
          ray.origin += ray.direction * m_setup.detail;
          break;
        default:  // along an axis, in the planes of sides of boxes
          ray.direction = Vec3{};
          ray.direction[number / 5 % 3] = number % 2 == 0 ? 1.0 : -1.0;
          ray.origin = about.origin - ray.direction * m_setup.far + v * (i * step);
          break;
      }
      rays.push_back(ray);
    }
    return rays;
  }

 private:
  const TestScene& m_setup;
  SceneMaker& m_make;
};

class UnitCoreBundle : public ::testing::TestWithParam<TestScene> {};

TEST_P(UnitCoreBundle, MeetsWhatEachRayMeets) {
  const TestScene& setup = GetParam();
  SceneMaker make(setup);
  const Objects objects = make.objects(400);
  const Hierarchy tree(objects);
  if (!tree.takes_bundles()) GTEST_SKIP() << "needs AVX2";
  BundleMaker bundles(setup, make);
  Compared counts;
  constexpr RayKind kKinds[] = {RayKind::kCamera, RayKind::kReflection};
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE("bundle " + std::to_string(i));
    compare(tree, bundles.rays(i), i % 3 == 0 ? 1e-4 * setup.detail : 0.0, kKinds[i / 5 % 2],
            counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.together, counts.bundles / 2);
  EXPECT_GT(counts.met, counts.bundles);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, UnitCoreBundle,
    ::testing::Values(TestScene{"Plain", 10, 2, {}, 20, false, false},
                      TestScene{"Flags", 10, 2, {}, 20, true, true},
                      TestScene{"Infinite", 10, 2, {}, 20, false, true},
                      TestScene{"Sparse", 10, 0.3, {}, 20, true, true},
                      TestScene{"Tiny", 1e-6, 2e-7, {}, 2e-6, true, false},
                      TestScene{"Large", 1e6, 2e5, {}, 2e6, true, false},
                      TestScene{"FarFromOrigin", 10, 2, {1e7, 1e6, -1e7}, 20, true, false},
                      TestScene{"SeenFromFar", 10, 2, {}, 1e5, true, false}),
    [](const auto& tested) { return std::string(tested.param.name); });

/// A picture's tile of a wall of spheres, triangles and polygons that touch each other.
TEST(UnitCoreBundleRules, GrazingRaysMeetWhatTheyMeetAlone) {
  Objects objects;
  const auto add = [&](std::unique_ptr<Shape> shape) {
    objects.push_back(std::make_unique<Leaf>(std::move(shape), Transform()));
  };
  for (int x = -6; x < 6; ++x) {
    for (int y = -6; y < 6; ++y) {
      const Vec3 at{x * 1.0, y * 1.0, 0.0};
      add(std::make_unique<Sphere>(at, 0.5));
      add(std::make_unique<Triangle>(at, at + Vec3{1, 0, 0}, at + Vec3{0, 1, 0}));
      add(std::make_unique<Polygon>(
          std::vector<Vec3>{at, at + Vec3{1, 0, 0}, at + Vec3{1, 0, 1}, at + Vec3{0, 0, 1}, at}));
    }
  }
  const Hierarchy tree(objects);
  if (!tree.takes_bundles()) GTEST_SKIP() << "needs AVX2";
  Compared counts;
  for (int place = 0; place < 400; ++place) {
    for (const Vec3& d : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 1}, Vec3{1, 1, 1}}) {
      std::vector<Ray> rays;
      for (int i = 0; i < RayBundle::kMost; ++i) {
        // Many lie in the planes of the polygons, touch spheres and pass corners.
        const Vec3 to{place % 20 * 0.5 - 5 + i % 8 * 0.125, place / 20 * 0.5 - 5 + i / 8 * 0.125,
                      0.0};
        rays.push_back({to - normalized(d) * 9.0, normalized(d)});
      }
      compare(tree, rays, 1e-6, RayKind::kCamera, counts);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(counts.together, counts.bundles / 2);
}

TEST(UnitCoreBundleRules, RaysThatRunApartAreLeftAlone) {
  SceneMaker make({"", 10, 0.5, {}, 20, false, false});
  const Objects objects = make.objects(5000);
  const Hierarchy tree(objects);
  if (!tree.takes_bundles()) GTEST_SKIP() << "needs AVX2";
  std::vector<Ray> rays;
  for (int i = 0; i < RayBundle::kMost; ++i) {
    Ray ray = make.ray();
    ray.direction = normalized(ray.direction);
    rays.push_back(ray);
  }
  Compared counts;
  compare(tree, rays, 0.0, RayKind::kCamera, counts);
  EXPECT_EQ(counts.together, 0);
}

/// What is seen beyond the box that the search knows is found or not as the order of a search has it.
TEST(UnitCoreBundleRules, ThingsSeenBeyondTheirBoundsAreSearchedRayByRay) {
  for (const bool beyond : {false, true}) {
    Objects objects;
    objects.push_back(std::make_unique<Leaf>(std::make_unique<Sphere>(Vec3{}, 1), Transform()));
    std::unique_ptr<Shape> shape;
    if (beyond) {
      shape = std::make_unique<Plane>(Vec3{0.1, 1, 0.2}, 0.0);
    } else {
      shape = std::make_unique<Sphere>(Vec3{0, 1, 0}, 1);
    }
    Object::Regions gates{
        std::make_shared<Leaf>(std::make_unique<Sphere>(Vec3{0, 0, 3}, 1), Transform())};
    objects.push_back(std::make_unique<Gated>(std::make_unique<Leaf>(std::move(shape), Transform()),
                                              std::move(gates)));
    const Hierarchy tree(objects), portable(objects, Accelerator::kBvh, true);
    EXPECT_EQ(tree.takes_bundles(), has_avx2() && !beyond);
    EXPECT_FALSE(portable.takes_bundles());
  }
}

}  // namespace
