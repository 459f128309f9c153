// The frames of an animation: which there are, and the clock and constants that a scene sees in each.
// Source: reference manual 3.7, "Animation Options"; when the loop runs, cyclic clocks, subsets and
// the digits of names measured on stock (tests/unit/parser_animation_test). Pure functions.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lentray::parser {

struct AnimationOptions {
  std::optional<int> initial_frame{}, final_frame{};
  std::optional<double> initial_clock{}, final_clock{};
  /// Frames; what is above 0 and below 1 is a part of all.
  std::optional<double> subset_start{}, subset_end{};
  int step = 1;
  bool cyclic = false;  ///< the frame after the last one would be the first
};

/// What a scene sees of the animation. A still has all 0, but perhaps a clock.
struct FrameClock {
  double clock = 0.0;
  bool clock_on = false;
  int frame_number = 0, initial_frame = 0, final_frame = 0;
  double initial_clock = 0.0, final_clock = 0.0, clock_delta = 0.0;
};

/// A frame's clock, and the digits that its picture's name ends in: "07" of 12.
struct AnimationFrame {
  FrameClock clock;
  std::string digits;
};

/// Whether there is a loop at all. As stock: unless both first and last frame are 0 or not given, or
/// both are 1.
bool is_animation(const AnimationOptions& options);

/// All frames of an animation in order, at least one. An animation of one frame has its
/// initial clock (in stock it is 0/0).
std::vector<AnimationFrame> frames_of(const AnimationOptions& options);

/// A still's: `given`: Clock= or +K was.
FrameClock still_clock(double clock, bool given);

}  // namespace lentray::parser
