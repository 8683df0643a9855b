#pragma once
/// What is wrong with a scene, collected so that one reading reports everything. Private to this module.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/scene/document.hpp"

namespace sunder::scene {

class Findings {
 public:
  Findings(std::string file, std::span<const Override> overrides, NumberFilter filter = {})
      : file_(std::move(file)), overrides_(overrides), filter_(std::move(filter)) {}

  /// The sound number as the scene shall have it.
  double filtered(double value) const { return filter_ ? filter_(value) : value; }

  /// `key: what`, at `origin`.
  void add(const Origin& origin, std::string_view key, std::string_view what);

  std::size_t count() const { return found_.size(); }

  /// Throws SceneError with all findings, one a line in the order of the file, where there are any.
  void throw_if_any() const;

 private:
  struct Finding {
    Origin origin;
    std::string text;
  };
  std::string file_;
  std::span<const Override> overrides_;
  NumberFilter filter_;
  std::vector<Finding> found_;
};

/// The candidate nearest to `word` by edits (insert, delete, replace, swap neighbours), or nothing where none is near:
/// at most one edit in words up to four letters, one edit more for every three further letters.
[[nodiscard]] std::string nearest(std::string_view word, std::span<const std::string> candidates);

/// Edits that turn one word into the other; a swap of neighbouring letters counts once.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// "a", "b", "c": for lists of what is accepted.
[[nodiscard]] std::string listed(std::span<const std::string> words);

}  // namespace sunder::scene
