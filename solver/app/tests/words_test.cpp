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
}

TEST(MemoryEstimate, CountsTheCouplesOfTwoPolygonsOnce) {
  mesh::PolygonMesh squares;
  squares.vertices = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  squares.polygons = {{.vertices = {0, 1, 4, 5}, .scaling_centre = {0.5, 0.5}},
                      {.vertices = {1, 2, 3, 4}, .scaling_centre = {1.5, 0.5}}};
  const mesh::NodalMesh nodes = mesh::place_nodes(squares, [](int, int) { return 1; });
  // 6 couples in each square, the shared edge's once: 11 blocks of 4, and 6 diagonal blocks of 3.
  EXPECT_EQ(stiffness_entries(nodes), 62);
  const mesh::NodalMesh none;
  EXPECT_EQ(stiffness_entries(none), 0);
  EXPECT_GT(memory_estimate(nodes), memory_estimate(none));
}

}  // namespace
}  // namespace sunder::app
