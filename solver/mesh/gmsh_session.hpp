#pragma once
/// One use of gmsh: started, silent, on one thread, with a model of its own, and ended again whatever happens.

#include <mutex>
#include <string>

namespace sunder::mesh {

/// gmsh keeps one state for the whole program: sessions exclude each other, and the interrupt handler of the program is
/// put back. Not for programs that use gmsh themselves.
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Runs the action; anything gmsh throws comes out as MeshError "<what>: <gmsh's words>".
  template <class Action>
  static void guarded(const std::string& what, const Action& action) {
    try {
      action();
    } catch (...) {
      rethrow(what);
    }
  }

 private:
  [[noreturn]] static void rethrow(const std::string& what);
  std::unique_lock<std::mutex> lock_;
};

}  // namespace sunder::mesh
