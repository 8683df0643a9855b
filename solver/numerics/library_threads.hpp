#pragma once
/// Keeps the libraries that the sparse factorisation calls on the thread that calls them.
///
/// CHOLMOD opens an OpenMP team of fixed size and OpenBLAS one thread a core for every small dense block of a factor.
/// The blocks of a plane body are too small to repay that: the teams mostly wait, the longer the more the cores are
/// used by others. Both numbers of threads are therefore fixed, whatever the environment says.

namespace sunder::numerics {

/// While it lives, CHOLMOD's OpenMP regions run on the calling thread; OpenBLAS is set to one thread for good when the
/// first one is made. Does nothing where other libraries stand behind CHOLMOD.
class OneLibraryThread {
 public:
  OneLibraryThread();
  ~OneLibraryThread();
  OneLibraryThread(const OneLibraryThread&) = delete;
  OneLibraryThread& operator=(const OneLibraryThread&) = delete;

 private:
  int levels_ = 0;  // of nested active parallel regions that OpenMP allowed before
};

}  // namespace sunder::numerics
