#include "core/accel/light_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/accel/hierarchy.h"
#include "core/accel/light_points.h"
#include "core/base/processor.h"
#include "core/light/light_ray.h"
#include "core/object/leaf.h"
#include "core/shape/cone.h"
#include "core/shape/smooth_triangle.h"
#include "core/shape/torus.h"
#include "tests/unit/shape/random_objects.h"

using namespace lentray::core;
using namespace lentray::test;

namespace {

constexpr double kTolerance = 1e-3;

struct Case {
  TestScene scene;
  Vec3 light;
  std::uint32_t cells;
  int objects;
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.scene.name; }

class UnitCoreLightBuffer : public ::testing::TestWithParam<Case> {};

void expect_same_answer(const LightBuffer& buffer, const Hierarchy& hierarchy, const Vec3& light,
                        const Vec3& point, HitLists& lists, int (&seen)[3]) {
  const Vec3 to = light - point;
  const double distance = length(to);
  const Ray ray{point, to / distance};
  const double reach = distance - kTolerance;
  LightBuffer::Spot spot;
  buffer.locate(point, spot);
  if (!buffer.serves(spot, distance) || !(reach > kTolerance)) return;
  const LightBuffer::Answer answer =
      buffer.any_opaque(spot, ray, kTolerance, reach, lists, nullptr);
  const Object* blocker = answer.blocker;
  const Object* expected = hierarchy.any_opaque(ray, kTolerance, reach, lists, nullptr);
  ASSERT_EQ(blocker != nullptr, expected != nullptr)
      << point.x << ", " << point.y << ", " << point.z;
  if (blocker) {
    ++seen[0];
    ASSERT_TRUE(blocker->is_opaque());
    ASSERT_FALSE(blocker->attributes().no_shadow);
    ASSERT_TRUE(blocker->any(ray, kTolerance, reach, {lists, RayKind::kShadow}));
    return;
  }
  ++seen[1];
  std::vector<Hit> ours, all;
  buffer.all_transparent(spot, ray, kTolerance, reach, false, ours, lists, nullptr);
  hierarchy.all_transparent(ray, kTolerance, reach, false, all, lists, nullptr);
  const auto before = [](const Hit& a, const Hit& b) {
    return a.t != b.t ? a.t < b.t : std::less<>()(a.object, b.object);
  };
  std::sort(ours.begin(), ours.end(), before);
  std::sort(all.begin(), all.end(), before);
  ASSERT_EQ(ours.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_EQ(ours[i].t, all[i].t);
    ASSERT_EQ(ours[i].object, all[i].object);
  }
  if (!all.empty()) ++seen[2];
}

/// Points that are asked for together. A third is not asked for, and of a third an object is said to be unmet.
class Together {
 public:
  Together(const LightBuffer& buffer, const Vec3& light) : m_buffer(buffer), m_light(light) {}

  void add(SceneMaker& make, const Vec3& point, const Object* object) {
    const Vec3 normal = normalized(make.point());
    const Vec3 front = make.integer(2) == 0 ? normal : normalized(make.point());
    const int kind = make.integer(3);
    const Object* unmet = kind == 1 ? object : nullptr;
    if (kind == 0) {
      m_points.add_none();
    } else {
      m_points.add(point, normal, front, unmet, 1e-3);
    }
    m_given.push_back({point, normal, front, unmet, kind != 0});
    if (m_given.size() == LightPoints::kMost) ask();
  }
  void ask() {
    m_points.fill_up();
    m_buffer.ask_together(m_points, kTolerance, m_lists, m_answers);
    for (std::size_t i = 0; i < m_given.size(); ++i) check(i);
    m_points.clear();
    m_given.clear();
  }
  int seen(LightAnswers::Answer answer) const { return m_seen[answer]; }

 private:
  struct Given {
    Vec3 point, normal, front;
    const Object* unmet;
    bool asks;
  };
  void check(std::size_t i) {
    const LightAnswers::Answer answer = m_answers.at(i);
    const auto bit = [i](std::uint64_t bits) { return (bits >> i & 1) != 0; };
    EXPECT_EQ(bit(m_answers.unknown), answer == LightAnswers::kUnknown);
    EXPECT_EQ(bit(m_answers.filtered), answer == LightAnswers::kFiltered);
    ++m_seen[answer];
    EXPECT_EQ(answer, expected(i, answer));
  }
  /// By the questions for one point. Where nothing opaque is in the way, the answer may be to look for filters.
  LightAnswers::Answer expected(std::size_t i, LightAnswers::Answer answer) {
    const Given& given = m_given[i];
    if (!given.asks) return LightAnswers::kUnknown;
    const Vec3 to = m_light - given.point;
    const double up = dot(given.normal, to);
    if (dot(given.front, to) < 0.0) return LightAnswers::kBehind;
    const LightRay ray = ray_along(to);
    const double reach = ray.distance - kTolerance;
    LightBuffer::Spot spot;
    m_buffer.locate(given.point, spot);
    if (up > 0.0 && up * up > 1e-3 * 1e-3 * length_squared(to)) spot.unmet = given.unmet;
    if (!m_buffer.serves(spot, ray.distance) || !(reach > kTolerance))
      return LightAnswers::kUnknown;
    EXPECT_EQ(m_answers.direction_at(i), ray.direction);
    EXPECT_EQ(m_answers.distance[i], ray.distance);
    const Ray way{given.point, ray.direction};
    const LightBuffer::Answer found =
        m_buffer.any_opaque(spot, way, kTolerance, reach, m_lists, nullptr);
    if (found.blocker) {
      return found.foreseen ? LightAnswers::kForeseen : LightAnswers::kBlocked;
    }
    std::vector<Hit> filters;
    if (m_buffer.may_filter(spot)) {
      m_buffer.all_transparent(spot, way, kTolerance, reach, false, filters, m_lists, nullptr);
    }
    if (answer == LightAnswers::kFiltered) {
      EXPECT_EQ(m_answers.spot[i].cell, spot.cell);
      EXPECT_EQ(m_answers.spot[i].w, spot.w);
      EXPECT_EQ(m_answers.spot[i].unmet, spot.unmet);
      return LightAnswers::kFiltered;
    }
    EXPECT_TRUE(filters.empty());
    return LightAnswers::kClear;
  }

  const LightBuffer& m_buffer;
  const Vec3 m_light;
  HitLists m_lists;
  LightPoints m_points;
  LightAnswers m_answers;
  std::vector<Given> m_given;
  int m_seen[6] = {};
};

/// What has an outline by its hull, or none but its box.
void add_turned(SceneMaker& make, const TestScene& scene, Objects& objects, int count) {
  for (int i = 0; i < count; ++i) {
    const Vec3 p = make.place();
    const double size = scene.detail * (0.1 + make.unit());
    const auto corner = [&] { return p + make.point() * size; };
    const auto turned = [&](std::unique_ptr<Shape> shape) {
      const Transform t = Transform::scaling(Vec3{1, 0.3 + make.unit(), 1} * size)
                              .then(Transform::rotation(make.point() * 180.0))
                              .then(Transform::translation(p));
      auto leaf = std::make_unique<Leaf>(std::move(shape), t);
      leaf->set_opaque(!scene.flags || make.integer(3) != 0);
      objects.push_back(std::move(leaf));
    };
    switch (make.integer(5)) {
      case 0:
        make.add(objects, std::make_unique<Cone>(corner(), size / 3, corner(),
                                                 make.integer(2) * size / 5, make.integer(2) == 0));
        break;
      case 1:
        make.add(objects, std::make_unique<SmoothTriangle>(corner(), Vec3{0, 1, 0}, corner(),
                                                           Vec3{1, 1, 0}, corner(), Vec3{0, 1, 1}));
        break;
      case 2: turned(std::make_unique<Sphere>(Vec3{}, 1.0)); break;
      case 3: turned(std::make_unique<Torus>(0.7, 0.2)); break;
      default: turned(std::make_unique<Cone>(Vec3{0, 0, 0}, 0.5, Vec3{0, 1, 0}, 0.2)); break;
    }
  }
}

TEST_P(UnitCoreLightBuffer, AnswersAsTheHierarchy) {
  const Case& c = GetParam();
  SceneMaker make(c.scene);
  Objects objects = make.objects(c.objects);
  add_turned(make, c.scene, objects, c.objects / 2);
  const Hierarchy hierarchy(objects);
  const LightBuffer buffer(c.light, objects, kTolerance, c.cells);
  ASSERT_FALSE(buffer.crowded());
  HitLists lists;
  int seen[3] = {};
  for (int i = 0; i < 20000; ++i) {
    expect_same_answer(buffer, hierarchy, c.light, make.place(), lists, seen);
    // Points on surfaces: shadow rays start there.
    const Ray ray = make.ray();
    Hit hit;
    if (hierarchy.nearest(ray, 0.0, Bounds::kInf, RayKind::kCamera, hit, lists, nullptr)) {
      expect_same_answer(buffer, hierarchy, c.light, ray.at(hit.t), lists, seen);
    }
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen[0], 1000);
  EXPECT_GT(seen[1], 1000);
  if (c.scene.flags) {
    EXPECT_GT(seen[2], 100);
  }
}

TEST_P(UnitCoreLightBuffer, AnswersManyPointsAsOne) {
  if (!can_run_avx2()) GTEST_SKIP();
  const Case& c = GetParam();
  SceneMaker make(c.scene);
  Objects objects = make.objects(c.objects);
  add_turned(make, c.scene, objects, c.objects / 2);
  const Hierarchy hierarchy(objects);
  const LightBuffer buffer(c.light, objects, kTolerance, c.cells);
  HitLists lists;
  Together together(buffer, c.light);
  for (int i = 0; i < 20000; ++i) {
    together.add(make, make.place(), nullptr);
    const Ray ray = make.ray();
    Hit hit;
    if (hierarchy.nearest(ray, 0.0, Bounds::kInf, RayKind::kCamera, hit, lists, nullptr)) {
      together.add(make, ray.at(hit.t), hit.object);
    }
    // Huge numbers, a light's own place, and its axes.
    if (i % 100 == 0) together.add(make, make.point() * 1e7, nullptr);
    if (i % 100 == 1) together.add(make, c.light, nullptr);
    if (i % 100 == 2) together.add(make, c.light + Vec3{1, 1, 0} * make.unit(), nullptr);
    if (HasFailure()) return;
  }
  together.ask();
  EXPECT_GT(together.seen(LightAnswers::kClear), 500);
  EXPECT_GT(together.seen(LightAnswers::kForeseen), 200);
  // Seldom: an object was tested in vain before the one that blocks.
  EXPECT_GT(together.seen(LightAnswers::kBlocked), 0);
  if (c.scene.flags) {
    EXPECT_GT(together.seen(LightAnswers::kFiltered), 50);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, UnitCoreLightBuffer,
    ::testing::Values(
        Case{{"outside", 1.0, 0.1, {0, 0, 0}, 3.0, true, false}, {3, 4, -2}, 20000, 300},
        Case{{"inside", 1.0, 0.1, {0, 0, 0}, 3.0, true, false}, {0.1, 0.2, -0.1}, 20000, 300},
        Case{{"all opaque", 1.0, 0.1, {0, 0, 0}, 3.0, false, false}, {3, 0, 0}, 5000, 300},
        Case{{"planes", 1.0, 0.1, {0, 0, 0}, 3.0, true, true}, {0.5, 3, 1}, 20000, 200},
        Case{{"few cells", 1.0, 0.2, {0, 0, 0}, 3.0, true, false}, {2, 3, -1}, 16, 60},
        Case{{"many cells", 1.0, 0.2, {0, 0, 0}, 3.0, true, false}, {2, 3, -1}, 200000, 60},
        Case{{"far from the origin", 1.0, 0.1, {1e5, -2e5, 5e4}, 3.0, true, false},
             {1e5 + 3, -2e5 + 4, 5e4 - 2},
             20000,
             300},
        Case{{"large", 1e5, 1e4, {0, 0, 0}, 3e5, true, false}, {3e5, 1e5, 1e5}, 20000, 300},
        Case{{"small", 0.02, 0.004, {0, 0, 0}, 0.05, true, false},
             {0.03, 0.02, -0.03},
             20000,
             300}));

/// A plate a little above another, about as far as the tolerance: the ends of the search count.
TEST(UnitCoreLightBufferRules, PlatesNearTheTolerance) {
  const Vec3 light{0.3, 5, -0.2};
  const auto plate = [](double y, double half) {
    std::vector<Vec3> p{
        {-half, y, -half}, {half, y, -half}, {half, y, half}, {-half, y, half}, {-half, y, -half}};
    auto leaf = std::make_unique<Leaf>(std::make_unique<Polygon>(std::move(p)), Transform());
    leaf->set_opaque(true);
    return leaf;
  };
  for (const double gap : {3e-4, 9.9e-4, 1.01e-3, 2e-3, 4e-3, 0.1}) {
    Objects objects;
    objects.push_back(plate(0.0, 2.0));
    objects.push_back(plate(gap, 1.0));
    objects.push_back(plate(5.0 - gap, 0.01));  // about the light
    const Hierarchy hierarchy(objects);
    const LightBuffer buffer(light, objects, kTolerance, 4096);
    HitLists lists;
    int seen[3] = {};
    for (int i = -30; i <= 30; ++i) {
      for (int k = -30; k <= 30; ++k) {
        expect_same_answer(buffer, hierarchy, light, {i / 20.0, 0.0, k / 20.0}, lists, seen);
        expect_same_answer(buffer, hierarchy, light, {i / 20.0, gap, k / 20.0}, lists, seen);
        if (HasFatalFailure()) return;
      }
    }
    EXPECT_GT(seen[1], 100);
  }
}

/// Cells that something covers wholly answer without a test.
TEST(UnitCoreLightBufferRules, CoveredCellsNeedNoTest) {
  SceneMaker make({"covered", 1.0, 0.3, {0, 0, 0}, 3.0, false, false});
  const Objects objects = make.objects(100);
  const LightBuffer buffer({0, 5, 0}, objects, kTolerance, 60000);
  EXPECT_GT(buffer.statistics().dark_cells, buffer.statistics().cells / 8);
  Counters counters;
  HitLists lists;
  int blocked = 0, tested = 0;
  for (int i = -20; i <= 20; ++i) {
    for (int k = -20; k <= 20; ++k) {
      const Vec3 point{i / 5.0, -20, k / 5.0};  // all objects are between it and the light
      const Vec3 to = Vec3{0, 5, 0} - point;
      const Ray ray{point, normalized(to)};
      counters.primitive_tests = 0;
      LightBuffer::Spot spot;
      buffer.locate(point, spot);
      if (!buffer.any_opaque(spot, ray, kTolerance, length(to) - kTolerance, lists, &counters)
               .blocker) {
        continue;
      }
      ++blocked;
      tested += counters.primitive_tests > 0;
    }
  }
  EXPECT_GT(blocked, 500);
  EXPECT_LT(tested, blocked / 4);
}

/// Many small objects in one direction: the hierarchy is asked there, the buffer everywhere else.
TEST(UnitCoreLightBufferRules, CellsMayBeCrowdedAlone) {
  SceneMaker make({"bunch", 1.0, 0.3, {0, 0, 0}, 3.0, false, false});
  Objects objects = make.objects(100);
  for (int i = 0; i < 200; ++i) {
    make.add(objects, std::make_unique<Sphere>(Vec3{0.5, 0.5, 0.5} + make.point() * 0.002, 1e-3));
  }
  const Vec3 light{4, 5, -3};
  const LightBuffer buffer(light, objects, kTolerance, 2000);
  ASSERT_FALSE(buffer.crowded());
  const auto served = [&](const Vec3& point) {
    LightBuffer::Spot spot;
    buffer.locate(point, spot);
    return buffer.serves(spot, length(light - point));
  };
  EXPECT_FALSE(served(light + (Vec3{0.5, 0.5, 0.5} - light) * 1.5));
  int served_points = 0;
  for (int i = 0; i < 1000; ++i) served_points += served(make.place());
  EXPECT_GT(served_points, 900);
}

/// So many objects behind one another that a list a cell is no gain.
TEST(UnitCoreLightBufferRules, CrowdIsRefused) {
  SceneMaker make({"crowd", 1.0, 0.5, {0, 0, 0}, 3.0, true, false});
  const Objects objects = make.objects(3000);
  EXPECT_TRUE(LightBuffer({9, 9, 9}, objects, kTolerance, 64).crowded());
}

}  // namespace
