// Numbers instead of pictures: stock prints the values of a function at many points.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/vec3.h"
#include "parser/compile/pattern_compiler.h"
#include "tests/support/render.h"
#include "tests/unit/material/material_reading.h"

namespace lentray::parser::test {

inline std::vector<core::Vec3> sample_points() {
  std::mt19937 random(7);
  const auto uniform = [&](double reach) {
    return (static_cast<double>(random()) / 4294967296.0 * 2.0 - 1.0) * reach;
  };
  std::vector<core::Vec3> points = {{0, 0, 0}, {1, 1, 1}, {-1, -2, -3}, {.5, .5, .5}};
  for (int i = 0; i < 120; ++i) points.emplace_back(uniform(8), uniform(8), uniform(8));
  for (int i = 0; i < 60; ++i) points.emplace_back(uniform(1), uniform(1), uniform(1));
  return points;
}

/// What stock prints for each expression of F, at each point.
inline std::vector<double> stock_values(const std::string& function, const std::string& before,
                                        const std::vector<std::string>& expressions) {
  std::ostringstream scene;
  scene << std::setprecision(17) << "#version 3.7; global_settings { assumed_gamma 1 }\n"
        << before << "\n#declare F = function { " << function << " }\n";
  const std::vector<core::Vec3> points = sample_points();
  scene << "#declare P = array[" << points.size() << "] {";
  for (const core::Vec3& p : points) scene << " <" << p.x << ',' << p.y << ',' << p.z << ">,";
  // Into a file: on the console a line can be torn by another stream.
  scene << " }\n#fopen OUT \"values.txt\" write\n#declare I = 0; #while (I < " << points.size()
        << ")\n#declare V = F(P[I].x, P[I].y, P[I].z);\n";
  for (const std::string& e : expressions) {
    scene << "#write(OUT, str(" << e << ", 0, 15), \"\\n\")\n";
  }
  scene << "#declare I = I + 1; #end\n#fclose OUT\n";
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", scene.str());
  const tool::RunResult result = tool::run_program(
      {"povray", "+Iscene.pov", "+Oout.png", "+W1", "+H1", "-D"}, folder.path(), 300.0);
  std::vector<double> values;
  std::ifstream lines(folder / "values.txt");
  for (std::string line; std::getline(lines, line);) values.push_back(std::stod(line));
  EXPECT_EQ(values.size(), points.size() * expressions.size()) << result.output;
  values.resize(points.size() * expressions.size());
  return values;
}

inline void expect_same(double ours, double stock, double tolerance, const core::Vec3& at) {
  if (std::isnan(ours) && std::isnan(stock)) return;
  EXPECT_NEAR(ours, stock, tolerance) << "at " << at.x << ' ' << at.y << ' ' << at.z;
}

/// For values of pigments: a grey ramp shows a pattern's as floats.
inline constexpr const char* kGreys = " color_map { [0 rgb 0] [1 rgb 1] } ";

/// The values of the pattern that a pigment of these words has.
inline std::vector<double> our_values(const std::string& pigment) {
  const LooksText read("pigment { " + pigment + " }");
  const TextureSettings settings;
  std::set<std::string> not_yet;
  const PatternBuild build{settings, not_yet, nullptr, nullptr, nullptr};
  const core::PlacedPattern pattern = compile_placed(read.pattern(), build);
  EXPECT_TRUE(not_yet.empty());
  std::vector<double> values;
  for (const core::Vec3& point : sample_points())
    values.push_back(pattern.value(pattern.placement.inwards(point)));
  return values;
}

/// The pattern of the words, with these transforms after it, has stock's values. Points of whole and half
/// numbers are left out: they are on edges and corners of many tiles.
inline void expect_stocks_tiles(const std::string& words, const std::string& transforms) {
  const std::string text = words + kGreys + transforms;
  const auto stock = stock_values("pigment { " + text + " }", "", {"V.red"});
  const auto ours = our_values(text);
  const auto points = sample_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const core::Vec3 twice = 2.0 * points[i];
    if (twice.x == std::floor(twice.x) && twice.z == std::floor(twice.z)) continue;
    expect_same(ours[i], stock[i], 2e-6, points[i]);
  }
}

}  // namespace lentray::parser::test
