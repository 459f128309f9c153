// Scenes with slanted lens sheets, for the tests of those. Scene units are mm; the sheet lies across z at
// the origin.
#pragma once

#include <cstdio>
#include <sstream>
#include <string>

#include "tests/support/render.h"
#include "tests/support/slanted_reference.h"

namespace lentray::test::slanted {

using Model = SlantReference::Model;

inline std::string number(SlantReal value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", static_cast<double>(value));
  return buffer;
}
inline std::string point(const SlantVector& v) {
  return "<" + number(v[0]) + "," + number(v[1]) + "," + number(v[2]) + ">";
}

inline std::string head() {
  return "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 0 }\n";
}

/// Solids before and behind the sheet; units are mm.
inline constexpr const char* kThings = R"(background { rgb <.2,.3,.5> }
light_source { <20,40,-60> rgb 1 }
plane { y, -4.1 pigment { checker rgb <.9,.8,.6> rgb <.3,.4,.2> translate <.137,0,.291> } }
sphere { <-1.1,.3,6>, 2.6 pigment { rgb <.8,.2,.1> } finish { phong .5 reflection .2 } }
box { <2.013,-2.47,-1.02>, <3.97,2.03,.84>
  pigment { gradient x color_map { [0 rgb 1] [1 rgb z] } scale .317 } }
cylinder { <-4,-3,-3>, <-3,3,2>, .5 pigment { rgb <.2,.6,.3> } }
)";

/// Stripes that stand one above the other before the sheet, each for its share of the rows.
inline std::string stripes(const SlantReference& s) {
  constexpr double kDepths[] = {3.0, 20.0, 60.0, 0.6};
  std::ostringstream out;
  for (int i = 0; i < 4; ++i) {
    const SlantReal depth = kDepths[i], shrunk = 1.0L - depth * s.inverse();
    const SlantReal top = (0.5L - i / 4.0L) * s.height() * shrunk;
    const SlantReal bottom = (0.25L - i / 4.0L) * s.height() * shrunk;
    const SlantReal wave = 0.35L + 0.12L * depth;
    out << "box { <-500," << number(bottom) << ",0>, <500," << number(top) << ",.001> translate "
        << number(-depth) << "*z\n  pigment { average pigment_map {"
        << " [1 function { 0.5 + 0.5*sin(x/" << number(wave)
        << ") } color_map { [0 rgb 0] [1 rgb <3,0,0>] }]"
        << " [1 function { 0.5 + 0.5*sin(x/" << number(3.1L * wave) << " + " << i
        << ") } color_map { [0 rgb 0] [1 rgb <0,3,0>] }]"
        << " [1 function { select(sin(x/" << number(5.0L * wave)
        << "), 0, 1) } color_map { [0 rgb 0] [1 rgb <0,0,3>] }]"
        << " } }\n  finish { ambient 0 diffuse 0 emission 1 } }\n";
  }
  return out.str();
}

inline constexpr double kFront = 70.0;

inline std::string world_of(const SlantReference& s) {
  return head() + (s.model == Model::kThick ? stripes(s) : std::string(kThings));
}

inline std::string sheet_scene(const SlantReference& s) {
  std::ostringstream out;
  const char* const models[] = {"paraxial", "pinhole", "thick"};
  out << world_of(s) << "camera { lenticular location 0 direction "
      << point({s.eye_slope_x, s.eye_slope_y, 1}) << " right " << number(s.width()) << "*x up "
      << number(s.height()) << "*y\n  lens_pitch " << number(s.pitch) << " lens_focal_length "
      << number(s.focal_length) << " lens_ior " << number(s.ior) << " lens_pixels "
      << number(s.pixels) << " lens_front " << number(kFront) << " view_distance "
      << number(s.distance) << " lens_slant " << number(s.slant) << " lens_model "
      << models[static_cast<int>(s.model)];
  if (s.model == Model::kThick) out << " lens_rays " << s.rays;
  out << " }\n";
  return out.str();
}

inline SceneText text_of(const std::string& sdl, int width, int height) {
  SceneText scene;
  scene.sdl = sdl;
  scene.width = static_cast<std::uint32_t>(width);
  scene.height = static_cast<std::uint32_t>(height);
  return scene;
}

}  // namespace lentray::test::slanted
