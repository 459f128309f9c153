// Polynomials to try solvers with: of each order and kind, the same in every run. Any thread.
#pragma once

#include <string>
#include <vector>

#include "tests/stability/polynomials/polynomial.h"

namespace lentray::stability {

/// simple: roots in [-1, 1], 0.02 apart, some pairs of them complex.
/// wide: the same with sizes over some decades, so that the coefficients span up to 12.
/// coefficients: each a random sign and a power of ten from -6 to 6; the roots as they fall.
/// double: simple with one root twice.
/// gap 1e-2 ... gap 1e-12: simple with one root nearly twice.
const std::vector<std::string>& kinds();

std::vector<Polynomial> samples(const std::string& kind, int order, int count);

}  // namespace lentray::stability
