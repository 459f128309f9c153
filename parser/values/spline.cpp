#include "parser/values/spline.h"

#include <algorithm>

namespace lentray::parser {
namespace {

using Values = std::array<double, 5>;

template <typename Op>
Values componentwise(Op op) {
  Values out{};
  for (std::size_t c = 0; c < out.size(); ++c) out[c] = op(c);
  return out;
}

// The parabola through three knots.
Values quadratic(const SplineKnot& a, const SplineKnot& b, const SplineKnot& c, double t) {
  const double wa = (t - b.at) * (t - c.at) / ((a.at - b.at) * (a.at - c.at));
  const double wb = (t - a.at) * (t - c.at) / ((b.at - a.at) * (b.at - c.at));
  const double wc = (t - a.at) * (t - b.at) / ((c.at - a.at) * (c.at - b.at));
  return componentwise(
      [&](std::size_t i) { return a.value[i] * wa + b.value[i] * wb + c.value[i] * wc; });
}

Values catmull_rom(const SplineKnot& before, const SplineKnot& a, const SplineKnot& b,
                   const SplineKnot& after, double t) {
  const double step = b.at - a.at, u = (t - a.at) / step;
  return componentwise([&](std::size_t i) {
    // Slopes at the ends: the mean of the chords to both sides.
    const double chord = (b.value[i] - a.value[i]) / step;
    const double slope_a = (chord + (a.value[i] - before.value[i]) / (a.at - before.at)) / 2.0;
    const double slope_b = (chord + (after.value[i] - b.value[i]) / (after.at - b.at)) / 2.0;
    return (2 * u * u * u - 3 * u * u + 1) * a.value[i] +
           (u * u * u - 2 * u * u + u) * step * slope_a + (3 * u * u - 2 * u * u * u) * b.value[i] +
           (u * u * u - u * u) * step * slope_b;
  });
}

Values natural(const SplineKnot& a, const SplineKnot& b, double t) {
  const double step = b.at - a.at;
  const double p = (b.at - t) / step, q = (t - a.at) / step;
  return componentwise([&](std::size_t i) {
    return p * a.value[i] + q * b.value[i] +
           ((p * p * p - p) * a.curvature[i] + (q * q * q - q) * b.curvature[i]) * step * step /
               6.0;
  });
}

}  // namespace

void SplineDesc::add(double at, const Values& value) {
  const auto place = std::lower_bound(knots.begin(), knots.end(), at,
                                      [](const SplineKnot& k, double t) { return k.at < t; });
  if (place != knots.end() && place->at == at) {
    const bool last = knots.size() > 1 && place + 1 == knots.end();
    if (!last) place->value = value;
  } else {
    knots.insert(place, {at, value, {}});
  }
}

// Second derivatives of the natural cubic spline: zero at the ends, a tridiagonal system between.
void SplineDesc::prepare() {
  const std::size_t n = knots.size();
  for (SplineKnot& k : knots) k.curvature = {};
  if (kind != SplineKind::kNatural || n < 3) return;
  for (std::size_t c = 0; c < 5; ++c) {
    std::vector<double> upper(n, 0.0), right(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double before = knots[i].at - knots[i - 1].at, after = knots[i + 1].at - knots[i].at;
      const double bend = (knots[i + 1].value[c] - knots[i].value[c]) / after -
                          (knots[i].value[c] - knots[i - 1].value[c]) / before;
      const double pivot = 2.0 * (before + after) - before * upper[i - 1];
      upper[i] = after / pivot;
      right[i] = (6.0 * bend - before * right[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 1;) {
      knots[i].curvature[c] = right[i] - upper[i] * knots[i + 1].curvature[c];
    }
  }
}

Values SplineDesc::evaluate(double at) const {
  const std::size_t n = knots.size();
  if (n == 0) return {};
  const bool cubic = kind == SplineKind::kCubic;
  if (n == 1) return knots[0].value;
  // Too few points for a cubic spline: stock gives the middle, whatever `at`.
  if (cubic && n == 2) {
    return componentwise(
        [&](std::size_t c) { return (knots[0].value[c] + knots[1].value[c]) / 2.0; });
  }
  if (cubic && n == 3) return knots[1].value;
  const std::size_t first = cubic ? 1 : 0, last = cubic ? n - 2 : n - 1;
  if (at <= knots[first].at) return knots[first].value;
  if (at >= knots[last].at) return knots[last].value;
  const auto above = std::upper_bound(knots.begin(), knots.end(), at,
                                      [](double t, const SplineKnot& k) { return t < k.at; });
  const std::size_t i = static_cast<std::size_t>(above - knots.begin()) - 1;
  switch (kind) {
    case SplineKind::kQuadratic: {
      if (n < 3) break;
      const std::size_t j = i == 0 ? 1 : i;
      return quadratic(knots[j - 1], knots[j], knots[j + 1], at);
    }
    case SplineKind::kCubic:
      return catmull_rom(knots[i - 1], knots[i], knots[i + 1], knots[i + 2], at);
    case SplineKind::kNatural: return natural(knots[i], knots[i + 1], at);
    default: break;
  }
  const double u = (at - knots[i].at) / (knots[i + 1].at - knots[i].at);
  return componentwise([&](std::size_t c) {
    return knots[i].value[c] + (knots[i + 1].value[c] - knots[i].value[c]) * u;
  });
}

}  // namespace lentray::parser
