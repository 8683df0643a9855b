#include "solver/scene/reference.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "solver/scene/reader.hpp"
#include "solver/scene/tests/scenes.hpp"

namespace sunder::scene {
namespace {

const KeyReference& key_of(const std::string& table, const std::string& key) {
  static const std::vector<TableReference> all = reference();
  for (const TableReference& one : all)
    for (const KeyReference& known : one.keys)
      if (one.name == table && known.name == key) return known;
  throw std::out_of_range(table + "." + key);
}

TEST(Reference, IsThePageOfThisModule) {
  std::ifstream stream("solver/scene/README.md");
  const std::string page(std::istreambuf_iterator<char>(stream), {});
  std::string tables = reference_markdown();
  tables.erase(tables.find_last_not_of('\n') + 1);
  EXPECT_NE(page.find(tables), std::string::npos)
      << "solver/scene/README.md does not end with what `sunder keys --markdown` prints:\n"
      << tables;
}

TEST(Reference, HasEveryKeyOnceWithItsMeaning) {
  std::set<std::string> tables;
  for (const TableReference& table : reference()) {
    EXPECT_TRUE(tables.insert(table.name).second) << table.name << " twice";
    EXPECT_FALSE(table.keys.empty()) << table.name;
    std::set<std::string> keys;
    for (const KeyReference& key : table.keys) {
      EXPECT_TRUE(keys.insert(key.name).second) << table.name << "." << key.name << " twice";
      EXPECT_FALSE(key.meaning.empty()) << table.name << "." << key.name;
      EXPECT_FALSE(key.type.empty()) << table.name << "." << key.name;
      EXPECT_FALSE(key.default_value.empty()) << table.name << "." << key.name;
    }
  }
}

TEST(Reference, TakesDefaultsFromTheStructs) {
  EXPECT_EQ(key_of("mesh", "order").default_value, std::to_string(Mesh{}.order));
  EXPECT_EQ(key_of("mesh", "max_polygons").default_value, "2000000");
  EXPECT_EQ(key_of("mesh", "cells").default_value, "\"dual\"");
  EXPECT_EQ(key_of("mesh", "dual").default_value, "false");
  EXPECT_EQ(key_of("mesh", "size").default_value, "absent");
  EXPECT_EQ(key_of("material", "youngs_modulus").default_value, "required");
  EXPECT_EQ(key_of("gravity", "acceleration").default_value, "9.81");
  EXPECT_EQ(key_of("support", "displacement").default_value, "[0, 0]");
  EXPECT_EQ(key_of("crack", "pressure").default_value, "absent");
  EXPECT_EQ(key_of("contact", "initial_stiffness").default_value, "1e+08");
  EXPECT_EQ(key_of("reservoir", "model").default_value, "\"compressible\"");
}

TEST(Reference, SaysWhatIsAcceptedAndInWhichUnit) {
  EXPECT_EQ(key_of("mesh", "size").unit, "m");
  EXPECT_EQ(key_of("mesh", "size").accepted, "> 0");
  EXPECT_EQ(key_of("mesh", "order").accepted, "1 … 64");
  EXPECT_EQ(key_of("material", "poisson_ratio").accepted, ">= 0, < 0.5");
  EXPECT_EQ(key_of("reservoir", "reflection_coefficient").accepted, "0 … 1");
}

}  // namespace
}  // namespace sunder::scene
