#include "core/pattern/fractal.h"

#include <algorithm>
#include <cmath>

#include "core/base/whole.h"
#include "core/numeric/complex_functions.h"

namespace lentray::core {
namespace {

Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
Complex operator+(Complex a, double real) { return {a.re + real, a.im}; }
Complex operator*(double s, Complex a) { return {s * a.re, s * a.im}; }
Complex operator/(Complex a, Complex b) {
  const double square = b.re * b.re + b.im * b.im;
  return {(a.re * b.re + a.im * b.im) / square, (a.im * b.re - a.re * b.im) / square};
}
double square_of(Complex a) { return a.re * a.re + a.im * a.im; }

class FractalPattern final : public Pattern {
 public:
  explicit FractalPattern(const Fractal& fractal) : m_fractal(fractal) {}

  double value(const Vec3& p) const override {
    const Complex point{p.x, p.y};
    const Complex c =
        m_fractal.julia ? Complex{m_fractal.parameter.u, m_fractal.parameter.v} : point;
    // The magnet's own set starts at 0; all others at the point.
    if (m_fractal.magnet == 0 && m_fractal.exponent == 2) return quadratic(point, c);
    const bool from_zero = m_fractal.magnet != 0 && !m_fractal.julia;
    Complex z = from_zero ? Complex{} : point;
    double least = from_zero ? 10000.0 : square_of(z);
    for (int i = 0; i < m_fractal.iterations; ++i) {
      z = step(z, c);
      const double norm = square_of(z);
      least = std::min(least, norm);
      if (escaped(z, norm)) return exterior(i, z);
    }
    return interior(z, least);
  }

 private:
  /// The same operations for z^2 + c, with the squares that the norm is made of used again.
  double quadratic(Complex z, Complex c) const {
    double re2 = z.re * z.re, im2 = z.im * z.im, least = re2 + im2;
    for (int i = 0; i < m_fractal.iterations; ++i) {
      const double product = z.re * z.im;
      z = {re2 - im2 + c.re, product + product + c.im};
      re2 = z.re * z.re;
      im2 = z.im * z.im;
      const double norm = re2 + im2;
      least = std::min(least, norm);
      if (norm > 4.0) return exterior(i, z);
    }
    return interior(z, least);
  }
  Complex step(Complex z, Complex c) const {
    if (m_fractal.magnet == 1) {
      const Complex root = (z * z + c + -1.0) / (2.0 * z + c + -2.0);
      return root * root;
    }
    if (m_fractal.magnet == 2) {
      const Complex c1 = c + -1.0, c2 = c + -2.0, both = c1 * c2;
      const Complex root =
          (z * z * z + 3.0 * (c1 * z) + both) / (3.0 * (z * z) + 3.0 * (c2 * z) + both + 1.0);
      return root * root;
    }
    Complex power = z;
    for (int i = 1; i < m_fractal.exponent; ++i) power = power * z;
    return power + c;
  }
  bool escaped(Complex z, double norm) const {
    if (m_fractal.magnet == 0) return norm > 4.0;
    return norm > 10000.0 || square_of(z + -1.0) < 1e-4;
  }
  double exterior(int iteration, Complex z) const {
    const double factor = m_fractal.exterior_factor;
    switch (m_fractal.exterior_type) {
      case 0: return factor;
      case 1: return static_cast<double>(iteration) / m_fractal.iterations;
      case 2: return z.re * factor;
      case 3: return z.im * factor;
      case 4: return z.re * z.re * factor;
      case 5: return z.im * z.im * factor;
      case 6: return std::sqrt(square_of(z)) * factor;
      case 7: return remainder(iteration, whole_of(factor)) / factor;
      case 8: return remainder(iteration, whole_of(1.0 + factor)) / factor;
      default: return 0.0;
    }
  }
  static double remainder(int iteration, int modulus) {
    return modulus == 0 ? 0.0 : iteration % modulus;
  }
  double interior(Complex z, double least) const {
    const double factor = m_fractal.interior_factor;
    switch (m_fractal.interior_type) {
      case 0: return factor;
      case 1: return std::sqrt(least) * factor;
      case 2: return z.re * factor;
      case 3: return z.im * factor;
      case 4: return z.re * z.re * factor;
      case 5: return z.im * z.im * factor;
      case 6: return z.re * z.re + z.im * z.im * factor;  // the factor counts once
      default: return 0.0;
    }
  }
  Fractal m_fractal;
};

}  // namespace

PatternPtr make_fractal(const Fractal& fractal) {
  return std::make_unique<FractalPattern>(fractal);
}

}  // namespace lentray::core
