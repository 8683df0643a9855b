#include "verification/harness/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace sunder::verification {
namespace {

using results::Quantity;

Quantity two_tips() {
  const Quantity left(Quantity::Table{{"K_I", 2.0}, {"position", Quantity(std::vector<double>{0.25, 0.5})}});
  const Quantity right(Quantity::Table{{"K_I", 3.0}, {"position", Quantity(std::vector<double>{0.75, 0.5})}});
  return Quantity::Table{{"tips", Quantity::List{left, right}}, {"strain_energy", 8.0}, {"status", "filled"}};
}

double value_of(const std::string& expression) {
  const Quantity quantities = two_tips();
  const Values values = evaluate(expression, [&](std::string_view name) { return select(quantities, name); });
  EXPECT_EQ(values.size(), 1u) << expression;
  return values.at(0);
}

std::string complaint(const std::string& expression) {
  try {
    value_of(expression);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Expression, FollowsTheUsualPrecedence) {
  struct Row {
    const char* expression;
    double value;
  };
  for (const Row& row :
       {Row{"1 + 2 * 3", 7.0}, Row{"-2^2", -4.0}, Row{"2^3^2", 512.0}, Row{"8 / 4 / 2", 1.0}, Row{"2^-1", 0.5},
        Row{"(1 + 2) * 3", 9.0}, Row{"1e3 - 1.5E+2", 850.0}, Row{"max(2, 3) - min(2, 3)", 1.0},
        Row{"tips[0].K_I*strain_energy", 16.0}, Row{"tips[1].position[0]", 0.75}})
    EXPECT_EQ(value_of(row.expression), row.value) << row.expression;
  EXPECT_EQ(value_of("sqrt(pi)"), std::sqrt(std::numbers::pi));
}

TEST(Expression, TakesListsNumberByNumber) {
  const Quantity quantities = two_tips();
  const Lookup lookup = [&](std::string_view name) { return select(quantities, name); };
  EXPECT_EQ(evaluate("tips[*].K_I * 10", lookup), (Values{20.0, 30.0}));
  EXPECT_EQ(evaluate("tips[*].position[*]", lookup), (Values{0.25, 0.5, 0.75, 0.5}));
  EXPECT_EQ(evaluate("span(tips[*].K_I)", lookup), Values{1.0});
  EXPECT_EQ(evaluate("count(tips[*].position)", lookup), Values{4.0});
  EXPECT_THROW(static_cast<void>(evaluate("tips[*].K_I + tips[*].position", lookup)), std::invalid_argument);
}

TEST(Expression, SaysWhatItMisses) {
  EXPECT_NE(complaint("tips[0].K_III").find("K_I, position"), std::string::npos) << complaint("tips[0].K_III");
  EXPECT_NE(complaint("tips[2].K_I").find("outside a list of 2"), std::string::npos);
  EXPECT_NE(complaint("status").find("not a number"), std::string::npos);
  EXPECT_NE(complaint("strain_energy[0]").find("no list"), std::string::npos);
  EXPECT_NE(complaint("1 + ").find("character 5"), std::string::npos);
  EXPECT_NE(complaint("sqrt(1, 2)").find("no function sqrt of 2"), std::string::npos);
  EXPECT_NE(complaint("1 2").find("operator"), std::string::npos);
}

TEST(Expression, RefusesWhatWouldExhaustTheStack) {
  for (const char* level : {"(", "-", "2^", "abs("}) {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += level;
    EXPECT_NE(complaint(text).find("less than 200 levels"), std::string::npos) << level;
  }
}

}  // namespace
}  // namespace sunder::verification
