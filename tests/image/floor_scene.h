// Objects above a chequered floor under two lights that cast shadows, compared with stock.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/support/render.h"

namespace lentray::test {

inline testing::AssertionResult same_on_the_floor(const std::string& objects) {
  return same_as_stock({.sdl = "#version 3.7; global_settings { assumed_gamma 1 }\n"
                               "camera { location <0,1.5,-4> angle 42 look_at 0 }\n"
                               "light_source { <-4,7,-6>, .8 } light_source { <4,7,-6>, .3 }\n"
                               "plane { y, -1.6 pigment { checker rgb .9 rgb .5 } }\n" +
                               objects,
                        .width = 100,
                        .height = 75,
                        .arguments = {},
                        .files = {}});
}

}  // namespace lentray::test
