// A common stage for the shading tests: a checkered floor, a camera, white light, and room for
// the surface under test. Pictures are small; every difference is a formula, not an edge.
#pragma once

#include <string>

#include "tests/support/render.h"

namespace lentray::test {

inline std::string stage(const std::string& more, const std::string& light = R"(
light_source { <-6, 9, -7> rgb 1 })",
                         const std::string& settings = "") {
  return R"(#version 3.7;
global_settings { assumed_gamma 1.0 )" +
         settings + R"( }
camera { location <0, 2.2, -6> look_at <0, 0.9, 0> angle 42 }
)" + light +
         R"(
plane { y, 0 pigment { checker rgb <0.9, 0.8, 0.6> rgb <0.3, 0.35, 0.5> }
  finish { ambient 0.1 diffuse 0.7 } }
)" + more;
}

inline SceneText staged(const std::string& more, const std::string& light = R"(
light_source { <-6, 9, -7> rgb 1 })",
                        const std::string& settings = "") {
  SceneText scene;
  scene.sdl = stage(more, light, settings);
  scene.width = 120;
  scene.height = 90;
  return scene;
}

/// A sphere of that finish (and pigment) in the middle of the stage, beside a small red one.
inline SceneText finished(const std::string& finish,
                          const std::string& pigment = "rgb <0.9, 0.5, 0.2>") {
  return staged("sphere { <0, 1, 0>, 1 pigment { " + pigment + " } finish { " + finish +
                " } }\nsphere { <1.5, 0.4, -0.8>, 0.4 pigment { rgb <0.8, 0.1, 0.1> } }\n"
                "background { rgb <0.2, 0.3, 0.5> }");
}

}  // namespace lentray::test
