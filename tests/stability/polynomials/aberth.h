// All complex roots at once: Aberth's iteration from Bini's starting points, for any kind of number.
// Source: D. Bini, "Numerical computation of polynomial zeros by means of Aberth's method", 1996.
#pragma once

#include <cmath>
#include <vector>

#include "tests/stability/polynomials/polynomial.h"

namespace lentray::stability {

template <class Real>
struct Complex {
  Real re{}, im{};
  Complex operator+(const Complex& o) const { return {re + o.re, im + o.im}; }
  Complex operator-(const Complex& o) const { return {re - o.re, im - o.im}; }
  Complex operator*(const Complex& o) const {
    return {re * o.re - im * o.im, re * o.im + im * o.re};
  }
  Complex inverse() const {
    const Real size = Real(1) / (re * re + im * im);
    return {re * size, -im * size};
  }
  Real size2() const { return re * re + im * im; }
};

/// Points on circles whose radii the upper hull of the coefficients' logarithms gives.
template <class Real>
std::vector<Complex<Real>> starting_points(const Polynomial& p) {
  std::vector<int> hull;
  const auto high = [&](int power) {  // logarithm of the coefficient of x^power
    const double c = std::fabs(p.c[static_cast<std::size_t>(p.order - power)]);
    return c > 0.0 ? std::log(c) : -1e9;
  };
  for (int k = 0; k <= p.order; ++k) {
    while (hull.size() >= 2) {
      const int a = hull[hull.size() - 2], b = hull.back();
      if ((high(b) - high(a)) * (k - a) > (high(k) - high(a)) * (b - a)) break;
      hull.pop_back();
    }
    hull.push_back(k);
  }
  std::vector<Complex<Real>> points;
  for (std::size_t i = 0; i + 1 < hull.size(); ++i) {
    const int a = hull[i], b = hull[i + 1];
    const double radius = std::exp((high(a) - high(b)) / (b - a));
    for (int k = 0; k < b - a; ++k) {
      const double angle =
          6.283185307179586 * (k / static_cast<double>(b - a) + i / static_cast<double>(p.order)) +
          0.7;
      points.push_back({Real(radius * std::cos(angle)), Real(radius * std::sin(angle))});
    }
  }
  return points;
}

/// Until no root moves by more than `close` times its size, or `steps` rounds.
template <class Real>
std::vector<Complex<Real>> aberth(const Polynomial& p, const Real& close, int steps) {
  std::vector<Complex<Real>> z = starting_points<Real>(p);
  std::vector<bool> done(z.size());
  bool moving = true;
  for (int step = 0; step < steps && moving; ++step) {
    moving = false;
    for (std::size_t i = 0; i < z.size(); ++i) {
      if (done[i]) continue;
      Complex<Real> f{Real(p.c[0]), Real(0)}, slope;
      for (int k = 1; k <= p.order; ++k) {
        slope = slope * z[i] + f;
        f = f * z[i];
        f.re += Real(p.c[static_cast<std::size_t>(k)]);
      }
      if (f.size2() == Real(0)) {
        done[i] = true;
        continue;
      }
      Complex<Real> sum = slope * f.inverse();
      for (std::size_t j = 0; j < z.size(); ++j) {
        const Complex<Real> apart = z[i] - z[j];
        if (j != i && apart.size2() > Real(0)) sum = sum - apart.inverse();
      }
      if (!(sum.size2() > Real(0))) continue;
      const Complex<Real> change = sum.inverse();
      z[i] = z[i] - change;
      if (change.size2() <= close * close * z[i].size2()) {
        done[i] = true;
      } else {
        moving = true;
      }
    }
  }
  return z;
}

}  // namespace lentray::stability
