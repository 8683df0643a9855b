#include "solver/simulation/byte_stream.hpp"

namespace sunder::simulation {

using results::Quantity;

namespace {
enum class Kind : char { number, text, list, table };
}

void ByteWriter::operator()(const Quantity& quantity) {
  if (const double* number = quantity.number()) {
    (*this)(Kind::number);
    (*this)(*number);
  } else if (const std::string* text = quantity.text()) {
    (*this)(Kind::text);
    (*this)(std::vector<char>(text->begin(), text->end()));
  } else if (const Quantity::List* list = quantity.list()) {
    (*this)(Kind::list);
    resize(*list);
    for (const Quantity& entry : *list) (*this)(entry);
  } else {
    (*this)(Kind::table);
    resize(*quantity.table());
    for (const auto& [name, entry] : *quantity.table()) {
      (*this)(Quantity(name));
      (*this)(entry);
    }
  }
}

void ByteReader::operator()(Quantity& quantity) {
  Kind kind{};
  (*this)(kind);
  switch (kind) {
    case Kind::number: {
      double number = 0.0;
      (*this)(number);
      quantity = number;
      return;
    }
    case Kind::text: {
      std::vector<char> text;
      (*this)(text);
      quantity = std::string(text.begin(), text.end());
      return;
    }
    case Kind::list: {
      Quantity::List list;
      resize(list);
      for (Quantity& entry : list) (*this)(entry);
      quantity = std::move(list);
      return;
    }
    case Kind::table: {
      Quantity::Table table;
      resize(table);
      for (auto& [name, entry] : table) {
        Quantity key;
        (*this)(key);
        if (key.text() != nullptr) name = *key.text();
        (*this)(entry);
      }
      quantity = std::move(table);
      return;
    }
  }
  short_of_ = true;  // no kind that a writer knows
}

}  // namespace sunder::simulation
