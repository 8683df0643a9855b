#include "solver/app/progress.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace sunder::app {
namespace {

constexpr int bar_width = 30;
constexpr const char* clear_line = "\r\033[K";

}  // namespace

void Progress::show(std::string_view phase, double fraction) {
  if (style_ == Style::none) return;
  const int percent = std::isfinite(fraction) ? static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0)) : 0;
  const bool new_phase = phase_ != phase;
  if (!new_phase && (style_ == Style::lines || percent == percent_)) return;
  phase_ = phase;
  percent_ = percent;
  if (style_ == Style::lines) {
    out_ << phase_ << std::endl;
    return;
  }
  const int full = percent * bar_width / 100;
  out_ << clear_line << '[' << std::string(static_cast<std::size_t>(full), '#')
       << std::string(static_cast<std::size_t>(bar_width - full), '.') << "] " << percent << " % " << phase_
       << std::flush;
}

void Progress::finish() {
  if (style_ == Style::bar && percent_ >= 0) out_ << clear_line << std::flush;
  percent_ = -1;
  phase_.clear();
}

}  // namespace sunder::app
