// The functions of a complex number that hypercomplex Julia sets iterate: principal values, their
// logarithms and roots cut along the negative real axis. Near poles they overflow to infinity.
// Those of exponentials, sines and cosines take two numbers side by side, the others one.
#pragma once

#include <cmath>

#include "core/base/pair_math.h"

namespace lentray::core {

struct Complex {
  double re = 0.0, im = 0.0;
};

inline Complex operator*(const Complex& a, const Complex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/// Two complex numbers.
struct ComplexPair {
  Pair re, im;
};

namespace complex_functions {

// slope_squared: of a value's squared size, no less than that of the function's slope there. At a distance d
// from there it is at most e^d times as steep.

/// cosh and sinh of both numbers.
struct Hyperbolic {
  explicit Hyperbolic(Pair x) {
    const Pair e = exp(x), inverse = 1.0 / e;
    cosh = 0.5 * (e + inverse);
    sinh = 0.5 * (e - inverse);
  }
  Pair cosh, sinh;
};

struct Exp {
  static Pair slope_squared(Pair size_squared) { return size_squared; }
  ComplexPair operator()(const ComplexPair& z) const {
    const Pair size = exp(z.re);
    const CosSin turn = cos_sin(z.im);
    return {size * turn.cos, size * turn.sin};
  }
};

struct Ln {
  Complex operator()(const Complex& z) const {
    return {0.5 * std::log(z.re * z.re + z.im * z.im), std::atan2(z.im, z.re)};
  }
};

struct Sin {
  static Pair slope_squared(Pair size_squared) { return 1.0 + size_squared; }
  ComplexPair operator()(const ComplexPair& z) const {
    const Hyperbolic h(z.im);
    const CosSin turn = cos_sin(z.re);
    return {turn.sin * h.cosh, turn.cos * h.sinh};
  }
};

struct Cos {
  static Pair slope_squared(Pair size_squared) { return 1.0 + size_squared; }
  ComplexPair operator()(const ComplexPair& z) const {
    const Hyperbolic h(z.im);
    const CosSin turn = cos_sin(z.re);
    return {turn.cos * h.cosh, -turn.sin * h.sinh};
  }
};

struct Sinh {
  static Pair slope_squared(Pair size_squared) { return 1.0 + size_squared; }
  ComplexPair operator()(const ComplexPair& z) const {
    const Hyperbolic h(z.re);
    const CosSin turn = cos_sin(z.im);
    return {h.sinh * turn.cos, h.cosh * turn.sin};
  }
};

struct Cosh {
  static Pair slope_squared(Pair size_squared) { return 1.0 + size_squared; }
  ComplexPair operator()(const ComplexPair& z) const {
    const Hyperbolic h(z.re);
    const CosSin turn = cos_sin(z.im);
    return {h.cosh * turn.cos, h.sinh * turn.sin};
  }
};

/// By double angles: tan z = (sin 2x + i sinh 2y) / (cos 2x + cosh 2y).
struct Tan {
  ComplexPair operator()(const ComplexPair& z) const {
    const Hyperbolic h(2.0 * z.im);
    const CosSin turn = cos_sin(2.0 * z.re);
    const Pair inverse = 1.0 / (turn.cos + h.cosh);
    return {turn.sin * inverse, h.sinh * inverse};
  }
};

struct Tanh {
  ComplexPair operator()(const ComplexPair& z) const {
    const Hyperbolic h(2.0 * z.re);
    const CosSin turn = cos_sin(2.0 * z.im);
    const Pair inverse = 1.0 / (h.cosh + turn.cos);
    return {h.sinh * inverse, turn.sin * inverse};
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
  ComplexPair operator()(const ComplexPair& z) const {
    const Complex a = Ln()({z.re[0], z.im[0]}) * exponent, b = Ln()({z.re[1], z.im[1]}) * exponent;
    const ComplexPair power = Exp()({Pair{a.re, b.re}, Pair{a.im, b.im}});
    const PairBits is_zero = (z.re == 0.0) & (z.im == 0.0);
    return {pair_math::chosen(is_zero, Pair{}, power.re),
            pair_math::chosen(is_zero, Pair{}, power.im)};
  }
};

}  // namespace complex_functions
}  // namespace lentray::core
