// Numbers of JSON files that came with scenes, as whole numbers of the program.
#include "tools/common/json_fields.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <map>
#include <string>

namespace lentray::tool {
namespace {

using nlohmann::json;

template <class T>
void expect_refused(const char* text) {
  EXPECT_THROW(whole_of<T>(json::parse(text)), json::exception) << text;
}

TEST(UnitJsonFields, WholeNumbersAreThoseThatTheTypeHolds) {
  EXPECT_EQ(whole_of<int>(json::parse("-7")), -7);
  EXPECT_EQ(whole_of<std::uint32_t>(json::parse("4294967295")), 4294967295u);
  EXPECT_EQ(whole_of<std::uint32_t>(json::parse("4294967295.0")), 4294967295u);
  EXPECT_EQ(whole_of<std::uint64_t>(json::parse("18446744073709551615")),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(whole_of<std::int64_t>(json::parse("-9223372036854775808")),
            std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(whole_of<int>(json::parse("2.9")), 2);
}

TEST(UnitJsonFields, OthersAreRefused) {
  expect_refused<std::uint64_t>("1e62");
  expect_refused<std::uint64_t>("18446744073709551616");
  expect_refused<std::uint64_t>("-1");
  expect_refused<std::uint32_t>("4294967296");
  expect_refused<std::uint32_t>("-1.5");
  expect_refused<std::int64_t>("9223372036854775808");
  expect_refused<std::int64_t>("-1e30");
  expect_refused<int>("2147483648");
  expect_refused<int>("\"7\"");
  expect_refused<int>("null");
}

TEST(UnitJsonFields, MapsOfWholeNumbers) {
  using Sums = std::map<std::string, std::uint64_t>;
  EXPECT_EQ(value_of<Sums>(json::parse(R"({"a": 1, "b": 2})")), (Sums{{"a", 1}, {"b", 2}}));
  EXPECT_THROW(value_of<Sums>(json::parse(R"({"a": 1e62})")), json::exception);
}

}  // namespace
}  // namespace lentray::tool
