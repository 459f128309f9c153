// Where the rays of a pixel go through the aperture of a thick lens, worked out apart from the program: in
// whole steps of 1e-5 of a turn. Pure.
#pragma once

#include <cstdint>

namespace lentray::test {

/// Of a lens's aperture from its left edge, and of a pixel's row downwards from its middle.
struct ThickPlace {
  long double part = 0.5L, down = 0.0L;
};

/// Ray j of so many, of the pixel of that view of a lens.
inline ThickPlace thick_place(std::int64_t lens, std::int64_t row, std::int64_t view, int j,
                              int rays) {
  constexpr std::int64_t kTurn = 100'000;
  const std::int64_t i = 2 * row + view;
  const auto steps = [](std::int64_t turns) { return ((turns % kTurn) + kTurn) % kTurn; };
  const std::int64_t across = steps(50'000 + 81'917 * i + 43'260 * lens);
  const std::int64_t down = steps(50'000 + 67'104 * i + 39'890 * lens + 56'984 * j);
  return {(j + across / static_cast<long double>(kTurn)) / rays,
          down / static_cast<long double>(kTurn) - 0.5L};
}

}  // namespace lentray::test
