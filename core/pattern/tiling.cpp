#include "core/pattern/tiling.h"

#include "core/pattern/golden_pentagons.h"
#include "core/pattern/golden_triangles.h"
#include "core/pattern/tile_lattice.h"
#include "core/pattern/tile_plans.h"

namespace lentray::core {

PatternPtr make_tiling(int number) {
  switch (number) {
    case 1:
    case 6:
    case 10:
    case 11:
    case 12:
    case 13:
    case 14:
    case 15:
    case 18: return make_tile_lattice(plan_of_squares(number));
    case 25: return make_golden_pentagons();
    case 26: return make_golden_triangles(GoldenTiles::kKitesAndDarts);
    case 27: return make_golden_triangles(GoldenTiles::kRhombs);
    default: return make_tile_lattice(plan_of_polygons(number));
  }
}

}  // namespace lentray::core
