#pragma once
/// A running sum that keeps what rounding drops [Neumaier 1974]: its error does not grow with the number of terms.

namespace sunder::numerics {

class CompensatedSum {
 public:
  void add(double value) {
    const double total = sum_ + value;
    const double part = total - sum_;
    rest_ += (sum_ - (total - part)) + (value - part);
    sum_ = total;
  }
  double value() const { return sum_ + rest_; }

 private:
  double sum_ = 0.0, rest_ = 0.0;
};

}  // namespace sunder::numerics
