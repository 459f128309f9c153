#include "parser/options/animation.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lentray::parser {
namespace {

/// "frame:clock ..." of six digits, then the first frame's digits.
std::string listed(const AnimationOptions& options) {
  std::string out;
  const AnimationFrames frames = frames_of(options);
  for (const AnimationFrame& frame : frames) {
    char text[64];
    std::snprintf(text, sizeof text, "%d:%g ", frame.clock.frame_number, frame.clock.clock);
    out += text;
  }
  return out + frames.front().digits;
}

TEST(UnitParserAnimation, WhenTheLoopRuns) {
  EXPECT_FALSE(is_animation({}));
  EXPECT_FALSE(is_animation({.initial_frame = 1, .final_frame = 1}));
  EXPECT_FALSE(is_animation({.initial_clock = 1.0, .final_clock = 2.0}));
  EXPECT_TRUE(is_animation({.final_frame = 1}));
  EXPECT_TRUE(is_animation({.initial_frame = 5}));
  EXPECT_TRUE(is_animation({.initial_frame = 0, .final_frame = 3}));
}

/// Each is made when it is asked for.
TEST(UnitParserAnimation, TwoThousandMillionFramesTakeNoRoom) {
  const AnimationFrames frames = frames_of({.final_frame = 2'000'000'000});
  EXPECT_EQ(frames.size(), 2'000'000'000u);
  EXPECT_EQ(frames.front().digits, "0000000001");
  EXPECT_EQ(frames[1'999'999'999].clock.frame_number, 2'000'000'000);
  EXPECT_EQ(frames[1'999'999'999].clock.clock, 1.0);
  EXPECT_EQ(frames_of({.final_frame = 2'000'000'000, .step = 1'500'000'000}).size(), 2u);
}

TEST(UnitParserAnimation, ClocksOfFrames) {
  EXPECT_EQ(listed({.final_frame = 3}), "1:0 2:0.5 3:1 1");
  EXPECT_EQ(listed({.initial_frame = 0, .final_frame = 3}), "0:0 1:0.333333 2:0.666667 3:1 0");
  EXPECT_EQ(listed({.final_frame = 4, .initial_clock = 1.0, .final_clock = 5.0}),
            "1:1 2:2.33333 3:3.66667 4:5 1");
  EXPECT_EQ(listed({.final_frame = 2, .cyclic = true}), "1:0 2:0.5 1");
  EXPECT_EQ(listed({.final_frame = 4, .step = 2}), "1:0 3:0.666667 1");
  EXPECT_EQ(listed({.initial_frame = 5}), "5:0 5");
  EXPECT_EQ(frames_of({.final_frame = 3})[1].clock.clock, 0.5);
  EXPECT_EQ(frames_of({.initial_frame = 0, .final_frame = 3})[1].clock.clock,
            static_cast<double>(1.0f / 3.0f));
}

TEST(UnitParserAnimation, Subsets) {
  EXPECT_EQ(listed({.final_frame = 12, .subset_start = 3.0, .subset_end = 0.5, .cyclic = true}),
            "3:0.166667 4:0.25 5:0.333333 6:0.416667 03");
  EXPECT_EQ(listed({.final_frame = 4, .subset_start = 0.5, .subset_end = 0.75}),
            "2:0.333333 3:0.666667 2");
  EXPECT_EQ(listed({.final_frame = 10, .subset_start = 9.0}), "9:0.888889 10:1 09");
  EXPECT_EQ(listed({.final_frame = 3, .subset_start = 5.0}), "5:2 5");
}

TEST(UnitParserAnimation, ConstantsAreTextsOfSixDigits) {
  const FrameClock clock = frames_of({.final_frame = 12, .cyclic = true})[2].clock;
  EXPECT_EQ(clock.clock_delta, 0.0833333);
  EXPECT_EQ(clock.final_frame, 13);
  EXPECT_EQ(clock.final_clock, 1.0);
  EXPECT_TRUE(clock.clock_on);
  EXPECT_EQ(still_clock(0.1, true).clock, static_cast<double>(0.1f));
  EXPECT_TRUE(still_clock(0.0, true).clock_on);
  EXPECT_FALSE(still_clock(0.0, false).clock_on);
  EXPECT_EQ(still_clock(0.5, true).frame_number, 0);
}

}  // namespace
}  // namespace lentray::parser
