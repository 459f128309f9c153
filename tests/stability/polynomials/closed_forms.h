// Orders 2 to 4 by formula, as textbooks have it.
#pragma once

#include "tests/stability/polynomials/polynomial.h"

namespace lentray::stability {

int closed_form(const Polynomial& p, double* roots);
/// Each root bettered by up to four Newton steps, as long as they help.
int polished_closed_form(const Polynomial& p, double* roots);

}  // namespace lentray::stability
