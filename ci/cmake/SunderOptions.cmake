# Compiler flags shared by every target.
#
# x86-64-v3 (AVX2, FMA) is the newest instruction set that valgrind understands, and AVX-512 gained nothing where it was
# measured. -ffast-math stays off: it would remove the checks for NaN. errno is never read after a math function.
# -Wno-restrict: g++ 12 warns of "text" + std::string (GCC bug 105651), falsely.
set(SUNDER_ARCHITECTURE "x86-64-v3" CACHE STRING "Instruction set of every target (-march); ci/matrix varies it")
set(SUNDER_OPTIMISATION "-O3" CACHE STRING "Optimisation of a release; ci/matrix varies it")
set(SUNDER_SANITIZERS "" CACHE STRING "Sanitizers of every target, as -fsanitize takes them; see ci/sanitize and ci/fuzz")
option(SUNDER_UNITY "Compile up to 16 sources of a module as one: a fraction of the time where nothing is cached" OFF)
add_library(sunder_options INTERFACE)
target_include_directories(sunder_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_features(sunder_options INTERFACE cxx_std_20)
target_compile_options(sunder_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  -fno-math-errno
  $<$<BOOL:${SUNDER_WARNINGS_AS_ERRORS}>:-Werror>)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(sunder_options INTERFACE -march=${SUNDER_ARCHITECTURE})
endif()
# A program exports by itself what a shared library also has. gmsh holds Eigen templates of its own, compiled for 16-byte
# alignment; with ours in their place (32 bytes with AVX) it freed what it had not allocated. So nothing is exported.
# A sanitizer must be seen by the libraries that it watches over: then only what bears the name of Eigen is hidden.
if(SUNDER_SANITIZERS)
  target_compile_options(sunder_options INTERFACE
    -fsanitize=${SUNDER_SANITIZERS} -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:Clang>:-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/ci/cmake/sanitizer-ignore.txt>)
  target_link_options(sunder_options INTERFACE -fsanitize=${SUNDER_SANITIZERS}
    -Wl,--version-script=${PROJECT_SOURCE_DIR}/ci/cmake/hide-eigen.map)
else()
  target_link_options(sunder_options INTERFACE
    -Wl,--version-script=${PROJECT_SOURCE_DIR}/ci/cmake/hide-symbols.map
    # a test's count of allocations is meant for the libraries too
    -Wl,--export-dynamic-symbol=malloc -Wl,--export-dynamic-symbol=calloc -Wl,--export-dynamic-symbol=realloc)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "${SUNDER_OPTIMISATION} -DNDEBUG")
if(SUNDER_SANITIZERS)
  set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1")  # assertions live, lines known, four times as fast as -O0
endif()

find_program(SUNDER_CCACHE ccache)
if(SUNDER_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${SUNDER_CCACHE})
endif()
