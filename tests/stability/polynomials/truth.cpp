#include "tests/stability/polynomials/truth.h"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "tests/stability/polynomials/aberth.h"

namespace lentray::stability {
namespace {

using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                             boost::multiprecision::et_off>;
constexpr double kEpsilon = 1.1e-16;

Number value(const Polynomial& p, const Number& x) {
  Number f = p.c[0];
  for (int k = 1; k <= p.order; ++k) f = f * x + p.c[static_cast<std::size_t>(k)];
  return f;
}

/// Sum of |c x^k|.
double size_of_terms(const Polynomial& p, double x) {
  double sum = std::fabs(p.c[0]);
  for (int k = 1; k <= p.order; ++k) {
    sum = sum * std::fabs(x) + std::fabs(p.c[static_cast<std::size_t>(k)]);
  }
  return sum;
}

double slope(const Polynomial& p, const Number& x) {
  Number f = p.c[0], df = 0;
  for (int k = 1; k <= p.order; ++k) {
    df = df * x + f;
    f = f * x + p.c[static_cast<std::size_t>(k)];
  }
  return static_cast<double>(df);
}

bool is_within_rounding(const Polynomial& p, const Number& x) {
  const double f = static_cast<double>(abs(value(p, x)));
  return f <= 2.0 * p.order * kEpsilon * size_of_terms(p, static_cast<double>(x));
}

}  // namespace

Polynomial expanded(const Factors& factors) {
  std::vector<Number> c{Number(factors.leading)};
  const auto multiply = [&](const std::vector<Number>& by) {
    std::vector<Number> product(c.size() + by.size() - 1);
    for (std::size_t i = 0; i < c.size(); ++i) {
      for (std::size_t j = 0; j < by.size(); ++j) product[i + j] += c[i] * by[j];
    }
    c = std::move(product);
  };
  for (const double root : factors.roots) multiply({Number(1), -Number(root)});
  for (const auto& [re, im] : factors.pairs) {
    multiply({Number(1), Number(-2) * re, Number(re) * re + Number(im) * im});
  }
  Polynomial p;
  p.order = static_cast<int>(c.size()) - 1;
  for (std::size_t k = 0; k < c.size(); ++k) p.c[k] = static_cast<double>(c[k]);
  return p;
}

Truth::Truth(const Polynomial& p) : m_polynomial(p) {
  const Number close("1e-80"), real("1e-20");
  constexpr int kSteps = 400;
  std::vector<Number> exact;
  for (const Complex<Number>& z : aberth<Number>(p, close, kSteps)) {
    if (abs(z.im) <= real * abs(z.re)) exact.push_back(z.re);
  }
  std::sort(exact.begin(), exact.end());
  std::vector<bool> hidden_after(exact.size(), false);
  for (std::size_t i = 0; i + 1 < exact.size(); ++i) {
    hidden_after[i] = is_within_rounding(p, (exact[i] + exact[i + 1]) / 2);
  }
  for (std::size_t i = 0; i < exact.size(); ++i) {
    TrueRoot root;
    root.x = static_cast<double>(exact[i]);
    root.condition = size_of_terms(p, root.x) / std::fabs(root.x * slope(p, exact[i]));
    root.is_hidden = hidden_after[i] || (i > 0 && hidden_after[i - 1]);
    m_roots.push_back(root);
  }
}

bool Truth::is_zero_within_rounding(double x) const { return is_within_rounding(m_polynomial, x); }

}  // namespace lentray::stability
