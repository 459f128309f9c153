#include "tests/stability/polynomials/closed_forms.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lentray::stability {
namespace {

int quadratic(double b, double c, double* roots) {
  const double d = b * b - 4.0 * c;
  if (d < 0.0) return 0;
  roots[0] = 0.5 * (-b - std::sqrt(d));
  roots[1] = 0.5 * (-b + std::sqrt(d));
  return 2;
}

int cubic(double a, double b, double c, double* roots) {
  const double q = (a * a - 3.0 * b) / 9.0, r = (a * (2.0 * a * a - 9.0 * b) + 27.0 * c) / 54.0;
  const double q3 = q * q * q;
  if (r * r <= q3 && q3 > 0.0) {
    const double angle = std::acos(std::clamp(r / std::sqrt(q3), -1.0, 1.0));
    for (int k = 0; k < 3; ++k) {
      roots[k] =
          -2.0 * std::sqrt(q) * std::cos((angle + 2.0 * std::numbers::pi * k) / 3.0) - a / 3.0;
    }
    return 3;
  }
  const double s = -std::copysign(std::cbrt(std::fabs(r) + std::sqrt(r * r - q3)), r);
  roots[0] = s + (s == 0.0 ? 0.0 : q / s) - a / 3.0;
  return 1;
}

int quartic(double a, double b, double c, double d, double* roots) {
  const double a2 = a * a;
  const double p = b - 0.375 * a2, q = c - 0.5 * a * b + 0.125 * a2 * a;
  const double r = d - 0.25 * a * c + a2 * b / 16.0 - 3.0 * a2 * a2 / 256.0;
  double z[3];
  const int found = cubic(2.0 * p, p * p - 4.0 * r, -q * q, z);
  const double square = *std::max_element(z, z + found);
  int n = 0;
  if (square > 0.0) {
    const double u = std::sqrt(square);
    n += quadratic(u, 0.5 * (p + square - q / u), roots);
    n += quadratic(-u, 0.5 * (p + square + q / u), roots + n);
  } else {
    double squares[2];
    const int halves = quadratic(p, r, squares);
    for (int i = 0; i < halves; ++i) {
      if (squares[i] < 0.0) continue;
      roots[n++] = -std::sqrt(squares[i]);
      roots[n++] = std::sqrt(squares[i]);
    }
  }
  for (int i = 0; i < n; ++i) roots[i] -= 0.25 * a;
  return n;
}

}  // namespace

int closed_form(const Polynomial& p, double* roots) {
  const double a = p.c[0];
  int n = 0;
  if (p.order == 2) n = quadratic(p.c[1] / a, p.c[2] / a, roots);
  if (p.order == 3) n = cubic(p.c[1] / a, p.c[2] / a, p.c[3] / a, roots);
  if (p.order == 4) n = quartic(p.c[1] / a, p.c[2] / a, p.c[3] / a, p.c[4] / a, roots);
  std::sort(roots, roots + n);
  return n;
}

int polished_closed_form(const Polynomial& p, double* roots) {
  constexpr int kSteps = 4;
  const int n = closed_form(p, roots);
  for (int i = 0; i < n; ++i) {
    double least = HUGE_VAL, x = roots[i];
    for (int step = 0; step <= kSteps; ++step) {
      double f = p.c[0], slope = 0.0;
      for (int k = 1; k <= p.order; ++k) {
        slope = slope * x + f;
        f = f * x + p.c[static_cast<std::size_t>(k)];
      }
      if (!(std::fabs(f) < least)) break;
      least = std::fabs(f);
      roots[i] = x;
      if (f == 0.0 || slope == 0.0) break;
      x -= f / slope;
    }
  }
  std::sort(roots, roots + n);
  return n;
}

}  // namespace lentray::stability
