#include <gtest/gtest.h>

#include <string>

#include "verification/harness/case.hpp"
#include "verification/harness/tests/temporary_case.hpp"

namespace sunder::verification {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string complaint(const std::string& text) {
  const TemporaryCases cases;
  try {
    static_cast<void>(cases.read(text));
  } catch (const CaseError& error) {
    return error.what();
  }
  return "accepted";
}

const std::string whole = plain_head + exact_two + check_two;

TEST(CaseReader, ReadsAWholeCase) {
  const TemporaryCases cases;
  const Case read =
      cases.read(plain_head +
                 "[parameters]\nshift = 0.5\n[sweep]\nerror = \"answer\"\ndefault = 1\n[sweep.keys]\n"
                 "parameters.terms = [1, 2, 4, 8]\n" +
                 exact_two + replaced(check_two, "tolerance = 1e-3", "tolerance = [1, 1e-1, 1e-2, 1e-3]") +
                 "[[negative]]\nfault = \"fake/twice\"\nchecks = [\"answer\"]\n");
  EXPECT_EQ(read.id, "demo/number");
  EXPECT_EQ(read.family, "demo");
  EXPECT_EQ(read.tier, Tier::quick);
  ASSERT_EQ(read.references.size(), 1u);
  EXPECT_EQ(read.references[0].kind, ReferenceClass::exact);
  EXPECT_EQ(read.references[0].values, std::vector<double>{2.0});
  ASSERT_EQ(read.checks.size(), 1u);
  EXPECT_EQ(read.checks[0].tolerance, (std::vector<double>{1.0, 0.1, 0.01, 0.001}));
  ASSERT_EQ(read.negatives.size(), 1u);
  EXPECT_EQ(read.negatives[0].fault, "fake/twice");
  ASSERT_EQ(settings(read).size(), 4u);
  EXPECT_EQ(settings(read)[2][0].first, "parameters.terms");
  EXPECT_EQ(settings(read)[2][0].second.number, 4.0);
  EXPECT_EQ(read.sweep->standard, 1);
}

TEST(CaseReader, MakesEveryCombinationOfAProduct) {
  const TemporaryCases cases;
  const Case read = cases.read(plain_head +
                               "[sweep]\ncombine = \"product\"\n[sweep.keys]\nparameters.a = [1, 2]\n"
                               "\"parameters.b\" = [\"x\", \"y\", \"z\"]\n" +
                               exact_two + check_two + "at = \"every\"\n");
  const auto all = settings(read);
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(all[4][0].second.text, "2");
  EXPECT_EQ(all[4][1].second.words, "y");
}

TEST(CaseReader, NamesFileLineAndKeyOfWhatIsWrong) {
  struct Row {
    const char* description;
    std::string text;
    const char* where;
    const char* what;
  };
  const std::string sweep = "[sweep.keys]\nparameters.h = [1, 0.5, 0.25]\n";
  const Row rows[] = {
      {"broken TOML", replaced(whole, "tier = \"quick\"", "tier = quick"), "demo/number.case.toml:6: TOML", ""},
      {"unknown key, nearest named", replaced(whole, "title =", "titel ="), "demo/number.case.toml",
       "title: is missing"},
      {"further key", replaced(whole, "study =", "stduy = \"x\"\nstudy ="), ":8: stduy", "did you mean \"study\"?"},
      {"no shall", replaced(whole, "shall give", "gives"), ":3: requirement", "\"shall\""},
      {"wrong tier", replaced(whole, "\"quick\"", "\"fast\""), ":6: tier", "\"quick\", \"full\", \"long\""},
      {"wrong family", replaced(whole, "family = \"demo\"", "family = \"sif\""), ":5: family", "folder"},
      {"version 0", replaced(whole, "version = 1", "version = 0"), ":1: version", "at least 1"},
      {"no class", replaced(whole, "class = \"exact\"\n", ""), ":9: reference.class", "is missing"},
      {"no source", replaced(whole, "source = \"arithmetic\"\n", ""), ":9: reference.source", "is missing"},
      {"no locator", replaced(whole, "locator = \"1 + 1\"\n", ""), ":9: reference.locator", "is missing"},
      {"no unit", replaced(whole, "unit = \"-\"\n", ""), ":9: reference.unit", "is missing"},
      {"no uncertainty", replaced(whole, "uncertainty = 0\n", ""), ":9: reference.uncertainty", "is missing"},
      {"published and certain", replaced(whole, "\"exact\"", "\"published\""), ":16: reference.uncertainty",
       "only an exact"},
      {"no basis", replaced(whole, "basis = \"round-off\"\n", ""), ":17: check.basis", "is missing"},
      {"no reason", replaced(whole, "reason = \"the study adds once\"\n", ""), ":17: check.reason", "is missing"},
      {"no tolerance", replaced(whole, "tolerance = 1e-3\n", ""), ":17: check.tolerance", "is missing"},
      {"tolerance is no number", replaced(whole, "1e-3", "nan"), ":21: check.tolerance", "finite"},
      {"unknown reference", replaced(whole, "reference = \"two\"", "reference = \"three\""), ":17: check.reference",
       "three"},
      {"own value as evidence", replaced(whole, "\"exact\"", "\"self\""), ":17: check.reference", "verifies nothing"},
      {"finer than the reference",
       replaced(replaced(whole, "\"exact\"", "\"published\""), "uncertainty = 0", "uncertainty = \"0.5 %\""),
       ":17: check.tolerance", "uncertainty"},
      {"checks nothing", plain_head + exact_two, ":1: check", "at least one check that gates"},
      {"a product without end",
       whole +
           "[sweep]\ncombine = \"product\"\nkeys = { a = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10], b = [1, 2, 3, 4, 5, 6, 7, 8, "
           "9, 10], c = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10], d = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10], e = [1, 2] }\n",
       "sweep.keys", "at most 10000 settings"},
      {"two of a name", whole + check_two, ":24: check.name", "taken"},
      {"negative of no check", whole + "[[negative]]\nfault = \"f\"\nchecks = [\"other\"]\n", ":24: negative.checks",
       "other"},
      {"scene missing", replaced(whole, "study = \"fake\"\n", ""), "scene", "is missing"},
      {"scene not there", replaced(whole, "study = \"fake\"\n", "scene = \"no.toml\"\n"), ":8: scene", "no file"},
      {"no place in the sweep", plain_head + sweep + exact_two + check_two, "check.at", "is missing"},
      {"order of three levels",
       plain_head + sweep + exact_two +
           replaced(check_two, "tolerance = 1e-3",
                    "kind = \"order\"\nover = \"parameters.h\"\nexpected = 2\nwindow = 0.1"),
       "check.over", "four levels"},
      {"lists of unequal length",
       plain_head + "[sweep.keys]\nparameters.a = [1, 2]\nparameters.b = [1]\n" + exact_two + check_two,
       ":11: sweep.keys.parameters.b", "as many values"},
      {"expiry is no date", whole + "known_limit = { reason = \"r\", expires = \"soon\" }\n",
       "check.known_limit.expires", "2027-06-30"},
  };
  for (const Row& row : rows) {
    const std::string said = complaint(row.text);
    EXPECT_NE(said.find(row.where), std::string::npos) << row.description << ": " << said;
    EXPECT_NE(said.find(row.what), std::string::npos) << row.description << ": " << said;
  }
  EXPECT_EQ(complaint(whole), "accepted");
}

TEST(CaseReader, TakesReferencesFromColumns) {
  const TemporaryCases cases;
  cases.write("reference-data/somebody-1999/table.csv", "# a note\nx,F\n0.1,1.5\n0.2,1.75\n0.3,2.5\n");
  const std::string reference =
      "[[reference]]\nname = \"two\"\nclass = \"published\"\ncsv = \"somebody-1999/table.csv\"\ncolumn = \"F\"\n"
      "unit = \"-\"\nsource = \"somebody-1999\"\nlocator = \"Table 1\"\nuncertainty = \"0.01 %\"\n";
  EXPECT_EQ(cases.read(plain_head + reference + check_two).references[0].values, (std::vector<double>{1.5, 1.75, 2.5}));
  EXPECT_EQ(cases.read(plain_head + reference + "rows = [2, 0]\n" + check_two).references[0].values,
            (std::vector<double>{2.5, 1.5}));
  const Case curve = cases.read(plain_head + reference + "abscissa = \"x\"\n" + check_two + "abscissa = \"a\"\n");
  EXPECT_EQ(curve.references[0].abscissae, (std::vector<double>{0.1, 0.2, 0.3}));
  EXPECT_THROW(static_cast<void>(cases.read(plain_head + replaced(reference, "\"F\"", "\"G\"") + check_two)),
               CaseError);
  cases.write("reference-data/somebody-1999/table.csv", "x,F\n0.1,1.5\n0.2\n");
  try {
    static_cast<void>(cases.read(plain_head + reference + check_two));
    FAIL() << "a short row was accepted";
  } catch (const CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("table.csv:3"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sunder::verification
