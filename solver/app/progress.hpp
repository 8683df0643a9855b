#pragma once
/// How far a run is: a bar on a terminal, one line a phase elsewhere.

#include <iosfwd>
#include <string>
#include <string_view>

namespace sunder::app {

class Progress {
 public:
  enum class Style { bar, lines, none };

  Progress(std::ostream& out, Style style) : out_(out), style_(style) {}
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `fraction` in 0 … 1 of the whole run. A bar is redrawn only where it would look different.
  void show(std::string_view phase, double fraction);

  /// Clears the bar.
  void finish();

 private:
  std::ostream& out_;
  Style style_;
  std::string phase_;
  int percent_ = -1;
};

}  // namespace sunder::app
