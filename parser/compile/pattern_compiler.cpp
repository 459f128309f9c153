#include "parser/compile/pattern_compiler.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "core/material/pigments.h"
#include "core/pattern/fractal.h"
#include "core/pattern/organic.h"
#include "core/pattern/pavement.h"
#include "core/pattern/shapes.h"
#include "core/pattern/surface_patterns.h"
#include "core/pattern/tiles.h"
#include "core/pattern/tiling.h"
#include "parser/compile/object_query.h"

namespace lentray::parser {
namespace {

core::Turbulence compile_turbulence(const core::Turbulence& t) {
  return {t.amount, t.octaves, single(t.lambda), single(t.omega)};
}

/// The turbulence outside warps, for the patterns that use it themselves.
std::optional<core::Turbulence> own_turbulence(const PatternDesc& pattern) {
  if (pattern.placement.empty() ||
      pattern.placement.front().kind != WarpDesc::Kind::kClassicTurbulence) {
    return std::nullopt;
  }
  return compile_turbulence(pattern.placement.front().own->turbulence);
}

/// These shift by turbulence in their own formula, and not in space.
bool shifts_itself(PatternKind kind) {
  return kind == PatternKind::kMarble || kind == PatternKind::kWood || kind == PatternKind::kPlain;
}

core::WarpPtr compile_warp(const WarpDesc& warp, PatternKind pattern) {
  const WarpParameters& own = *warp.own;
  switch (warp.kind) {
    case WarpDesc::Kind::kTransform:
      return warp.transform->is_identity() ? nullptr : core::make_transform_warp(*warp.transform);
    case WarpDesc::Kind::kClassicTurbulence:
      if (shifts_itself(pattern)) return nullptr;
      [[fallthrough]];
    case WarpDesc::Kind::kTurbulence:
      if (own.turbulence.amount == core::Vec3{}) return nullptr;
      return core::make_turbulence_warp(compile_turbulence(own.turbulence));
    case WarpDesc::Kind::kRepeat:
      return core::make_repeat_warp(own.axis, single(own.width), own.flip, own.offset);
    case WarpDesc::Kind::kBlackHole: return core::make_black_hole_warp(own.hole);
    case WarpDesc::Kind::kSpherical:
      return core::make_spherical_warp(own.orientation, own.distance_exponent);
    case WarpDesc::Kind::kToroidal:
      return core::make_toroidal_warp(own.orientation, own.distance_exponent, own.major_radius);
    case WarpDesc::Kind::kPlanar: return core::make_planar_warp(own.orientation, own.plane_offset);
    case WarpDesc::Kind::kCylindrical:
      return core::make_cylindrical_warp(own.orientation, own.distance_exponent);
    case WarpDesc::Kind::kCubic: return core::make_cubic_warp();
  }
  return nullptr;
}

/// What stands for a pattern that is not rendered yet.
class MiddlePattern final : public core::Pattern {
 public:
  double value(const core::Vec3&) const override { return 0.5; }
};

core::PatternPtr compile_fractal(const PatternDesc& p) {
  core::Fractal fractal;
  fractal.julia = p.kind == PatternKind::kJulia || p.kind == PatternKind::kMagnetJulia;
  fractal.parameter = p.own->julia;
  const bool magnet = p.kind == PatternKind::kMagnetMandel || p.kind == PatternKind::kMagnetJulia;
  fractal.magnet = magnet ? p.own->magnet : 0;
  fractal.exponent = p.own->exponent;
  fractal.iterations = p.own->iterations;
  fractal.exterior_type = p.own->exterior_type;
  fractal.interior_type = p.own->interior_type;
  fractal.exterior_factor = p.own->exterior_factor;
  fractal.interior_factor = p.own->interior_factor;
  return core::make_fractal(fractal);
}

core::PatternPtr compile_tiles(const PatternDesc& p) {
  switch (p.kind) {
    case PatternKind::kChecker:
    case PatternKind::kTiles: return core::make_checker();
    case PatternKind::kHexagon: return core::make_hexagon();
    case PatternKind::kSquare: return core::make_square();
    case PatternKind::kTriangular: return core::make_triangular();
    case PatternKind::kCubic: return core::make_cubic();
    case PatternKind::kCells: return core::make_cells();
    case PatternKind::kTiling: return core::make_tiling(p.own->tiling);
    case PatternKind::kPavement:
      return core::make_pavement({p.own->pavement_sides, p.own->pavement_tiles,
                                  p.own->pavement_pattern, p.own->pavement_exterior,
                                  p.own->pavement_interior, p.own->pavement_form});
    // Mortar is kept a little thinner than asked, so that bricks of its size still show.
    case PatternKind::kBrick:
      return core::make_brick(p.own->brick_size, single(p.own->mortar - 2e-10));
    default: return nullptr;
  }
}

core::PatternPtr compile_shape(const PatternDesc& p) {
  switch (p.kind) {
    case PatternKind::kGradient: return core::make_gradient(p.own->vector);
    case PatternKind::kOnion: return core::make_onion();
    case PatternKind::kRadial: return core::make_radial();
    case PatternKind::kSpherical: return core::make_spherical();
    case PatternKind::kCylindrical: return core::make_cylindrical();
    case PatternKind::kPlanar: return core::make_planar();
    case PatternKind::kBoxed: return core::make_boxed();
    case PatternKind::kLeopard: return core::make_leopard();
    case PatternKind::kQuilted:
      return core::make_quilted(single(p.own->quilt0), single(p.own->quilt1));
    case PatternKind::kAoi: return core::make_aoi();
    case PatternKind::kSlope:
      return core::make_slope({p.own->vector, p.own->slope_point_at, p.own->altitude,
                               p.own->slope_low, p.own->slope_high, p.own->altitude_low,
                               p.own->altitude_high});
    case PatternKind::kMandel:
    case PatternKind::kJulia:
    case PatternKind::kMagnetMandel:
    case PatternKind::kMagnetJulia: return compile_fractal(p);
    default: return nullptr;
  }
}

core::PatternPtr compile_organic(const PatternDesc& p, const TextureSettings& settings) {
  const int generator = noise_generator(p, settings);
  const auto turbulence = own_turbulence(p);
  switch (p.kind) {
    case PatternKind::kBozo:
    case PatternKind::kSpotted:
    case PatternKind::kBumps: return core::make_bozo(generator);
    case PatternKind::kDents: return core::make_dents(generator);
    case PatternKind::kGranite: return core::make_granite(generator);
    case PatternKind::kWrinkles: return core::make_wrinkles(generator);
    case PatternKind::kMarble: return core::make_marble(turbulence, generator);
    case PatternKind::kWood: return core::make_wood(turbulence);
    case PatternKind::kAgate:
      return core::make_agate(turbulence.value_or(core::Turbulence{}),
                              single(p.own->agate_turbulence), generator);
    case PatternKind::kSpiral1: return core::make_spiral(p.own->arms, turbulence, generator, false);
    case PatternKind::kSpiral2: return core::make_spiral(p.own->arms, turbulence, generator, true);
    case PatternKind::kRipples:
      return core::make_ripples(settings.number_of_waves, single(p.frequency), single(p.phase));
    case PatternKind::kWaves:
      return core::make_waves(settings.number_of_waves, single(p.frequency), single(p.phase));
    case PatternKind::kCrackle:
      return core::make_crackle(
          {p.own->crackle_form, p.own->crackle_metric, p.own->crackle_offset, p.own->crackle_solid},
          generator);
    default: return nullptr;
  }
}

core::PatternPtr compile_density(const PatternDesc& p, const PatternBuild& build) {
  if (p.own->density_path.path.empty()) {
    throw std::runtime_error("cannot find the density file \"" + p.own->density_file + "\"");
  }
  core::GridInterpolation interpolation = core::GridInterpolation::kTricubic;
  if (p.own->density_interpolate % 10 == 0) interpolation = core::GridInterpolation::kNone;
  if (p.own->density_interpolate % 10 == 1) interpolation = core::GridInterpolation::kTrilinear;
  return core::make_density_pattern(build.density(p.own->density_path), interpolation);
}

core::PatternPtr compile_function(const PatternDesc& p, const PatternBuild& build) {
  if (!p.own->function || !p.own->function->function) return nullptr;
  const auto& function = p.own->function->function;
  if (const std::string missing = function->not_yet(); !missing.empty()) {
    build.not_yet.insert(missing);
    return nullptr;
  }
  return function->parameters() == 3 ? core::make_function(function) : nullptr;
}

}  // namespace

int noise_generator(const PatternDesc& pattern, const TextureSettings& settings) {
  const int chosen = pattern.noise_generator ? pattern.noise_generator : settings.noise_generator;
  return std::clamp(chosen, 1, 3);
}

core::Placement compile_placement(const PatternDesc& pattern) {
  std::vector<core::WarpPtr> steps;
  // The description goes from the pattern outwards, a point the other way.
  for (auto warp = pattern.placement.rbegin(); warp != pattern.placement.rend(); ++warp) {
    if (auto step = compile_warp(*warp, pattern.kind)) steps.push_back(std::move(step));
  }
  return core::Placement(std::move(steps));
}

core::PatternPtr compile_pattern(const PatternDesc& pattern, const PatternBuild& build) {
  if (auto tiles = compile_tiles(pattern)) return tiles;
  if (auto shape = compile_shape(pattern)) return shape;
  if (auto organic = compile_organic(pattern, build.settings)) return organic;
  if (pattern.kind == PatternKind::kFunction) {
    if (auto function = compile_function(pattern, build)) return function;
  } else if (pattern.kind == PatternKind::kPigmentPattern && pattern.own->pigment) {
    return core::make_pigment_pattern(build.pigment(pattern.own->pigment));
  } else if (pattern.kind == PatternKind::kObject && pattern.own->object) {
    const auto query = std::make_shared<const ObjectQuery>(*pattern.own->object);
    return core::make_inside([query](const core::Vec3& p) { return query->inside(p); });
  } else if (pattern.kind == PatternKind::kDensityFile) {
    return compile_density(pattern, build);
  } else if (pattern.kind == PatternKind::kImagePattern && pattern.own->image && build.picture) {
    return core::make_picture_pattern(build.picture(*pattern.own->image),
                                      pattern.own->image->use == ImageDesc::Use::kAlpha);
  } else {
    build.not_yet.insert(std::string("pattern ") + pattern_name(pattern.kind));
  }
  return std::make_unique<MiddlePattern>();
}

core::Wave compile_wave(const PatternDesc& pattern) {
  core::Wave wave;
  wave.frequency = single(pattern.frequency);
  wave.phase = single(pattern.phase);
  wave.exponent = single(pattern.wave_exponent);
  wave.form = pattern.wave;
  return wave;
}

core::PlacedPattern compile_placed(const PatternDesc& pattern, const PatternBuild& build) {
  return {compile_placement(pattern), compile_pattern(pattern, build), compile_wave(pattern)};
}

core::BlendMap<core::Colour> default_colours(PatternKind kind) {
  using Entries = std::vector<std::pair<double, core::Colour>>;
  const auto rgb = [](float r, float g, float b) { return core::Colour{{r, g, b}, 0, 0}; };
  switch (kind) {
    case PatternKind::kAgate:
      return core::BlendMap(Entries{{0.0, rgb(1, 1, 1)},
                                    {0.5, rgb(.95f, .75f, .5f)},
                                    {0.5, rgb(.9f, .7f, .5f)},
                                    {0.6, rgb(.9f, .7f, .4f)},
                                    {0.6, rgb(1, .7f, .4f)},
                                    {1.0, rgb(.6f, .3f, 0)}});
    case PatternKind::kBozo:
      return core::BlendMap(Entries{{0.4, rgb(1, 1, 1)},
                                    {0.4, rgb(0, 1, 0)},
                                    {0.6, rgb(0, 1, 0)},
                                    {0.6, rgb(0, 0, 1)},
                                    {0.8, rgb(0, 0, 1)},
                                    {0.8, rgb(1, 0, 0)}});
    case PatternKind::kMandel:
      return core::BlendMap(Entries{{0.001, rgb(0, 0, 0)},
                                    {0.001, rgb(0, 1, 1)},
                                    {0.012, rgb(1, 1, 0)},
                                    {0.015, rgb(1, 0, 1)},
                                    {0.1, rgb(0, 1, 1)}});
    case PatternKind::kMarble:
      return core::BlendMap(
          Entries{{0.0, rgb(.9f, .8f, .8f)}, {0.9, rgb(.9f, .08f, .08f)}, {0.9, rgb(0, 0, 0)}});
    case PatternKind::kRadial:
      return core::BlendMap(Entries{
          {0.0, rgb(0, 1, 1)}, {0.333, rgb(1, 1, 0)}, {0.666, rgb(1, 0, 1)}, {1.0, rgb(0, 1, 1)}});
    case PatternKind::kWood:
      return core::BlendMap(Entries{{0.6, rgb(.666f, .312f, .2f)}, {0.6, rgb(.4f, .1333f, .066f)}});
    default: return core::BlendMap(Entries{{0.0, rgb(0, 0, 0)}, {1.0, rgb(1, 1, 1)}});
  }
}

}  // namespace lentray::parser
