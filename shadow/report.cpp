#include "shadow/report.h"

#include <utility>

namespace lentray::shadow {
namespace {

using nlohmann::json;

json counts_json(const core::ShadowCounts& counts) {
  return {{"rays", counts.rays},
          {"blocked", counts.blocked},
          {"cache", {{"probes", counts.probes}, {"hits", counts.hits}, {"misses", counts.misses}}},
          {"auto", {{"cached", counts.cached}}}};
}

json tests_json(const RunReport& report) {
  json by_type = json::object();
  for (const auto& [type, count] : report.counters.tests_by_type) by_type[type] = count;
  return {{"bounds", report.counters.bounds_tests},
          {"primitives", report.counters.primitive_tests},
          {"by_type", std::move(by_type)}};
}

json log_json(const std::vector<LightRuns>& lights) {
  LightRuns all;
  std::uint64_t pairs = 0, most_hits = 0;
  for (const LightRuns& light : lights) {
    all.add(light);
    pairs += light.blockers.size();
    most_hits += light.most_hits();
  }
  json by_length = json::array();
  for (const std::uint64_t count : all.by_length) by_length.push_back(count);
  while (!by_length.empty() && by_length.back() == 0) by_length.erase(by_length.size() - 1);
  return {{"tests", all.tests},
          {"miss_tests", all.miss_tests},
          {"pairs", pairs},
          {"most_hits", most_hits},
          {"runs", {{"count", all.runs}, {"longest", all.longest}, {"by_length", by_length}}}};
}

json passes_json(const std::vector<core::PassReport>& passes) {
  json out = json::array();
  for (const core::PassReport& pass : passes) {
    json numbers = json::object();
    for (const auto& [name, value] : pass.numbers) numbers[name] = value;
    out.push_back({{"name", pass.name},
                   {"wall_s", pass.wall_s},
                   {"cpu_s", pass.cpu_s},
                   {"numbers", std::move(numbers)}});
  }
  return out;
}

}  // namespace

json to_json(const RunReport& report) {
  const core::Counters& c = report.counters;
  core::ShadowCounts all;
  json lights = json::array();
  for (std::size_t i = 0; i < c.lights.size(); ++i) {
    all.add(c.lights[i]);
    lights.push_back({{"index", i}, {"shadow", counts_json(c.lights[i])}});
  }
  json out;
  out["scene"] = report.scene;
  out["image"] = {{"width", report.width}, {"height", report.height}};
  out["options"] = {{"pixel_order", report.pixel_order},
                    {"shadow_cache", report.shadow_cache},
                    {"accelerator", report.accelerator}};
  out["bands"] = {{"height", report.band_height}, {"count", report.bands}};
  out["rays"] = {{"camera", c.camera_rays},
                 {"reflected", c.reflected_rays},
                 {"refracted", c.refracted_rays},
                 {"shadow", all.rays}};
  out["pixels"] = {{"dark", c.dark_pixels}, {"antialiased", c.antialiased_pixels}};
  out["shadow"] = counts_json(all);
  if (!report.shadow_log.empty()) out["shadow"]["log"] = log_json(report.shadow_log);
  out["lights"] = std::move(lights);
  if (report.tests_counted) out["tests"] = tests_json(report);
  if (!report.passes.empty()) out["passes"] = passes_json(report.passes);
  out["time"] = {{"parse_cpu_s", report.parse_cpu_s},
                 {"compile_cpu_s", report.compile_cpu_s},
                 {"render_cpu_s", report.render_cpu_s},
                 {"write_cpu_s", report.write_cpu_s},
                 {"wall_s", report.wall_s}};
  out["threads"] = report.threads;
  out["memory"] = {{"peak_bytes", report.peak_bytes}};
  for (const core::MemoryStage& stage : report.memory) {
    out["memory"]["stages"][std::string(stage.name)] = stage.bytes;
  }
  return out;
}

}  // namespace lentray::shadow
