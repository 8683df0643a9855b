# Compiler flags shared by every target.
#
# x86-64-v3 (AVX2, FMA) is the newest instruction set that valgrind understands, and AVX-512 gained nothing where it was
# measured. -ffast-math stays off: it would remove the checks for NaN. errno is never read after a math function.
# -Wno-restrict: g++ 12 warns of "text" + std::string (GCC bug 105651), falsely.
add_library(sunder_options INTERFACE)
target_include_directories(sunder_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_features(sunder_options INTERFACE cxx_std_20)
target_compile_options(sunder_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast -Wno-restrict
  -fno-math-errno
  $<$<BOOL:${SUNDER_WARNINGS_AS_ERRORS}>:-Werror>)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(sunder_options INTERFACE -march=x86-64-v3)
endif()
# A program exports by itself what a shared library also has. gmsh holds Eigen templates of its own, compiled for 16-byte
# alignment; with ours in their place (32 bytes with AVX) it freed what it had not allocated. So nothing is exported.
target_link_options(sunder_options INTERFACE
  -Wl,--version-script=${PROJECT_SOURCE_DIR}/ci/cmake/hide-symbols.map
  # a test's count of allocations is meant for the libraries too
  -Wl,--export-dynamic-symbol=malloc -Wl,--export-dynamic-symbol=calloc -Wl,--export-dynamic-symbol=realloc)
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

find_program(SUNDER_CCACHE ccache)
if(SUNDER_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${SUNDER_CCACHE})
endif()
