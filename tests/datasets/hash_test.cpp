#include "datasets/hash.h"

#include <gtest/gtest.h>

namespace datasets {
namespace {

TEST(Hash, KnowsWhereWordsEnd) {
  EXPECT_NE(hash({"ab", "c"}), hash({"a", "bc"}));
  EXPECT_NE(hash({"a", ""}), hash({"a"}));
  EXPECT_EQ(hash({"a", "b"}), hash({"a", "b"}));
}

// The published test vectors of FNV-1a.
TEST(Hash, Fnv1aIsTheOneOfItsAuthors) {
  EXPECT_EQ(hex(Fnv1a().value()), "cbf29ce484222325");
  Fnv1a fnv;
  fnv.add("foo");
  fnv.add("bar");
  EXPECT_EQ(hex(fnv.value()), "85944171f73967e8");
}

TEST(Hash, HexHasSixteenDigits) {
  EXPECT_EQ(hex(0xab), "00000000000000ab");
}

}  // namespace
}  // namespace datasets
