// Every case of tests/compat/language/*.cases: the text, or the failure, of stock.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/compat/language_cases.h"

namespace lentray::test {
namespace {

std::filesystem::path case_folder() {
  return std::filesystem::path(LENTRAY_SOURCE_DIR) / "tests/compat/language";
}

std::vector<std::string> case_files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(case_folder())) {
    if (entry.path().extension() == ".cases") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class CompatCases : public ::testing::TestWithParam<std::string> {};

TEST_P(CompatCases, SameAsStock) {
  const LanguageCases cases = read_cases(case_folder() / (GetParam() + ".cases"));
  ASSERT_FALSE(cases.cases.empty());
  expect_same(cases);
}

INSTANTIATE_TEST_SUITE_P(Language, CompatCases, ::testing::ValuesIn(case_files()),
                         [](const auto& file) { return file.param; });

}  // namespace
}  // namespace lentray::test
