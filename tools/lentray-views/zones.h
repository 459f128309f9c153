// Two eyes before a sheet. A lens shows its own strip within its zone; beyond that the strips of its neighbours, and
// every view again. Eyes that look into two zones see views that do not belong together: where the left eye's view lies
// to the right of the right eye's, depth is reversed.
// Zones are numbered by the strip that is seen: 0 is a lens's own, -1 that of the lens to its left, which eyes far to the
// right see. Lengths in mm, angles in degrees. Errors: none. Pure.
#pragma once

#include <string>
#include <vector>

#include "tools/lentray-views/arguments.h"
#include "tools/lentray-views/sheet.h"
#include "tools/lentray-views/strips.h"

namespace lentray::views {

struct EyePair {
  Eye left, right;
};

/// So far apart, on both sides of an eye that has a distance.
EyePair eyes_beside(const Eye& middle, double separation);
/// In the zone that the eye in the middle looks into at the sheet's middle: moved to the side as little as that takes,
/// and closer together where the zone is narrower, to its outermost views.
EyePair eyes_in_one_zone(const Sheet& sheet, const Eye& middle, double separation);

/// That the eyes look into two zones, of all lenses or of some; or nothing.
std::vector<std::string> warnings_of_eyes(const Sheet& sheet, const EyePair& eyes);
/// That the left eye's view lies to the right of the right eye's; or nothing.
std::vector<std::string> warnings_of_views(const Range& pair);

}  // namespace lentray::views
