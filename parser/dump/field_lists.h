// The members of all descriptions but shapes, whose lists stand beside them; see fields.h. A new
// member of a description is added here too: the compiler asks for it.
#pragma once

#include "parser/descriptions/fields.h"
#include "parser/descriptions/interior.h"
#include "parser/descriptions/scene.h"

namespace lentray::parser {

// What surrounds a scene.
LENTRAY_FIELDS(FogDesc, where, type, distance, colour, turb_depth, turbulence, octaves, lambda,
               omega, fog_offset, fog_alt, up, transform)
LENTRAY_FIELDS(RainbowDesc, where, direction, up, angle, width, distance, jitter, arc_angle,
               falloff_angle, colour_map)
LENTRAY_FIELDS(SkySphereDesc, where, pigments, transform, emission)

// Camera and light.
LENTRAY_FIELDS(LensDesc, slant, pitch, lpi, focal_length, ior, pixels, print_dpi, front,
               view_distance, model, rays)
LENTRAY_FIELDS(CameraDesc, where, kind, cylinder_type, location, direction, right, up, sky, look_at,
               has_look_at, has_right, has_up, has_angle, angle, horizontal_angle, vertical_angle,
               transform, lens, aperture, blur_samples, blur_samples_min, confidence, variance,
               focal_point, has_focal_point, focal_distance, bokeh, normal, rays_per_pixel,
               distribution, max_ray_distance, smooth, meshes, location_functions,
               direction_functions)
LENTRAY_FIELDS(PhotonFlags, given, target, density, refraction, reflection, pass_through, collect,
               area_light)
LENTRAY_FIELDS(LightDesc, where, kind, parallel, position, colour, point_at, radius, falloff,
               tightness, has_area, axis1, axis2, size1, size2, adaptive, has_adaptive, jitter,
               circular, orient, area_illumination, fade_distance, fade_power, media_interaction,
               media_attenuation, looks_like, projected_through, photons)

// Looks.
LENTRAY_FIELDS(ReflectionDesc, minimum, maximum, block, fresnel, falloff, metallic)
LENTRAY_FIELDS(SubsurfaceDesc, translucency, anisotropy)
LENTRAY_FIELDS(FinishDesc, where, ambient, emission, diffuse, diffuse_back, albedo_factor,
               diffuse_albedo, brilliance, phong, phong_size, phong_albedo, specular, roughness,
               specular_albedo, metallic, reflection, reflection_exponent, conserve_energy, crand,
               irid, irid_thickness, irid_turbulence, subsurface, ior, caustics, refraction)
LENTRAY_FIELDS(core::SlopePoint, height, slope)
LENTRAY_FIELDS(ColourMapDesc, where, entries)
LENTRAY_FIELDS(PigmentMapDesc, where, entries)
LENTRAY_FIELDS(NormalMapDesc, where, entries)
LENTRAY_FIELDS(SlopeMapDesc, where, entries)
LENTRAY_FIELDS(TextureMapDesc, where, entries)
LENTRAY_FIELDS(DensityMapDesc, where, entries)
LENTRAY_FIELDS(core::Turbulence, amount, octaves, lambda, omega)
LENTRAY_FIELDS(core::BlackHole, centre, repeat, uncertainty, radius, strength, power, inverse,
               repeats, uncertain)
LENTRAY_FIELDS(WarpParameters, turbulence, axis, width, flip, offset, hole, orientation,
               distance_exponent, major_radius, plane_offset)
LENTRAY_FIELDS(WarpDesc, kind, transform, own)
LENTRAY_FIELDS(ImageDesc, type, name, path, where, function, function_width, function_height, gamma,
               working_gamma, decoding, premultiplied, once, map_type, interpolate, use, repeat,
               offset, filter_all, transmit_all, filters, transmits)
LENTRAY_FIELDS(PatternParameters, vector, brick_size, mortar, agate_turbulence, arms, quilt0,
               quilt1, facets_coords, facets_size, facets_metric, crackle_form, crackle_metric,
               crackle_offset, crackle_solid, julia, iterations, exponent, magnet, exterior_type,
               interior_type, exterior_factor, interior_factor, altitude, slope_low, slope_high,
               altitude_low, altitude_high, slope_point_at, tiling, pavement_sides, pavement_tiles,
               pavement_pattern, pavement_exterior, pavement_interior, pavement_form, function,
               image, object, potential_threshold, pigment, density_file, density_path,
               density_interpolate)
LENTRAY_FIELDS(PatternDesc, kind, where, placement, frequency, phase, wave, wave_exponent,
               noise_generator, own, nesting)
LENTRAY_FIELDS(PigmentDesc, where, pattern, colour, colour_map, pigment_map, quick_colour)
LENTRAY_FIELDS(NormalDesc, where, pattern, amount, bump_size, no_bump_scale, accuracy, slope_map,
               normal_map)
LENTRAY_FIELDS(TextureLayerDesc, where, pigment, normal, finish, pattern, map)
LENTRAY_FIELDS(TextureDesc, where, layers)
LENTRAY_FIELDS(DensityDesc, where, pattern, colour, colour_map, density_map)
LENTRAY_FIELDS(ScatteringDesc, type, colour, eccentricity, extinction)
LENTRAY_FIELDS(MediaDesc, where, method, intervals, min_samples, max_samples, confidence, variance,
               ratio, jitter, aa_level, aa_threshold, absorption, emission, scattering,
               ignore_photons, densities)
LENTRAY_FIELDS(InteriorDesc, where, ior, ior_given, dispersion, dispersion_samples, caustics,
               fade_distance, fade_power, fade_colour, media)

// Settings.
LENTRAY_FIELDS(RadiositySettings, adc_bailout, brightness, error_bound, gray_threshold,
               low_error_factor, maximum_reuse, minimum_reuse, max_sample, pretrace_start,
               pretrace_end, count, direction_pool, nearest_count, nearest_count_adaptive,
               recursion_limit, always_sample, media, normal, subsurface, default_importance)
LENTRAY_FIELDS(PhotonSettings, spacing, jitter, autostop, expand_increase, adc_bailout, radius,
               radius_multiplier, media_radius, media_radius_multiplier, media_factor, count,
               gather_min, gather_max, expand_min, media_steps, max_trace_level, load_file,
               save_file)
LENTRAY_FIELDS(SubsurfaceSettings, samples_diffuse, samples_single, radiosity)
LENTRAY_FIELDS(GlobalDesc, where, assumed_gamma, gamma_is_srgb, assumed_gamma_version,
               max_trace_level, adc_bailout, ambient_light, irid_wavelength, number_of_waves,
               noise_generator, mm_per_unit, radiosity, photons, loaded_photons, subsurface)

// Objects and the whole.
LENTRAY_FIELDS(RareParts, interior_texture, interior, clipped_by, bounded_by, radiosity_importance,
               photons)
LENTRAY_FIELDS(ObjectDesc, where, keyword, shape, transform, texture, rare, texture_waits,
               bounds_are_clips, inverse, no_shadow, no_image, no_reflection, no_radiosity,
               double_illuminate, hollow, sturm, hierarchy, uv_mapping, reopened, copied, nesting,
               compiled)
LENTRAY_FIELDS(SceneObject, object, default_texture, default_importance)
LENTRAY_FIELDS(SceneDesc, objects, dropped, camera, global, background, has_background,
               background_version, fogs, rainbows, sky_sphere, atmosphere_media, atmosphere_ior,
               deepest, language_version)

}  // namespace lentray::parser
