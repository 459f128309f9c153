#include "core/function/internal.h"

#include <string_view>
#include <utility>

#include "core/function/internal_formulas.h"
#include "core/function/noise_function.h"

namespace lentray::core {
namespace {

struct Entry {
  const char* name;
  int extra;  // parameters beside x, y, z
};

constexpr Entry kEntries[] = {
    {"f_algbr_cyl1", 5},
    {"f_algbr_cyl2", 5},
    {"f_algbr_cyl3", 5},
    {"f_algbr_cyl4", 5},
    {"f_bicorn", 2},
    {"f_bifolia", 2},
    {"f_blob", 5},
    {"f_blob2", 4},
    {"f_boy_surface", 2},
    {"f_comma", 1},
    {"f_cross_ellipsoids", 4},
    {"f_crossed_trough", 1},
    {"f_cubic_saddle", 1},
    {"f_cushion", 1},
    {"f_devils_curve", 1},
    {"f_devils_curve_2d", 6},
    {"f_dupin_cyclid", 6},
    {"f_ellipsoid", 3},
    {"f_enneper", 1},
    {"f_flange_cover", 4},
    {"f_folium_surface", 3},
    {"f_folium_surface_2d", 6},
    {"f_glob", 1},
    {"f_heart", 1},
    {"f_helical_torus", 10},
    {"f_helix1", 7},
    {"f_helix2", 7},
    {"f_hex_x", 1},
    {"f_hex_y", 1},
    {"f_hetero_mf", 6},
    {"f_hunt_surface", 1},
    {"f_hyperbolic_torus", 3},
    {"f_isect_ellipsoids", 4},
    {"f_kampyle_of_eudoxus", 3},
    {"f_kampyle_of_eudoxus_2d", 6},
    {"f_klein_bottle", 1},
    {"f_kummer_surface_v1", 1},
    {"f_kummer_surface_v2", 4},
    {"f_lemniscate_of_gerono", 1},
    {"f_lemniscate_of_gerono_2d", 6},
    {"f_mesh1", 5},
    {"f_mitre", 1},
    {"f_nodal_cubic", 1},
    {"f_odd", 1},
    {"f_ovals_of_cassini", 4},
    {"f_paraboloid", 1},
    {"f_parabolic_torus", 3},
    {"f_ph", 0},
    {"f_pillow", 1},
    {"f_piriform", 1},
    {"f_piriform_2d", 7},
    {"f_poly4", 5},
    {"f_polytubes", 6},
    {"f_quantum", 1},
    {"f_quartic_paraboloid", 1},
    {"f_quartic_saddle", 1},
    {"f_quartic_cylinder", 3},
    {"f_r", 0},
    {"f_ridge", 6},
    {"f_ridged_mf", 6},
    {"f_rounded_box", 4},
    {"f_sphere", 1},
    {"f_spikes", 5},
    {"f_spikes_2d", 4},
    {"f_spiral", 6},
    {"f_steiners_roman", 1},
    {"f_strophoid", 4},
    {"f_strophoid_2d", 7},
    {"f_superellipsoid", 2},
    {"f_th", 0},
    {"f_torus", 2},
    {"f_torus2", 3},
    {"f_torus_gumdrop", 1},
    {"f_umbrella", 1},
    {"f_witch_of_agnesi", 2},
    {"f_witch_of_agnesi_2d", 6},
    {"f_noise3d", 0},
    {"f_pattern", 0},
    {"f_noise_generator", 1},
};

/// Null where there is none.
const InternalFormula* formula_of(std::string_view name) {
  for (const auto table :
       {algebraic_formulas(), curve_formulas(), solid_formulas(), noise_formulas()}) {
    for (const InternalFormula& formula : table) {
      if (formula.name == name) return &formula;
    }
  }
  return nullptr;
}

// f_pattern has no pattern when it is called by itself: 0.
class Internal final : public Function {
 public:
  explicit Internal(const Entry& entry) : m_entry(entry) {
    if (const InternalFormula* formula = formula_of(entry.name)) m_formula = *formula;
  }
  std::size_t parameters() const override { return static_cast<std::size_t>(m_entry.extra) + 3; }
  double evaluate(std::span<const double> arguments) const override {
    return m_formula.evaluate ? m_formula.evaluate(arguments.data()) : 0.0;
  }
  bool takes_pairs() const override { return m_formula.evaluate_pair != nullptr; }
  Pair evaluate_pair(std::span<const Pair> arguments) const override {
    return m_formula.evaluate_pair(arguments.data());
  }
  std::string not_yet() const override { return {}; }

 private:
  const Entry& m_entry;
  InternalFormula m_formula{};
};

}  // namespace

std::shared_ptr<const Function> internal_function(int number,
                                                  std::shared_ptr<const int> noise_generator) {
  if (number < 0 || number >= static_cast<int>(std::size(kEntries))) return nullptr;
  if (noise_generator && std::string_view(kEntries[number].name) == "f_noise3d") {
    return std::make_shared<NoiseFunction>(std::move(noise_generator));
  }
  return std::make_shared<Internal>(kEntries[number]);
}

}  // namespace lentray::core
