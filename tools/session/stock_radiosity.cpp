#include "tools/session/stock_radiosity.h"

#include <cstdint>

#include "core/base/formed.h"

namespace lentray::tool {
namespace {

using core::GatherCounts;
using core::RadiosityReport;

unsigned long long number(std::uint64_t count) { return count; }

void add(GatherCounts& sum, const GatherCounts& more) {
  sum.queries += more.queries;
  sum.gathers += more.gathers;
  sum.rays += more.rays;
}

GatherCounts sum_of(const RadiosityReport::Level& level) {
  GatherCounts sum;
  for (const GatherCounts& depth : level.depths) add(sum, depth);
  return sum;
}

std::string block(const std::string& what, const char* samples, const GatherCounts& c) {
  const double share =
      c.queries == 0 ? 0.0
                     : 100.0 * static_cast<double>(c.gathers) / static_cast<double>(c.queries);
  std::string out = core::formed("%-35s%11llu (%.2f %%)\n",
                                 ("Radiosity " + what + samples + "calculated:").c_str(),
                                 number(c.gathers), share);
  out += core::formed("%-35s%11llu\n", ("Radiosity " + what + samples + "reused:").c_str(),
                      number(c.queries - c.gathers));
  out += core::formed("%-35s%11llu\n",
                      ("Radiosity " + what + (*samples ? "sample " : "") + "rays shot:").c_str(),
                      number(c.rays));
  return out;
}

std::string row(const std::string& title, const std::vector<GatherCounts>& depths) {
  std::string out = core::formed("  %-5s", title.c_str());
  std::uint64_t sum = 0;
  for (const GatherCounts& depth : depths) {
    out += core::formed(" %10s", depth.gathers == 0 ? "-" : std::to_string(depth.gathers).c_str());
    sum += depth.gathers;
  }
  return out + core::formed(" %15llu\n", number(sum));
}

std::string table(const RadiosityReport& report, const std::vector<GatherCounts>& depths) {
  const std::string rule(76, '-');
  std::string out = "  Pass ";
  for (std::size_t i = 0; i < depths.size(); ++i)
    out += core::formed(" %10s", ("Depth " + std::to_string(i)).c_str());
  out += core::formed(" %15s\n", "Total") + rule + "\n";
  for (std::size_t i = 0; i < report.levels.size(); ++i) {
    const bool is_last = i + 1 == report.levels.size();
    out += row(is_last ? "Final" : std::to_string(i + 1), report.levels[i].depths);
  }
  return out + rule + "\n" + row("Total", depths) + rule + "\n";
}

}  // namespace

std::string stock_radiosity_text(const RadiosityReport& report) {
  const std::string rule = std::string(76, '-') + "\n";
  std::vector<GatherCounts> depths(report.levels.front().depths.size());
  GatherCounts all;
  for (const RadiosityReport::Level& level : report.levels) {
    add(all, sum_of(level));
    for (std::size_t i = 0; i < depths.size(); ++i) add(depths[i], level.depths[i]);
  }
  std::string out = rule + block("", "samples ", all) + rule;
  out += block("Depth 0 ", "", depths.front());
  return out + rule + block("(final) ", "", sum_of(report.levels.back())) + rule +
         table(report, depths);
}

}  // namespace lentray::tool
