#include "verification/harness/csv.hpp"

#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace sunder::verification {
namespace {

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> result;
  std::stringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) {
    const auto begin = field.find_first_not_of(" \t\r");
    const auto end = field.find_last_not_of(" \t\r");
    result.push_back(begin == std::string::npos ? "" : field.substr(begin, end - begin + 1));
  }
  if (!line.empty() && line.back() == ',') result.emplace_back();
  return result;
}

}  // namespace

const std::vector<double>* Csv::column(const std::string& name) const {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return &columns[i];
  return nullptr;
}

Csv read_csv(const std::filesystem::path& file) {
  std::ifstream stream(file);
  const std::string shown = file.parent_path().filename().string() + "/" + file.filename().string();
  if (!stream) throw std::runtime_error(shown + ": cannot be opened");
  Csv csv;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
    const std::vector<std::string> row = fields(line);
    if (csv.names.empty()) {
      csv.names = row;
      csv.columns.resize(row.size());
      continue;
    }
    const std::string place = shown + ":" + std::to_string(number) + ": ";
    if (row.size() != csv.names.size())
      throw std::runtime_error(place + std::to_string(row.size()) + " fields, the header has " +
                               std::to_string(csv.names.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      char* end = nullptr;
      const double value = std::strtod(row[i].c_str(), &end);
      if (!row[i].empty() && *end != '\0') throw std::runtime_error(place + "\"" + row[i] + "\" is not a number");
      csv.columns[i].push_back(row[i].empty() ? std::numeric_limits<double>::quiet_NaN() : value);
    }
  }
  if (csv.names.empty()) throw std::runtime_error(shown + ": there is no header row");
  return csv;
}

}  // namespace sunder::verification
