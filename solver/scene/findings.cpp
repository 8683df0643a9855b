#include "solver/scene/findings.hpp"

#include <algorithm>
#include <tuple>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::scene {

void Findings::add(const Origin& origin, std::string_view key, std::string_view what) {
  std::string place = file_;
  if (origin.override_index >= 0) {
    const Override& given = overrides_[static_cast<std::size_t>(origin.override_index)];
    place += ": override " + given.key + " = " + given.value;
  } else if (origin.line > 0) {
    place += ":" + std::to_string(origin.line) + ":" + std::to_string(origin.column);
  }
  const std::string subject = key.empty() ? "" : std::string(key) + ": ";
  found_.push_back({origin, place + ": " + subject + std::string(what)});
}

void Findings::throw_if_any() const {
  if (found_.empty() || numerics::planted_fault("scene/findings-forgotten")) return;
  std::vector<Finding> sorted = found_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Finding& a, const Finding& b) {
    return std::tie(a.origin.line, a.origin.column) < std::tie(b.origin.line, b.origin.column);
  });
  std::string text;
  for (const Finding& finding : sorted) text += (text.empty() ? "" : "\n") + finding.text;
  throw SceneError(text);
}

int edit_distance(std::string_view a, std::string_view b) {
  // Rows of the table of distances between beginnings: before[j] of a[0, i - 2), last[j] of a[0, i - 1), row[j] of a[0,
  // i).
  std::vector<int> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

std::string nearest(std::string_view word, std::span<const std::string> candidates) {
  const int allowed = word.size() <= 4 ? 1 : 1 + static_cast<int>(word.size() - 2) / 3;
  int best = allowed + 1;
  std::string found;
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(word, candidate);
    if (distance < best) {
      best = distance;
      found = candidate;
    }
  }
  return found;
}

std::string listed(std::span<const std::string> words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace sunder::scene
