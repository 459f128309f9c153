// Every message of the statements and of what they are made into is provoked: the sources are
// searched for texts of more than one word, and each must be heard from a program below. A new
// message without a program fails.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "parser/compile/camera.h"
#include "parser/read_scene.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

// In each the words that follow are looked for in its own messages.
struct Program {
  const char* text;
  const char* heard;
};

#define PIGMENT(words) "plane { y, 0 pigment { " words " } }"
#define NORMAL(words) "plane { y, 0 pigment { rgb 1 } normal { " words " } }"

const Program kPrograms[] = {
    // the scene
    {"sphree { 0, 1 }", "expected an object or a statement: one of background,"},
    {"sphree { 0, 1 }", "object, light_source, light_group, bicubic_patch"},
    {"sphree { 0, 1 }", "found the undeclared identifier 'sphree', did you mean 'sphere'?"},
    {"camera { location x } camera { location y }",
     "More than one camera in the scene; the last one is used."},
    {"sky_sphere { pigment { rgb 1 } } sky_sphere { pigment { rgb 1 } }",
     "Only one sky_sphere allowed; the last one is used."},
    {"max_trace_level 5", "max_trace_level belongs in global_settings"},
    {"max_intersections 5", "max_intersections belongs in global_settings"},
    {"@0 sphere { 0, 1 }",
     "the scene has no #version: it is read with today's grammar and rendered as one from before "
     "3.7"},
    {"@0 #declare A = 1; #version 3.7; sphere { 0, 1 }",
     "the #version of the scene stands behind other declarations: they were read with another one"},
    {"@0 #declare F = \"old.inc\"; #fopen W F write #write (W, \"#version 3.6;\") #fclose W "
     "#include F sphere { 0, 1 }",
     "the scene has no #version of its own: its include files leave it at 3.6"},
    {"sphere { 0, 1 finish { crand .1 } }",
     "crand: its random numbers are not POV-Ray's, so pixels differ from POV-Ray's by as much as "
     "those of two such runs"},
    {"sphere { 0, 1 } light_source { 9, 1 area_light x, y, 2, 2 jitter }",
     "jitter of area lights: its random numbers"},
    {"sphere { 0, 1 } rainbow { direction z angle 40 width 5 jitter .1 color_map { [0 rgbt 1] } }",
     "jitter of rainbows: its"},
    {"@0 #version 3.0; sphere { 0, 1 }",
     "the scene ends with a #version of 3.1 or earlier: faults of those programs are not imitated"},
    {"", "there are no objects in the scene"},
    {"#default { sphere { 0, 1 } }",
     "one of texture, pigment, normal, finish, camera, radiosity or }"},
    {"@0 #version 3.7; sphere { 0, 1 }", "assumed_gamma is not specified: 1.0 is used."},
    {"@0 #version 3.7; #declare C = srgb .5; global_settings { assumed_gamma 1 }",
     "sRGB colours need an assumed_gamma before them"},
    {"@0 sphere { 0, 1 }",
     "assumed_gamma is not specified: gamma correction is off, as it was before #version 3.7."},
    {"media { method 1 scattering { 1, rgb .1 } } sphere { 0, 1 }", "sampling of media"},
    {"camera { mesh_camera { 2, 0, mesh { triangle { x, y, z } } } } sphere { 0, 1 }",
     "A mesh_camera of distribution 0 needs a mesh for each ray of a pixel."},
    {"camera { mesh_camera { 2, 3, mesh { triangle { x, y, z } } } } sphere { 0, 1 }",
     "A mesh_camera of distribution 2 or 3 has one ray a pixel."},
    // fog, rainbow, sky
    {"@1.5 fog { 5 color rgb 1 }", "the distance of a fog wants the word distance"},
    {"fog { fogtype 2 }",
     "one of fog_type, distance, color, turbulence, octaves, lambda, omega, turb_depth, "
     "fog_offset, fog_alt, up, a transform or }"},
    {"fog { fogtype 2 }", "did you mean 'fog_type'?"},
    {"rainbow { radius 2 }",
     "one of direction, up, angle, width, distance, jitter, arc_angle, falloff_angle, color_map, "
     "color or }"},
    {"rainbow { angle 2 }", "a rainbow needs a direction"},
    {"sky_sphere { rgb 1 }", "pigment, emission, a transform or }"},
    {"sky_sphere { }", "a sky_sphere needs a pigment"},
    // cameras
    {"#declare C = camera { location x } camera { C location y }",
     "a transform or } after a camera identifier"},
    {"camera { cylinder 5 }", "Invalid cylinder camera type; valid are types 1 to 4."},
    {"camera { mesh_camera { 0, 0 } }", "A mesh_camera needs at least one ray a pixel."},
    {"camera { mesh_camera { 1, 5 } }", "The distribution of a mesh_camera must be 0 to 3."},
    {"camera { mesh_camera { 1, 0 } }", "A mesh_camera needs a mesh or mesh2."},
    {"camera { mesh_camera { 1, 0 sphere { 0, 1 } } } sphere { 0, 1 }",
     "a mesh_camera takes meshes, not a "},
    {"camera { angle -1 }", "Negative viewing angle."},
    {"camera { angle 180 }", "Viewing angle has to be smaller than 180 degrees."},
    {"camera { blur_samples 0 }", "Illegal number of focal blur samples."},
    {"camera { blur_samples 9, 3 }", "Focal blur samples minimum must not be larger than maximum."},
    {"camera { confidence 2 }", "Illegal confidence value; the default is used."},
    {"camera { variance 2 }", "Illegal variance value; the default is used."},
    {"camera { lenticular lens_pitch 0 }", "lens_pitch must be greater than 0"},
    {"camera { lenticular lens_pixels 0 }", "lens_pixels must be at least "},
    {"camera { lenticular lens_model round }", "a lens model: one of paraxial, pinhole, thick"},
    {"camera { lenticular lens_rays 0 }", "lens_rays must be a whole number from 1 to 1024."},
    {"camera { lenticular lens_slant 90 }", "lens_slant must be an angle of -80 to 80 degrees."},
    {"camera { lenticular lens_slant -1e300 }",
     "lens_slant must be an angle of -80 to 80 degrees."},
    {"camera { lenticular lens 2 }",
     ", lens_pitch, lens_lpi, lens_focal_length, lens_ior, lens_pixels, print_dpi, lens_front, "
     "view_distance, lens_model, lens_rays, lens_slant or }"},
    {"camera { locaton x }",
     "one of perspective, orthographic, fisheye, ultra_wide_angle, omnimax, panoramic, spherical, "
     "cylinder, mesh_camera, lenticular, location, direction, right, up, sky, look_at, angle, "
     "aperture, blur_samples, confidence, variance, focal_point, normal, bokeh, a transform or }"},
    {"camera { location x look_at x }", "Camera location and look_at point must be different."},
    {"camera { location 0 look_at y }",
     "The camera looks along its sky direction: the right vector is kept."},
    {"camera { up y + x/2 right x direction z }",
     "Camera vectors are not perpendicular. Making look_at the last statement may help."},
    // global_settings
    {"global_settings { assumed_gamma 2 assumed_gamma 1 }",
     "New instance of assumed_gamma ignored."},
    {"@0 #version 3.7; global_settings { assumed_gamma 0 }",
     "assumed_gamma must be greater than 0."},
    {"global_settings { noise_generator 4 }", "noise_generator must be 1, 2 or 3."},
    {"global_settings { number_of_waves 0 }",
     "number_of_waves must be greater than 0; changed to 1."},
    {"global_settings { charset latin }", "ascii, utf8 or sys"},
    {"global_settings { hf_gray_16 on }",
     "hf_gray_16 is an option of the command line now and has no effect in a scene."},
    {"global_settings { max_intersections 5 }", "max_intersections has no effect any more."},
    {"global_settings { max_trace_level 1000 }", "max_trace_level 1000 is more than "},
    {"global_settings { max_trace_level 1000 }", "; using that."},
    {"global_settings { max_trace 5 }", "one of "},
    {"global_settings { max_trace 5 }", " or }"},
    {"global_settings { radiosity { brightness 0 } }", "brightness must be greater than 0."},
    {"global_settings { radiosity { count 0 } }", "Radiosity count must be a positive number."},
    {"global_settings { radiosity { count 5, 3 } }", "The pool of directions must hold the count."},
    {"global_settings { radiosity { count 5, 2e7 } }",
     "Radiosity has at most 10,000,000 directions."},
    {"global_settings { radiosity { count 1e9 } }", "Radiosity has at most 10,000,000 directions."},
    {"global_settings { radiosity { pretrace_start 0.01 } }",
     "Radiosity pretrace_end must not be greater than pretrace_start."},
    {"global_settings { radiosity { minimum_reuse .3 maximum_reuse .5 } }",
     "radiosity: maximum_reuse should be much larger than minimum_reuse"},
    {"global_settings { radiosity { nearest_count 50 } }",
     "Radiosity nearest_count goes from 1 to 20."},
    {"global_settings { radiosity { nearest_count 5, 9 } }",
     "The second number of nearest_count must be less than the first."},
    {"global_settings { radiosity { recursion_limit 50 } }",
     "Radiosity recursion_limit goes from 1 to 20."},
    {"global_settings { radiosity { load_file \"a\" } }",
     "Radiosity files are options of the command line now; ignored here."},
    {"global_settings { radiosity { low_error_factor 0 } }", " must be greater than 0"},
    {"global_settings { radiosity { gray_threshold 2 } }", "gray_threshold goes from 0 to 1."},
    {"global_settings { radiosity { error_bound -1 } }", "error_bound must be greater than 0."},
    {"global_settings { radiosity { minimum_reuse -1 } }", "minimum_reuse must not be negative."},
    {"global_settings { radiosity { pretrace_end 2 } }",
     "pretrace_end must be greater than 0 and at most 1."},
    {"global_settings { radiosity { minimum_reuse .5 maximum_reuse .4 } }",
     "Radiosity maximum_reuse must be larger than minimum_reuse."},
    {"global_settings { radiosity { minimum_reuse .3 } }",
     "radiosity: maximum_reuse should be much larger than minimum_reuse; "},
    {"global_settings { radiosity { minimum_reuse .3 } }", " has been adjusted."},
    {"global_settings { radiosity { maximum_reuse .01 } }", "; minimum_reuse has been adjusted."},
    {"global_settings { radiosity { cuont 5 } }", "one of count, nearest_count, recursion_limit, "},
    {"@3.1 global_settings { radiosity { count 5 } }",
     "since 3.5 a radiosity { } in global_settings turns radiosity on"},
    {"global_settings { photons { count 5 expand_thresholds -1, -2 } }",
     "The numbers of expand_thresholds must not be negative: 0 is used."},
    {"global_settings { photons { count 5 media -1 } }",
     "The steps of photons' media must not be negative."},
    {"global_settings { photons { count 5 media 1, 0 } }",
     "The factor of photons' media must be greater than 0."},
    {"global_settings { photons { cuont 5 } }",
     "one of radius, spacing, expand_thresholds, gather, jitter, count, autostop, adc_bailout, "
     "max_trace_level, load_file, save_file, media or }"},
    {"global_settings { photons { count 5 gather 9, 3 } }",
     "The first number of gather must not be greater than the second."},
    {"global_settings { photons { count 5 gather 0, 0 } }", "gather is 0: there are no photons."},
    {"global_settings { photons { load_file \"none\" } }", "cannot find the photon file 'none'"},
    {"global_settings { photons { load_file \"bad.df3\" } }",
     "cannot use the photon file 'bad.df3': it ends before its photons"},
    {"global_settings { photons { save_file \"a.ph\" save_file \"b.ph\" load_file \"empty.ph\" } }",
     "photons are either loaded or saved: this load_file holds"},
    {"global_settings { photons { spacing 0 } }",
     "no photons are shot: their spacing must be greater than 0"},
    {"global_settings { photons { spacing 1 } }", "no photons are shot: no object is a target"},
    {"global_settings { photons { spacing 1 } } sphere { 0, 1 photons { target } }",
     "no photons are shot: there is no light that shoots them; shadowless ones and those of light "
     "groups do not"},
    {"global_settings { photons { spacing 1 } } sphere { 0, 1 photons { target } } "
     "light_source { 9 1 }",
     "neither targets nor lights have reflection or refraction of photons on"},
    {"global_settings { photons { spacing 1e-6 } } light_source { 9 1 } "
     "sphere { 0, 1 photons { target reflection on } }",
     "photons would be shot, 1e+09 are the most: a greater spacing or a smaller count shoots "
     "fewer"},
    {"global_settings { subsurface { sample 1 } }", "samples, radiosity or }"},
    // lights
    {"light_source { 0 radius 5 }",
     "radius needs spotlight or cylinder before it in a light_source."},
    {"light_source { 0 falloff 5 }",
     "falloff needs spotlight or cylinder before it in a light_source."},
    {"light_source { 0 tightness 5 }",
     "tightness needs spotlight or cylinder before it in a light_source."},
    {"light_source { 0 looks_like { sphere { 0, 1 } } looks_like { sphere { 0, 1 } } }",
     "Only one looks_like allowed per light_source."},
    {"light_source { 0 projected_through { sphere { 0, 1 } } projected_through { sphere { 0, 1 } } "
     "}",
     "Only one projected_through allowed per light_source."},
    {"light_source { 0 point_at x }",
     "point_at needs spotlight, cylinder or parallel before it in a light_source."},
    {"light_source { 0 area_light x, y, 1e9, 1e9 }",
     "An area_light has at most 100,000,000 lights."},
    {"light_source { 0 area_light x, y, 0, 2 }",
     "The numbers of lights of an area_light must be greater than zero."},
    {"light_source { 0 circular }", "circular only affects an area_light."},
    {"light_source { 0 spotlite }",
     "one of translate, rotate, scale, matrix, transform, adaptive,"},
    {"light_source { 0 area_light x, y, 2, 2 orient }",
     "orient needs a circular area_light: this one is circular now."},
    {"light_source { 0 area_light x, y, 1, 2 circular }",
     "A circular area_light must have more than one light along each axis."},
    {"light_group { light_source { 0 } pigment { rgb 1 } }",
     "an object, a transform, global_lights, photons or }"},
    // shapes
    {"plane { 0, 1 }", "Degenerate plane normal."},
    {"cylinder { 0, 0, 1 }", "Degenerate cylinder, base point = apex point."},
    {"cone { 0, 1, 0, 2 }", "Degenerate cone, base point = apex point."},
    {"triangle { 0, x, x }", "Degenerate triangle: it has no area."},
    {"smooth_triangle { 0, y, x, y, z, 0 }",
     "Degenerate triangle: it has no area or a normal of no length."},
    {"mesh { smooth_triangle { 0, 0, x, y, y, y } }",
     "a normal of a mesh has no length: <1, 0, 0> instead"},
    {"mesh { smooth_triangle { 0, 0, x, 0, y, y } }",
     "2 normals of a mesh have no length, the first here: <1, 0, 0> instead"},
    {"polygon { 2, 0, x }", "Polygon needs at least three points."},
    {"polygon { 3, 0, x, y }", "This polygon is not closed: closing it."},
    {"intersection { sphere { 0, 1 } triangle { 0, x, y } }",
     "what has no inside does not belong in an intersection or difference"},
    {"union { sphere { 0, 1 } }", "a CSG should have at least two objects"},
    {"composite { sphere { 0, 1 } sphere { 0, 1 } }", "composite is union now"},
    {"object { 5 }", "an object: one of object,"},
    {"object { 5 }", " or an object identifier"},
    {"isosurface { function { x } contained_by { plane { y, 0 } } }", "sphere or box"},
    {"blob { sphere { 0, 1, 1 hollow } }", "a transform, texture, pigment, normal, finish or }"},
    {"blob { cylinder { y, y, 1, 1 } }", "Degenerate cylinder in a blob: both ends are one point."},
    {"#declare N = sphere { 0, 1 } union { N N }",
     "a modifier or } behind an identifier that comes first (as a part it is written"},
    {"mesh { triangle { 0, x, y texture_list { } } }",
     "three texture identifiers, one for each corner"},
    {"blob { threshold 1 }", "one of sphere, cylinder, component or threshold"},
    {"poly { 50, <1> }", "The order of a poly must be 2 to 35."},
    {"prism { bezier_spline 0, 1, 5, 0, u, v, <1,1>, 0 }",
     "A prism of a Bezier spline needs four points a segment."},
    {"prism { 0, 1, 3, 0, u, v }", "This prism is not closed: closing it."},
    {"prism { quadratic_spline 0, 1, 5, 0, u, v, <1,1>, <2,3> }",
     "This prism is not closed: its outline must come back to its first point."},
    {"prism { quadratic_spline 0, 1, 8, v, 0, u, <1,1>, 0, <2,2>, <2,3>, <3,3> }",
     "An outline of this prism is not closed: it is left out."},
    {"prism { 0, 1, 2, 0, u }", "A prism must have at least three points."},
    {"bicubic_patch { type 2 flatness 0 u_steps 1 v_steps 1 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, "
     "0, 0, 0 }",
     "types 2 and 3 of a bicubic_patch are gone: type 1 is used"},
    {"bicubic_patch { type 7 }", "The type of a bicubic_patch must be 0 or 1."},
    {"height_field { png \"none.png\" }", "Cannot find the height_field's file \"none.png\""},
    {"height_field { function 1e5, 1e5 { x } }", "a picture made by a function has at most "},
    {"height_field { function 1, 1 { x } }", "a height_field needs at least 2 x 2 heights"},
    {"#declare F = function(a) { a } height_field { function 2, 2 { F(x, y) } }",
     "function F takes 1 arguments"},
    {"julia_fractal { <1,0,0,0> precision 0 }", "precision must be at least 1."},
    {"julia_fractal { <1,0,0,0> slice <0,0,0,0>, 0 }",
     "The fourth component of a slice must not be 0."},
    {"julia_fractal { <1,0,0,0> quaternion exp }",
     "quaternion fractals have the functions sqr and cube only"},
    {"lathe { linear_spline 1, 0 }", "A lathe of this spline needs at least "},
    {"ovus { -1, 1 }", "The radii of an ovus must be positive."},
    {"ovus { 1, 2 }",
     "the upper radius of this ovus is at least twice the lower one: it is a sphere"},
    {"parametric { function { u } function { v } function { u } 0, 1 precompute 50 x }",
     "The depth of precompute goes from 1 to 20."},
    {"polynomial { 2, xyz(5,0,0): 1 }",
     "The powers of a polynomial must be 0 or more, their sum at most its order."},
    {"sor { 4, <1,0>, <1,0>, <1,0>, <1,0> }", "Incorrect point in surface of revolution."},
    {"sor { 3, <1,0>, <1,1>, <1,2> }", "A surface of revolution must have at least four points."},
    {"sphere_sweep { 3, x, 1 }",
     "A sphere_sweep begins with linear_spline, cubic_spline or b_spline."},
    {"sphere_sweep { linear_spline 1, x, 1 }", "A sphere_sweep of this spline needs at least "},
    {"text { \"a\" }", "ttf or internal"},
    {"text { ttf \"none.ttf\" \"a\" 1, 0 }", "Cannot find the font file \"none.ttf\""},
    {"text { ttf \"bad.ttf\" \"a\" 1, 0 }", "cannot read the font '"},
    {"mesh { triangle { x, y, z normal { bumps } } }",
     "one of uv_vectors, texture, texture_list or }"},
    {"mesh { }", "triangle or smooth_triangle"},
    {"mesh2 { vertex_vectors { 0 } }", "No vertices in triangle mesh."},
    {"mesh2 { vertex_vectors { 1, x } face_indices { 0 } }", "No triangles in triangle mesh."},
    {"mesh2 { vertex_vectors { 1, x } face_indices { 1, <0,0,5> } }",
     "Mesh vertex index 5 is out of range: there are "},
    {"mesh2 { vertex_vectors { 1, x } face_indices { 1, <0,0,0>, 3 } }", "Mesh texture index 3"},
    {"mesh2 { vertex_vectors { 3, x, y, z } normal_vectors { 1, y } face_indices { 1, <0,1,2> } }",
     "Mesh normal index "},
    {"mesh2 { vertex_vectors { 3, x, y, z } uv_vectors { 1, 0 } face_indices { 1, <0,1,2> } }",
     "Mesh uv index "},
    {"mesh2 { texture_list { 1, 5 } }", "expected texture"},
    {"mesh2 { }", "expected vertex_vectors"},
    {"mesh2 { vertex_vectors { 1, x } }", "expected face_indices"},
    // what follows a shape
    {"sphere { 0, 1 bounded_by { triangle { x, y, z } } }",
     "What bounds or clips must have an inside: a triangle, patch or light has none."},
    {"sphere { 0, 1 clipped_by { sphere { 0, 1 } } bounded_by { clipped_by } bounded_by { sphere { "
     "0, 1 } } }",
     "Cannot add bounds after linking bounds and clips."},
    {"sphere { 0, 1 bounded_by { sphere { 0, 1 } } bounded_by { clipped_by } }",
     "Cannot link clips with previous bounds."},
    {"sphere { 0, 1 clipped_by { sphere { 0, 1 } } bounded_by { clipped_by } clipped_by { sphere { "
     "0, 1 } } }",
     "Cannot add clips after linking bounds and clips."},
    {"sphere { 0, 1 clipped_by { sphere { 0, 1 } } clipped_by { bounded_by } }",
     "Cannot link bounds with previous clips."},
    {"sphere { 0, 1 split_union on }", "split_union holds for a union only."},
    {"sphere { 0, 1 texture { pigment { rgb 1 } } uv_mapping }",
     "uv_mapping must be specified before texture."},
    {"sphere { 0, 1 cutaway_textures }",
     "cutaway_textures holds for intersection and difference only."},
    {"sphere { 0, 1 hierarchy on }", "hierarchy holds for blob, mesh and height_field only."},
    {"sphere { 0, 1 sturm }",
     "sturm holds for blob, lathe, ovus, poly, prism, sor and torus only."},
    {"sphere { 0, 1 radiosity { importance 2 } }",
     "Radiosity importance must be greater than 0 and at most 1."},
    {"light_source { 0 photons { target } }", "one of refraction, reflection, area_light or }"},
    {"sphere { 0, 1 photons { area_light } }",
     "one of target, refraction, reflection, pass_through, collect or }"},
    {"sphere { 0, 1 photons { target refraction on pass_through } }",
     "what photons pass through cannot refract them as a target: refraction is off"},
    {"sphere { 0, 1 light_source { 0 } }",
     "A light source inside an object is written with looks_like now."},
    {"sphere { 0, 1 pigmnt { rgb 1 } }",
     "one of translate, rotate, scale, matrix, transform, texture, pigment, normal, finish, "
     "interior, interior_texture, material, bounded_by,"},
    {"sphere { 0, 1 interior_texture { pigment { rgb 1 } } }",
     "interior_texture requires an exterior texture."},
    {"sphere { 0, 1 color rgb 1 }", "a color in an object is ignored; it belongs in a pigment"},
    // textures
    {"sphere { 0, 1 texture { tiles { texture { } tile2 texture { } } } texture { } }",
     "a texture with a texture_map, tiles or material_map cannot be layered"},
    {"sphere { 0, 1 texture { tiles { texture { } tile2 texture { } } } pigment { rgb 1 } }",
     "a texture with a texture_map, tiles or material_map has no single part to change"},
    {"sphere { 0, 1 material { pigment { rgb 1 } } }",
     "one of texture, interior_texture, interior, a transform or }"},
    {"#default { texture { tiles { texture { } tile2 texture { } } } }",
     "the default texture cannot be a map of textures"},
    {"#declare T = texture { } texture { } #default { texture { T } }",
     "the default texture cannot be layered"},
    {"sphere { 0, 1 texture { bozo } }", "a texture with a pattern needs a texture_map"},
    {"sphere { 0, 1 texture { rgb 1 } }",
     "one of pigment, normal, finish, a transform, a pattern with a texture_map or }"},
    {"sphere { 0, 1 texture { tiles { pigment { } } } }", "the texture of a tile"},
    {"@1.0 sphere { <0,0,0> 1 texture { phong 1 } }", "'phong' belongs in a finish"},
    {"@2.0 #declare T = texture { phong 1 } sphere { <0,0,0> 1 texture { phong 1 T } }",
     "this texture replaces what was said before"},
    {"@2.0 sphere { <0,0,0> 1 texture { 0.5 phong 1 } }", "a bare number in a texture is crand"},
    {"#declare T = texture { } #while (1) #declare T = texture { T } texture { T } #end",
     "a texture of more than 50 layers"},
    {"#declare P = pigment { rgb 1 } #while (1) #declare P = pigment { bozo pigment_map { [0 P] } "
     "} #end",
     "pigments within each other, more than 100 deep"},
    {"#declare P = pigment { rgb 1 } #while (1) #declare P = pigment { average pigment_map { [1 P] "
     "[1 P] } } #end",
     "pigments made of too many others"},
    // finish, interior, media
    {"sphere { 0, 1 finish { reflection { 1 fresnel 2 } } }", "fresnel is on or off"},
    {"sphere { 0, 1 finish { reflection { 1 phong 2 } } }",
     "one of fresnel, falloff, exponent, metallic or }"},
    {"sphere { 0, 1 finish { irid { 1 phong 2 } } }", "one of thickness, turbulence or }"},
    {"sphere { 0, 1 finish { subsurface { phong 2 } } }", "one of translucency, anisotropy or }"},
    {"sphere { 0, 1 finish { roughness 0 } }", "roughness is 0"},
    {"sphere { 0, 1 finish { ior 1.5 } }",
     "ior belongs in the interior { } of an object, not in a finish"},
    {"sphere { 0, 1 finish { phnog 1 } }",
     "one of ambient, emission, diffuse, brilliance, crand, phong, phong_size, specular, "
     "roughness, metallic, reflection, reflection_exponent, conserve_energy, irid, subsurface or "
     "}"},
    {"sphere { 0, 1 finish { phnog 1 } }", "did you mean 'phong'?"},
    {"sphere { 0, 1 interior { dispersion_samples 1 } }", "dispersion_samples must be at least 2"},
    {"sphere { 0, 1 interior { refraction 1 } }",
     "refraction has no effect any more: what is transparent refracts"},
    {"sphere { 0, 1 interior { iro 1 } }",
     "one of ior, dispersion, dispersion_samples, caustics, fade_color, fade_distance, fade_power, "
     "media or } but found the undeclared identifier 'iro', did you mean 'ior'?"},
    {"media { samples 0 }", "media needs at least one sample an interval"},
    {"media { samples 5, 3 }", "the most samples of media are fewer than the least"},
    {"media { intervals 0 }", "media needs at least one interval"},
    {"media { method 4 }", "the method of media is 1, 2 or 3"},
    {"media { aa_threshold 0 }", "aa_threshold of media must be greater than 0"},
    {"media { aa_level 0 }", "aa_level of media must be at least 1"},
    {"media { confidence 1 }", "confidence of media is at least 0 and less than 1"},
    {"media { scattering { 6, 1 } }", "scattering types go from 1 to 5"},
    {"media { scattering { 1, 1 eccentricity 1 } }",
     "eccentricity goes with scattering type 5 only"},
    {"media { scattering { 1, 1 phong 1 } }", "one of a color, eccentricity, extinction or }"},
    {"media { scatering { 1 } }",
     "one of method, intervals, samples, confidence, variance, ratio, jitter, aa_level, "
     "aa_threshold, absorption, emission, scattering, collect, density, a transform or }"},
    // patterns
    {PIGMENT("facets"), "facets can only be used in a normal"},
    {PIGMENT("mandel 0"), "a fractal pattern needs at least one iteration"},
    {PIGMENT("magnet 3 mandel 5"), "the magnet pattern is of type 1 or 2"},
    {PIGMENT("magnet 1 5"), "mandel or julia"},
    {PIGMENT("object { 5 }"), "an object"},
    {NORMAL("image_map { png \"bad.png\" }"), "image_map can only be used in a pigment"},
    {PIGMENT("image_pattern { png \"bad.png\" filter 1 }"),
     "one of interpolate, map_type, once, use_color, use_index, use_alpha, repeat, offset or }"},
    {PIGMENT("slope { y, 1, 1 }"), "the range is empty; it is ignored"},
    {PIGMENT("slope { point_at y altitude y }"), "altitude cannot be used with point_at"},
    {PIGMENT("slope { y phong }"), "expected altitude or }"},
    {PIGMENT("slope 0"), "both vectors of the slope pattern are null"},
    {PIGMENT("tiling 28"), "the number of a tiling is between 1 and 27"},
    {PIGMENT("pavement number_of_sides 5"), "number_of_sides of pavement is 3, 4 or 6"},
    {PIGMENT("pavement number_of_tiles 9"), "number_of_tiles of this pavement is between 1 and 6"},
    {PIGMENT("pavement pattern 9"), "pattern of this pavement is between 1 and 1"},
    {PIGMENT("checker color_map { [0 rgb 1] }"), "cannot use color_map with checker"},
    {PIGMENT("pigment_map { [0 rgb 1] }"), "cannot use pigment_map with no pattern"},
    {PIGMENT("average"), "average needs a map of pigments"},
    {PIGMENT(""), "this pigment has neither colour nor pattern, or does not begin with it"},
    {NORMAL(""), "this normal has no pattern"},
    {NORMAL("bmups 1"),
     "expected a pattern but found the undeclared identifier 'bmups', did you mean 'bumps'?"},
    {PIGMENT("rbg 1"),
     "one of a color, a pattern, its modifiers (turbulence, warp, scale ...), a map or } but found "
     "the undeclared identifier 'rbg', did you mean 'rgb'?"},
    {NORMAL("bumps rbg"),
     "one of a pattern, its modifiers (turbulence, warp, scale ...), bump_size, a map or }"},
    {NORMAL("facets normal_map { [0 bozo] }"), "cannot use normal_map with facets"},
    {"#declare F = function { pattern { rgb 1 } }", "expected a pattern"},
    {"#declare F = function { pattern { bozo phong } }",
     "a modifier of the pattern (turbulence, warp, scale ...) or }"},
    {PIGMENT("bozo color_map { 5 }"), "an entry [value ...] of the color_map"},
    {PIGMENT("bozo color_map { [0 \"a\"] }"), "a color"},
    {PIGMENT("bozo color_map { [0, 1 rgb 1 \"a\"] }"), "a second color"},
    {PIGMENT("image_map { png \"none.png\" }"), "cannot find the image file 'none.png'"},
    {PIGMENT("image_map { png \"bad.png\" }"), "cannot read 'bad.png': "},
    {"#declare F = function { pigment { image_map { png \"bad.png\" } } }",
     "cannot read 'bad.png': "},
    {"sphere { 0, 1 } sky_sphere { pigment { image_map { png \"bad.png\" } } }",
     "cannot read 'bad.png': "},
    {PIGMENT("image_map { function 0, 2 { x } }"), "image 'function' (it cannot be read)"},
    {PIGMENT("image_map { function 2, 2 x }"), "{ after the size of the image"},
    {PIGMENT("image_map { <1,0,0> png \"bad.png\" }"),
     "the orientation of an image has no meaning any more"},
    {PIGMENT("image_map { 5 }"), "an image file"},
    {PIGMENT("image_map { png \"bad.png\" filter 0, 1 }"),
     "expected all: 'bad.png' has no palette of which this could be an entry; filter all is for "
     "the whole picture"},
    {PIGMENT("image_map { function 2, 2 { x } transmit 0, 1 }"),
     "expected all: the function has no palette"},
    {PIGMENT("image_map { gif \"two.gif\" transmit 2, 1 }"),
     "expected an entry of the palette of 'two.gif', 0 to 1, found 2; transmit all is for the "
     "whole picture"},
    {PIGMENT("image_map { png \"bad.png\" repeat 0 }"),
     "the repeat of an image must be greater than 0 both ways"},
    {PIGMENT("image_map { png \"bad.png\" interpolate 1 }"),
     "interpolate of an image_map is 2, 3 or 4"},
    {PIGMENT("image_map { png \"bad.png\" map_type 3 }"),
     "map_type of an image_map is 0, 1, 2 or 5"},
    {PIGMENT("image_map { png \"bad.png\" phong }"),
     "one of interpolate, map_type, once, use_color, use_index, use_alpha, repeat, offset, filter, "
     "transmit or }"},
    {NORMAL("bump_map { png \"bad.png\" phong }"),
     "one of interpolate, map_type, once, use_color, use_index, use_alpha, repeat, offset, "
     "bump_size or }"},
    {PIGMENT("bozo form <1,0,0>"), "'form' can only be used with crackle or pavement"},
    {PIGMENT("bozo metric 1"), "'metric' can only be used with crackle or facets"},
    {PIGMENT("bozo exterior 1, 1"),
     "'exterior' can only be used with mandel, julia, magnet or pavement"},
    {PIGMENT("mandel 5 exterior 20, 1"), " type of a fractal pattern is between 0 and "},
    {PIGMENT("bozo exponent 3"), "'exponent' can only be used with mandel or julia"},
    {PIGMENT("mandel 5 exponent 50"), "exponents of mandel and julia go from 2 to 33; 2 is taken"},
    {PIGMENT("bozo noise_generator 4"), "noise_generator is 0, 1, 2 or 3"},
    {NORMAL("bozo color_map { [0 rgb 1] }"), "color_map can only be used in a pigment or density"},
    {NORMAL("bozo pigment_map { [0 rgb 1] }"), "pigment_map can only be used in a pigment"},
    {PIGMENT("bozo density_map { [0 rgb 1] }"), "density_map can only be used in a density"},
    {PIGMENT("bozo slope_map { [0 1] }"), "slope_map can only be used in a normal"},
    {PIGMENT("bozo normal_map { [0 bozo] }"), "normal_map can only be used in a normal"},
    {PIGMENT("bozo texture_map { [0 pigment { }] }"), "texture_map can only be used in a texture"},
    {NORMAL("bozo quick_color rgb 1"), "quick_color can only be used in a pigment"},
    {PIGMENT("bozo bump_size 1"), "bump_size can only be used in a normal"},
    {PIGMENT("bozo accuracy 1"), "accuracy can only be used in a normal"},
    {PIGMENT("bozo warp { repeat 0 }"), "repeat needs an axis"},
    {PIGMENT("bozo warp { repeat <1,1,0> }"), "repeat goes along one axis only"},
    {PIGMENT("bozo warp { black_hole 0, 5 repeat 1 }"),
     "the repeat of this black_hole is too small; it is made larger"},
    {PIGMENT("bozo warp { scale 2 }"), "a kind of warp"},
    {PIGMENT("bozo warp { spherical phong }"), "a word of this warp or }"},
#define TRANSLUCENT(mm, far)                         \
  "global_settings { subsurface { } mm_per_unit " mm \
  " } sphere { 0, 1 pigment { rgb 0.8 } finish { subsurface { translucency " far " } } }"
    {TRANSLUCENT("10", "1"), "subsurface light"},
    {TRANSLUCENT("0", "1"), "mm_per_unit is not greater than 0: 10 is used."},
    {TRANSLUCENT("10", "0"),
     "translucency is too little for subsurface light: a ten thousandth of a unit of the scene is "
     "used."},
#undef TRANSLUCENT
    {PIGMENT("density_file df3 \"none.df3\""), "cannot find the density file \"none.df3\""},
    {PIGMENT("density_file df3 \"bad.df3\""), "cannot read the density file \"bad.df3\""},
    {PIGMENT("density_file df3 \"odd.df3\""),
     "the density file \"odd.df3\" has 5 bytes for 2 voxels: expected 1, 2 or 4 a voxel"},
};

// Texts that only a fault of the program itself could bring up.
const char* const kUnheard[] = {"FreeType does not start", "this kind of spline is not known here",
                                "too few points for this spline",
                                "a sphere_sweep of this spline needs at least ",
                                "the function of a height_field has the parameters x, y, z"};

// A version in front: "@3.1 text"; 3.7 with assumed_gamma unless told; "@0" takes the text as it is.
std::string scene_of(const std::string& text) {
  if (text.rfind("@0", 0) == 0) return text.substr(2);
  if (text.rfind("@", 0) == 0) {
    const std::size_t blank = text.find(' ');
    return "#version " + text.substr(1, blank - 1) + ";" + text.substr(blank);
  }
  return "#version 3.7; global_settings { assumed_gamma 1 }\n" + text;
}

std::string messages_of(const fs::path& folder, const std::string& text) {
  tool::write_text(folder / "scene.pov", text);
  parser::SourceManager sources;
  parser::Diagnostics diagnostics(sources);
  for (std::size_t i = 0; i < parser::kStreams; ++i) {
    diagnostics.connect(static_cast<parser::Stream>(i), {});
  }
  parser::ParserOptions options;
  options.limits.turns = 2000;
  options.limits.nested = 100;
  options.limits.layers = 50;
  options.limits.object_parts = 1e3;
  std::string all;
  try {
    const auto scene =
        parser::read_scene((folder / "scene.pov").string(), sources, diagnostics, options);
    parser::camera_request(scene.camera, {});
  } catch (const camera::CameraError& error) {
    all = std::string(error.what()) + "\n";
  } catch (const parser::ParseError& error) {
    all = error.message() + "\n";
    EXPECT_NE(error.where().file, 0u) << "a message without a place: " << all << text;
  }
  for (const auto& warning : diagnostics.warnings()) all += warning.message + "\n";
  return all;
}

// Literals of more than one word, those that stand beside each other joined.
std::vector<std::string> texts_of(const fs::path& file) {
  static const std::regex comment("//[^\n]*"), joined("\"\\s*\\n\\s*\""),
      literal("\"((?:[^\"\\\\\\n]|\\\\.)*)\""), escape("\\\\(.)");
  std::string text = std::regex_replace(tool::read_text(file), comment, "");
  text = std::regex_replace(text, joined, "");
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), literal), end; at != end; ++at) {
    const std::string words = std::regex_replace((*at)[1].str(), escape, "$1");
    const std::size_t first = words.find_first_not_of(' ');
    const std::size_t blank = first == std::string::npos ? first : words.find(' ', first);
    if (blank != std::string::npos && words.find_first_not_of(' ', blank) != std::string::npos) {
      found.push_back(words);
    }
  }
  return found;
}

TEST(GrammarMessages, EachIsHeard) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "bad.png", "no picture");
  tool::write_text(folder / "bad.ttf", "no font");
  tool::write_text(folder / "two.gif", std::string("GIF89a\1\0\1\0\200\0\0", 13) + "abcdef");
  tool::write_text(folder / "bad.df3", "no");
  tool::write_text(folder / "empty.ph", std::string(8, '\0'));
  tool::write_text(folder / "odd.df3", std::string("\0\2\0\1\0\1", 6) + "abcde");
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  std::string heard;
  for (const Program& program : kPrograms) {
    const std::string messages = messages_of(folder.path(), scene_of(program.text));
    EXPECT_NE(messages.find(program.heard), std::string::npos)
        << program.text << "\n  wanted: " << program.heard << "\n  heard: " << messages;
    heard += messages;
  }
  fs::current_path(before);
  std::size_t count = 0;
  for (const char* part : {"grammar", "compile", "shapes", "stock"}) {
    for (const auto& file :
         fs::directory_iterator(fs::path(LENTRAY_SOURCE_DIR) / "parser" / part)) {
      for (const std::string& words : texts_of(file.path())) {
        ++count;
        const bool unheard =
            std::find(std::begin(kUnheard), std::end(kUnheard), words) != std::end(kUnheard);
        EXPECT_TRUE(unheard || heard.find(words) != std::string::npos)
            << file.path().filename() << ": no program provokes \"" << words << '"';
      }
    }
  }
  EXPECT_GT(count, 200u);
}

TEST(GrammarMessages, RandomNumbersOfIncludeFilesAreNotHeard) {
  const tool::TemporaryFolder folder;
  for (const char* text :
       {"#declare F = finish { crand .1 } sphere { 0, 1 }",
        "#declare L = light_source { 9, 1 area_light x, y, 2, 2 jitter } sphere { 0, 1 }"}) {
    EXPECT_EQ(messages_of(folder.path(), scene_of(text)).find("random numbers"), std::string::npos)
        << text;
  }
}

}  // namespace
}  // namespace lentray::test
