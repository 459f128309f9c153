// CSG: what is hit along a ray against what is inside along it.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/object/csg.h"
#include "core/object/gated.h"
#include "core/object/leaf.h"
#include "core/shape/box.h"
#include "core/shape/cone.h"
#include "core/shape/cylinder.h"
#include "core/shape/disc.h"
#include "core/shape/plane.h"
#include "core/shape/quadric.h"
#include "core/shape/sphere.h"
#include "core/shape/torus.h"
#include "core/shape/triangle.h"
#include "tests/unit/shape/geometry_help.h"

namespace lentray::core {
namespace {

using geometry_test::Random;
constexpr double kGeometryCsgInf = Bounds::kInf;
using Children = std::vector<std::unique_ptr<Object>>;

template <class S, class... Args>
std::unique_ptr<Object> leaf(Args&&... args) {
  return std::make_unique<Leaf>(std::make_unique<S>(std::forward<Args>(args)...), Transform());
}

template <class... Objects>
std::unique_ptr<Object> geometry_csg_csg(CsgKind kind, Objects... objects) {
  Children children;
  (children.push_back(std::move(objects)), ...);
  return std::make_unique<Csg>(kind, std::move(children));
}

std::vector<double> depths(const Object& object, const Ray& ray) {
  HitLists lists;
  std::vector<Hit> hits;
  object.all(ray, 0.0, kGeometryCsgInf, hits, {lists, RayKind::kShadow});
  std::vector<double> t;
  for (const Hit& h : hits) t.push_back(h.t);
  std::sort(t.begin(), t.end());
  return t;
}

std::unique_ptr<Object> random_leaf(Random& random) {
  const Transform place =
      Transform::rotation(random.vector(180)).then(Transform::translation(random.vector(0.8)));
  std::unique_ptr<Shape> shape;
  switch (random.whole(0, 5)) {
    case 0: shape = std::make_unique<Sphere>(Vec3{}, random.in(0.3, 1.0)); break;
    case 1:
      shape = std::make_unique<Box>(Vec3(-random.in(0.2, 0.8)), Vec3(random.in(0.2, 0.8)));
      break;
    case 2:
      shape = std::make_unique<Cylinder>(Vec3{0, -1, 0}, Vec3{0, 1, 0}, random.in(0.2, 0.7));
      break;
    case 3:
      shape = std::make_unique<Cone>(Vec3{0, -1, 0}, random.in(0.2, 1.0), Vec3{0, 1, 0}, 0.1);
      break;
    case 4: shape = std::make_unique<Torus>(0.7, 0.25); break;
    default: shape = std::make_unique<Plane>(Vec3{0, 1, 0}, random.in(-0.5, 0.5)); break;
  }
  auto object = std::make_unique<Leaf>(std::move(shape), place);
  if (random.whole(0, 5) == 0) object->set_inverse(true);
  return object;
}

std::unique_ptr<Object> random_tree(Random& random, int depth) {
  if (depth == 0 || random.whole(0, 4) == 0) return random_leaf(random);
  const CsgKind kinds[3] = {CsgKind::kIntersection, CsgKind::kDifference, CsgKind::kMerge};
  Children children;
  const int n = random.whole(1, depth == 1 && random.whole(0, 3) == 0 ? 14 : 3);
  for (int i = 0; i < n; ++i) children.push_back(random_tree(random, depth - 1));
  auto object = std::make_unique<Csg>(kinds[random.whole(0, 2)], std::move(children));
  if (random.whole(0, 4) == 0) object->set_inverse(true);
  complete(*object);
  return object;
}

TEST(UnitCoreCsg, SurfacesLieExactlyWhereInsideChanges) {
  Random random(21);
  int crossings = 0;
  for (int tree = 0; tree < 400; ++tree) {
    const auto object = random_tree(random, 3);
    const Bounds box = object->bounds(), solid = object->solid_bounds(),
                 hollow = object->void_bounds();
    HitLists lists;
    for (int k = 0; k < 40; ++k) {
      const Ray ray = random.ray(4.0, 1.0);
      std::vector<double> t = depths(*object, ray);
      Hit first;
      ASSERT_EQ(object->nearest(ray, 0.0, kGeometryCsgInf, first, {lists, RayKind::kShadow}),
                !t.empty());
      EXPECT_EQ(object->any(ray, 0.0, kGeometryCsgInf, {lists, RayKind::kShadow}), !t.empty());
      if (!t.empty()) {
        EXPECT_EQ(first.t, t[0]);
      }
      bool in = object->inside(ray.origin);
      double from = 0.0;
      t.push_back(9.0);
      for (const double depth : t) {
        if (depth > 9.0) break;
        const double middle = 0.5 * (from + depth);
        if (depth - from > 1e-7) {
          ASSERT_EQ(object->inside(ray.at(middle)), in) << tree << " " << k << " at " << middle;
          // And nothing changes unseen in between.
          EXPECT_EQ(object->inside(ray.at(from + 0.1 * (depth - from))), in);
          EXPECT_EQ(object->inside(ray.at(from + 0.93 * (depth - from))), in);
        }
        const Vec3 p = ray.at(middle);
        EXPECT_TRUE(in ? solid.contains(p) : hollow.contains(p));
        EXPECT_TRUE(depth >= 9.0 || box.contains(ray.at(depth)));
        in = !in;
        from = depth;
        ++crossings;
      }
    }
  }
  EXPECT_GT(crossings, 10000);
}

TEST(UnitCoreCsg, UnionKeepsInnerSurfacesAndMergeDoesNot) {
  const Ray ray{{-5, 0, 0}, {1, 0, 0}};
  const auto make = [](CsgKind kind) {
    return geometry_csg_csg(kind, leaf<Sphere>(Vec3{0, 0, 0}, 1.0),
                            leaf<Sphere>(Vec3{1, 0, 0}, 1.0));
  };
  EXPECT_EQ(depths(*make(CsgKind::kUnion), ray), (std::vector<double>{4, 5, 6, 7}));
  EXPECT_EQ(depths(*make(CsgKind::kMerge), ray), (std::vector<double>{4, 7}));
  EXPECT_EQ(depths(*make(CsgKind::kIntersection), ray), (std::vector<double>{5, 6}));
  EXPECT_EQ(depths(*make(CsgKind::kDifference), ray), (std::vector<double>{4, 5}));
  const auto both = make(CsgKind::kDifference);
  EXPECT_NEAR(both->solid_bounds().hi.x, 1.0, 1e-12);
  EXPECT_EQ(both->name(), "difference");
}

TEST(UnitCoreCsg, DifferenceFromAUnionHasNoWallsInItsHole) {
  // Two overlapping spheres cut out of a box: no surface within the hole.
  const auto object =
      geometry_csg_csg(CsgKind::kDifference, leaf<Box>(Vec3(-5.0), Vec3(5.0)),
                       geometry_csg_csg(CsgKind::kUnion, leaf<Sphere>(Vec3{0, 0, 0}, 1.0),
                                        leaf<Sphere>(Vec3{1, 0, 0}, 1.0)));
  EXPECT_EQ(depths(*object, {{0.5, 0, 0}, {1, 0, 0}}), (std::vector<double>{1.5, 4.5}));
  EXPECT_FALSE(object->inside({0.5, 0, 0}));
  EXPECT_TRUE(object->inside({3, 0, 0}));
}

TEST(UnitCoreCsg, NormalsOfInvertedPartsPointIntoTheHole) {
  const auto object = geometry_csg_csg(CsgKind::kDifference, leaf<Box>(Vec3(-5.0), Vec3(5.0)),
                                       leaf<Sphere>(Vec3{}, 1.0));
  HitLists lists;
  Hit hit;
  const Ray ray{{0, 0, 0}, {1, 0, 0}};
  ASSERT_TRUE(object->nearest(ray, 0, kGeometryCsgInf, hit, {lists, RayKind::kShadow}));
  EXPECT_EQ(hit.leaf->normal(ray.at(hit.t), hit.shape), (Vec3{-1, 0, 0}));
}

TEST(UnitCoreCsg, PatchesHaveNoInside) {
  const auto object =
      geometry_csg_csg(CsgKind::kIntersection, leaf<Sphere>(Vec3{}, 1.0),
                       leaf<Triangle>(Vec3{-5, -5, 0}, Vec3{5, -5, 0}, Vec3{0, 5, 0}));
  // Only the patch within the sphere is left; inverse does not change a patch.
  EXPECT_EQ(depths(*object, {{0, 0, -5}, {0, 0, 1}}), (std::vector<double>{5}));
  const auto cut = geometry_csg_csg(CsgKind::kDifference, leaf<Sphere>(Vec3{}, 1.0),
                                    leaf<Triangle>(Vec3{-5, -5, 0}, Vec3{5, -5, 0}, Vec3{0, 5, 0}));
  EXPECT_EQ(depths(*cut, {{0, 0, -5}, {0, 0, 1}}), (std::vector<double>{5}));
}

TEST(UnitCoreCsg, ManyChildrenMatchFew) {
  // The same forty holes as one difference (searched by a hierarchy) and as nested ones.
  Random random(22);
  std::vector<std::pair<Vec3, double>> holes;
  for (int i = 0; i < 40; ++i) holes.push_back({random.vector(1.0), random.in(0.1, 0.4)});
  for (const bool join : {false, true}) {
    Children flat;
    std::unique_ptr<Object> nested;
    if (!join) {
      flat.push_back(leaf<Box>(Vec3(-1.0), Vec3(1.0)));
      nested = leaf<Box>(Vec3(-1.0), Vec3(1.0));
    }
    for (const auto& [centre, radius] : holes) {
      flat.push_back(leaf<Sphere>(centre, radius));
      auto sphere = leaf<Sphere>(centre, radius);
      nested = !nested ? std::move(sphere)
                       : geometry_csg_csg(join ? CsgKind::kMerge : CsgKind::kDifference,
                                          std::move(nested), std::move(sphere));
    }
    Csg wide(join ? CsgKind::kMerge : CsgKind::kDifference, std::move(flat));
    complete(wide);
    for (int k = 0; k < 2000; ++k) {
      const Ray ray = random.ray(3.0, 1.0);
      ASSERT_EQ(depths(wide, ray), depths(*nested, ray));
      const Vec3 p = random.vector(1.2);
      ASSERT_EQ(wide.inside(p), nested->inside(p));
      HitLists lists;
      Hit a, b;
      ASSERT_EQ(wide.nearest(ray, 0.0, kGeometryCsgInf, a, {lists, RayKind::kShadow}),
                nested->nearest(ray, 0.0, kGeometryCsgInf, b, {lists, RayKind::kShadow}));
      EXPECT_EQ(a.t, b.t);
    }
  }
}

TEST(UnitCoreCsg, TiesGoToTheLastChild) {
  for (int extra : {0, 20}) {
    Children children;
    for (int i = 0; i < 2 + extra; ++i) {
      const double far = i < 2 ? 0.0 : 10.0 * i;
      children.push_back(leaf<Box>(Vec3{far - 1, -1, -1}, Vec3{far + 1, 1, 1}));
    }
    const Object* last = children[1].get();
    Csg object(CsgKind::kUnion, std::move(children));
    complete(object);
    HitLists lists;
    Hit hit;
    ASSERT_TRUE(object.nearest({{0, 0, -5}, {0, 0, 1}}, 0, kGeometryCsgInf, hit,
                               {lists, RayKind::kShadow}));
    EXPECT_EQ(hit.leaf, last);
  }
}

TEST(UnitCoreClipping, KeepsSurfacesWithinAndCountsForInside) {
  auto sphere = leaf<Sphere>(Vec3{}, 1.0);
  sphere->set_clips(
      {std::shared_ptr<const Object>(leaf<Plane>(Vec3{0, 0, -1}, 0.0))});  // keeps z >= 0
  EXPECT_EQ(depths(*sphere, {{0, 0, -5}, {0, 0, 1}}), (std::vector<double>{6}));
  HitLists lists;
  Hit hit;
  ASSERT_TRUE(
      sphere->nearest({{0, 0, -5}, {0, 0, 1}}, 0, kGeometryCsgInf, hit, {lists, RayKind::kShadow}));
  EXPECT_DOUBLE_EQ(hit.t, 6.0);
  EXPECT_TRUE(sphere->inside({0, 0, 0.5}));
  EXPECT_FALSE(sphere->inside({0, 0, -0.5}));
  EXPECT_NEAR(sphere->bounds().lo.z, 0.0, 1e-9);
  EXPECT_FALSE(sphere->any({{0, 0, -5}, {0, 0, 1}}, 0, 5.5, {lists, RayKind::kShadow}));
  EXPECT_FALSE(sphere->nearest({{0, 0, -5}, {0, 0, 1}}, 0, 5.5, hit, {lists, RayKind::kShadow}));
  EXPECT_DOUBLE_EQ(hit.t, 6.0);

  auto pair = geometry_csg_csg(CsgKind::kUnion, leaf<Sphere>(Vec3{0, 0, 0}, 1.0),
                               leaf<Sphere>(Vec3{0, 0, 5}, 1.0));
  pair->set_clips(
      {std::shared_ptr<const Object>(leaf<Plane>(Vec3{0, 0, -1}, -4.5))});  // keeps z >= 4.5
  EXPECT_EQ(depths(*pair, {{0, 0, -5}, {0, 0, 1}}), (std::vector<double>{11}));
  ASSERT_TRUE(
      pair->nearest({{0, 0, -5}, {0, 0, 1}}, 0, kGeometryCsgInf, hit, {lists, RayKind::kShadow}));
  EXPECT_DOUBLE_EQ(hit.t, 11.0);
  // Without a hit in the range the caller's stays as it was.
  EXPECT_FALSE(pair->nearest({{0, 0, -5}, {0, 0, 1}}, 0, 10.5, hit, {lists, RayKind::kShadow}));
  EXPECT_DOUBLE_EQ(hit.t, 11.0);
}

TEST(UnitCoreClipping, InverseClipsAndInfiniteObjects) {
  auto plane = leaf<Plane>(Vec3{0, 1, 0}, 0.0);
  auto clip = leaf<Sphere>(Vec3{}, 2.0);
  plane->set_clips({std::shared_ptr<const Object>(std::move(clip))});
  EXPECT_TRUE(plane->bounds().is_finite());
  HitLists lists;
  Hit hit;
  EXPECT_TRUE(
      plane->nearest({{1, 5, 0}, {0, -1, 0}}, 0, kGeometryCsgInf, hit, {lists, RayKind::kShadow}));
  EXPECT_FALSE(
      plane->nearest({{3, 5, 0}, {0, -1, 0}}, 0, kGeometryCsgInf, hit, {lists, RayKind::kShadow}));
  auto hole = leaf<Sphere>(Vec3{}, 2.0);
  hole->set_inverse(true);
  plane->set_clips({std::shared_ptr<const Object>(std::move(hole))});
  EXPECT_FALSE(plane->bounds().is_finite());
  EXPECT_FALSE(
      plane->nearest({{1, 5, 0}, {0, -1, 0}}, 0, kGeometryCsgInf, hit, {lists, RayKind::kShadow}));
  EXPECT_TRUE(
      plane->nearest({{3, 5, 0}, {0, -1, 0}}, 0, kGeometryCsgInf, hit, {lists, RayKind::kShadow}));
}

std::unique_ptr<Object> gated_by_box(std::unique_ptr<Object> content, const Vec3& lo,
                                     const Vec3& hi) {
  return std::make_unique<Gated>(std::move(content),
                                 Object::Regions{std::shared_ptr<const Object>(leaf<Box>(lo, hi))});
}

TEST(UnitCoreGated, RaysThatMissAGateMissTheContent) {
  const auto sphere = gated_by_box(leaf<Sphere>(Vec3{}, 1.0), {-2, 0, -2}, {2, 2, 2});
  HitLists lists;
  Hit hit;
  EXPECT_TRUE(sphere->nearest({{0, 0.5, -5}, {0, 0, 1}}, 0, kGeometryCsgInf, hit,
                              {lists, RayKind::kShadow}));
  EXPECT_FALSE(sphere->nearest({{0, -0.5, -5}, {0, 0, 1}}, 0, kGeometryCsgInf, hit,
                               {lists, RayKind::kShadow}));
  EXPECT_FALSE(
      sphere->any({{0, -0.5, -5}, {0, 0, 1}}, 0, kGeometryCsgInf, {lists, RayKind::kShadow}));
  EXPECT_TRUE(sphere->nearest({{0, 0.5, 0}, {0, -1, 0}}, 0, kGeometryCsgInf, hit,
                              {lists, RayKind::kShadow}));  // starts inside it
  EXPECT_TRUE(sphere->inside({0, -0.5, 0}));
}

TEST(UnitCoreGated, APartOfACsgIsSeenThroughItsGateAlone) {
  const auto cut =
      geometry_csg_csg(CsgKind::kDifference, leaf<Sphere>(Vec3{}, 2.0),
                       gated_by_box(leaf<Sphere>(Vec3{0, 0, -2}, 1.0), {-2, 0, -2}, {2, 2, 2}));
  EXPECT_EQ(depths(*cut, {{0, 0.5, -5}, {0, 0, 1}}).size(), 2u);
  // The front of the outer sphere is in the part, whose own surface no ray here meets.
  EXPECT_EQ(depths(*cut, {{0, -0.5, -5}, {0, 0, 1}}).size(), 1u);
}

TEST(UnitCoreGated, FollowsItsContentWhenItIsInverted) {
  const auto sphere = gated_by_box(leaf<Sphere>(Vec3{}, 1.0), Vec3(-2.0), Vec3(2.0));
  sphere->set_inverse(true);
  EXPECT_TRUE(sphere->is_inverse());
  EXPECT_FALSE(sphere->inside({0, 0, 0}));
  EXPECT_TRUE(sphere->inside({3, 0, 0}));
  const auto patch = gated_by_box(leaf<Triangle>(Vec3{-5, -5, 0}, Vec3{5, -5, 0}, Vec3{0, 5, 0}),
                                  Vec3(-2.0), Vec3(2.0));
  patch->set_inverse(true);
  EXPECT_FALSE(patch->is_inverse() || patch->inside({0, 0, 1}));
}

TEST(UnitCoreGated, BoxesOfGatesStandForInfiniteOnes) {
  const auto plane = gated_by_box(leaf<Plane>(Vec3{0, 1, 0}, 0.0), Vec3(-2.0), Vec3(2.0));
  EXPECT_TRUE(plane->bounds().is_finite());
  EXPECT_FALSE(plane->solid_bounds().is_finite());
  // Through the gate, and on to what lies beyond it.
  EXPECT_EQ(depths(*plane, {{0, 1, 0}, normalized(Vec3{10, -1, 0})}).size(), 1u);
}

TEST(UnitCoreCsg, EmptyAndInfiniteOnes) {
  const auto nothing = geometry_csg_csg(CsgKind::kIntersection, leaf<Sphere>(Vec3{}, 1.0),
                                        leaf<Sphere>(Vec3{5, 0, 0}, 1.0));
  EXPECT_TRUE(nothing->bounds().is_empty());
  EXPECT_TRUE(depths(*nothing, {{-5, 0, 0}, {1, 0, 0}}).empty());
  const auto slab = geometry_csg_csg(CsgKind::kIntersection, leaf<Plane>(Vec3{0, 1, 0}, 1.0),
                                     leaf<Plane>(Vec3{0, -1, 0}, 1.0),
                                     leaf<Quadric>(Vec3{1, 0, 1}, Vec3{}, Vec3{}, -4.0));
  const Bounds b = slab->bounds();
  ASSERT_TRUE(b.is_finite());  // planes bound the height, the quadric the rest
  EXPECT_NEAR(b.hi.y, 1.0, 1e-9);
  EXPECT_NEAR(b.hi.x, 2.0, 1e-9);
  EXPECT_EQ(depths(*slab, {{0, -5, 0}, {0, 1, 0}}), (std::vector<double>{4, 6}));
  const auto all_but = geometry_csg_csg(CsgKind::kUnion, leaf<Sphere>(Vec3{}, 1.0));
  all_but->set_inverse(true);
  EXPECT_TRUE(all_but->inside({5, 0, 0}));
  EXPECT_FALSE(all_but->inside({0, 0, 0}));
  EXPECT_TRUE(all_but->bounds().is_finite());
  EXPECT_FALSE(all_but->solid_bounds().is_finite());
}

}  // namespace
}  // namespace lentray::core
