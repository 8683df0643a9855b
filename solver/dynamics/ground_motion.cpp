#include "solver/dynamics/ground_motion.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::dynamics {
namespace {

constexpr double standard_gravity = 9.80665;  // m/s², of PEER's records
constexpr double step_change = 1e-3;          // of the time step: more is a gap, less is rounding in the file

[[noreturn]] void refuse(const std::filesystem::path& file, std::size_t line, const std::string& what) {
  throw RecordError(file.string() + ":" + std::to_string(line) + ": " + what);
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view between = " \t\r,;";
  for (std::size_t at = line.find_first_not_of(between); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(between, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(between, end);
  }
  return words;
}

/// False where the word is no number at all; nan and inf are numbers here, and refused by name later.
bool read_number(std::string_view word, double& value) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

double finite_number(const std::filesystem::path& file, std::size_t line, std::string_view word, const char* what) {
  double value = 0.0;
  const bool believes = numerics::planted_fault("dynamics/record-believed");
  if (!read_number(word, value) && !believes)
    refuse(file, line, std::string(what) + ": \"" + std::string(word) + "\" is no number");
  if (!std::isfinite(value) && !believes)
    refuse(file, line, std::string(what) + ": \"" + std::string(word) + "\" is not finite");
  return value;
}

GroundMotion read_table(std::ifstream& stream, const std::filesystem::path& file) {
  GroundMotion motion;
  std::string text;
  double before = 0.0;
  for (std::size_t line = 1; std::getline(stream, text); ++line) {
    const std::vector<std::string_view> words = words_of(std::string_view(text).substr(0, text.find('#')));
    if (words.empty()) continue;
    double ignored = 0.0;
    if (motion.acceleration.empty() && !read_number(words[0], ignored)) continue;  // the heading
    if (words.size() != 2 && !numerics::planted_fault("dynamics/record-believed")) {
      refuse(file, line,
             "has " + std::to_string(words.size()) + " column(s); accepted: time [s] and acceleration [m/s²]");
    }
    const double time = finite_number(file, line, words[0], "time");
    const double value = finite_number(file, line, words[1], "acceleration");
    const std::size_t count = motion.acceleration.size();
    if (count == 0) motion.start = time;
    if (count == 1) motion.sample_step = time - motion.start;
    if (count >= 1) {
      const double step = time - before;
      if (!(step > 0.0 && std::isfinite(step)))
        refuse(file, line,
               "time " + std::string(words[0]) + " does not follow the one before; accepted: ascending times");
      if (std::abs(step - motion.sample_step) > step_change * motion.sample_step &&
          !numerics::planted_fault("dynamics/record-believed")) {
        refuse(file, line,
               "the time step changes from " + std::to_string(motion.sample_step) + " s to " + std::to_string(step) +
                   " s; accepted: equal steps");
      }
    }
    before = time;
    motion.acceleration.push_back(value);
  }
  if (motion.acceleration.size() >= 2) {  // the mean step: the file rounds its times
    motion.sample_step = (before - motion.start) / static_cast<double>(motion.acceleration.size() - 1);
  }
  return motion;
}

GroundMotion read_at2(std::ifstream& stream, const std::filesystem::path& file) {
  GroundMotion motion;
  std::string text;
  double points = 0.0;
  std::string shown_points;
  std::size_t line = 1;
  for (; line <= 4 && std::getline(stream, text); ++line) {
    if (line < 4) continue;
    std::string heading = text;
    std::replace(heading.begin(), heading.end(), '=', ' ');
    const std::vector<std::string_view> words = words_of(heading);
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
      if (words[i] == "NPTS") {
        points = finite_number(file, line, words[i + 1], "NPTS");
        shown_points = words[i + 1];
      }
      if (words[i] == "DT") motion.sample_step = finite_number(file, line, words[i + 1], "DT");
    }
    if (!(points >= 2.0)) refuse(file, line, "NPTS is missing or less than 2; accepted: \"NPTS= 4000, DT= .01 SEC\"");
    if (!(motion.sample_step > 0.0))
      refuse(file, line, "DT is missing or not > 0; accepted: \"NPTS= 4000, DT= .01 SEC\"");
  }
  for (; std::getline(stream, text); ++line) {
    for (const std::string_view word : words_of(text)) {
      const double value = standard_gravity * finite_number(file, line, word, "acceleration");
      if (!std::isfinite(value)) refuse(file, line, "acceleration: \"" + std::string(word) + "\" g is not finite");
      motion.acceleration.push_back(value);
    }
  }
  if (static_cast<double>(motion.acceleration.size()) != points &&
      !numerics::planted_fault("dynamics/record-believed")) {
    refuse(file, line, "has " + std::to_string(motion.acceleration.size()) + " samples, but NPTS says " + shown_points);
  }
  return motion;
}

}  // namespace

double GroundMotion::at(double time) const {
  double place = (time - start) / sample_step;
  if (numerics::planted_fault("dynamics/record-one-sample-late")) place -= 1.0;
  // round-off of a time that is a whole number of samples must not fall out of the record
  const auto last = static_cast<double>(acceleration.size() - 1);
  constexpr double round_off = 1e-9;
  if (!(place >= -round_off) || place > last + round_off) return 0.0;
  place = std::clamp(place, 0.0, last);
  const auto below = std::min(static_cast<std::size_t>(place), acceleration.size() - 2);
  const double share = place - static_cast<double>(below);
  return (1.0 - share) * acceleration[below] + share * acceleration[below + 1];
}

GroundMotion read_ground_motion(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file)) throw RecordError(file.string() + ": cannot be read");
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  GroundMotion motion = ending == ".at2" ? read_at2(stream, file) : read_table(stream, file);
  if (motion.acceleration.size() < 2 && numerics::planted_fault("dynamics/record-believed")) {
    motion = {.start = 0.0, .sample_step = 1.0, .acceleration = {0.0, 0.0}};
  }
  if (motion.acceleration.size() < 2) {
    throw RecordError(file.string() + ": has " + std::to_string(motion.acceleration.size()) +
                      " sample(s); accepted: two or more");
  }
  if (!std::isfinite(motion.start) || !std::isfinite(motion.end() - motion.start)) {
    throw RecordError(file.string() + ": its samples span more time than a number holds");
  }
  return motion;
}

GroundMotion baseline_corrected(GroundMotion motion) {
  // Velocities of the record (column 3) and of 1, τ, τ² with τ = t / duration, all integrated by the same trapezoids;
  // what is found is the least-squares fit of the first by the others.
  const auto count = static_cast<Eigen::Index>(motion.acceleration.size());
  if (count < 4) throw std::invalid_argument("samples = " + std::to_string(count) + " must be at least 4");
  const auto basis = [count](Eigen::Index sample, int power) {
    return std::pow(static_cast<double>(sample) / static_cast<double>(count - 1), power);
  };
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  Eigen::Vector3d of_basis = Eigen::Vector3d::Zero();
  double of_record = 0.0;
  const double half = 0.5 * motion.sample_step;
  for (Eigen::Index i = 1; i < count; ++i) {
    for (int k = 0; k < 3; ++k) of_basis[k] += half * (basis(i - 1, k) + basis(i, k));
    of_record += half * (motion.acceleration[static_cast<std::size_t>(i - 1)] +
                         motion.acceleration[static_cast<std::size_t>(i)]);
    normal += of_basis * of_basis.transpose();
    right += of_record * of_basis;
  }
  const Eigen::Vector3d coefficients = normal.ldlt().solve(right);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) motion.acceleration[static_cast<std::size_t>(i)] -= coefficients[k] * basis(i, k);
  }
  return motion;
}

}  // namespace sunder::dynamics
