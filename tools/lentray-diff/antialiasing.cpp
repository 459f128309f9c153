#include "tools/lentray-diff/antialiasing.h"

#include <algorithm>

#include "core/base/formed.h"
#include "parser/options/options.h"

namespace lentray::diff {

Antialiasing antialiasing_of(const parser::RenderOptions& options) {
  Antialiasing out;
  out.on = options.antialias;
  out.method = std::min(options.sampling_method, 2);
  if (out.on && options.sampling_method == 3 && options.lenticular)
    throw parser::OptionError(
        "Sampling_Method=3 spreads the samples of a print for the eye, which POV-Ray does not: its "
        "pictures are compared with those of methods 1 and 2");
  out.threshold = options.antialias_threshold;
  out.depth = options.antialias_depth;
  out.jitter = options.jitter ? options.jitter_amount : 0.0;
  out.gamma = options.antialias_gamma;
  out.angles = options.antialias_angles;
  return out;
}

std::vector<std::string> words(const Antialiasing& a) {
  if (!a.on) return {"-A", "-J"};
  const auto option = [](const char* name, double value) {
    return core::formed("%s=%.17g", name, value);
  };
  std::vector<std::string> out{"Antialias=On", "Sampling_Method=" + std::to_string(a.method),
                               option("Antialias_Threshold", a.threshold),
                               "Antialias_Depth=" + std::to_string(a.depth),
                               option("Antialias_Gamma", a.gamma)};
  if (a.jitter > 0.0) {
    out.insert(out.end(), {"Jitter=On", option("Jitter_Amount", a.jitter)});
  } else {
    out.emplace_back("Jitter=Off");
  }
  return out;
}

bool is_random(const Antialiasing& a) { return a.on && a.jitter > 0.0; }

}  // namespace lentray::diff
