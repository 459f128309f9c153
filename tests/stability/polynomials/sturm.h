// All real roots by a Sturm chain, as textbooks have it.
#pragma once

#include "tests/stability/polynomials/polynomial.h"

namespace lentray::stability {

int sturm(const Polynomial& p, double* roots);

}  // namespace lentray::stability
