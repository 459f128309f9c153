#include "parser/compile/photons.h"

#include <algorithm>
#include <string>

#include "core/base/formed.h"
#include "core/numeric/bounds_help.h"
#include "core/photon/units.h"
#include "parser/stock/stock_box.h"

namespace lentray::parser {
namespace {

constexpr double kMostShot = 1e9;

/// Stock's box in the world. A part of a CSG is moved with it: a single shape is then boxed anew, others have
/// the box of their turned box.
core::Bounds box_of(const ObjectDesc& object, const core::Transform& outer) {
  bool is_whole = true;
  if (outer.is_identity()) return kept_stock_box(object, is_whole);
  const bool is_single = !object.csg() && object.rare->clipped_by.empty() &&
                         object.rare->bounded_by.empty() && object.transform->steps->empty();
  if (!is_single) return kept_stock_box(core::transformed(kept_stock_box(object, is_whole), outer));
  ObjectDesc moved = object;
  moved.transform.edit().add(outer);
  return kept_stock_box(moved, is_whole);
}

bool shoots_none(const core::Light& light) { return light.shadowless || light.grouped; }

}  // namespace

std::optional<core::PhotonSettings> photon_settings(const GlobalDesc& global,
                                                    const core::SceneSettings& settings) {
  if (!global.photons || global.photons->gather_max <= 0) return std::nullopt;
  core::PhotonSettings photons = *global.photons;
  if (photons.max_trace_level < 0) photons.max_trace_level = settings.max_trace_level;
  if (photons.adc_bailout < 0.0) photons.adc_bailout = settings.adc_bailout;
  return photons;
}

core::PhotonTarget photon_target(const ObjectDesc& object, const core::Transform& outer,
                                 const core::PassFlags& flags) {
  const core::Bounds box = box_of(object, outer);
  core::PhotonTarget target;
  target.centre = box.lo + (box.hi - box.lo) / 2.0;
  target.radius = length(target.centre - box.lo);
  target.factor = flags.photon_target;
  target.reflection = flags.photon_reflection;
  target.refraction = flags.photon_refraction;
  target.collects = flags.photon_collect;
  return target;
}

void check_photons(const GlobalDesc& global, core::SceneParts& parts, Diagnostics& diagnostics) {
  std::optional<core::PhotonSettings>& photons = parts.settings.photons;
  if (!photons || parts.settings.loaded_photons) return;
  const auto drop = [&](const std::string& why) {
    diagnostics.warn(global.where, "no photons are shot: " + why);
    photons.reset();
  };
  if (photons->count <= 0 && !(photons->spacing > 0.0))
    return drop("their spacing must be greater than 0");
  if (parts.photon_targets.empty())
    return drop("no object is a target (`photons { target }` in it)");
  if (std::all_of(parts.lights.begin(), parts.lights.end(), shoots_none))
    return drop(
        "there is no light that shoots them; shadowless ones and those of light groups do not");
  const double spacing = core::photon_spacing(parts.lights, parts.photon_targets, *photons);
  const auto units = core::photon_units(parts.lights, parts.photon_targets, spacing);
  if (units.empty())
    return drop("neither targets nor lights have reflection or refraction of photons on");
  const double expected = core::expected_photons(parts.lights, units);
  if (!(expected <= kMostShot)) {
    diagnostics.fail(global.where,
                     "about " + core::formed("%.2g", expected) +
                         " photons would be shot, 1e+09 are the most: a greater spacing or a "
                         "smaller count shoots fewer");
  }
}

}  // namespace lentray::parser
