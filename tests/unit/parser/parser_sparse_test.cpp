// A value that most of its owners leave as it is made.
#include "parser/base/sparse.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace lentray::parser {
namespace {

struct Counted {
  std::shared_ptr<int> owners = std::make_shared<int>(0);
  int number = 7;
};

TEST(UnitParserSparse, StoresNothingBeforeItIsChanged) {
  Sparse<Counted> a;
  EXPECT_FALSE(a.is_stored());
  EXPECT_EQ(a->number, 7);
  a.edit().number = 8;
  EXPECT_TRUE(a.is_stored());
  EXPECT_EQ(a->number, 8);
  EXPECT_EQ(Sparse<Counted>()->number, 7);
}

TEST(UnitParserSparse, CopiesShareUntilOneIsChanged) {
  Sparse<Counted> a(Counted{});
  Sparse<Counted> b = a;
  EXPECT_EQ(&*a, &*b);
  b.edit().number = 9;
  EXPECT_EQ(a->number, 7);
  EXPECT_EQ(b->number, 9);
  const Counted* alone = &*b;
  EXPECT_EQ(&b.edit(), alone) << "nobody else has it: no copy";
}

TEST(UnitParserSparse, TheLastOwnerFreesIt) {
  Counted value;
  const std::weak_ptr<int> owners = value.owners;
  {
    Sparse<Counted> a(std::move(value));
    Sparse<Counted> b = a, c;
    c = b;
    c = std::move(a);
    b = Sparse<Counted>();
    EXPECT_FALSE(b.is_stored());
    EXPECT_EQ(owners.use_count(), 1);
    const Sparse<Counted>& itself = c;
    c = itself;
    EXPECT_EQ(owners.use_count(), 1);
  }
  EXPECT_TRUE(owners.expired());
}

}  // namespace
}  // namespace lentray::parser
