// A root of any continuous function between two points of different sign: never leaves the bracket,
// and takes at most twice the steps of bisection (Illinois steps, bisection where they stall).
#pragma once

#include <cmath>

namespace lentray::core {

/// f(lo) and f(hi), given, have different signs. Stops when the bracket is below `close` times its
/// greater end, or cannot shrink.
template <class Function>
double bracketed_root(const Function& f, double lo, double flo, double hi, double fhi,
                      double close = 1e-15) {
  constexpr int kMaxSteps = 100;
  int side = 0;
  double x = lo;
  for (int step = 0; step < kMaxSteps; ++step) {
    const double size = std::fmax(std::fabs(lo), std::fabs(hi));
    if (hi - lo <= close * size) break;
    x = step % 3 == 2 ? 0.5 * (lo + hi) : (lo * fhi - hi * flo) / (fhi - flo);
    if (!(x > lo && x < hi)) {
      x = 0.5 * (lo + hi);
      if (!(x > lo && x < hi)) break;
    }
    const double fx = f(x);
    if (fx == 0.0) return x;
    if ((fx > 0.0) == (fhi > 0.0)) {
      hi = x;
      fhi = fx;
      if (side == 1) flo *= 0.5;
      side = 1;
    } else {
      lo = x;
      flo = fx;
      if (side == -1) fhi *= 0.5;
      side = -1;
    }
  }
  return x;
}

}  // namespace lentray::core
