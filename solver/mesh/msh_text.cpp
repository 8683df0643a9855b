#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <string_view>

#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/msh_content.hpp"

namespace sunder::mesh {
namespace {

/// Words of a text, one after another, with the line they stand in.
class Words {
 public:
  Words(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// The next word, empty at the end of the text; a quoted name counts as one word and loses its quotes.
  std::string_view next() {
    while (at_ < text_.size() && space(text_[at_])) skip();
    start_line_ = line_;
    if (at_ < text_.size() && text_[at_] == '"') {
      const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
      if (end == std::string_view::npos || text_[end] == '\n') fail("a name without its closing quote");
      const std::string_view word = text_.substr(at_ + 1, end - at_ - 1);
      at_ = end + 1;
      return word;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !space(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  template <class Number>
  Number number(const char* what) {
    const std::string_view word = next();
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty()) fail(std::string("the file ends where ") + what + " should stand");
    if (error != std::errc{} || end != word.data() + word.size()) {
      fail("\"" + std::string(word) + "\" stands where " + what + " should");
    }
    return value;
  }

  long count(const char* what) {
    const long value = number<long>(what);
    if (value < 0 || value > static_cast<long>(text_.size())) {
      fail(std::to_string(value) + " is no possible " + what);
    }
    return value;
  }

  void expect(std::string_view word) {
    const std::string_view found = next();
    if (found == word) return;
    fail(found.empty() ? "the file ends before " + std::string(word)
                       : "\"" + std::string(found) + "\" stands where " + std::string(word) + " should");
  }

  /// Over everything up to and with the word.
  void skip_to(std::string_view word) {
    for (;;) {
      const std::string_view found = next();
      if (found == word) return;
      if (found.empty() && at_ >= text_.size()) fail("the file ends before " + std::string(word));
    }
  }

  long line() const { return start_line_; }

  [[noreturn]] void fail(const std::string& words) const {
    throw MeshError(name_ + ":" + std::to_string(start_line_) + ": " + words);
  }

 private:
  static bool space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
  void skip() {
    if (text_[at_++] == '\n') ++line_;
  }

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0;
  long line_ = 1, start_line_ = 1;
};

constexpr const char* accepted = "a gmsh file of version 2.2 or 4.1 is accepted";

class Parser {
 public:
  Parser(const std::string& text, const std::string& name) : words_(text, name) {}

  MshContent parse() {
    if (std::string_view first = words_.next(); first.empty()) {
      words_.fail(std::string("the file is empty; ") + accepted);
    } else if (first != "$MeshFormat") {
      words_.fail("the file starts with \"" + std::string(first.substr(0, 40)) + "\", not with $MeshFormat; " +
                  accepted);
    }
    version();
    for (std::string_view section = words_.next(); !section.empty(); section = words_.next()) {
      if (section == "$PhysicalNames") {
        physical_names();
      } else if (section == "$Entities") {
        entities();
      } else if (section == "$Nodes") {
        new_format_ ? nodes_4() : nodes_2();
      } else if (section == "$Elements") {
        if (content_.nodes.empty()) words_.fail("$Elements stands before $Nodes");
        new_format_ ? elements_4() : elements_2();
      } else if (section.front() == '$') {
        words_.skip_to("$End" + std::string(section.substr(1)));
      } else {
        words_.fail("\"" + std::string(section.substr(0, 40)) + "\" stands between two sections");
      }
    }
    if (content_.nodes.empty()) words_.fail("the file ends without $Nodes");
    if (content_.cells.empty()) words_.fail("the file has no triangles or quadrilaterals");
    return std::move(content_);
  }

 private:
  void version() {
    const std::string version(words_.next());
    if (version != "2.2" && version != "4.1") words_.fail("version \"" + version + "\"; " + accepted);
    new_format_ = version == "4.1";
    words_.expect("0");  // text; binary files never come here
    words_.number<int>("the size of a number");
    words_.expect("$EndMeshFormat");
  }

  void physical_names() {
    const long count = words_.count("number of physical names");
    for (long i = 0; i < count; ++i) {
      const int dimension = words_.number<int>("a dimension"), tag = words_.number<int>("a physical number");
      const std::string name(words_.next());
      if (dimension == 1) curve_names_[tag] = name;
    }
    words_.expect("$EndPhysicalNames");
  }

  /// Of a physical curve; its sign is the sense in which it is run along.
  int physical_number() {
    const int number = words_.number<int>("a physical number");
    if (number == std::numeric_limits<int>::min()) words_.fail(std::to_string(number) + " is no physical number");
    return std::abs(number);
  }

  std::string curve_name(int physical) const {
    const auto at = curve_names_.find(physical);
    return at == curve_names_.end() ? std::to_string(physical) : at->second;
  }

  void entities() {
    std::array<long, 4> counts{};
    for (long& count : counts) count = words_.count("number of entities");
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (long i = 0; i < counts[dimension]; ++i) {
        const int tag = words_.number<int>("an entity's number");
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) words_.number<double>("a coordinate");
        const long physicals = words_.count("number of physical groups");
        for (long k = 0; k < physicals; ++k) {
          const int physical = physical_number();
          if (dimension == 1) physicals_of_curve_[tag].push_back(physical);
        }
        if (dimension == 0) continue;
        const long bounds = words_.count("number of bounding entities");
        for (long k = 0; k < bounds; ++k) words_.number<int>("an entity's number");
      }
    }
    words_.expect("$EndEntities");
  }

  void coordinates(MshContent::Node& node) {
    for (double* x : {&node.x, &node.y, &node.z}) {
      *x = words_.number<double>("a coordinate");
      if (!std::isfinite(*x)) words_.fail("node " + std::to_string(node.tag) + " has a coordinate that is not finite");
    }
  }

  void nodes_2() {
    const long count = words_.count("number of nodes");
    for (long i = 0; i < count; ++i) {
      MshContent::Node node{.tag = words_.number<long>("a node's number")};
      coordinates(node);
      content_.nodes.push_back(node);
    }
    words_.expect("$EndNodes");
  }

  void nodes_4() {
    const long blocks = words_.count("number of blocks");
    words_.count("number of nodes");
    words_.number<long>("a node's number");
    words_.number<long>("a node's number");
    for (long b = 0; b < blocks; ++b) {
      const int dimension = words_.number<int>("a dimension");
      words_.number<int>("an entity's number");
      const int parametric = words_.number<int>("0 or 1");
      const long count = words_.count("number of nodes");
      const std::size_t first = content_.nodes.size();
      for (long i = 0; i < count; ++i) content_.nodes.push_back({.tag = words_.number<long>("a node's number")});
      for (long i = 0; i < count; ++i) {
        coordinates(content_.nodes[first + i]);
        for (int k = 0; parametric != 0 && k < dimension; ++k) words_.number<double>("a parameter");
      }
    }
    words_.expect("$EndNodes");
  }

  void element(int type, const std::vector<std::string>& names) {
    const long line = words_.line();
    const auto node = [&] { return words_.number<long>("a node's number"); };
    switch (type) {
      case 1: {
        const std::array<long, 2> ends{node(), node()};
        for (const std::string& name : names) content_.lines.push_back({ends, name, line});
        break;
      }
      case 2:
        content_.cells.push_back({{node(), node(), node(), 0}, 3, line});
        break;
      case 3:
        content_.cells.push_back({{node(), node(), node(), node()}, 4, line});
        break;
      case 15:
        node();
        break;
      default:
        words_.fail("element type " + std::to_string(type) +
                    "; lines (1), triangles (2), quadrilaterals (3) of first order and points (15) are accepted");
    }
  }

  void elements_2() {
    const long count = words_.count("number of elements");
    for (long i = 0; i < count; ++i) {
      words_.number<long>("an element's number");
      const int type = words_.number<int>("an element's type");
      const long tags = words_.count("number of tags");
      std::vector<std::string> names;
      for (long k = 0; k < tags; ++k) {
        const int tag = k == 0 ? physical_number() : words_.number<int>("a tag");
        if (k == 0 && tag != 0 && type == 1) names = {curve_name(tag)};
      }
      element(type, names);
    }
    words_.expect("$EndElements");
  }

  void elements_4() {
    const long blocks = words_.count("number of blocks");
    words_.count("number of elements");
    words_.number<long>("an element's number");
    words_.number<long>("an element's number");
    for (long b = 0; b < blocks; ++b) {
      const int dimension = words_.number<int>("a dimension"), entity = words_.number<int>("an entity's number");
      const int type = words_.number<int>("an element's type");
      const long count = words_.count("number of elements");
      std::vector<std::string> names;
      if (dimension == 1) {
        for (const int physical : physicals_of_curve_[entity]) names.push_back(curve_name(physical));
      }
      for (long i = 0; i < count; ++i) {
        words_.number<long>("an element's number");
        element(type, names);
      }
    }
    words_.expect("$EndElements");
  }

  Words words_;
  MshContent content_;
  bool new_format_ = false;
  std::map<int, std::string> curve_names_;
  std::map<int, std::vector<int>> physicals_of_curve_;
};

}  // namespace

MshContent parse_msh(const std::string& text, const std::string& name) {
  return Parser(text, name).parse();
}

bool binary_msh(const std::string& text) {
  const std::string_view head = std::string_view(text).substr(0, 64);
  const std::size_t format = head.find("$MeshFormat");
  if (format == std::string_view::npos) return false;
  Words words(head.substr(format), "");
  words.next();
  words.next();
  return words.next() == "1";
}

}  // namespace sunder::mesh
