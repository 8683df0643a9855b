#include "solver/mesh/gmsh_session.hpp"

#include <gmsh.h>

#include <csignal>
#include <exception>

#include "solver/mesh/mesh_error.hpp"

namespace sunder::mesh {
namespace {

std::mutex& session_mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

GmshSession::GmshSession() : lock_(session_mutex()) {
  struct sigaction interrupt {};
  sigaction(SIGINT, nullptr, &interrupt);
  gmsh::initialize(0, nullptr, false);  // false: no configuration file of the user may change a mesh
  sigaction(SIGINT, &interrupt, nullptr);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
  gmsh::model::add("sunder");
}

GmshSession::~GmshSession() {
  try {
    gmsh::finalize();
  } catch (...) {  // nothing is left to end
  }
}

void GmshSession::rethrow(const std::string& what) {
  try {
    throw;
  } catch (const MeshError&) {
    throw;
  } catch (const std::exception& error) {
    throw MeshError(what + ": " + error.what());
  } catch (const std::string& words) {  // gmsh 4.8 throws bare strings
    throw MeshError(what + ": " + words);
  } catch (...) {
    throw MeshError(what + ": gmsh stopped without a word");
  }
}

}  // namespace sunder::mesh
