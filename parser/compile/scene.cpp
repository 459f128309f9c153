#include "parser/compile/scene.h"

#include <algorithm>

#include "parser/compile/atmosphere.h"
#include "parser/compile/object_builder.h"
#include "parser/compile/photons.h"
#include "parser/source/build_error.h"

namespace lentray::parser {
namespace {

constexpr int kAirQuality = 9, kRadiosityQuality = 9, kPhotonQuality = 9, kSubsurfaceQuality = 9;
constexpr double kLeastTranslucency = 1e-4;  ///< in units of the scene

/// Without +UA a background that is clear is laid over black; its filter is passed over, as in stock. With it, one
/// from before #version 3.7 is seen in mirrors only, as if there were none.
void set_background(const SceneDesc& scene, bool alpha, core::SceneSettings& s) {
  s.alpha = alpha;
  s.background.rgb = scene.background.rgb;
  const bool is_layer = scene.has_background && scene.background_version >= 370;
  if (!alpha) {
    if (is_layer) s.background.rgb *= 1.0f - scene.background.transmit;
  } else if (is_layer) {
    s.background = scene.background;
  } else {
    s.background.transmit = 1.0f;
  }
}

void override_radiosity(const RadiosityOverrides& instead, core::RadiositySettings& r) {
  r.count = instead.count.value_or(r.count);
  r.error_bound = instead.error_bound.value_or(r.error_bound);
  r.nearest_count = instead.nearest_count.value_or(r.nearest_count);
  r.nearest_count_adaptive = std::min(r.nearest_count_adaptive, r.nearest_count - 1);
  r.recursion_limit = instead.recursion_limit.value_or(r.recursion_limit);
}

void override_photons(const PhotonOverrides& instead, core::PhotonSettings& p) {
  if (p.count > 0 || p.spacing > 0.0) p.count = instead.count.value_or(p.count);
  p.gather_max = instead.gather.value_or(p.gather_max);
  p.gather_min = std::min(p.gather_min, p.gather_max);
}

core::SceneSettings build_settings(const SceneDesc& scene, const BuildOptions& options) {
  core::SceneSettings s;
  const GlobalDesc& g = scene.global;
  const SceneOverrides& instead = options.overrides;
  s.max_trace_level =
      instead.max_trace_level.value_or(g.max_trace_level.value_or(s.max_trace_level));
  s.adc_bailout = instead.adc_bailout.value_or(g.adc_bailout.value_or(s.adc_bailout));
  if (g.ambient_light) s.ambient_light = *g.ambient_light;
  s.language_version = scene.language_version;
  s.assumed_gamma_set = g.assumed_gamma.has_value() || g.gamma_is_srgb;
  if (g.assumed_gamma) {
    s.assumed_gamma = *g.assumed_gamma;
  } else {
    s.assumed_gamma = g.gamma_is_srgb || scene.language_version < 370 ? 0.0 : 1.0;
  }
  s.irid_wavelength = g.irid_wavelength;
  // Without one, scenes older than 3.5 have the noise of their time.
  s.noise_generator = g.noise_generator.value_or(scene.language_version < 350 ? 1 : 2);
  s.atmosphere_ior = scene.atmosphere_ior;
  set_background(scene, options.alpha, s);
  if (g.radiosity && options.quality >= kRadiosityQuality) {
    s.radiosity = g.radiosity;
    override_radiosity(instead.radiosity, *s.radiosity);
    // From then on radiosity takes the place of `ambient`.
    if (scene.language_version >= 370) s.ambient_light = core::Rgb(0.0f);
  }
  if (options.quality >= kPhotonQuality) {
    s.photons = photon_settings(g, s);
    if (s.photons) {
      override_photons(instead.photons, *s.photons);
      s.loaded_photons = g.loaded_photons.maps;
    }
  }
  if (g.subsurface && options.quality >= kSubsurfaceQuality) {
    s.subsurface = g.subsurface;
    for (int* samples : {&s.subsurface->samples_diffuse, &s.subsurface->samples_single}) {
      if (*samples > 0) *samples = instead.subsurface_samples.value_or(*samples);
    }
  }
  if (g.mm_per_unit > 0.0) s.mm_per_unit = g.mm_per_unit;
  return s;
}

void override_area_lights(const SceneOverrides& instead, std::vector<core::Light>& lights) {
  for (core::Light& light : lights) {
    if (!light.has_area) continue;
    for (int* size : {&light.area.size1, &light.area.size2}) {
      if (*size > 1) *size = instead.area_light_samples.value_or(*size);
    }
    light.area.adaptive = instead.area_light_adaptive.value_or(light.area.adaptive);
  }
}

}  // namespace

TextureSettings texture_settings(const SceneDesc& scene, const core::SceneSettings& settings,
                                 const BuildOptions& options) {
  TextureSettings t;
  t.quality = options.quality;
  t.number_of_waves = scene.global.number_of_waves;
  t.language_version = scene.language_version;
  t.noise_generator = settings.noise_generator;
  // Rays need some room below a surface.
  if (settings.subsurface) t.least_translucency = kLeastTranslucency * settings.mm_per_unit;
  t.media = options.overrides.media;
  return t;
}

namespace {

std::unique_ptr<core::SkySphere> build_sky(const SkySphereDesc& sky, TextureCompiler& textures) {
  auto out = std::make_unique<core::SkySphere>();
  out->emission = sky.emission;
  for (const Ref<PigmentDesc>& pigment : sky.pigments) {
    out->pigments.push_back(textures.pigment(transformed(pigment, sky.transform)));
  }
  return out;
}

void warn_about_gamma(const SceneDesc& scene, Diagnostics& diagnostics) {
  if (scene.global.assumed_gamma || scene.global.gamma_is_srgb) return;
  if (scene.language_version < 370) {
    diagnostics.warn({},
                     "assumed_gamma is not specified: gamma correction is off, as it was before "
                     "#version 3.7.");
  } else {
    diagnostics.warn({}, "assumed_gamma is not specified: 1.0 is used.");
  }
}

bool any_random_media(const core::SceneParts& parts) {
  const auto any = [](const std::vector<std::shared_ptr<const core::Medium>>& media) {
    return std::ranges::any_of(media, [](const auto& m) { return m->sampling.is_random(); });
  };
  return any(parts.atmosphere.media) ||
         std::ranges::any_of(parts.interiors,
                             [&](const auto& inside) { return any(inside->media); });
}

/// Once for each thing that the picture shows and that is random in stock: what include files declare does not count.
void warn_of_random_numbers(const core::SceneParts& parts, const TextureCompiler& textures,
                            Diagnostics& diagnostics) {
  const auto warn = [&](bool used, const std::string& what) {
    if (!used) return;
    diagnostics.warn(
        {},
        what +
            ": its random numbers are not POV-Ray's, so pixels differ from POV-Ray's by as much as "
            "those of two such runs");
  };
  warn(textures.has_crand(), "crand");
  warn(textures.has_subsurface(), "subsurface light");
  const auto jitters = [](const core::Light& light) { return light.has_area && light.area.jitter; };
  warn(std::ranges::any_of(parts.lights, jitters), "jitter of area lights");
  warn(any_random_media(parts), "sampling of media");
  const auto shakes = [](const core::Rainbow& rainbow) { return rainbow.jitter > 0.0; };
  warn(std::ranges::any_of(parts.atmosphere.rainbows, shakes), "jitter of rainbows");
}

void warn_about_subsurface(const SceneDesc& scene, const TextureCompiler& textures,
                           Diagnostics& diagnostics) {
  if (!textures.has_subsurface()) return;
  if (!(scene.global.mm_per_unit > 0.0)) {
    diagnostics.warn(scene.global.where, "mm_per_unit is not greater than 0: 10 is used.");
  }
  if (const FinishDesc* finish = textures.too_opaque()) {
    diagnostics.warn(finish->where,
                     "translucency is too little for subsurface light: a ten thousandth of a unit "
                     "of the scene is used.");
  }
}

}  // namespace

core::SceneParts build_scene(SceneDesc& scene, Diagnostics& diagnostics,
                             const BuildOptions& options, BuildReport* report) {
  core::SceneParts parts;
  parts.settings = build_settings(scene, options);
  parts.deepest = scene.deepest;
  warn_about_gamma(scene, diagnostics);

  const TextureSettings for_textures = texture_settings(scene, parts.settings, options);
  TextureCompiler textures(for_textures);

  NotYet not_yet;
  ObjectBuilder builder(parts, textures, not_yet);
  builder.set_places(options.places);
  try {
    for (SceneObject& object : scene.objects) {
      builder.add(object);
      object = {};  // its memory is used again by what is built next
      textures.forget_unused();
    }
    scene.objects = std::vector<SceneObject>();  // {} would keep its memory
    override_area_lights(options.overrides, parts.lights);
    if (scene.sky_sphere) parts.sky_sphere = build_sky(*scene.sky_sphere, textures);
    if (options.quality >= kAirQuality) {
      parts.atmosphere = build_atmosphere(scene, for_textures.noise_generator);
      for (const Ref<MediaDesc>& medium : scene.atmosphere_media) {
        parts.atmosphere.media.push_back(textures.medium(medium));
      }
    }
  } catch (const BuildError& error) {
    diagnostics.fail(error.where(), error.what());
  }
  for (auto& texture : textures.take_textures()) parts.textures.push_back(std::move(texture));
  parts.picture_bytes = textures.picture_bytes();
  if (report) report->texture_bytes = textures.texture_bytes();
  warn_of_random_numbers(parts, textures, diagnostics);
  check_photons(scene.global, parts, diagnostics);
  warn_about_subsurface(scene, textures, diagnostics);
  for (const std::string& feature : textures.not_yet()) not_yet.try_emplace(feature, Location{});

  for (const auto& [feature, where] : not_yet) {
    if (report) report->not_rendered.push_back(feature);
    diagnostics.not_yet(feature, where);
  }
  if (report) report->slopes = builder.slope_watches().named(diagnostics);
  diagnostics.report_not_yet();
  diagnostics.report_repeats();
  return parts;
}

}  // namespace lentray::parser
