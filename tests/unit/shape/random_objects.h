// Random objects and rays for tests of what finds them: every kind that has a pack or an outline
// of its own, some transparent, unseen or infinite, some twice in the same place.
#pragma once

#include <memory>
#include <random>
#include <vector>

#include "core/object/leaf.h"
#include "core/object/object.h"
#include "core/shape/box.h"
#include "core/shape/cylinder.h"
#include "core/shape/plane.h"
#include "core/shape/polygon.h"
#include "core/shape/sphere.h"
#include "core/shape/triangle.h"

namespace lentray::test {

using namespace lentray::core;

using Objects = std::vector<std::unique_ptr<Object>>;

struct TestScene {
  const char* name;
  double scale, detail;
  Vec3 offset;
  double far;
  bool flags, infinite;
};

class SceneMaker {
 public:
  explicit SceneMaker(const TestScene& s) : m_setup(s) {}

  void add(Objects& out, std::unique_ptr<Shape> shape) {
    auto leaf = std::make_unique<Leaf>(std::move(shape), Transform());
    leaf->set_opaque(!m_setup.flags || integer(3) != 0);
    if (m_setup.flags) {
      Attributes a;
      a.no_image = integer(5) == 0;
      a.no_reflection = integer(5) == 0;
      a.no_shadow = integer(5) == 0;
      leaf->set_attributes(a);
    }
    out.push_back(std::move(leaf));
  }
  Objects objects(int count) {
    Objects out;
    for (int i = 0; i < count; ++i) {
      const Vec3 p = place();
      const double size = m_setup.detail * (0.1 + unit());
      const auto corner = [&] { return p + point() * size; };
      switch (integer(6)) {
        case 0:
        case 1: add(out, std::make_unique<Sphere>(p, size)); break;
        case 2: add(out, std::make_unique<Triangle>(corner(), corner(), corner())); break;
        case 3: add(out, std::make_unique<Box>(corner(), corner())); break;
        case 4: add(out, polygon(p, size)); break;
        default: add(out, std::make_unique<Cylinder>(corner(), corner(), size / 4)); break;
      }
      // Now and then the same again: equal distances.
      if (integer(8) == 0) add(out, std::make_unique<Sphere>(p, size));
    }
    if (m_setup.infinite) {
      add(out, std::make_unique<Plane>(Vec3{0.1, 1, 0.2}, dot(m_setup.offset, {0.1, 1, 0.2})));
      add(out, std::make_unique<Plane>(point(), 0.3));
    }
    return out;
  }
  /// Of three to seven corners, at times upright on an axis.
  std::unique_ptr<Shape> polygon(const Vec3& at, double size) {
    const Vec3 normal = integer(3) == 0 ? Vec3{0, 1, 0} : normalized(point());
    const Vec3 u = normalized(cross(normal, {0.3, 0.2, 0.9})), v = cross(normal, u);
    std::vector<Vec3> corners;
    const int n = 3 + integer(5);
    for (int i = 0; i < n; ++i) {
      const double a = 6.283185307 * i / n, r = size * (0.5 + 0.5 * unit());
      corners.push_back(at + u * (r * std::cos(a)) + v * (r * std::sin(a)));
    }
    corners.push_back(corners.front());
    return std::make_unique<Polygon>(std::move(corners));
  }
  Vec3 place() { return m_setup.offset + point() * m_setup.scale; }
  Ray ray() {
    const Vec3 from = place() + point() * (m_setup.far * unit());
    Vec3 d = place() - from;
    const int kind = integer(8);
    if (kind < 3) d[kind] = 0.0;
    if (kind == 3) d = {0, 0, d.z};
    return {from, integer(2) ? normalized(d) : d};
  }
  double unit() { return std::uniform_real_distribution<double>(0, 1)(m_random); }
  Vec3 point() { return {2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1}; }
  int integer(int below) { return std::uniform_int_distribution<int>(0, below - 1)(m_random); }

 private:
  TestScene m_setup;
  std::mt19937_64 m_random{99};
};

}  // namespace lentray::test
