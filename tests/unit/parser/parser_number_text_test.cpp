// str() and #write print as the C library does: the same text for every number tried.
#include "parser/values/number_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace lentray::test {
namespace {

std::string printed(const char* format, int width, int digits, double x) {
  char text[512];
  std::snprintf(text, sizeof text, format, width, digits, x);
  return text;
}

// Whole numbers, halves and neighbours of what is rounded, and numbers of every size.
std::vector<double> numbers() {
  std::vector<double> all{0.0,
                          -0.0,
                          0.5,
                          1.5,
                          2.5,
                          -0.5,
                          0.125,
                          0.375,
                          99999.95,
                          999999.5,
                          999999.4999999,
                          0.0001,
                          0.00009999995,
                          1e-5,
                          1e15,
                          4503599627370496.5,
                          9007199254740993.0,
                          1e22,
                          1e300,
                          5e-324,
                          std::numeric_limits<double>::infinity(),
                          -std::numeric_limits<double>::infinity()};
  std::mt19937_64 random(20261122);
  for (int i = 0; i < 20000; ++i) {
    const double whole = static_cast<double>(random() % 2000001) - 1000000.0;
    const double power = std::pow(10.0, static_cast<double>(random() % 9));
    all.push_back(whole / power);
    all.push_back(std::nextafter(whole / power, 1e9));
    all.push_back((whole + 0.5) / power);
    all.push_back(whole / 1024.0);
    const double any = std::bit_cast<double>(random());
    if (std::isfinite(any)) all.push_back(any);
  }
  return all;
}

TEST(UnitParserNumberText, FixedIsAsPrintf) {
  for (const double x : numbers()) {
    if (std::isfinite(x) && std::fabs(x) > 1e100) continue;  // beyond stock's buffer
    for (const int digits : {0, 1, 2, 4, 6, 9, 12}) {
      std::string text = "|";
      parser::append_fixed(text, {0, digits, false}, x);
      ASSERT_EQ(text, "|" + printed("%*.*f", 0, digits, x)) << digits;
    }
    std::string spaces, zeros;
    parser::append_fixed(spaces, {14, 3, false}, x);
    parser::append_fixed(zeros, {14, 3, true}, x);
    ASSERT_EQ(spaces, printed("%*.*f", 14, 3, x));
    ASSERT_EQ(zeros, printed("%0*.*f", 14, 3, x));
  }
}

TEST(UnitParserNumberText, GeneralIsAsPrintf) {
  for (const double x : numbers()) {
    std::string text;
    parser::append_general(text, x);
    ASSERT_EQ(text, printed("%*.*g", 0, 6, x));
  }
}

}  // namespace
}  // namespace lentray::test
