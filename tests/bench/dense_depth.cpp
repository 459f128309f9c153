// How far everything moves that a lens sheet shows, by a ray through every pixel: what composition.py holds sheets
// against. Of the sheet it takes what a statistics file says of it.
//   lentray-dense-depth SCENE STATISTICS.json    prints one JSON object
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/vec3.h"
#include "tests/support/dense_depth.h"

namespace {

using lentray::core::Vec3;
using nlohmann::json;

Vec3 vector_of(const json& from) { return {from[0], from[1], from[2]}; }

void print(const std::string& scene_path, const json& statistics) {
  const json& lens = statistics.at("lens");
  lentray::test::DenseSheet sheet;
  sheet.pitch = lens.at("pitch_mm");
  sheet.focal_length = lens.at("focal_length_mm");
  sheet.index = lens.at("ior");
  sheet.pixels = lens.at("pixels");
  sheet.print_pitch = lens.at("print_pitch_mm");
  sheet.width = static_cast<int>(lens.at("lenses").get<double>() * sheet.pixels + 0.5);
  sheet.height = static_cast<int>(
      lens.at("print_height_mm").get<double>() * lens.at("print_dpi_y").get<double>() / 25.4 + 0.5);
  const lentray::test::DenseScene scene(scene_path, sheet.width, sheet.height);
  sheet.factor = lens.at("depth_factor");
  sheet.distance = scene.distance_of(vector_of(lens.at("centre")));
  const lentray::test::DenseDepth seen = scene.look(sheet);
  const json out{{"least", seen.least},
                 {"most", seen.most},
                 {"low", seen.low},
                 {"high", seen.high},
                 {"sky", seen.sky},
                 {"rays", seen.rays},
                 {"background", seen.background},
                 {"distance", sheet.distance}};
  std::puts(out.dump().c_str());
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fputs("usage: lentray-dense-depth SCENE STATISTICS.json\n", stderr);
    return 2;
  }
  try {
    print(arguments[1], json::parse(std::ifstream(arguments[2])));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lentray-dense-depth: %s\n", error.what());
    return 1;
  }
}
