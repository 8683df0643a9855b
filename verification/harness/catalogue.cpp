#include "verification/harness/catalogue.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "verification/harness/report_text.hpp"

namespace sunder::verification {
namespace {

std::string three_digits(double value) {
  return short_number(value, 3);
}

/// A cell of a Markdown table holds no bar and no line end.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|')
      result += "\\|";
    else
      result += c == '\n' ? ' ' : c;
  }
  return result;
}

std::string tolerance_text(const Check& check) {
  switch (check.kind) {
    case CheckKind::refused:
      return "refuses: \"" + check.message + "\"";
    case CheckKind::bound:
      return (check.at_least ? "≥ " + three_digits(*check.at_least) : "") +
             (check.at_least && check.at_most ? ", " : "") + (check.at_most ? "≤ " + three_digits(*check.at_most) : "");
    case CheckKind::order: {
      std::string orders;
      for (const double expected : check.expected) orders += (orders.empty() ? "" : ", ") + three_digits(expected);
      return "order " + orders + " ± " + three_digits(check.window);
    }
    case CheckKind::value:
    case CheckKind::invariant:
    case CheckKind::pin: {
      const auto [least, greatest] = std::minmax_element(check.tolerance.begin(), check.tolerance.end());
      const std::string range =
          *least == *greatest ? three_digits(*least) : three_digits(*least) + " … " + three_digits(*greatest);
      return (check.kind == CheckKind::invariant ? "invariant" : std::string(word(check.norm))) + " " + range;
    }
  }
  return "";
}

std::string source_text(const Case& verification_case, const Check& check) {
  if (const Reference* reference = find_reference(verification_case, check.reference))
    return std::string(word(reference->kind)) + ": " + reference->source + ", " + reference->locator;
  if (!check.law.empty()) return "law: " + check.law;
  if (check.kind == CheckKind::pin) return "own earlier value";
  return "specification";
}

std::string figure_text(const CaseResult& result, const std::string& name) {
  for (const CheckOutcome& check : result.checks)
    if (check.name == name) {
      if (check.kind == "order" && !check.orders.empty())
        return std::string(word(check.status)) + ", " + three_digits(check.value);
      if (check.compared == 0 || check.kind == "refused" || check.kind == "bound")
        return std::string(word(check.status));
      return std::string(word(check.status)) + ", " + three_digits(check.error);
    }
  return "";
}

}  // namespace

Evidence evidence_of(const std::vector<Case>& cases) {
  Evidence evidence;
  for (const Case& entry : cases)
    for (const Check& check : entry.checks) {
      if (!check.gates || check.kind == CheckKind::pin) continue;
      ++evidence.gating;
      if (check.kind == CheckKind::order) ++evidence.orders;
      if (check.kind == CheckKind::bound) ++evidence.bounds;
      if (check.kind == CheckKind::refused) ++evidence.refusals;
      if (!check.law.empty()) ++evidence.by_law;
      const Reference* reference = find_reference(entry, check.reference);
      if (!reference) continue;
      ++evidence.with_reference;
      if (reference->kind == ReferenceClass::exact || reference->kind == ReferenceClass::high_precision ||
          reference->kind == ReferenceClass::cross_code)
        ++evidence.independent;
    }
  return evidence;
}

std::string catalogue_page(const std::vector<Case>& cases, const std::vector<CaseResult>& results) {
  std::map<std::string, std::vector<const Case*>> families;
  std::size_t negatives = 0;
  for (const Case& entry : cases) {
    families[entry.family].push_back(&entry);
    negatives += entry.negatives.size();
  }
  const Evidence evidence = evidence_of(cases);
  std::ostringstream page;
  page << "# The verification catalogue\n\n"
          "Made by `sunder-verify catalogue --write` from the cases; a test holds all but its last column to them. How "
          "a case is\n"
          "written stands in [cases/README.md](cases/README.md).\n\n"
       << cases.size() << " cases, " << evidence.gating << " gating checks, " << negatives
       << " runs with a planted fault. Of the checks " << evidence.with_reference << " have a reference, "
       << evidence.independent << " of them (" << three_digits(std::floor(100.0 * evidence.share()))
       << " %) exact,\nhigh-precision or another code's; " << evidence.by_law << " hold a law, " << evidence.bounds
       << " a bound, " << evidence.refusals << " ask for a refusal. " << evidence.orders
       << " are orders of accuracy.\n";
  for (const auto& [family, members] : families) {
    page << "\n## " << family
         << "\n\n| case | claim | check | source | tolerance | last figure |\n|---|---|---|---|---|---|\n";
    for (const Case* member : members) {
      const auto result =
          std::find_if(results.rbegin(), results.rend(), [&](const CaseResult& r) { return r.id == member->id; });
      bool first = true;
      for (const Check& check : member->checks) {
        page << "| " << (first ? cell(member->id) : "") << " | " << (first ? cell(member->requirement) : "") << " | "
             << cell(check.name) << (check.gates ? "" : " (informs)") << " | " << cell(source_text(*member, check))
             << " | " << cell(tolerance_text(check)) << " | "
             << (result == results.rend() ? "" : cell(figure_text(*result, check.name))) << " |\n";
        first = false;
      }
    }
  }
  return page.str();
}

std::string claims_of(const std::string& page) {
  std::istringstream stream(page);
  std::string claims;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("| ") && line.ends_with(" |")) {
      line.resize(line.size() - 2);
      line.resize(line.rfind(" | ") == std::string::npos ? line.size() : line.rfind(" | "));
    }
    claims += line + "\n";
  }
  return claims;
}

}  // namespace sunder::verification
