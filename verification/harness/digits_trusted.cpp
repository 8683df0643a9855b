#include "verification/harness/digits_trusted.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder::verification {
namespace {

using results::Quantity;

/// Neither empty nor of anything but numbers.
bool numbers_only(const Quantity& quantity) {
  const Quantity::List* list = quantity.list();
  return list != nullptr && !list->empty() &&
         std::all_of(list->begin(), list->end(), [](const Quantity& entry) { return entry.number() != nullptr; });
}

double largest(const Quantity& quantity) {
  if (const double* number = quantity.number()) return std::abs(*number);
  double found = 0.0;
  for (const Quantity& entry : *quantity.list()) found = std::fmax(found, std::abs(*entry.number()));
  return found;
}

/// Enlarges `spread` by |other − plain|; false where the two have not one shape.
bool enlarge(const Quantity& plain, const Quantity& other, Quantity& spread) {
  if (const double* number = plain.number()) {
    if (other.number() == nullptr) return false;
    spread = std::fmax(*spread.number(), std::abs(*other.number() - *number));
    return true;
  }
  if (const Quantity::List* list = plain.list()) {
    const Quantity::List* others = other.list();
    if (others == nullptr || others->size() != list->size()) return false;
    const bool one = numbers_only(plain);
    Quantity::List spreads = one ? Quantity::List{} : *spread.list();
    for (std::size_t i = 0; i < list->size(); ++i)
      if (!enlarge((*list)[i], (*others)[i], one ? spread : spreads[i])) return false;
    if (!one) spread = std::move(spreads);
    return true;
  }
  if (const Quantity::Table* table = plain.table()) {
    const Quantity::Table* others = other.table();
    if (others == nullptr || others->size() != table->size()) return false;
    for (std::size_t i = 0; i < table->size(); ++i) {
      const auto& [name, value] = (*table)[i];
      if ((*others)[i].first != name) return false;
      if (value.text() == nullptr && !enlarge(value, (*others)[i].second, spread[name])) return false;
    }
    return true;
  }
  return other.text() != nullptr;  // words say nothing in digits
}

Quantity digits_of(const Quantity& plain, const Quantity& spread) {
  if (const double* moved = spread.number()) {
    if (*moved == 0.0) return decimal_digits(0.0);
    return decimal_digits(*moved / largest(plain));
  }
  if (const Quantity::List* list = plain.list()) {
    Quantity::List digits;
    for (std::size_t i = 0; i < list->size(); ++i) digits.push_back(digits_of((*list)[i], (*spread.list())[i]));
    return digits;
  }
  Quantity digits;
  if (const Quantity::Table* table = plain.table())
    for (const auto& [name, value] : *table)
      if (value.text() == nullptr) digits[name] = digits_of(value, *spread.find(name));
  return digits;
}

}  // namespace

double jittered(double value, std::mt19937_64& generator) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const auto drawn = generator() % 3;
  if (drawn == 1 || value == 0.0) return value;
  return std::nextafter(value, drawn == 0 ? -far : far);
}

double decimal_digits(double relative_spread) {
  const double finest = 0.5 * std::numeric_limits<double>::epsilon();
  return std::fmax(0.0, -std::log10(std::fmax(relative_spread, finest)));
}

Quantity DigitsTrusted::zero_spread(const Quantity& plain) {
  if (plain.number() != nullptr || numbers_only(plain)) return 0.0;
  if (const Quantity::List* list = plain.list()) {
    Quantity::List zeros;
    for (const Quantity& entry : *list) zeros.push_back(zero_spread(entry));
    return zeros;
  }
  Quantity zeros;
  if (const Quantity::Table* table = plain.table())
    for (const auto& [name, value] : *table)
      if (value.text() == nullptr) zeros[name] = zero_spread(value);
  return zeros;
}

bool DigitsTrusted::add(const Quantity& run) {
  return enlarge(plain_, run, spread_);
}

Quantity DigitsTrusted::digits() const {
  return digits_of(plain_, spread_);
}

}  // namespace sunder::verification
