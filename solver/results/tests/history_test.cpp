#include "solver/results/history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace sunder::results {
namespace {

TEST(History, HasOneHeaderRowWithNamesAndUnits) {
  History history({{"time", "s"}, {"crest_displacement", "m"}, {"steps", "-"}});
  history.add_row(std::vector{0.0, 0.0, 1.0});
  history.add_row(std::vector{0.01, -1.5e-3, 2.0});
  EXPECT_EQ(to_csv(history), "time [s],crest_displacement [m],steps [-]\n0,0,1\n0.01,-0.0015,2\n");
}

TEST(History, QuotesNamesWithCommasAndQuotes) {
  EXPECT_EQ(to_csv(History(std::vector<Column>{{"force, \"net\"", "N"}})), "\"force, \"\"net\"\" [N]\"\n");
}

TEST(History, GivesDoublesBackExactly) {
  History history(std::vector<Column>{{"a", "-"}});
  const double values[] = {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308};
  for (double value : values) history.add_row({&value, 1});
  const std::string text = to_csv(history);
  std::size_t at = text.find('\n') + 1;
  for (double value : values) {
    EXPECT_EQ(std::strtod(text.c_str() + at, nullptr), value);
    at = text.find('\n', at) + 1;
  }
}

TEST(History, LeavesACellEmptyWhereTheNumberIsNotFiniteAndNamesIt) {
  History history({{"time", "s"}, {"force", "N"}});
  history.add_row(std::vector{0.0, 1.0});
  history.add_row(std::vector{1.0, std::nan("")});
  history.add_row(std::vector{2.0, std::numeric_limits<double>::infinity()});
  EXPECT_EQ(to_csv(history), "time [s],force [N]\n0,1\n1,\n2,\n");
  EXPECT_EQ(not_finite(history), std::vector<std::string>{"force (row 2)"});
}

TEST(History, RefusesARowOfAnotherLength) {
  History history({{"time", "s"}, {"force", "N"}});
  EXPECT_THROW(history.add_row(std::vector{1.0}), std::invalid_argument);
  EXPECT_EQ(history.rows(), 0u);
}

}  // namespace
}  // namespace sunder::results
