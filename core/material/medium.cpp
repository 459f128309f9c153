#include "core/material/medium.h"

#include <boost/math/distributions/chi_squared.hpp>

#include "core/base/tiny.h"

namespace lentray::core {
namespace {

/// The value that a chi-square variable exceeds with that probability.
double exceeded(int freedom, double probability) {
  using boost::math::chi_squared;
  if (!(probability > 0.0)) return 0.0;
  return boost::math::quantile(boost::math::complement(chi_squared(freedom), probability));
}

}  // namespace

std::vector<double> find_variance_limits(const MediumSampling& sampling) {
  std::vector<double> limits{0.0};
  if (sampling.max_samples <= 1) return limits;
  const double most = exceeded(sampling.max_samples - 1, sampling.confidence);
  const double scale = most > 0.0 ? sampling.variance / most : sampling.variance * kTiny;
  limits.clear();
  for (int samples = 1; samples <= sampling.max_samples; ++samples) {
    limits.push_back(scale * exceeded(samples, sampling.confidence));
  }
  return limits;
}

}  // namespace lentray::core
