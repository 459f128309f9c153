// Whether a picture with random numbers is as near to stock's as stock's own pictures are to each other: those
// of other block sizes and of two threads. What counts are the means of blocks of 16 x 16 pixels, in which
// noise is little and light that is wrong stays.
#pragma once

#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {

/// In 1/255 of full scale.
struct BlockDifference {
  double rms = 0.0;   ///< of the blocks' means, over all channels
  double mean = 0.0;  ///< of the whole picture, with its sign
};
BlockDifference block_difference(const StoredImage& a, const StoredImage& b);

/// At most 1.5 times stock's own rms and mean, or 0.3 and 0.2. Renders stock four times.
::testing::AssertionResult within_stocks_noise(const SceneText& scene);

}  // namespace lentray::test
