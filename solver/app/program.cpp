#include "solver/app/program.hpp"

#include <exception>
#include <filesystem>
#include <new>
#include <ostream>
#include <stdexcept>

#include "solver/app/commands.hpp"

namespace sunder::app {

int program(std::span<const std::string> words, const Console& console, const Solver& solver) noexcept {
  try {
    const CommandLine line = parse_command_line(words);
    if (!line.arguments) {
      (line.status == completed ? console.out : console.err) << line.text << std::flush;
      return line.status;
    }
    switch (line.arguments->command) {
      case Command::run:
        return run_command(*line.arguments, console, solver);
      case Command::check:
        return check_command(*line.arguments, console, solver);
      case Command::ablate:
        return ablate_command(*line.arguments, console, solver);
      case Command::keys:
        return keys_command(*line.arguments, console);
    }
  } catch (const scene::SceneError& error) {
    console.err << error.what() << std::endl;
    return unusable_input;
  } catch (const std::filesystem::filesystem_error& error) {
    console.err << "sunder: " << error.what() << std::endl;
    return unusable_input;
  } catch (const std::invalid_argument& error) {
    console.err << "sunder: " << error.what() << std::endl;
    return unusable_input;
  } catch (const std::bad_alloc&) {
    console.err << "sunder: not enough memory" << std::endl;
    return numbers_did_not_come_out;
  } catch (const std::exception& error) {
    console.err << "sunder: " << error.what() << std::endl;
    return numbers_did_not_come_out;
  }
  return numbers_did_not_come_out;
}

}  // namespace sunder::app
