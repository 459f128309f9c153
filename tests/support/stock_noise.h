// Whether a picture with random numbers is as near to stock's as stock's own pictures are to each other: those
// of other block sizes and of two threads (core/image/compare.h).
#pragma once

#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {

/// The grade is noise or better. Renders stock four times.
::testing::AssertionResult within_stocks_noise(const SceneText& scene);

}  // namespace lentray::test
