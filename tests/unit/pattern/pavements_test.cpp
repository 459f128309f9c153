// Pavements: how many there are, height, numbers beyond. Their values are compared with stock by
// tests/image/pavements_test.cpp.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "core/pattern/pavement.h"

namespace lentray::core {
namespace {

TEST(UnitPavements, AreAsManyAsThereArePolyforms) {
  const int polyiamonds[] = {1, 1, 1, 3, 4, 12}, polyominoes[] = {1, 1, 2, 5, 12, 35};
  const int polyhexes[] = {1, 1, 3, 7, 22, 0};
  for (int tiles = 1; tiles <= 6; ++tiles) {
    EXPECT_EQ(pavement_patterns(3, tiles), polyiamonds[tiles - 1]);
    EXPECT_EQ(pavement_patterns(4, tiles), polyominoes[tiles - 1]);
    EXPECT_EQ(pavement_patterns(6, tiles), polyhexes[tiles - 1]);
  }
  EXPECT_EQ(pavement_patterns(3, 0), 0);
  EXPECT_EQ(pavement_patterns(4, 7), 0);
  EXPECT_EQ(pavement_patterns(5, 1), 0);
}

TEST(UnitPavements, RefuseWhatThereIsNot) {
  EXPECT_THROW(make_pavement({.sides = 5}), std::invalid_argument);
  EXPECT_THROW(make_pavement({.sides = 4, .tiles = 3, .pattern = 3}), std::invalid_argument);
  EXPECT_THROW(make_pavement({.pattern = 0}), std::invalid_argument);
}

TEST(UnitPavements, AreHighestOnEdgesAndDoNotMindHeight) {
  const PatternPtr dominoes = make_pavement({.sides = 4, .tiles = 2});
  EXPECT_EQ(dominoes->value({0, 0, .5}), 1.0);
  EXPECT_EQ(dominoes->value({-3, 7.5, -8.5}), 1.0);
  EXPECT_NEAR(dominoes->value({.5, 0, 1}), 0.0, 1e-12);
  EXPECT_NEAR(dominoes->value({.5, 0, -2.25}), dominoes->value({.5, 0, -.25}), 1e-12);
}

TEST(UnitPavements, AnswerToWhatIsNoNumber) {
  for (const int sides : {3, 4, 6}) {
    const PatternPtr pavement = make_pavement({.sides = sides, .tiles = 5, .pattern = 4});
    for (const double odd : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), -1e300, 1e18, -1e18}) {
      pavement->value({odd, 0, 0});
      pavement->value({0, 0, odd});
      pavement->value({odd, 0, odd});
    }
  }
}

}  // namespace
}  // namespace lentray::core
