// How steep the function of an isosurface turned out to be along the rays that were searched, beside
// the max_gradient it was given. What it finds depends on the rays: a picture with holes may hide it.
// note(): any number of threads; the rest after rendering.
// Source: when stock 3.7 warns of it, measured with functions of known slope
// (tests/unit/numeric/geometry_slope_watch_test.cpp).
#pragma once

#include <atomic>
#include <string>

namespace lentray::core {

class SlopeWatch {
 public:
  explicit SlopeWatch(double max_gradient) : m_max_gradient(max_gradient) {}

  void note(double slope) {
    double seen = m_steepest.load(std::memory_order_relaxed);
    while (slope > seen &&
           !m_steepest.compare_exchange_weak(seen, slope, std::memory_order_relaxed)) {
    }
  }

  double max_gradient() const { return m_max_gradient; }
  double steepest() const { return m_steepest.load(std::memory_order_relaxed); }

  /// What to say to the user; empty where max_gradient suits what was seen, or nothing was.
  std::string advice() const;

 private:
  double m_max_gradient;
  std::atomic<double> m_steepest{0.0};
};

}  // namespace lentray::core
