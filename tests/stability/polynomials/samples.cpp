#include "tests/stability/polynomials/samples.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/stability/polynomials/truth.h"

namespace lentray::stability {
namespace {

class Sampler {
 public:
  Sampler(const std::string& kind, int order)
      : m_order(order),
        m_random(static_cast<unsigned>(
            order + 100 * (std::find(kinds().begin(), kinds().end(), kind) - kinds().begin()))) {}

  Factors simple() {
    Factors f;
    const int pairs = order_in(0, (m_order - 1) / 2);
    for (int i = 0; i < pairs; ++i) f.pairs.push_back({in(-1.0, 1.0), in(0.1, 1.0)});
    while (static_cast<int>(f.roots.size()) < m_order - 2 * pairs) {
      const double x = in(-1.0, 1.0);
      const bool apart = std::all_of(f.roots.begin(), f.roots.end(),
                                     [&](double other) { return std::fabs(x - other) >= kApart; });
      if (apart && std::fabs(x) >= kApart) f.roots.push_back(x);
    }
    return f;
  }

  Factors wide() {
    Factors f = simple();
    for (double& root : f.roots) root *= std::pow(10.0, in(-6.0, 6.0) / m_order);
    f.leading = std::pow(10.0, in(-6.0, 6.0));
    return f;
  }

  /// The last two roots `gap` apart.
  Factors with_gap(double gap) {
    Factors f = simple();
    while (f.roots.size() < 2) f = simple();
    f.roots.back() = f.roots[f.roots.size() - 2] + gap;
    return f;
  }

  Polynomial coefficients() {
    Polynomial p;
    p.order = m_order;
    for (int k = 0; k <= m_order; ++k) {
      p.c[static_cast<std::size_t>(k)] =
          std::copysign(std::pow(10.0, in(-6.0, 6.0)), in(-1.0, 1.0));
    }
    return p;
  }

 private:
  static constexpr double kApart = 0.02;
  double in(double lo, double hi) { return lo + (hi - lo) * (m_random() * 0x1p-32); }
  int order_in(int lo, int hi) {
    return lo + static_cast<int>(m_random() % static_cast<unsigned>(hi - lo + 1));
  }

  int m_order;
  std::mt19937 m_random;
};

}  // namespace

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> kKinds = {
      "simple",   "wide",     "coefficients", "double",    "gap 1e-2",
      "gap 1e-4", "gap 1e-6", "gap 1e-8",     "gap 1e-10", "gap 1e-12"};
  return kKinds;
}

std::vector<Polynomial> samples(const std::string& kind, int order, int count) {
  Sampler sampler(kind, order);
  std::vector<Polynomial> result;
  for (int i = 0; i < count; ++i) {
    if (kind == "coefficients")
      result.push_back(sampler.coefficients());
    else if (kind == "simple")
      result.push_back(expanded(sampler.simple()));
    else if (kind == "wide")
      result.push_back(expanded(sampler.wide()));
    else
      result.push_back(
          expanded(sampler.with_gap(kind == "double" ? 0.0 : std::stod(kind.substr(4)))));
  }
  return result;
}

}  // namespace lentray::stability
