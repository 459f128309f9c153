// Pictures for tests: SDL text in, picture out, by stock POV-Ray or by lentray, each in a
// temporary folder that is gone afterwards. Nothing is cached: references are rendered live.
//
//   const SceneText scene{.sdl = "#version 3.7; ...", .width = 80, .height = 60};
//   EXPECT_TRUE(same_as_stock(scene, Grade::exact));
//
// Errors: std::runtime_error with the renderer's output, except from run_lentray, which reports
// whatever happens. Threads: any number.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/image/compare.h"
#include "core/image/reader.h"
#include "tools/common/process.h"

namespace lentray::test {

using core::Comparison;
using core::Grade;
using core::StoredImage;

struct SceneText {
  std::string sdl;
  std::uint32_t width = 80, height = 60;
  std::vector<std::string> arguments = {};  ///< for both renderers, such as "File_Gamma=1.0"
  int bits = 8;                             ///< 8 or 16
  std::vector<std::pair<std::string, std::string>> files = {};  ///< further files: name, contents
};

/// Where the repository and the programs under test are.
std::filesystem::path source_folder();
std::filesystem::path program(const std::string& name);

StoredImage stock_render(const SceneText& scene);
StoredImage lentray_render(const SceneText& scene, const std::vector<std::string>& more = {});

/// lentray with just these arguments, in that folder.
tool::RunResult run_lentray(const std::vector<std::string>& arguments,
                            const std::filesystem::path& folder = {}, double seconds = 300.0);
tool::RunResult run_diff(const std::vector<std::string>& arguments,
                         const std::filesystem::path& folder = {}, double seconds = 600.0);

/// lentray's Statistics_File for the scene.
nlohmann::json lentray_statistics(const SceneText& scene,
                                  const std::vector<std::string>& more = {});

/// Compares whole pictures. The failure message gives all figures and, with LENTRAY_KEEP set in
/// the environment, both pictures stay in that folder.
::testing::AssertionResult same_as_stock(const SceneText& scene, Grade asked = Grade::exact);
::testing::AssertionResult reaches(const StoredImage& ours, const StoredImage& reference,
                                   Grade asked);
/// Every sample equal.
::testing::AssertionResult same_bits(const StoredImage& a, const StoredImage& b);

/// "exact: largest 1, mean 0.001, beyond 1/255 0.02 %, ..."
std::string describe(const Comparison& c);

}  // namespace lentray::test
