#include <unistd.h>

#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "solver/app/program.hpp"
#include "solver/simulation/body.hpp"
#include "solver/simulation/ledger.hpp"

namespace {

sunder::app::Plan plan(const sunder::scene::Scene& scene) {
  sunder::simulation::Ledger unread;
  sunder::simulation::Body body = sunder::simulation::build_body(scene, unread);
  return {std::move(body.polygons), std::move(body.nodes)};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
  const sunder::app::Console console{std::cout, std::cerr, ::isatty(STDERR_FILENO) == 1};
  return sunder::app::program(words, console, {sunder::simulation::run, plan});
}
