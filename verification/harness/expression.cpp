#include "verification/harness/expression.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "verification/harness/exact_functions.hpp"

namespace sunder::verification {
namespace {

using Reduction = double (*)(const Values&);

Reduction find_reduction(std::string_view name) {
  if (name == "largest") return [](const Values& v) { return *std::max_element(v.begin(), v.end()); };
  if (name == "smallest") return [](const Values& v) { return *std::min_element(v.begin(), v.end()); };
  if (name == "sum") return [](const Values& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  if (name == "mean")
    return [](const Values& v) { return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size()); };
  if (name == "rms")
    return [](const Values& v) {
      return std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0) / static_cast<double>(v.size()));
    };
  if (name == "span")
    return
        [](const Values& v) { return *std::max_element(v.begin(), v.end()) - *std::min_element(v.begin(), v.end()); };
  return nullptr;
}

class Parser {
 public:
  Parser(std::string_view text, const Lookup& lookup) : text_(text), lookup_(lookup) {}

  Values whole() {
    Values result = sum();
    skip_blanks();
    if (position_ != text_.size()) fail("an operator");
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& wanted) const {
    throw std::invalid_argument("\"" + std::string(text_) + "\": " + wanted + " was expected at character " +
                                std::to_string(position_ + 1));
  }
  void skip_blanks() {
    while (position_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[position_]))) ++position_;
  }
  bool take(char c) {
    skip_blanks();
    if (position_ >= text_.size() || text_[position_] != c) return false;
    ++position_;
    return true;
  }

  template <class Operation>
  Values combine(const Values& a, const Values& b, Operation operation) const {
    if (a.size() != b.size() && a.size() != 1 && b.size() != 1)
      throw std::invalid_argument("\"" + std::string(text_) + "\": lists of " + std::to_string(a.size()) + " and " +
                                  std::to_string(b.size()) + " numbers do not go together");
    if (a.empty() || b.empty()) return {};
    Values result(std::max(a.size(), b.size()));
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = operation(a[a.size() == 1 ? 0 : i], b[b.size() == 1 ? 0 : i]);
    return result;
  }

  Values sum() {
    Values result = product();
    for (;;) {
      if (take('+'))
        result = combine(result, product(), [](double a, double b) { return a + b; });
      else if (take('-'))
        result = combine(result, product(), [](double a, double b) { return a - b; });
      else
        return result;
    }
  }
  Values product() {
    Values result = signed_power();
    for (;;) {
      if (take('*'))
        result = combine(result, signed_power(), [](double a, double b) { return a * b; });
      else if (take('/'))
        result = combine(result, signed_power(), [](double a, double b) { return a / b; });
      else
        return result;
    }
  }
  Values signed_power() {
    const Depth depth(*this);
    if (take('-')) return combine({-1.0}, signed_power(), [](double a, double b) { return a * b; });
    Values base = primary();
    if (take('^')) return combine(base, signed_power(), [](double a, double b) { return std::pow(a, b); });
    return base;
  }
  Values primary() {
    if (take('(')) {
      Values result = sum();
      if (!take(')')) fail("\")\"");
      return result;
    }
    skip_blanks();
    if (position_ >= text_.size()) fail("a number or a name");
    const char c = text_[position_];
    if (std::isdigit(static_cast<unsigned char>(c)) || c == '.') return {number()};
    if (std::isalpha(static_cast<unsigned char>(c)) || c == '_') return named();
    fail("a number or a name");
  }
  double number() {
    const std::string rest(text_.substr(position_));
    char* end = nullptr;
    const double value = std::strtod(rest.c_str(), &end);
    if (end == rest.c_str()) fail("a number");
    position_ += static_cast<std::size_t>(end - rest.c_str());
    return value;
  }
  std::string name() {
    const std::size_t begin = position_;
    bool in_index = false;  // so that * inside brackets belongs to the name
    while (position_ < text_.size()) {
      const char c = text_[position_];
      if (c == '[') in_index = true;
      if (!(std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '[' || c == ']' || in_index))
        break;
      if (c == ']') in_index = false;
      ++position_;
    }
    return std::string(text_.substr(begin, position_ - begin));
  }
  Values named() {
    const std::string called = name();
    if (!take('(')) return called == "pi" ? Values{std::numbers::pi} : lookup_(called);
    std::vector<Values> arguments;
    if (!take(')')) {
      do arguments.push_back(sum());
      while (take(','));
      if (!take(')')) fail("\",\" or \")\"");
    }
    return call(called, arguments);
  }
  Values call(const std::string& called, const std::vector<Values>& arguments) const {
    if (called == "count" && arguments.size() == 1) return {static_cast<double>(arguments[0].size())};
    if (const Reduction reduction = find_reduction(called); reduction && arguments.size() == 1)
      return arguments[0].empty() ? Values{} : Values{reduction(arguments[0])};
    const NumberFunction* function = find_number_function(called, arguments.size());
    if (!function)
      throw std::invalid_argument("\"" + std::string(text_) + "\": there is no function " + called + " of " +
                                  std::to_string(arguments.size()) + " arguments");
    std::size_t length = arguments.empty() ? 1 : 0;
    for (const Values& argument : arguments) length = std::max(length, argument.size());
    Values result(length);
    std::vector<double> at(arguments.size());
    for (std::size_t i = 0; i < length; ++i) {
      for (std::size_t k = 0; k < at.size(); ++k) {
        if (arguments[k].size() != length && arguments[k].size() != 1)
          throw std::invalid_argument("\"" + std::string(text_) + "\": " + called + " got lists of unequal length");
        at[k] = arguments[k][arguments[k].size() == 1 ? 0 : i];
      }
      result[i] = function->call(at);
    }
    return result;
  }

  /// Every bracket, sign and exponent comes by here; the stack of the program has an end.
  class Depth {
   public:
    explicit Depth(Parser& parser) : depth_(parser.depth_) {
      if (++depth_ > 200) parser.fail("a formula of less than 200 levels");
    }
    ~Depth() { --depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

   private:
    int& depth_;
  };

  std::string_view text_;
  const Lookup& lookup_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

void append_numbers(const results::Quantity& quantity, Values& values) {
  if (const double* number = quantity.number()) {
    values.push_back(*number);
  } else if (const auto* list = quantity.list()) {
    for (const auto& entry : *list) append_numbers(entry, values);
  } else {
    throw std::invalid_argument("not a number");
  }
}

std::string names_of(const results::Quantity::Table& table) {
  std::string names;
  for (const auto& [name, value] : table) names += (names.empty() ? "" : ", ") + name;
  return names.empty() ? "nothing" : names;
}

/// Follows what is left of the path below `quantity`.
void follow(const results::Quantity& quantity, std::string_view whole, std::string_view rest, Values& values) {
  const auto fail = [&](const std::string& why) {
    throw std::invalid_argument("quantity " + std::string(whole) + ": " + why);
  };
  if (!rest.empty() && rest.front() == '.') rest.remove_prefix(1);
  if (rest.empty()) {
    try {
      append_numbers(quantity, values);
    } catch (const std::invalid_argument&) {
      fail("it is not a number or a list of numbers");
    }
    return;
  }
  if (rest.front() == '[') {
    const std::size_t close = rest.find(']');
    const auto* list = quantity.list();
    if (close == std::string_view::npos) fail("\"]\" is missing");
    if (!list) fail("there is no list at \"" + std::string(rest) + "\"");
    const std::string index(rest.substr(1, close - 1));
    const std::string_view after = rest.substr(close + 1);
    if (index == "*") {
      for (const auto& entry : *list) follow(entry, whole, after, values);
      return;
    }
    char* end = nullptr;
    const long i = std::strtol(index.c_str(), &end, 10);
    if (index.empty() || *end != '\0') fail("\"" + index + "\" is no index");
    if (i < 0 || i >= static_cast<long>(list->size()))
      fail("index " + index + " is outside a list of " + std::to_string(list->size()));
    follow((*list)[static_cast<std::size_t>(i)], whole, after, values);
    return;
  }
  const std::string_view name = rest.substr(0, rest.find_first_of(".["));
  const auto* table = quantity.table();
  if (!table) fail("there is no table that could hold \"" + std::string(name) + "\"");
  for (const auto& [key, value] : *table)
    if (key == name) {
      follow(value, whole, rest.substr(name.size()), values);
      return;
    }
  fail("there is no \"" + std::string(name) + "\" among " + names_of(*table));
}

}  // namespace

Values evaluate(std::string_view expression, const Lookup& lookup) {
  return Parser(expression, lookup).whole();
}

Values select(const results::Quantity& quantities, std::string_view path) {
  Values values;
  follow(quantities, path, path, values);
  return values;
}

}  // namespace sunder::verification
