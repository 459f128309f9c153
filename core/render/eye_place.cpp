#include "core/render/eye_place.h"

#include <cmath>

namespace lentray::core {
namespace {

double part_of(double turns) { return turns - std::floor(turns) - 0.5; }

}  // namespace

SpreadPlace spread_place(const EyePlace& at, std::uint32_t number) {
  const auto i = static_cast<double>(2 * at.row + at.view), s = static_cast<double>(number),
             lens = static_cast<double>(at.lens);
  return {part_of(0.5 + 0.81917 * i + 0.75488 * s + 0.4326 * lens),
          part_of(0.5 + 0.67104 * i + 0.56984 * s + 0.3989 * lens)};
}

SpreadPlace spread_place(const EyePlace& at, std::uint32_t number, std::uint32_t count) {
  const double within = spread_place(at, 0).across;
  return {(number + 0.5 + within) / count - 0.5, spread_place(at, number).down};
}

}  // namespace lentray::core
