// The frames of an animation: which there are, and the clock and constants that a scene sees in
// each.
// Source: reference manual 3.7, "Animation Options"; when the loop runs, cyclic clocks, subsets and
// the digits of names measured on stock (tests/unit/parser/parser_animation_test). Pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

namespace lentray::parser {

/// What a scene sees of the animation. A still has all 0, but perhaps a clock.
struct FrameClock {
  double clock = 0.0;
  bool clock_on = false;
  int frame_number = 0, initial_frame = 0, final_frame = 0;
  double initial_clock = 0.0, final_clock = 0.0, clock_delta = 0.0;
};

/// Pictures of one lens sheet, a view each, made one after another as frames are (docs/views.md).
struct ViewFrames {
  std::uint32_t count = 0;  ///< 0: there are none
  FrameClock still{};       ///< of every view, unless
  std::optional<std::pair<double, double>>
      clocks{};  ///< the first view's and the last view's clock
};

struct AnimationOptions {
  std::optional<int> initial_frame{}, final_frame{};
  std::optional<double> initial_clock{}, final_clock{};
  /// Frames; what is above 0 and below 1 is a part of all.
  std::optional<double> subset_start{}, subset_end{};
  int step = 1;
  bool cyclic = false;  ///< the frame after the last one would be the first
  ViewFrames views{};   ///< instead of a clock's frames
};

/// A frame's clock, and the digits that its picture's name ends in: "07" of 12.
struct AnimationFrame {
  FrameClock clock;
  std::string digits;
};

/// Whether there is a loop at all. As stock: unless both first and last frame are 0 or not given,
/// or both are 1. Views of a sheet are a loop too.
bool is_animation(const AnimationOptions& options);

/// The frames of an animation in order. There may be two thousand million: each is made when it is asked for.
class AnimationFrames {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = AnimationFrame;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = AnimationFrame;
    Iterator(const AnimationFrames& frames, std::size_t at) : m_frames(frames), m_at(at) {}
    AnimationFrame operator*() const { return m_frames[m_at]; }
    Iterator& operator++() {
      ++m_at;
      return *this;
    }
    bool operator==(const Iterator& other) const { return m_at == other.m_at; }

   private:
    const AnimationFrames& m_frames;
    std::size_t m_at;
  };

  using Make = std::function<AnimationFrame(int number)>;
  /// Numbers `first`, `first` + `step` and so on to `last` at most.
  AnimationFrames(int first, int last, int step, Make make);

  std::size_t size() const { return m_size; }
  bool empty() const { return m_size == 0; }
  AnimationFrame operator[](std::size_t place) const;
  AnimationFrame front() const { return (*this)[0]; }
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, m_size}; }

 private:
  int m_first, m_step;
  std::size_t m_size;
  Make m_make;
};

/// At least one. An animation of one frame has its initial clock (in stock it is 0/0). The digits of views begin at 0; a
/// subset may leave none.
AnimationFrames frames_of(const AnimationOptions& options);

/// A still's: `given`: Clock= or +K was.
FrameClock still_clock(double clock, bool given);

/// The clock of view j of `count`: evenly from the first view's to the last one's.
double view_clock(const std::pair<double, double>& clocks, std::uint32_t view, std::uint32_t count);

}  // namespace lentray::parser
