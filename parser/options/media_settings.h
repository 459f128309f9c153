// How media are sampled, whatever the scene says: so that a study can vary it from the command line.
#pragma once

#include <optional>

namespace lentray::parser {

struct MediaSettings {
  std::optional<int> method, intervals;
  std::optional<int> samples;  ///< the least and the most
  std::optional<double> confidence;
};

}  // namespace lentray::parser
