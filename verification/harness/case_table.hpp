#pragma once
/// One table of a case file: hands out its entries with file, line and key in every complaint, and knows in the end
/// which of them nobody asked for. Private to the reader of cases.

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "verification/harness/case_document.hpp"

namespace sunder::verification {

class CaseTable {
 public:
  /// `node` must outlive the table; `prefix` stands before its keys in messages: "check.".
  CaseTable(const Node& node, std::string file, std::string prefix)
      : node_(node), file_(std::move(file)), prefix_(std::move(prefix)) {}

  /// Throw CaseError: at the value, at the heading of this table, at a line.
  [[noreturn]] void fail(const Node& node, std::string_view key, const std::string& message) const;
  [[noreturn]] void fail_here(std::string_view key, const std::string& message) const;
  [[noreturn]] void fail_at(int line, std::string_view key, const std::string& message) const;

  int line() const { return node_.line; }
  const std::string& file() const { return file_; }
  std::string path(std::string_view key) const { return prefix_ + std::string(key); }

  /// nullptr where the key is absent.
  const Node* find(std::string_view key);
  const Node& need(std::string_view key, const std::string& accepted);

  /// The entry as what it must be; CaseError where it is absent and has no default, or is something else.
  std::string text(std::string_view key);
  std::string text(std::string_view key, std::string otherwise);
  double number(std::string_view key);
  double number(std::string_view key, double otherwise);
  double positive(std::string_view key);
  int whole(std::string_view key, int otherwise, int least);
  bool truth(std::string_view key, bool otherwise);
  std::vector<double> numbers(std::string_view key);  ///< a number, a list, or lists of lists flattened; not empty
  std::vector<std::string> texts(std::string_view key);
  const Node* table(std::string_view key);                ///< nullptr where absent
  const std::vector<Node>& tables(std::string_view key);  ///< an array of tables; empty where absent

  /// An enumerator by its word.
  template <class Enumerator>
  Enumerator word_of(std::string_view key, std::initializer_list<Enumerator> choices,
                     std::optional<Enumerator> otherwise = {}) {
    std::vector<std::string> words;
    for (const Enumerator choice : choices) words.emplace_back(word(choice));
    const int i = index_of_word(key, words, otherwise.has_value());
    return i < 0 ? *otherwise : choices.begin()[i];
  }

  /// Rejects every key that was not asked for, naming the nearest that was.
  void finish() const;

  std::string text_of(const Node& node, std::string_view key) const;

 private:
  double number_of(const Node& node, std::string_view key) const;
  void flatten(const Node& node, std::string_view key, std::vector<double>& result) const;
  int index_of_word(std::string_view key, const std::vector<std::string>& words, bool may_be_absent);

  const Node& node_;
  std::string file_, prefix_;
  std::set<std::string, std::less<>> asked_;
};

}  // namespace sunder::verification
