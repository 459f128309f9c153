// A run of lentray-diff on a sheet as a line of a table (Markdown), for the suites that take long.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/render.h"

namespace lentray::test {

/// What lentray-diff found: its JSON (null after an error) and what it said.
struct SheetRun {
  int status = 2;
  nlohmann::json report;
  std::string said;
};

/// `arguments` are the scene and its options; no pictures are written.
SheetRun compare_sheet(std::vector<std::string> arguments, const std::string& grade,
                       double seconds = 3000.0);

/// The worst of a list of parts (lenses or views) as "exact, 61.2 dB": the lowest grade, and the
/// lowest PSNR of any part.
std::string worst_of(const nlohmann::json& parts);

/// Every part has one of the grades exact and match.
bool all_match(const nlohmann::json& parts);

/// "| name | 480 x 180 | 15 | oblique perspective views | exact | worst view | worst lens |",
/// printed on standard output.
void print_row(const std::string& name, const nlohmann::json& report);

}  // namespace lentray::test
