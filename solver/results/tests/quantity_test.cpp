#include "solver/results/quantity.hpp"

#include <gtest/gtest.h>

namespace sunder::results {
namespace {

Quantity tips() {
  Quantity all;
  all["tips"] = Quantity::List{Quantity::Table{{"K_I", 2.5}, {"position", Quantity(std::vector<double>{1.0, 60.0})}}};
  all["status"] = "exact";
  return all;
}

TEST(Quantity, IsFoundByItsPath) {
  const Quantity all = tips();
  ASSERT_NE(all.find("tips[0].K_I"), nullptr);
  EXPECT_EQ(*all.find("tips[0].K_I")->number(), 2.5);
  EXPECT_EQ(*all.find("tips[0].position[1]")->number(), 60.0);
  EXPECT_EQ(*all.find("status")->text(), "exact");
  EXPECT_EQ(all.find(""), &all);
}

TEST(Quantity, IsNotFoundWhereThePathLeadsNowhere) {
  const Quantity all = tips();
  for (const char* path : {"tip", "tips[1]", "tips[1].K_I", "tips.K_I", "tips[0]K_I", "tips[x]", "tips[-1]", "tips[0",
                           "[0]", "status.K_I", "status[0]", "tips[0]..K_I", "tips[ 0]"})
    EXPECT_EQ(all.find(path), nullptr) << path;
}

TEST(Quantity, KeepsTheOrderOfWritingAndMakesAnEntryOnce) {
  Quantity all;
  all["z"] = 1;
  all["a"] = 2.0;
  all["z"] = 3;
  ASSERT_EQ(all.table()->size(), 2u);
  EXPECT_EQ((*all.table())[0].first, "z");
  EXPECT_EQ(*(*all.table())[0].second.number(), 3.0);
}

TEST(Quantity, RefusesAnEntryOfANumber) {
  Quantity number = 1.0;
  EXPECT_THROW(number["K_I"], std::invalid_argument);
}

}  // namespace
}  // namespace sunder::results
