#include "parser/options/animation.h"

#include <algorithm>
#include <cstdlib>

#include "core/base/formed.h"

namespace lentray::parser {
namespace {

/// Stock hands these constants to the scene as texts of six digits.
double six_digits(double value) { return std::strtod(core::formed("%g", value).c_str(), nullptr); }

/// The first or last frame of a subset of `count` frames.
int subset(std::optional<double> given, int count, int otherwise) {
  if (!given) return otherwise;
  const bool is_part = *given > 0.0 && *given < 1.0;
  return static_cast<int>(is_part ? count * *given : *given);
}

/// With zeros before, as many digits as the largest number has.
std::string padded(std::string digits, std::size_t count) {
  if (digits.size() < count) digits.insert(0, count - digits.size(), '0');
  return digits;
}

AnimationFrames frames_of_views(const AnimationOptions& options) {
  const ViewFrames views = options.views;
  const int count = static_cast<int>(views.count);
  const std::size_t digits = std::to_string(count - 1).size();
  const int from = subset(options.subset_start, count, 0);
  const int to = std::min(subset(options.subset_end, count, count - 1), count - 1);
  return {from, to, options.step, [views, digits](int view) {
            AnimationFrame frame{views.still, padded(std::to_string(view), digits)};
            if (views.clocks) {
              const auto number = static_cast<std::uint32_t>(view);
              frame.clock = still_clock(view_clock(*views.clocks, number, views.count), true);
            }
            return frame;
          }};
}

}  // namespace

AnimationFrames::AnimationFrames(int first, int last, int step, Make make)
    : m_first(first), m_step(step),
      m_size(last < first ? 0 : static_cast<std::size_t>((std::int64_t{last} - first) / step + 1)),
      m_make(std::move(make)) {}

AnimationFrame AnimationFrames::operator[](std::size_t place) const {
  return m_make(static_cast<int>(m_first + static_cast<std::int64_t>(place) * m_step));
}

double view_clock(const std::pair<double, double>& clocks, std::uint32_t view,
                  std::uint32_t count) {
  if (count < 2) return clocks.first;
  return clocks.first + (clocks.second - clocks.first) * view / (count - 1);
}

bool is_animation(const AnimationOptions& options) {
  if (options.views.count > 0) return true;
  const int first = options.initial_frame.value_or(0), last = options.final_frame.value_or(0);
  return !(first == 0 && last == 0) && !(first == 1 && last == 1);
}

AnimationFrames frames_of(const AnimationOptions& options) {
  if (options.views.count > 0) return frames_of_views(options);
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
  return {from, to, options.step, [=](int number) {
            AnimationFrame frame{all, padded(std::to_string(number), digits)};
            frame.clock.frame_number = number;
            const double past = static_cast<double>(number) - initial;
            frame.clock.clock = static_cast<float>(delta * past + initial_clock);
            return frame;
          }};
}

FrameClock still_clock(double clock, bool given) {
  FrameClock out;
  out.clock = static_cast<float>(clock);
  out.clock_on = given;
  return out;
}

}  // namespace lentray::parser
