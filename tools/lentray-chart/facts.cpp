#include "tools/lentray-chart/facts.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <sstream>

#include "core/base/lower_case.h"

namespace lentray::chart {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

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
  for (std::string word; std::getline(words, word, ',');) items.insert(trimmed(word));
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

/// The number behind a label at the beginning of a line.
long number_of(const std::string& text, const std::string& label, long otherwise) {
  const std::size_t at = text.find("\n  " + label + " ");
  if (at == std::string::npos) return otherwise;
  const char* const begin = text.c_str() + at + label.size() + 4;
  char* end = nullptr;
  const long value = std::strtol(begin, &end, 10);
  return end == begin ? otherwise : value;
}

}  // namespace

Abilities::Abilities(const std::string& help) {
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      const std::size_t equals = word.find('=');
      if (equals == std::string::npos || equals == 0) continue;
      while (!word.empty() && word.back() == ',') word.pop_back();
      m_forms.try_emplace(core::lower_case(word.substr(0, equals)),
                          core::lower_case(word.substr(equals + 1)));
    }
  }
}

bool Abilities::has(const std::string& name) const {
  return m_forms.contains(core::lower_case(name));
}

bool Abilities::has(const std::string& name, const std::string& value) const {
  const auto form = m_forms.find(core::lower_case(name));
  if (form == m_forms.end()) return false;
  std::istringstream values(form->second);
  for (std::string word; std::getline(values, word, '|');) {
    if (word == core::lower_case(value)) return true;
  }
  return false;
}

SceneFacts facts_of(const std::string& explanation) {
  SceneFacts facts;
  const std::string text = "\n" + explanation;
  facts.is_sheet = text.find("\nCamera\n  lenticular,") != std::string::npos;
  const std::set<std::string> used = list_of(text, "used");
  facts.area_lights = used.contains("area lights");
  facts.media = used.contains("media");
  facts.objects = static_cast<std::size_t>(std::max(0L, number_of(text, "objects", 0)));
  facts.depth = static_cast<int>(number_of(text, "trace level", 1));
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
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : "; ") + part;
  return out;
}

}  // namespace lentray::chart
