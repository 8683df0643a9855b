/// Any bytes are a record, as a table and as .at2, or refused with RecordError; what is accepted is finite everywhere.

#include <cmath>
#include <cstdlib>

#include "solver/dynamics/ground_motion.hpp"
#include "verification/fuzz/input_file.hpp"
#include "verification/fuzz/try_bytes.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sunder;
  static const fuzz::InputFile table("record.csv"), at2("record.at2");
  for (const fuzz::InputFile* input : {&table, &at2}) {
    try {
      const dynamics::GroundMotion motion = dynamics::read_ground_motion(input->write({data, size}));
      for (const double place : {-1.0, 0.0, 0.3, 1.0, 2.0})
        if (!std::isfinite(motion.at(motion.start + place * (motion.end() - motion.start)))) std::abort();
    } catch (const dynamics::RecordError&) {
    }
  }
  return 0;
}
