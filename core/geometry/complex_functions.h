// The functions of a complex number that hypercomplex Julia sets iterate: principal values, their
// logarithms and roots cut along the negative real axis. Near poles they overflow to infinity.
#pragma once

#include <cmath>

namespace lentray::core {

struct Complex {
  double re = 0.0, im = 0.0;
};

inline Complex operator*(const Complex& a, const Complex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

namespace complex_functions {

/// cosh and sinh of one number.
struct Hyperbolic {
  explicit Hyperbolic(double x) {
    const double e = std::exp(x), inverse = 1.0 / e;
    cosh = 0.5 * (e + inverse);
    sinh = 0.5 * (e - inverse);
  }
  double cosh, sinh;
};

struct Exp {
  Complex operator()(const Complex& z) const {
    const double size = std::exp(z.re);
    return {size * std::cos(z.im), size * std::sin(z.im)};
  }
};

struct Ln {
  Complex operator()(const Complex& z) const {
    return {0.5 * std::log(z.re * z.re + z.im * z.im), std::atan2(z.im, z.re)};
  }
};

struct Sin {
  Complex operator()(const Complex& z) const {
    const Hyperbolic h(z.im);
    return {std::sin(z.re) * h.cosh, std::cos(z.re) * h.sinh};
  }
};

struct Cos {
  Complex operator()(const Complex& z) const {
    const Hyperbolic h(z.im);
    return {std::cos(z.re) * h.cosh, -std::sin(z.re) * h.sinh};
  }
};

struct Sinh {
  Complex operator()(const Complex& z) const {
    const Hyperbolic h(z.re);
    return {h.sinh * std::cos(z.im), h.cosh * std::sin(z.im)};
  }
};

struct Cosh {
  Complex operator()(const Complex& z) const {
    const Hyperbolic h(z.re);
    return {h.cosh * std::cos(z.im), h.sinh * std::sin(z.im)};
  }
};

/// By double angles: tan z = (sin 2x + i sinh 2y) / (cos 2x + cosh 2y).
struct Tan {
  Complex operator()(const Complex& z) const {
    const Hyperbolic h(2.0 * z.im);
    const double inverse = 1.0 / (std::cos(2.0 * z.re) + h.cosh);
    return {std::sin(2.0 * z.re) * inverse, h.sinh * inverse};
  }
};

struct Tanh {
  Complex operator()(const Complex& z) const {
    const Hyperbolic h(2.0 * z.re);
    const double inverse = 1.0 / (h.cosh + std::cos(2.0 * z.im));
    return {h.sinh * inverse, std::sin(2.0 * z.im) * inverse};
  }
};

/// The root with a real part that is not negative; its other part's sign is that of z.im.
inline Complex square_root(const Complex& z) {
  const double size = std::sqrt(z.re * z.re + z.im * z.im);
  if (size == 0.0) return {};
  const double large = std::sqrt(0.5 * (size + std::fabs(z.re)));
  const double small = 0.5 * std::fabs(z.im) / large;
  return {z.re >= 0.0 ? large : small, std::copysign(z.re >= 0.0 ? small : large, z.im)};
}

/// ln(z + sqrt(z2 + add))
inline Complex inverse_hyperbolic(const Complex& z, double add) {
  const Complex square = z * z;
  const Complex root = square_root({square.re + add, square.im});
  return Ln()({root.re + z.re, root.im + z.im});
}

struct Asinh {
  Complex operator()(const Complex& z) const { return inverse_hyperbolic(z, 1.0); }
};

struct Acosh {
  Complex operator()(const Complex& z) const { return inverse_hyperbolic(z, -1.0); }
};

struct Acos {
  Complex operator()(const Complex& z) const {
    const Complex l = inverse_hyperbolic(z, -1.0);
    return {l.im, -l.re};
  }
};

/// -i ln(i z + sqrt(1 - z2))
struct Asin {
  Complex operator()(const Complex& z) const {
    const Complex square = z * z;
    const Complex root = square_root({1.0 - square.re, -square.im});
    const Complex l = Ln()({root.re - z.im, root.im + z.re});
    return {l.im, -l.re};
  }
};

/// Half of ln((1 + z) / (1 - z))
struct Atanh {
  Complex operator()(const Complex& z) const {
    const double x2 = z.re * z.re, y2 = z.im * z.im;
    const double up = 1.0 + z.re, down = 1.0 - z.re;
    return {0.25 * std::log((up * up + y2) / (down * down + y2)),
            0.5 * std::atan2(2.0 * z.im, 1.0 - x2 - y2)};
  }
};

/// -i atanh(i z)
struct Atan {
  Complex operator()(const Complex& z) const {
    const Complex l = Atanh()({-z.im, z.re});
    return {l.im, -l.re};
  }
};

struct Power {
  Complex exponent;
  Complex operator()(const Complex& z) const {
    if (z.re == 0.0 && z.im == 0.0) return {};
    return Exp()(Ln()(z) * exponent);
  }
};

}  // namespace complex_functions
}  // namespace lentray::core
