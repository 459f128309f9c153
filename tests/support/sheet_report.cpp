#include "tests/support/sheet_report.h"

#include <cmath>
#include <cstdio>
#include <limits>

namespace lentray::test {

using nlohmann::json;

namespace {

std::string decibels(double psnr) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f dB", psnr);
  return std::isinf(psnr) ? "equal" : text;
}

double psnr_of(const json& part) {
  return part["psnr"].is_null() ? std::numeric_limits<double>::infinity()
                                : part["psnr"].get<double>();
}

}  // namespace

SheetRun compare_sheet(std::vector<std::string> arguments, const std::string& grade,
                       double seconds) {
  const tool::TemporaryFolder folder;
  arguments.insert(arguments.end(), {"--no-pictures", "--json", "report.json", "--grade", grade});
  const tool::RunResult result = run_diff(arguments, folder.path(), seconds);
  SheetRun run{result.status, {}, result.output};
  if (std::filesystem::exists(folder / "report.json")) {
    run.report = json::parse(tool::read_text(folder / "report.json"));
  }
  return run;
}

std::string worst_of(const json& parts) {
  if (parts.empty()) return "-";
  core::Grade grade = core::Grade::exact;
  double psnr = std::numeric_limits<double>::infinity();
  for (const json& part : parts) {
    grade = std::min(grade, core::grade_named(part["grade"].get<std::string>()).value());
    psnr = std::min(psnr, psnr_of(part));
  }
  return std::string(core::name_of(grade)) + ", " + decibels(psnr);
}

bool all_match(const json& parts) {
  for (const json& part : parts) {
    if (core::grade_named(part["grade"].get<std::string>()).value() < core::Grade::match) {
      return false;
    }
  }
  return true;
}

void print_row(const std::string& name, const json& report) {
  const json &whole = report["whole"], &lens = report["lens"];
  std::printf("| %s | %u x %u | %.6g | %s | %s, %s | %s | %s |\n", name.c_str(),
              report["width"].get<unsigned>(), report["height"].get<unsigned>(),
              lens["pixels"].get<double>(), report["way"].get<std::string>().c_str(),
              whole["grade"].get<std::string>().c_str(), decibels(psnr_of(whole)).c_str(),
              worst_of(report["views"]).c_str(), worst_of(report["lenses"]).c_str());
  std::fflush(stdout);
}

}  // namespace lentray::test
