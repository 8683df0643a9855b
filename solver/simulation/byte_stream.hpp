#pragma once
/// Values as bytes in the machine's own order, and back: one function template that visits the parts of a value with
/// `stream(part)` both writes and reads it, so that the two cannot differ.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "solver/results/quantity.hpp"

namespace sunder::simulation {

template <class Value>
concept PlainValue = std::is_trivially_copyable_v<Value> && !std::is_pointer_v<Value>;

class ByteWriter {
 public:
  explicit ByteWriter(std::string& bytes) : bytes_(bytes) {}

  template <PlainValue Value>
  void operator()(const Value& value) {
    std::array<char, sizeof(Value)> raw;
    std::memcpy(raw.data(), &value, sizeof(Value));
    bytes_.append(raw.data(), raw.size());
  }
  template <PlainValue Value>
  void operator()(const std::vector<Value>& values) {
    (*this)(std::uint64_t{values.size()});
    for (const Value& value : values) (*this)(value);
  }
  void operator()(const Eigen::VectorXd& values) { (*this)(std::vector<double>(values.begin(), values.end())); }
  void operator()(const results::Quantity& quantity);

  /// As many as there are, one after the other; `count` of a list that the reader makes as long.
  template <class List>
  void resize(List& list) {
    (*this)(std::uint64_t{list.size()});
  }

 private:
  std::string& bytes_;
};

/// Takes from the front what a ByteWriter has written; more than is left gives zeros, and `whole` is false.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <PlainValue Value>
  void operator()(Value& value) {
    short_of_ = short_of_ || bytes_.size() < sizeof(Value);
    if (short_of_) return;
    std::memcpy(&value, bytes_.data(), sizeof(Value));
    bytes_.remove_prefix(sizeof(Value));
  }
  template <PlainValue Value>
  void operator()(std::vector<Value>& values) {
    resize(values);
    for (Value& value : values) (*this)(value);
  }
  void operator()(Eigen::VectorXd& values) {
    std::vector<double> read;
    (*this)(read);
    values = Eigen::VectorXd::Map(read.data(), std::ssize(read));
  }
  void operator()(results::Quantity& quantity);

  template <class List>
  void resize(List& list) {
    std::uint64_t count = 0;
    (*this)(count);
    short_of_ = short_of_ || count > bytes_.size();  // each takes a byte at least
    list.resize(short_of_ ? 0 : count);
  }

  bool whole() const { return !short_of_ && bytes_.empty(); }

 private:
  std::string_view bytes_;
  bool short_of_ = false;
};

}  // namespace sunder::simulation
