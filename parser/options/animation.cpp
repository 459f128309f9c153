#include "parser/options/animation.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace lentray::parser {
namespace {

/// Stock hands these constants to the scene as texts of six digits.
double six_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return std::strtod(text, nullptr);
}

/// The first or last frame of a subset of `count` frames.
int subset(std::optional<double> given, int count, int otherwise) {
  if (!given) return otherwise;
  const bool is_part = *given > 0.0 && *given < 1.0;
  return static_cast<int>(is_part ? count * *given : *given);
}

}  // namespace

bool is_animation(const AnimationOptions& options) {
  const int first = options.initial_frame.value_or(0), last = options.final_frame.value_or(0);
  return !(first == 0 && last == 0) && !(first == 1 && last == 1);
}

std::vector<AnimationFrame> frames_of(const AnimationOptions& options) {
  const int initial = options.initial_frame.value_or(1);
  const int last = std::max(options.final_frame.value_or(1), initial);
  const int end = options.cyclic ? last + 1 : last;  // where the final clock is reached
  FrameClock all;
  all.clock_on = true;
  all.initial_frame = initial;
  all.final_frame = end;
  const double initial_clock = static_cast<float>(options.initial_clock.value_or(0.0));
  const double final_clock = static_cast<float>(options.final_clock.value_or(1.0));
  const double delta = end > initial ? (final_clock - initial_clock) / (end - initial) : 0.0;
  all.initial_clock = six_digits(initial_clock);
  all.final_clock = six_digits(final_clock);
  all.clock_delta = six_digits(delta);

  const int from = std::max(subset(options.subset_start, end - initial + 1, initial), initial);
  const int to = std::max(subset(options.subset_end, end - initial + 1, last), from);
  const std::size_t digits = std::to_string(end).size();
  std::vector<AnimationFrame> out;
  for (long long number = from; number <= to; number += options.step) {
    AnimationFrame frame{all, std::to_string(number)};
    frame.clock.frame_number = static_cast<int>(number);
    frame.clock.clock =
        static_cast<float>(delta * static_cast<double>(number - initial) + initial_clock);
    if (frame.digits.size() < digits) frame.digits.insert(0, digits - frame.digits.size(), '0');
    out.push_back(std::move(frame));
  }
  return out;
}

FrameClock still_clock(double clock, bool given) {
  FrameClock out;
  out.clock = static_cast<float>(clock);
  out.clock_on = given;
  return out;
}

}  // namespace lentray::parser
