#include "solver/scene/values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::scene {
namespace {

template <class Integer>
void read_whole(const Node& node, Integer& out, const Reading& reading) {
  const bool fits = node.kind == Node::Kind::integer && node.integer >= std::numeric_limits<Integer>::min() &&
                    node.integer <= std::numeric_limits<Integer>::max();
  if (!fits || !reading.facts.range.holds(node.number)) return reading.wrong(node, "a whole number");
  out = static_cast<Integer>(node.integer);
}

}  // namespace

std::string accepted_text(const std::string& what, const KeyFacts& facts) {
  const std::string range = text_of(facts.range);
  return what + (range.empty() ? "" : " " + range) + (facts.unit.empty() ? "" : " [" + facts.unit + "]") + " (" +
         facts.meaning + ")";
}

std::string text_of(const Range& range) {
  const bool low = std::isfinite(range.low), high = std::isfinite(range.high);
  if (low && high && !range.low_open && !range.high_open) return shown(range.low) + " … " + shown(range.high);
  std::string text;
  if (low) text += (range.low_open ? "> " : ">= ") + shown(range.low);
  if (high) text += std::string(low ? ", " : "") + (range.high_open ? "< " : "<= ") + shown(range.high);
  return text;
}

void Reading::wrong(const Node& node, const std::string& accepted) const {
  const bool number = node.kind == Node::Kind::number || node.kind == Node::Kind::integer;
  const bool wants_number = accepted.find("number") != std::string::npos && accepted.find("list") == std::string::npos;
  std::string what = shown(node);
  if (number && wants_number)
    what += std::isfinite(node.number) ? " is not accepted" : " is not a finite number";
  else if (node.kind == Node::Kind::list)
    what += " is a list of " + std::to_string(node.list.size());
  else if (node.kind == Node::Kind::date || node.kind == Node::Kind::table)
    what = "is " + what;
  else
    what += " is " + std::string(kind_name(node.kind));
  findings.add(node.origin, path, what + "; accepted: " + accepted_text(accepted, facts));
}

void read_value(const Node& node, double& out, const Reading& reading) {
  const bool number = node.kind == Node::Kind::number || node.kind == Node::Kind::integer;
  const Range& range = reading.facts.range;
  if (number && !range.holds(node.number) && numerics::planted_fault("scene/number-moved-into-its-range")) {
    constexpr double inside = std::numeric_limits<double>::min();
    out = std::clamp(node.number, range.low + (range.low_open ? inside : 0.0), range.high);
    return;
  }
  if (!number || !std::isfinite(node.number) || !range.holds(node.number)) return reading.wrong(node, "a number");
  out = reading.findings.filtered(node.number);
}

void read_value(const Node& node, int& out, const Reading& reading) {
  read_whole(node, out, reading);
}
void read_value(const Node& node, long& out, const Reading& reading) {
  read_whole(node, out, reading);
}

void read_value(const Node& node, bool& out, const Reading& reading) {
  if (node.kind != Node::Kind::boolean) return reading.wrong(node, "true or false");
  out = node.boolean;
}

void read_value(const Node& node, std::string& out, const Reading& reading) {
  if (node.kind != Node::Kind::text) return reading.wrong(node, "a text in quotes");
  if (node.text.empty()) return reading.complain(node, "the text is empty");
  out = node.text;
}

void read_value(const Node& node, std::filesystem::path& out, const Reading& reading) {
  std::string text;
  read_value(node, text, reading);
  out = text;
}

void read_value(const Node& node, Point& out, const Reading& reading) {
  if (node.kind != Node::Kind::list || node.list.size() != 2) return reading.wrong(node, "a point [x, y]");
  for (int i = 0; i < 2; ++i) read_value(node.list[i], out[i], reading);
}

void read_value(const Node& node, std::vector<double>& out, const Reading& reading) {
  if (node.kind == Node::Kind::integer || node.kind == Node::Kind::number) {
    out.assign(1, 0.0);
    return read_value(node, out[0], reading);
  }
  if (node.kind != Node::Kind::list) return reading.wrong(node, "a number or a list of numbers");
  out.assign(node.list.size(), 0.0);
  for (std::size_t i = 0; i < out.size(); ++i) read_value(node.list[i], out[i], reading.element(i));
}

}  // namespace sunder::scene
