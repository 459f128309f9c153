// Helpers of the geometry tests: repeatable random numbers, rays and transforms.
#pragma once

#include <cmath>
#include <random>

#include "core/base/ray.h"
#include "core/object/object.h"

namespace lentray::core::geometry_test {

class Random {
 public:
  explicit Random(unsigned seed) : m_engine(seed) {}
  double in(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(m_engine()) / 4294967296.0);
  }
  int whole(int lo, int hi) {
    return lo + static_cast<int>(m_engine() % static_cast<unsigned>(hi - lo + 1));
  }
  Vec3 vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = vector(1.0);
      if (length(v) > 0.1 && length(v) < 1.0) return normalized(v);
    }
  }
  /// A ray that starts `far` away and passes within `near` of the origin.
  Ray ray(double far, double near) {
    const Vec3 from = direction() * far;
    return {from, normalized(vector(near) - from)};
  }
  Transform similarity() {
    return Transform::rotation(vector(180.0))
        .then(Transform::scaling(Vec3(in(0.3, 3.0))))
        .then(Transform::translation(vector(5.0)));
  }
  Transform any_transform() {
    return Transform::scaling({in(0.3, 3.0), in(0.3, 3.0), -in(0.3, 3.0)})
        .then(Transform::rotation(vector(180.0)))
        .then(Transform::matrix({{{1.0, in(-0.5, 0.5), 0.0},
                                  {0.0, 1.0, in(-0.5, 0.5)},
                                  {0.0, 0.0, 1.0},
                                  {in(-3.0, 3.0), in(-3.0, 3.0), in(-3.0, 3.0)}}}));
  }

 private:
  std::mt19937 m_engine;
};

}  // namespace lentray::core::geometry_test
