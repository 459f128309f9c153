// How much of a picture's work is done and left, foreseen from probes (a few samples, traced ahead,
// all over the picture) and from what the threads report. CPU seconds. One thread.
//
// Stage 0 of a cell: its pixels by what a sample costs in probes of the cell and around it.
// Stage 1: its pixels by how many are antialiased (as neighbouring samples differ) by the samples
// these take. Both by what the work done took beside what was foreseen for it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/render/antialiasing.h"
#include "core/render/work_cells.h"

namespace lentray::core {

/// What antialiasing adds to a pixel.
struct FinerWork {
  double samples = 0.0;     ///< of a pixel that is antialiased; 0: there is no stage 1
  double neighbours = 3.0;  ///< independent pairs of samples that have a pixel antialiased
  std::uint32_t job = 64;   ///< the side of the square of pixels that one thread does, about
  static FinerWork of(const Antialiasing& antialiasing);
};

class WorkEstimate {
 public:
  /// `cells` outlives it. `repeats`: visits of stage 0 a pixel (bands overlap).
  WorkEstimate(const WorkCells& cells, const FinerWork& finer, double repeats = 1.0);

  /// A sample of a pixel of that cell took so long; of so many neighbours so many differed.
  void probe(std::size_t cell, double seconds, int pairs, int differing);

  struct Work {
    double done = 0.0, left = 0.0;
    double longest = 0.0;  ///< left of a single job: no more than one thread works on it
    double fraction() const { return done + left > 0.0 ? done / (done + left) : 0.0; }
  };
  Work work() const;
  /// Stage 0 of the cell is done: probes there tell nothing new.
  bool is_traced(std::size_t cell) const;

 private:
  /// Sums of probes.
  struct Sum {
    double probes = 0.0, seconds = 0.0, pairs = 0.0, differing = 0.0;
  };
  /// What is expected of a pixel.
  struct Expected {
    double seconds = 0.0, differing = 0.0;
  };
  /// A level of squares of squares of cells; each holds the probes of its four.
  struct Level {
    std::uint32_t columns = 0, rows = 0;
    std::vector<Sum> sums{};
  };

  std::vector<Expected> expected() const;
  /// Adds what is left of the cells in a stage with jobs of squares of that side, in pixels.
  void add_left(const std::vector<double>& left, std::uint32_t job, Work& out) const;
  std::vector<double> sample_seconds(const std::vector<Expected>& expected, Work& out) const;
  void add_finer(const std::vector<Expected>& expected, const std::vector<double>& seconds,
                 Work& out) const;

  const WorkCells& m_cells;
  const FinerWork m_finer;
  const double m_repeats;
  std::vector<Level> m_levels;  ///< the cells first, one square of all last
};

}  // namespace lentray::core
