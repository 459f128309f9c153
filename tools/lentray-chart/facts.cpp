#include "tools/lentray-chart/facts.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <sstream>

#include "core/base/joined.h"
#include "core/base/lower_case.h"
#include "core/base/trimmed.h"

namespace lentray::chart {
namespace {

/// The list that begins with "  label" and ends before the next line of two blanks; items at commas.
std::set<std::string> list_of(const std::string& text, const std::string& label) {
  const std::string begin = "\n  " + label + " ";
  const std::size_t at = text.find(begin);
  std::set<std::string> items;
  if (at == std::string::npos) return items;
  std::istringstream lines(text.substr(at + begin.size()));
  std::string all, line;
  while (std::getline(lines, line) && (all.empty() || line.starts_with("    "))) all += line + " ";
  std::istringstream words(all);
  for (std::string word; std::getline(words, word, ',');)
    items.emplace(core::trimmed(word, " \t\n"));
  return items;
}

/// The number behind some words of a line.
double number_behind(const std::string& line, const std::string& words) {
  const std::size_t at = line.find(words);
  return at == std::string::npos ? 0.0 : std::strtod(line.c_str() + at + words.size(), nullptr);
}

/// The line that begins with two blanks and `label`; empty where there is none.
std::string line_of(const std::string& text, const std::string& label) {
  const std::size_t begin = text.find("\n  " + label + " ");
  if (begin == std::string::npos) return "";
  return text.substr(begin + 1, text.find('\n', begin + 1) - begin - 1);
}

/// "  radiosity  35 rays a sample, 2 bounces, error_bound 1.8"
/// "  photons  count 20000, gather 20 to 100", or "spacing 0.02, ..."
/// "  subsurface light  50 and 50 samples"
void look_at_global_light(const std::string& text, SceneFacts& facts) {
  const std::string radiosity = line_of(text, "radiosity"), photons = line_of(text, "photons");
  facts.radiosity_count = static_cast<int>(number_behind(radiosity, "radiosity "));
  facts.radiosity_bounces = static_cast<int>(number_behind(radiosity, "a sample, "));
  facts.radiosity_error = number_behind(radiosity, "error_bound ");
  facts.photon_count = static_cast<int>(number_behind(photons, "count "));
  facts.photon_gather = static_cast<int>(number_behind(photons, " to "));
  facts.subsurface_samples =
      static_cast<int>(number_behind(line_of(text, "subsurface light"), "subsurface light "));
}

}  // namespace

Abilities::Abilities(const std::string& help) {
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      const std::size_t equals = word.find('=');
      if (equals == std::string::npos || equals == 0) continue;
      m_names.insert(core::lower_case(word.substr(0, equals)));
    }
  }
}

bool Abilities::has(const std::string& name) const {
  return m_names.contains(core::lower_case(name));
}

SceneFacts facts_of(const std::string& explanation) {
  SceneFacts facts;
  const std::string text = "\n" + explanation;
  facts.is_sheet = text.find("\nCamera\n  lenticular,") != std::string::npos;
  const std::set<std::string> used = list_of(text, "used");
  facts.area_lights = used.contains("area lights");
  facts.media = used.contains("media");
  facts.objects =
      static_cast<std::size_t>(std::max(0.0, number_behind(line_of(text, "objects"), "objects ")));
  const std::string depth = line_of(text, "trace level");
  if (!depth.empty()) facts.depth = static_cast<int>(number_behind(depth, "trace level "));
  look_at_global_light(text, facts);
  const std::size_t level = text.find("(max_trace_level ");
  if (level != std::string::npos) {
    facts.max_trace_level = std::max(1, std::atoi(text.c_str() + level + 17));
  }
  return facts;
}

std::string noise_of(const SceneFacts& facts, bool jittered_antialiasing) {
  std::vector<std::string> parts;
  if (jittered_antialiasing) parts.emplace_back("antialiasing is jittered");
  if (facts.area_lights) parts.emplace_back("area lights with jitter take random points");
  if (facts.focal_blur) parts.emplace_back("focal blur takes random points of the aperture");
  if (facts.media)
    parts.emplace_back("media of methods 1 and 2, or with jitter, take random samples");
  if (facts.photon_gather > 0) parts.emplace_back("photons are strewn at random");
  if (facts.subsurface_samples > 0) {
    parts.emplace_back("subsurface light comes from random points of the surface");
  }
  return core::joined(parts, "; ");
}

}  // namespace lentray::chart
