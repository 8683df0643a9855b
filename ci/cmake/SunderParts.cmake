# Parts that a build may leave out: SUNDER_WITH_<PART>=OFF.
#
# sunder_part(<PART> MODULE <name> SEAM <file>...): where the part is off, module simulation links absent/<name>.cpp in
# place of the files of the seam, and module <name> is not built. A scene that names the part is then refused by name.
# Convolution has no table in a scene and no option: it goes with the last of its users, foundation and reservoir.
set(SUNDER_ABSENT_MODULES "")
set(SUNDER_ABSENT_SEAMS "")    # sources of module simulation that are left out
set(SUNDER_ABSENT_SOURCES "")  # what stands in for them

function(sunder_part part)
  cmake_parse_arguments(arg "" "MODULE" "SEAM" ${ARGN})
  option(SUNDER_WITH_${part} "Build the part ${arg_MODULE}" ON)
  if(SUNDER_WITH_${part})
    return()
  endif()
  if(SUNDER_TESTS OR SUNDER_BENCHMARKS)
    message(FATAL_ERROR "SUNDER_WITH_${part}=OFF needs SUNDER_TESTS=OFF and SUNDER_BENCHMARKS=OFF: they use every part")
  endif()
  set(SUNDER_ABSENT_MODULES ${SUNDER_ABSENT_MODULES} ${arg_MODULE} PARENT_SCOPE)
  set(SUNDER_ABSENT_SEAMS ${SUNDER_ABSENT_SEAMS} ${arg_SEAM} PARENT_SCOPE)
  set(SUNDER_ABSENT_SOURCES ${SUNDER_ABSENT_SOURCES} absent/${arg_MODULE}.cpp PARENT_SCOPE)
endfunction()

sunder_part(CONTACT MODULE contact SEAM static_contact.cpp)
sunder_part(CRACKWATER MODULE crackwater SEAM crack_waters.cpp moving_water.cpp run_crack_water.cpp)
sunder_part(FOUNDATION MODULE foundation SEAM attached_foundation.cpp foundation_line.cpp foundation_response.cpp)
sunder_part(RESERVOIR MODULE reservoir SEAM attached_reservoir.cpp reservoir_response.cpp)
if(NOT SUNDER_WITH_FOUNDATION AND NOT SUNDER_WITH_RESERVOIR)
  list(APPEND SUNDER_ABSENT_MODULES convolution)
endif()
