#include "parser/compile/finish.h"

#include <algorithm>

#include "parser/compile/pattern_compiler.h"

namespace lentray::parser {

namespace {

core::SubsurfaceFinish subsurface_of(const FinishDesc& finish, double least_translucency) {
  core::Rgb translucency = finish.subsurface->translucency;
  for (int c = 0; c < 3; ++c) {
    translucency[c] = std::max(translucency[c], static_cast<float>(least_translucency));
  }
  return {translucency, single(finish.diffuse) / finish.albedo_factor,
          single(finish.diffuse_back) / finish.albedo_factor};
}

}  // namespace

core::Finish compile_finish(const FinishDesc& finish, std::optional<double> least_translucency) {
  core::Finish result;
  result.ambient = finish.ambient;
  result.emission = finish.emission;
  result.diffuse = single(finish.diffuse);
  result.diffuse_back = single(finish.diffuse_back);
  result.albedo_factor = finish.albedo_factor;
  result.brilliance = single(finish.brilliance);
  result.phong = single(finish.phong);
  result.phong_size = single(finish.phong_size);
  result.specular = single(finish.specular);
  // Stock keeps a roughness of 0 as the exponent 0.
  result.roughness_exponent =
      finish.roughness == 0.0 ? 0.0 : single(1.0 / single(finish.roughness));
  result.metallic = single(finish.metallic);
  result.reflection_min = finish.reflection.minimum;
  result.reflection_max = finish.reflection.maximum;
  result.reflection_falloff = single(finish.reflection.falloff);
  result.reflection_exponent = finish.reflection_exponent;
  result.reflection_metallic = single(finish.reflection.metallic);
  result.reflection_fresnel = finish.reflection.fresnel;
  result.reflection_variable = finish.reflection.block;
  result.conserve_energy = finish.conserve_energy;
  result.crand = single(finish.crand);
  result.irid = single(finish.irid);
  result.irid_thickness = single(finish.irid_thickness);
  result.irid_turbulence = single(finish.irid_turbulence);
  if (finish.subsurface && least_translucency) {
    result.subsurface = subsurface_of(finish, *least_translucency);
    result.diffuse = result.diffuse_back = 0.0;
  }
  return result;
}

std::shared_ptr<core::Interior> compile_interior(const Ref<InteriorDesc>& interior,
                                                 const Ref<TextureDesc>& texture) {
  const FinishDesc* finish = nullptr;
  if (texture && !texture->layers.back().is_patterned()) {
    finish = texture->layers.back().finish.get();
  }
  const bool from_finish =
      finish && (finish->ior || finish->caustics || finish->refraction.value_or(1.0) != 1.0);
  if (!interior && !from_finish) return nullptr;
  auto result = std::make_shared<core::Interior>();
  if (interior) {
    result->ior = single(interior->ior);
    // Without an ior of its own an interior is the air's, dispersion included.
    if (interior->ior_given && interior->dispersion != 0.0) {
      result->dispersion = single(interior->dispersion);
    }
    result->dispersion_samples = interior->dispersion_samples;
    // Stock scales an interior's caustics by 45 and leaves a finish's as written (measured by
    // tests/image, ImageShadingShadows.Caustics).
    result->caustics = 45.0 * single(interior->caustics);
    result->fade_distance = single(interior->fade_distance);
    result->fade_power = single(interior->fade_power);
    result->fade_colour = interior->fade_colour;
  }
  if (from_finish) {
    if (finish->ior) {
      result->ior = single(*finish->ior);
      result->dispersion = 1.0;
    }
    if (finish->caustics) result->caustics = single(*finish->caustics);
    if (finish->refraction) result->passed = static_cast<float>(*finish->refraction);
  }
  return result;
}

}  // namespace lentray::parser
