#include "verification/harness/case_table.hpp"

#include <algorithm>
#include <cmath>

#include "verification/harness/case.hpp"

namespace sunder::verification {
namespace {

/// How many single-letter edits lead from a to b.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

}  // namespace

void CaseTable::fail(const Node& node, std::string_view key, const std::string& message) const {
  fail_at(node.line, key, message);
}

void CaseTable::fail_here(std::string_view key, const std::string& message) const {
  fail_at(node_.line, key, message);
}

void CaseTable::fail_at(int line, std::string_view key, const std::string& message) const {
  throw CaseError(file_ + ":" + std::to_string(line) + ": " + prefix_ + std::string(key) + ": " + message);
}

const Node* CaseTable::find(std::string_view key) {
  asked_.insert(std::string(key));
  return node_.find(key);
}

const Node& CaseTable::need(std::string_view key, const std::string& accepted) {
  const Node* node = find(key);
  if (!node) fail_here(key, "is missing; " + accepted + " is needed");
  return *node;
}

std::string CaseTable::text_of(const Node& node, std::string_view key) const {
  if (node.kind != Node::Kind::text || node.text.empty()) fail(node, key, "a text that is not empty is needed");
  return node.text;
}

double CaseTable::number_of(const Node& node, std::string_view key) const {
  if (!node.is_number() || !std::isfinite(node.number)) fail(node, key, "a finite number is needed");
  return node.number;
}

std::string CaseTable::text(std::string_view key) {
  return text_of(need(key, "a text"), key);
}

std::string CaseTable::text(std::string_view key, std::string otherwise) {
  const Node* node = find(key);
  return node ? text_of(*node, key) : std::move(otherwise);
}

double CaseTable::number(std::string_view key) {
  return number_of(need(key, "a number"), key);
}

double CaseTable::number(std::string_view key, double otherwise) {
  const Node* node = find(key);
  return node ? number_of(*node, key) : otherwise;
}

double CaseTable::positive(std::string_view key) {
  const Node& node = need(key, "a number > 0");
  if (!(number_of(node, key) > 0.0)) fail(node, key, "a number > 0 is needed");
  return node.number;
}

int CaseTable::whole(std::string_view key, int otherwise, int least) {
  const Node* node = find(key);
  if (!node) return otherwise;
  if (node->kind != Node::Kind::integer || node->integer < least || node->integer > 1'000'000'000)
    fail(*node, key, "a whole number of at least " + std::to_string(least) + " is needed");
  return static_cast<int>(node->integer);
}

bool CaseTable::truth(std::string_view key, bool otherwise) {
  const Node* node = find(key);
  if (!node) return otherwise;
  if (node->kind != Node::Kind::boolean) fail(*node, key, "true or false is needed");
  return node->boolean;
}

std::vector<double> CaseTable::numbers(std::string_view key) {
  const Node& node = need(key, "a number or a list of numbers");
  std::vector<double> result;
  flatten(node, key, result);
  if (result.empty()) fail(node, key, "a list that is not empty is needed");
  return result;
}

std::vector<std::string> CaseTable::texts(std::string_view key) {
  const Node& node = need(key, "a list of texts");
  if (node.kind != Node::Kind::list) fail(node, key, "a list of texts is needed");
  std::vector<std::string> result;
  for (const Node& entry : node.list) result.push_back(text_of(entry, key));
  return result;
}

const Node* CaseTable::table(std::string_view key) {
  const Node* node = find(key);
  if (node && node->kind != Node::Kind::table) fail(*node, key, "a table is needed");
  return node;
}

const std::vector<Node>& CaseTable::tables(std::string_view key) {
  static const std::vector<Node> none;
  const Node* node = find(key);
  if (!node) return none;
  const bool all_tables = std::all_of(node->list.begin(), node->list.end(),
                                      [](const Node& entry) { return entry.kind == Node::Kind::table; });
  if (node->kind != Node::Kind::list || !all_tables) fail(*node, key, "an array of tables is needed");
  return node->list;
}

int CaseTable::index_of_word(std::string_view key, const std::vector<std::string>& words, bool may_be_absent) {
  const Node* node = find(key);
  if (!node && may_be_absent) return -1;
  std::string accepted;
  for (const std::string& choice : words) accepted += (accepted.empty() ? "\"" : ", \"") + choice + "\"";
  if (!node) fail_here(key, "is missing; one of " + accepted + " is needed");
  const std::string given = text_of(*node, key);
  const auto found = std::find(words.begin(), words.end(), given);
  if (found == words.end()) fail(*node, key, "\"" + given + "\" is not accepted; one of " + accepted + " is");
  return static_cast<int>(found - words.begin());
}

void CaseTable::flatten(const Node& node, std::string_view key, std::vector<double>& result) const {
  if (node.kind != Node::Kind::list) {
    result.push_back(number_of(node, key));
    return;
  }
  for (const Node& entry : node.list) flatten(entry, key, result);
}

void CaseTable::finish() const {
  for (const auto& [key, node] : node_.table) {
    if (asked_.count(key)) continue;
    const std::string* nearest = nullptr;
    std::size_t best = 4;  // further than three edits is another word
    for (const std::string& known : asked_)
      if (const std::size_t distance = edits(key, known); distance < best) {
        best = distance;
        nearest = &known;
      }
    fail(node, key, "is not known here" + (nearest ? "; did you mean \"" + *nearest + "\"?" : std::string()));
  }
}

}  // namespace sunder::verification
