#pragma once
/// Pieces of work whose instructions are counted: the same bits, the same count, whatever else the machine does.

#include <functional>
#include <string>
#include <vector>

namespace sunder::counts {

/// One piece of work, set up and ready. `run` calls `start` and `stop` around what is counted, once each.
struct Work {
  std::function<void(const std::function<void()>& start, const std::function<void()>& stop)> run;
  std::function<bool()> is_right;  ///< after the run: a count of a wrong answer means nothing
};

struct Region {
  std::string name, meaning;
  long size;                            ///< that the gate counts: steps, segments, nodes, … as `meaning` says
  std::function<Work(long size)> make;  ///< > 0
};

std::vector<Region> kernel_regions();  ///< kernels.cpp
std::vector<Region> dam_regions();     ///< dam.cpp

/// Work that is counted as a whole.
inline Work whole(std::function<void()> body, std::function<bool()> is_right) {
  return {[body = std::move(body)](const auto& start, const auto& stop) {
            start();
            body();
            stop();
          },
          std::move(is_right)};
}

}  // namespace sunder::counts
