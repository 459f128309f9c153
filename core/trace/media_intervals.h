// The pieces of a ray's way through media that are sampled each on its own: lit parts get more of them
// than dark ones. Distances from the ray's origin.
// Source: reference manual 3.7, "Sampling Parameters & Methods"; how pieces are counted is stock's
// (docs/media.md).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/color.h"
#include "core/light/lit_part.h"
#include "core/material/medium.h"

namespace lentray::core {

struct MediaInterval {
  double from, length;
  bool lit;         ///< whether any light reaches it
  Rgb source{};     ///< sum of samples: light that comes out at the interval's start
  Rgb squares{};    ///< sum of their squares
  Rgb depth{};      ///< sum of samples: optical depth
  int samples = 0;  ///< that the sums are to be divided by
};

/// One a thread: its buffer is used again.
class IntervalCutter {
 public:
  /// Fills `out` so that it covers 0..length. `lit`: of each light what it reaches; changed. `even`: there
  /// is no density to sample.
  void cut(const MediumSampling& sampling, bool even, double length, std::vector<RayPart>& lit,
           std::vector<MediaInterval>& out);

 private:
  struct Stretch {
    double from, to;
    bool lit;
  };
  void find_stretches(double length, std::vector<RayPart>& lit);
  static void split(const Stretch& stretch, std::size_t pieces, std::vector<MediaInterval>& out);

  std::vector<Stretch> m_stretches;  ///< the union of the lights' parts, and what lies between them
};

/// What comes out of all intervals at the ray's origin.
struct MediaSum {
  Rgb source;
  Rgb left{1.0f, 1.0f, 1.0f};  ///< of the light that enters at the far end
};
MediaSum sum_of(std::span<const MediaInterval> intervals);

}  // namespace lentray::core
