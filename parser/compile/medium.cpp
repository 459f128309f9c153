#include "parser/compile/medium.h"

#include <vector>

#include "core/pattern/single.h"

namespace lentray::parser {
namespace {

using core::single;

/// Patterns that are a few operations, unless they are stirred.
bool is_quick(PatternKind kind) {
  switch (kind) {
    case PatternKind::kPlain:
    case PatternKind::kGradient:
    case PatternKind::kPlanar:
    case PatternKind::kSpherical:
    case PatternKind::kBoxed:
    case PatternKind::kCylindrical:
    case PatternKind::kOnion:
    case PatternKind::kChecker:
    case PatternKind::kRadial: return true;
    default: return false;
  }
}

core::PhaseFunction phase_of(const ScatteringDesc& scattering) {
  using Kind = core::PhaseFunction::Kind;
  const bool known = scattering.type >= static_cast<int>(Kind::kIsotropic) &&
                     scattering.type <= static_cast<int>(Kind::kHenyeyGreenstein);
  return {known ? static_cast<Kind>(scattering.type) : Kind::kIsotropic, scattering.eccentricity};
}

core::MediumSampling sampling_of(const MediaDesc& media, const MediaSettings& instead) {
  core::MediumSampling sampling;
  sampling.method = static_cast<core::SamplingMethod>(instead.method.value_or(media.method));
  sampling.intervals = instead.intervals.value_or(media.intervals);
  sampling.min_samples = instead.samples.value_or(media.min_samples);
  sampling.max_samples = instead.samples.value_or(media.max_samples);
  sampling.confidence = instead.confidence.value_or(media.confidence);
  sampling.variance = media.variance;
  sampling.ratio = media.ratio;
  sampling.jitter = media.jitter;
  sampling.aa_threshold = media.aa_threshold;
  sampling.aa_level = media.aa_level;
  return sampling;
}

}  // namespace

PigmentDesc as_pigment(const DensityDesc& density, const AsPigmentMap& as_map) {
  PigmentDesc pigment;
  pigment.where = density.where;
  pigment.pattern = density.pattern;
  pigment.colour = density.colour;
  pigment.colour_map = density.colour_map;
  if (density.density_map) pigment.pigment_map = as_map(density.density_map);
  return pigment;
}

Ref<PigmentMapDesc> as_pigment_map(const DensityMapDesc& densities) {
  auto map = std::make_shared<PigmentMapDesc>();
  map->where = densities.where;
  for (const auto& entry : densities.entries) {
    map->entries.push_back(
        {entry.value, std::make_shared<const PigmentDesc>(as_pigment(
                          *entry.item, [](const auto& inner) { return as_pigment_map(*inner); }))});
  }
  return map;
}

std::shared_ptr<const core::Medium> compile_medium(
    const MediaDesc& media, const MediaSettings& instead,
    const std::function<core::PigmentPtr(const DensityDesc&)>& density) {
  auto medium = std::make_shared<core::Medium>();
  medium->absorption = media.absorption;
  medium->emission = media.emission;
  medium->scattering = media.scattering.colour;
  medium->extinction_of_scattering = single(media.scattering.extinction);
  medium->phase = phase_of(media.scattering);
  medium->collects_photons = !media.ignore_photons;
  medium->sampling = sampling_of(media, instead);
  medium->variance_limits = core::find_variance_limits(medium->sampling);
  std::vector<Ref<DensityDesc>> densities = media.densities;
  std::stable_partition(densities.begin(), densities.end(),
                        [](const auto& one) { return is_quick(one->pattern.kind); });
  for (const Ref<DensityDesc>& one : densities) medium->densities.push_back(density(*one));
  return medium;
}

}  // namespace lentray::parser
