// The short table and the memory estimate.
#include <gtest/gtest.h>

#include "solver/app/memory_estimate.hpp"
#include "solver/app/quantity_table.hpp"

namespace sunder::app {
namespace {

TEST(QuantityTable, PutsNamesInAColumn) {
  results::Quantity all;
  all["tips"] = results::Quantity::List{
      results::Quantity::Table{{"K_I", 1.23456789e6}, {"position", results::Quantity(std::vector<double>{1.0, 60.5})}}};
  all["status"] = "exact";
  all["pressure"] = results::Quantity(std::vector<double>{9, 8, 7, 6, 5, 4, 3, 2, 1.5});
  EXPECT_EQ(quantity_table(all),
            "  tips[0].K_I       1.23457e+06\n"
            "  tips[0].position  [1, 60.5]\n"
            "  status            exact\n"
            "  pressure          9 values, 9 … 1.5\n");
  EXPECT_EQ(quantity_table({}), "");
}

// Entries of the factor that SymmetricFactor::entries() reports for hexagonal meshes of order 1, against the fit that
// the header states to 4 %; the smallest mesh, where the law is not meant, is left out.
TEST(MemoryEstimate, FitsTheFactorsMeasured) {
  struct Measured {
    double unknowns, entries;
  };
  for (const Measured& one :
       {Measured{7200, 532618}, Measured{80000, 10008506}, Measured{320000, 49392558}, Measured{980000, 175041570}})
    EXPECT_NEAR(factor_entries(one.unknowns) / one.entries, 1.0, 0.04) << one.unknowns;
  EXPECT_GE(factor_entries(0), 0.0);
  EXPECT_GE(memory_estimate({}), 0.0);
}

}  // namespace
}  // namespace sunder::app
