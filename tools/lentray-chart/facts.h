// What a scene uses that a setting can trade time for error with, and which options the lentray that is measured has.
// Pure functions; errors: none, what is not told counts as absent.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace lentray::chart {

/// Options of a lentray, from its help.
class Abilities {
 public:
  Abilities() = default;
  /// `help`: what --help=all prints.
  explicit Abilities(const std::string& help);
  bool has(const std::string& name) const;

 private:
  std::set<std::string> m_names;  ///< in small letters
};

struct SceneFacts {
  unsigned width = 0, height = 0;
  bool is_sheet = false;
  std::string lens_model{};  ///< of a sheet
  bool area_lights = false, media = false, focal_blur = false;
  int radiosity_count = 0;  ///< rays of a sample; 0: no radiosity
  int radiosity_bounces = 0;
  double radiosity_error = 0.0;  ///< error_bound
  int photon_gather = 0;         ///< at most, at a point; 0: no photons
  int photon_count = 0;          ///< that the scene asks for; 0: it has a spacing
  int subsurface_samples = 0;    ///< of light that is scattered many times; 0: no subsurface light
  std::size_t objects = 0;       ///< after splitting unions
  int depth = 1;                 ///< the deepest trace level that can matter
  int max_trace_level = 5;
  /// +Q levels below the user's own whose picture differs from those of all levels above them, falling.
  std::vector<int> quality_levels{};
};

/// From what `lentray --explain` prints: all but width, height, lens_model, focal_blur and quality_levels.
SceneFacts facts_of(const std::string& explanation);

/// Why pictures of the scene hold random noise; empty where nothing is known that makes any.
std::string noise_of(const SceneFacts& facts, bool jittered_antialiasing);

}  // namespace lentray::chart
