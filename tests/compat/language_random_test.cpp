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

TEST(SlowCompatRandom, SameAsStock) {
  constexpr std::uint32_t kPrograms = 20000, kBatch = 400;
  for (std::uint32_t first = 1000; first < 1000 + kPrograms; first += kBatch) {
    compare_programs(first, kBatch);
    if (HasFailure()) return;  // one batch says enough
  }
}

}  // namespace
}  // namespace lentray::test
