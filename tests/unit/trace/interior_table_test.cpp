// The numbers of stacks of interiors, beside lists that are kept as they are.
#include "core/trace/interior_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "core/trace/refraction.h"

namespace lentray::core::test {
namespace {

/// Key and hollow of each entry, outermost first.
using InteriorList = std::vector<std::pair<std::uintptr_t, bool>>;

InteriorList list_of(const InteriorTable& table, InteriorsId id) {
  InteriorList list;
  for (; id != InteriorsId::kOpen; id = table.around(id)) {
    list.emplace_back(table.back(id).key, table.back(id).hollow);
  }
  std::reverse(list.begin(), list.end());
  return list;
}

TEST(UnitInteriorTable, EqualStacksHaveEqualNumbers) {
  InteriorTable table;
  std::mt19937 random(5);
  std::map<InteriorList, InteriorsId> known{{{}, InteriorsId::kOpen}};
  InteriorsId id = InteriorsId::kOpen;
  InteriorList list;
  for (int step = 0; step < 40000; ++step) {
    const std::uintptr_t key = 2 * (random() % 5) + 1;
    if (random() % 9 == 0) {
      id = InteriorsId::kOpen;
      list.clear();
    } else if (random() % 2 == 0) {
      const bool hollow = random() % 2 == 0;
      id = table.push(id, {key, nullptr, hollow});
      list.emplace_back(key, hollow);
    } else {
      const InteriorsId left = table.remove(id, key);
      const auto outermost = std::find_if(list.begin(), list.end(),
                                          [&](const auto& entry) { return entry.first == key; });
      ASSERT_EQ(left == id, outermost == list.end());
      ASSERT_EQ(table.contains(id, key), outermost != list.end());
      if (outermost != list.end()) list.erase(outermost);
      id = left;
    }
    ASSERT_EQ(list_of(table, id), list);
    ASSERT_EQ(table.size(id), list.size());
    ASSERT_EQ(table.is_hollow(id), std::all_of(list.begin(), list.end(),
                                               [](const auto& entry) { return entry.second; }));
    ASSERT_EQ(known.emplace(list, id).first->second, id);
  }
  EXPECT_GT(known.size(), 1000u);
}

TEST(UnitInteriorTable, ForgetsOnlyWhatIsLarge) {
  InteriorTable table;
  const InteriorsId one = table.push(InteriorsId::kOpen, {1, nullptr, true});
  EXPECT_FALSE(table.forget_if_large());
  EXPECT_TRUE(table.contains(one, 1));
  for (std::uintptr_t key = 3; key < 400000; key += 2) table.push(one, {key, nullptr, true});
  EXPECT_TRUE(table.forget_if_large());
  EXPECT_FALSE(table.forget_if_large());
  EXPECT_EQ(table.push(InteriorsId::kOpen, {9, nullptr, false}), one) << "numbers begin anew";
  EXPECT_FALSE(table.is_hollow(one));
}

/// Any number of solids in each other: each is left as what it was entered as.
TEST(UnitInteriorTable, NestsAHundredDeep) {
  InteriorTable table;
  std::vector<Interior> glass(100);
  for (std::size_t i = 0; i < glass.size(); ++i) glass[i].ior = 1.0 + 0.01 * static_cast<double>(i);
  const auto entry = [&](std::size_t i) { return InteriorEntry{2 * (i + 1), &glass[i], true}; };
  InteriorsId inside = InteriorsId::kOpen;
  std::vector<double> bends;
  for (std::size_t i = 0; i < glass.size(); ++i) {
    bends.push_back(enter(entry(i), 1.0, table, inside).ior);
  }
  EXPECT_EQ(table.size(inside), 100u);
  for (std::size_t i = glass.size(); i-- > 0;) {
    EXPECT_DOUBLE_EQ(enter(entry(i), 1.0, table, inside).ior * bends[i], 1.0) << i;
  }
  EXPECT_EQ(inside, InteriorsId::kOpen);
}

}  // namespace
}  // namespace lentray::core::test
