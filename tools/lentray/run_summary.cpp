#include "tools/lentray/run_summary.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/formed.h"
#include "parser/options/said_options.h"

namespace lentray::tool {
namespace {

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

std::string share(std::uint64_t part, std::uint64_t all) {
  return core::formed(
      "%.1f %%", all == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(all));
}

/// "Pass:    radiosity 3.21 s: samples 5,779, gathers 12,000".
std::string pass_line(const core::PassReport& pass) {
  std::string out = "\nPass:    " + pass.name + core::formed(" %.2f s", pass.wall_s);
  for (std::size_t i = 0; i < pass.numbers.size(); ++i) {
    const auto& [name, value] = pass.numbers[i];
    const bool is_count = value >= 0.0 && value < 1e18 && value == std::floor(value);
    out += (i == 0 ? ": " : ", ") + name + " ";
    out += is_count ? grouped(static_cast<std::uint64_t>(value)) : core::formed("%.4g", value);
  }
  return out;
}

/// ": descriptions 12 MB, light buffers 3 MB", of those that are large enough to matter.
std::string stages_text(const core::MemoryStages& stages) {
  constexpr std::uint64_t kMatters = 1'000'000;
  std::string out;
  for (const core::MemoryStage& stage : stages) {
    if (stage.bytes < kMatters) continue;
    std::string name(stage.name);
    std::ranges::replace(name, '_', ' ');
    out += (out.empty() ? ": " : ", ") + name +
           core::formed(" %.0f MB", static_cast<double>(stage.bytes) * 1e-6);
  }
  return out;
}

}  // namespace

std::string no_picture(const parser::RenderOptions& options) {
  return parser::with_said("No picture is written: Output_to_File is off", options,
                           {"Output_to_File"});
}

std::string summary(const parser::RenderOptions& options, const shadow::RunReport& report,
                    const std::string& output) {
  const core::Counters& c = report.counters;
  const std::uint64_t pixels = std::uint64_t{report.width} * report.height;
  core::ShadowCounts shadow;
  for (const core::ShadowCounts& light : c.lights) shadow.add(light);
  std::string out = "Pixels:  " + grouped(pixels);
  if (c.antialiased_pixels > 0)
    out += ", antialiased " + grouped(c.antialiased_pixels) + " (" +
           share(c.antialiased_pixels, pixels) + ")";
  out += "\nRays:    camera " + grouped(c.camera_rays) + ", reflected " +
         grouped(c.reflected_rays) + ", refracted " + grouped(c.refracted_rays) + ", shadow " +
         grouped(shadow.rays);
  if (shadow.rays > 0) out += " (" + share(shadow.blocked, shadow.rays) + " blocked)";
  for (const core::PassReport& pass : report.passes) out += pass_line(pass);
  out += core::formed(
      "\nSeconds: reading %.2f, building %.2f, rendering %.2f (CPU, %d thread%s), writing %.2f\n",
      report.parse_cpu_s, report.compile_cpu_s, report.render_cpu_s, report.threads,
      report.threads == 1 ? "" : "s", report.write_cpu_s);
  out += core::formed("Memory:  %.0f MB at most", static_cast<double>(report.peak_bytes) * 1e-6);
  out += stages_text(report.memory) + "\n";
  return out + (output.empty() ? no_picture(options) : output) +
         core::formed(": %u x %u pixels in %.2f s\n", report.width, report.height, report.wall_s);
}

}  // namespace lentray::tool
