#include "tools/lentray-views/zones.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "camera/lenticular.h"
#include "tools/lentray-views/slanted.h"

namespace lentray::views {
namespace {

double tangent_of(double degrees) { return std::tan(degrees * std::numbers::pi / 180.0); }
double degrees_of(double tangent) { return std::atan(tangent) * 180.0 / std::numbers::pi; }

/// What the lens in the sheet's middle shows to an eye at that tangent.
double middle_cell(const Sheet& sheet, double tangent, double distance) {
  const std::vector<double> cells = cells_seen(sheet, {degrees_of(tangent), distance});
  return cells[cells.size() / 2];
}

/// The tangent at which that place of the cell is seen: places grow as tangents fall.
double tangent_that_sees(const Sheet& sheet, double place, double distance) {
  constexpr int kHalvings = 60;
  double low = -tangent_of(85.0), high = -low;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (middle_cell(sheet, middle, distance) > place ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::string zone_text(double cell) { return std::to_string(std::llround(std::floor(cell))); }

}  // namespace

EyePair eyes_beside(const Eye& middle, double separation) {
  const double tangent = tangent_of(middle.angle), half = 0.5 * separation / middle.distance;
  return {{degrees_of(tangent - half), middle.distance},
          {degrees_of(tangent + half), middle.distance}};
}

EyePair eyes_in_one_zone(const Sheet& sheet, const Eye& middle, double separation) {
  const double distance = middle.distance, tangent = tangent_of(middle.angle);
  const double zone = std::floor(middle_cell(sheet, tangent, distance));
  // The middles of the outermost views.
  const double edge = 0.5 / camera::usual_views(sheet.lenses);
  const double right = tangent_that_sees(sheet, zone + edge, distance),
               left = tangent_that_sees(sheet, zone + 1.0 - edge, distance);
  const double half = 0.5 * std::min(separation / distance, std::max(0.0, right - left));
  const double centre = std::clamp(tangent, left + half, std::max(left + half, right - half));
  return {{degrees_of(centre - half), distance}, {degrees_of(centre + half), distance}};
}

std::vector<std::string> warnings_of_eyes(const Sheet& sheet, const EyePair& eyes) {
  const std::vector<double> left = cells_seen(sheet, eyes.left),
                            right = cells_seen(sheet, eyes.right);
  std::size_t apart = 0, reversed = 0, example = left.size() / 2;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const double own_left = std::floor(left[i]), own_right = std::floor(right[i]);
    if (own_left == own_right) continue;
    if (apart == 0 || i == left.size() / 2) example = i;
    ++apart;
    if (left[i] - own_left < right[i] - own_right) ++reversed;
  }
  if (apart == 0) return {};
  const auto share = [&](std::size_t count) {
    if (count == left.size()) return std::string();
    return " in " + std::to_string((100 * count + left.size() / 2) / left.size()) +
           " % of the sheet";
  };
  return {"the two eyes look into two zones" + share(apart) + ", the left one into zone " +
          zone_text(left[example]) + " and the right one into zone " + zone_text(right[example]) +
          (reversed > 0 ? ": depth is reversed" + share(reversed) : ": depth is wrong") +
          "; --one-zone has both look into one, --eyes MM says how far apart they are"};
}

std::vector<std::string> warnings_of_views(const Range& pair) {
  if (pair.first >= pair.last) return {};
  return {"--pair " + std::to_string(pair.first) + "," + std::to_string(pair.last) + ": view " +
          std::to_string(pair.first) + " is seen from the right of view " +
          std::to_string(pair.last) + ": depth is reversed"};
}

}  // namespace lentray::views
