// Places of rays that an eye blends. Nobody sees a pixel of a print: the eye blends several rows, and
// the lens several columns. So the rays of pixels that are seen together go through different places,
// well spread, and the eye averages them. Pure.
// Source: the steps from row to row and from ray to ray are those of M. Roberts' sequences of three
// and of two dimensions ("The Unreasonable Effectiveness of Quasirandom Sequences", 2018); those
// from lens to lens keep neighbouring lenses apart. tests/bench/eye_samples.py measures what an eye
// sees.
#pragma once

#include <cstdint>

namespace lentray::core {

/// Where an eye sees a pixel: it blends neighbouring rows, and neighbouring views of a lens.
struct EyePlace {
  std::int64_t lens = 0, row = 0, view = 0;
};

/// Across and down a pixel's area, or a lens's aperture and a pixel's row: -0.5 to 0.5 each.
struct SpreadPlace {
  double across = 0.0, down = 0.0;
};

/// Of ray `number` of a pixel, of any number of rays.
SpreadPlace spread_place(const EyePlace& at, std::uint32_t number);
/// The same of `count` rays, each in its own part of so many from the left.
SpreadPlace spread_place(const EyePlace& at, std::uint32_t number, std::uint32_t count);

}  // namespace lentray::core
