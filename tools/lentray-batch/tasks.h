// The work of a batch for a cluster: pictures, and bands of large ones, packed into tasks of about the same time.
// Pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lentray::batch {

/// What is known of a picture before it is rendered.
struct Estimate {
  std::string name;    ///< of its job
  double fixed = 0.0;  ///< seconds of a processor that every part of it takes: reading, building
  double rendering = 0.0;  ///< seconds of a processor for all rows
  std::int64_t rows = 0;   ///< of the picture; 0: it cannot be cut into bands
  std::int64_t grain = 1;  ///< bands begin at multiples of so many rows, which are traced together
};

/// A picture, or rows of it.
struct Item {
  std::string name;
  int band = 0, bands = 1;
  std::int64_t first_row = 1, last_row = 0;  ///< as +SR and +ER, of a band
  double seconds = 0.0;
};
using Task = std::vector<Item>;

/// Tasks of about `seconds`, the longest first. Pictures that take more than 1.5 times that are cut into bands, so many that
/// what each repeats stays below a half. Small ones are packed together.
std::vector<Task> pack(const std::vector<Estimate>& pictures, double seconds);

/// How long tasks should be: a few minutes, and shorter where `processors` would otherwise have too few to share.
double task_seconds(const std::vector<Estimate>& pictures, int processors);

}  // namespace lentray::batch
