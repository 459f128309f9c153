// Random programs through stock and through us; each seed is one program, many go into one process.
#include <gtest/gtest.h>

#include "tests/compat/language_cases.h"
#include "tests/compat/language_random.h"

namespace lentray::test {
namespace {

void compare_programs(std::uint32_t first, std::uint32_t count) {
  LanguageCases cases;
  for (std::uint32_t seed = first; seed < first + count; ++seed) {
    LanguageCase c;
    c.where = "seed " + std::to_string(seed);
    c.sdl = random_program(seed, "Z" + std::to_string(seed - first) + "_");
    c.text = "\n" + c.sdl;
    cases.cases.push_back(c);
  }
  expect_same(cases);
}

TEST(CompatRandom, SameAsStock) { compare_programs(1, 300); }

// Ten parts of 2000 programs: ctest may run them side by side.
class SlowCompatRandom : public testing::TestWithParam<std::uint32_t> {};

TEST_P(SlowCompatRandom, SameAsStock) {
  constexpr std::uint32_t kPrograms = 2000, kBatch = 200;
  const std::uint32_t first = 1000 + GetParam() * kPrograms;
  int failed = 0;
  for (std::uint32_t seed = first; seed < first + kPrograms; seed += kBatch) {
    compare_programs(seed, kBatch);
    if (HasFailure() && ++failed == 3) return;  // a few batches say enough
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, SlowCompatRandom, testing::Range(0u, 10u));

}  // namespace
}  // namespace lentray::test
