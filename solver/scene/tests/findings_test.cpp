#include "solver/scene/findings.hpp"

#include <gtest/gtest.h>

namespace sunder::scene {
namespace {

struct Distance {
  const char *a, *b;
  int edits;
};

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  const Distance cases[] = {
      {"", "", 0},          {"", "abc", 3},      {"size", "size", 0},   {"size", "siez", 1},
      {"size", "sizes", 1}, {"size", "siz", 1},  {"size", "side", 1},   {"kitten", "sitting", 3},
      {"ab", "ba", 1},      {"abcd", "badc", 2}, {"order", "ordre", 1}, {"density", "desnity", 1},
      {"a", "b", 1},        {"level", "lvl", 2},
  };
  for (const Distance& one : cases) {
    EXPECT_EQ(edit_distance(one.a, one.b), one.edits) << one.a << " " << one.b;
    EXPECT_EQ(edit_distance(one.b, one.a), one.edits) << one.b << " " << one.a;
  }
}

TEST(Nearest, SuggestsANearWordAndNoFarOne) {
  const std::vector<std::string> words = {"size", "order", "tip_order", "max_polygons", "poisson_ratio"};
  EXPECT_EQ(nearest("siez", words), "size");
  EXPECT_EQ(nearest("Size", words), "size");
  EXPECT_EQ(nearest("max_polygon", words), "max_polygons");
  EXPECT_EQ(nearest("poison_ration", words), "poisson_ratio");
  EXPECT_EQ(nearest("tiporder", words), "tip_order");
  EXPECT_EQ(nearest("side_length", words), "");
  EXPECT_EQ(nearest("x", words), "");
  EXPECT_EQ(nearest("", words), "");
  EXPECT_EQ(nearest("size", {}), "");
}

TEST(Findings, ThrowOnlyWhereThereAreAny) {
  Findings findings("dam.toml", {});
  EXPECT_NO_THROW(findings.throw_if_any());
  findings.add({3, 1}, "b", "second");
  findings.add({2, 7}, "a", "first");
  findings.add({}, "", "without a place");
  try {
    findings.throw_if_any();
    FAIL() << "findings were swallowed";
  } catch (const SceneError& error) {
    EXPECT_STREQ(error.what(), "dam.toml: without a place\ndam.toml:2:7: a: first\ndam.toml:3:1: b: second");
  }
}

}  // namespace
}  // namespace sunder::scene
