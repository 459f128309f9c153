#include "tests/stability/polynomials/sturm.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/bracket.h"

namespace lentray::stability {
namespace {

double value(const Polynomial& p, double x) {
  double f = p.c[0];
  for (int k = 1; k <= p.order; ++k) f = f * x + p.c[static_cast<std::size_t>(k)];
  return f;
}

/// p, its derivative, and the negative remainders of their divisions.
struct Chain {
  std::array<Polynomial, kMaxOrder + 1> member;
  int size = 2;

  explicit Chain(const Polynomial& p) {
    member[0] = p;
    member[1].order = p.order - 1;
    for (int k = 0; k < p.order; ++k) member[1].c[at(k)] = (p.order - k) * p.c[at(k)];
    while (member[at(size - 1)].order > 0 && add_remainder()) ++size;
  }

  int changes(double x) const {
    int count = 0;
    double last = 0.0;
    for (int i = 0; i < size; ++i) {
      const double f = value(member[at(i)], x);
      if (f == 0.0) continue;
      if (last != 0.0 && (f < 0.0) != (last < 0.0)) ++count;
      last = f;
    }
    return count;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  /// False where nothing but rounding is left.
  bool add_remainder() {
    constexpr double kNothing = 1e-13;
    Polynomial a = member[at(size - 2)];
    const Polynomial& b = member[at(size - 1)];
    double before = 0.0;
    for (int k = 0; k <= a.order; ++k) before = std::max(before, std::fabs(a.c[at(k)]));
    for (int k = 0; k <= a.order - b.order; ++k) {
      const double factor = a.c[at(k)] / b.c[0];
      for (int j = 0; j <= b.order; ++j) a.c[at(k + j)] -= factor * b.c[at(j)];
    }
    int first = a.order - b.order + 1;
    while (first <= a.order && std::fabs(a.c[at(first)]) <= kNothing * before) ++first;
    if (first > a.order) return false;
    Polynomial& rest = member[at(size)];
    rest.order = a.order - first;
    double most = 0.0;
    for (int k = first; k <= a.order; ++k) most = std::max(most, std::fabs(a.c[at(k)]));
    for (int k = 0; k <= rest.order; ++k) rest.c[at(k)] = -a.c[at(first + k)] / most;
    return true;
  }
};

struct Search {
  const Polynomial& p;
  const Chain& chain;
  double* roots;
  int n = 0;

  void between(double lo, int lo_changes, double hi, int hi_changes) {
    constexpr double kNarrow = 4e-16;
    const int count = lo_changes - hi_changes;
    if (count <= 0 || n >= p.order) return;
    const double middle = 0.5 * (lo + hi);
    const bool narrow = hi - lo <= kNarrow * std::max(std::fabs(lo), std::fabs(hi)) ||
                        !(middle > lo && middle < hi);
    if (narrow) {
      roots[n++] = middle;
      return;
    }
    if (count == 1) {
      const double flo = value(p, lo), fhi = value(p, hi);
      if (fhi == 0.0 || (flo < 0.0) != (fhi < 0.0)) {
        roots[n++] = fhi == 0.0 ? hi
                                : core::bracketed_root([&](double x) { return value(p, x); }, lo,
                                                       flo, hi, fhi);
        return;
      }
    }
    const int changes = chain.changes(middle);
    between(lo, lo_changes, middle, changes);
    between(middle, changes, hi, hi_changes);
  }
};

}  // namespace

int sturm(const Polynomial& p, double* roots) {
  double bound = 0.0;
  for (int k = 1; k <= p.order; ++k) {
    const double ratio = std::fabs(p.c[static_cast<std::size_t>(k)] / p.c[0]);
    bound = std::max(bound, 2.0 * std::pow(ratio, 1.0 / k));
  }
  const Chain chain(p);
  Search search{p, chain, roots};
  search.between(-bound, chain.changes(-bound), bound, chain.changes(bound));
  return search.n;
}

}  // namespace lentray::stability
