#include "core/numeric/slope_watch.h"

#include <algorithm>

#include "core/base/formed.h"

namespace lentray::core {
namespace {

constexpr double kLarge = 10.0;               ///< from this max_gradient on
constexpr double kShareOfLarge = 0.1;         ///< so much more is let pass,
constexpr double kShare = 0.05, kMost = 0.1;  ///< below it so much, and no more than that
constexpr double kGenerousShare = 0.1, kGenerous = 0.5;  ///< what may be given beyond need

}  // namespace

std::string SlopeWatch::advice() const {
  const double found = steepest();
  if (!(found > 0.0)) return {};
  const double let_pass =
      m_max_gradient < kLarge ? std::min(kShare * found, kMost) : kShareOfLarge * found;
  const char* what = nullptr;
  if (found - m_max_gradient > let_pass) {
    what =
        "max_gradient %.3f is too small: the function is as steep as %.3f, and the isosurface may "
        "have "
        "holes";
  } else if (m_max_gradient - found > std::max(kGenerousShare * found, kGenerous)) {
    what =
        "max_gradient %.3f is more than is needed: the function is no steeper than %.3f along the "
        "rays "
        "of this picture, and with less it renders faster";
  } else {
    return {};
  }
  return formed(what, m_max_gradient, found);
}

}  // namespace lentray::core
