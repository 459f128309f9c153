#include "core/pattern/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lentray::core {
namespace {

/// Distance 0..1 turned into density 1..0.
double fall(double distance) {
  if (distance < 0.0) return 1.0;
  return distance > 1.0 ? 0.0 : 1.0 - distance;
}

class Gradient final : public Pattern {
 public:
  explicit Gradient(const Vec3& direction) : m_direction(direction) {}
  double value(const Vec3& p) const override {
    const double along = dot(p, m_direction);
    return along > 1.0 ? std::fmod(along, 1.0) : along;
  }

 private:
  Vec3 m_direction;
};

class Onion final : public Pattern {
 public:
  double value(const Vec3& p) const override { return std::fmod(length(p), 1.0); }
};

class Radial final : public Pattern {
 public:
  double value(const Vec3& p) const override {
    if (std::fabs(p.x) < 0.001 && std::fabs(p.z) < 0.001) return 0.25;
    return 0.25 + (std::atan2(p.x, p.z) + std::numbers::pi) / (2.0 * std::numbers::pi);
  }
};

class Spherical final : public Pattern {
 public:
  double value(const Vec3& p) const override { return fall(length(p)); }
};

class Cylindrical final : public Pattern {
 public:
  double value(const Vec3& p) const override { return fall(std::sqrt(p.x * p.x + p.z * p.z)); }
};

class Planar final : public Pattern {
 public:
  double value(const Vec3& p) const override { return fall(std::fabs(p.y)); }
};

class Boxed final : public Pattern {
 public:
  double value(const Vec3& p) const override {
    return fall(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}));
  }
};

class Leopard final : public Pattern {
 public:
  double value(const Vec3& p) const override {
    const double mean = (std::sin(p.x) + std::sin(p.y) + std::sin(p.z)) / 3.0;
    return mean * mean;
  }
};

class Quilted final : public Pattern {
 public:
  Quilted(double control0, double control1) : m_control0(control0), m_control1(control1) {}
  double value(const Vec3& p) const override {
    const Vec3 q = quilt_offset(p, m_control0, m_control1);
    return (std::fabs(q.x) + std::fabs(q.y) + std::fabs(q.z)) / 3.0;
  }

 private:
  double m_control0, m_control1;
};

class FunctionPattern final : public Pattern {
 public:
  explicit FunctionPattern(std::shared_ptr<const Function> function)
      : m_function(std::move(function)) {}
  double value(const Vec3& p) const override {
    const std::array<double, 3> arguments = {p.x, p.y, p.z};
    const double result = m_function->evaluate(arguments);
    return result > 1.0 ? std::fmod(result, 1.0) : result;
  }

 private:
  std::shared_ptr<const Function> m_function;
};

class Inside final : public Pattern {
 public:
  explicit Inside(std::function<bool(const Vec3&)> inside) : m_inside(std::move(inside)) {}
  double value(const Vec3& p) const override { return m_inside(p) ? 1.0 : 0.0; }

 private:
  std::function<bool(const Vec3&)> m_inside;
};

}  // namespace

double quilt_curve(double t, double control0, double control1) {
  // A cubic Bezier from 0 to 1, scaled so that a cell's corner, sqrt(3/4) away, is met.
  const double rest = 1.0 - t;
  const double bezier =
      t * t * t + 3.0 * t * rest * rest * control0 + 3.0 * t * t * rest * control1;
  return bezier * (1.0 / std::sqrt(0.75));
}

Vec3 quilt_offset(const Vec3& point, double control0, double control1) {
  // Whole negative coordinates belong to the cell below.
  const auto place = [](double v) {
    const double cell = v >= 0.0 ? std::floor(v) : -std::floor(-v) - 1.0;
    return v - cell - 0.5;
  };
  const Vec3 q{place(point.x), place(point.y), place(point.z)};
  return q * quilt_curve(length(q), control0, control1);
}

PatternPtr make_gradient(const Vec3& unit_direction) {
  return std::make_unique<Gradient>(unit_direction);
}
PatternPtr make_onion() { return std::make_unique<Onion>(); }
PatternPtr make_radial() { return std::make_unique<Radial>(); }
PatternPtr make_spherical() { return std::make_unique<Spherical>(); }
PatternPtr make_cylindrical() { return std::make_unique<Cylindrical>(); }
PatternPtr make_planar() { return std::make_unique<Planar>(); }
PatternPtr make_boxed() { return std::make_unique<Boxed>(); }
PatternPtr make_leopard() { return std::make_unique<Leopard>(); }
PatternPtr make_quilted(double control0, double control1) {
  return std::make_unique<Quilted>(control0, control1);
}
PatternPtr make_function(std::shared_ptr<const Function> function) {
  return std::make_unique<FunctionPattern>(std::move(function));
}
PatternPtr make_inside(std::function<bool(const Vec3&)> inside) {
  return std::make_unique<Inside>(std::move(inside));
}

}  // namespace lentray::core
