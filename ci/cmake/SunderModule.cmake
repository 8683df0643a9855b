# sunder_module(<name> FLOOR <n> [DEPENDS <module>...] [LIBRARIES <target>...] [SEPARATE])
#
# One library `sunder_<name>` of solver/<name>/*.cpp and, where solver/<name>/tests/*_test.cpp exist, one test program
# `<name>_test`; a main.cpp is left to the program that it belongs to. A module may depend only on modules of lower
# floors; anything else stops the configuration. The include lines are held to the same table by ci/check-layers, which
# reads the file `layers.txt` written here.
#
# SEPARATE: its sources use a name for two things, each in its own file, and cannot be compiled as one (SUNDER_UNITY).
#
# Sources that plant faults (they include numerics/planted_fault.hpp) are compiled a second time with the faults alive, as
# objects that only the test program `sunder-verify-faulted` links (property SUNDER_FAULTED_OBJECTS).
set_property(GLOBAL PROPERTY SUNDER_FAULTED_OBJECTS "")
set_property(GLOBAL PROPERTY SUNDER_MODULE_LIBRARIES "")
file(WRITE ${PROJECT_BINARY_DIR}/layers.txt "")

function(sunder_module name)
  cmake_parse_arguments(arg "SEPARATE" "FLOOR" "DEPENDS;LIBRARIES" ${ARGN})
  if(name IN_LIST SUNDER_ABSENT_MODULES)
    return()
  endif()
  if(SUNDER_ABSENT_MODULES)
    list(REMOVE_ITEM arg_DEPENDS ${SUNDER_ABSENT_MODULES})
  endif()
  set_property(GLOBAL PROPERTY SUNDER_FLOOR_${name} ${arg_FLOOR})
  foreach(dependency IN LISTS arg_DEPENDS)
    get_property(floor GLOBAL PROPERTY SUNDER_FLOOR_${dependency})
    if(floor STREQUAL "" OR NOT floor LESS arg_FLOOR)
      message(FATAL_ERROR "module ${name} (floor ${arg_FLOOR}) may not depend on ${dependency} (floor ${floor})")
    endif()
  endforeach()
  list(JOIN arg_DEPENDS " " depends)
  file(APPEND ${PROJECT_BINARY_DIR}/layers.txt "${name} ${arg_FLOOR} ${depends}\n")

  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(name STREQUAL "simulation" AND SUNDER_ABSENT_SEAMS)
    list(TRANSFORM SUNDER_ABSENT_SEAMS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/${name}/ OUTPUT_VARIABLE left_out)
    list(REMOVE_ITEM sources ${left_out})
    list(TRANSFORM SUNDER_ABSENT_SOURCES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/${name}/ OUTPUT_VARIABLE in_their_place)
    list(APPEND sources ${in_their_place})
  endif()
  list(TRANSFORM arg_DEPENDS PREPEND sunder_ OUTPUT_VARIABLE modules)
  if(sources)
    add_library(sunder_${name} STATIC ${sources})
    target_link_libraries(sunder_${name} PUBLIC sunder_options ${modules} ${arg_LIBRARIES})
    if(SUNDER_UNITY AND NOT arg_SEPARATE)
      set_target_properties(sunder_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
    endif()
  else()
    add_library(sunder_${name} INTERFACE)
    target_link_libraries(sunder_${name} INTERFACE sunder_options ${modules} ${arg_LIBRARIES})
  endif()

  set_property(GLOBAL APPEND PROPERTY SUNDER_MODULE_LIBRARIES sunder_${name})

  set(faulted "")
  foreach(source IN LISTS sources)
    file(STRINGS ${source} plants REGEX "#include \"solver/numerics/planted_fault.hpp\"")
    if(plants)
      list(APPEND faulted ${source})
    endif()
  endforeach()
  if(faulted AND SUNDER_TESTS)
    add_library(sunder_${name}_faulted OBJECT ${faulted})
    target_compile_definitions(sunder_${name}_faulted PRIVATE SUNDER_PLANTED_FAULTS)
    target_link_libraries(sunder_${name}_faulted PUBLIC sunder_options ${modules} ${arg_LIBRARIES})
    set_property(GLOBAL APPEND PROPERTY SUNDER_FAULTED_OBJECTS $<TARGET_OBJECTS:sunder_${name}_faulted>)
  endif()

  file(GLOB tests CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/tests/*_test.cpp)
  if(tests AND SUNDER_TESTS)
    add_executable(${name}_test ${tests})
    target_link_libraries(${name}_test PRIVATE sunder_${name} GTest::gtest_main)
    add_test(NAME unit/${name}
             COMMAND ${name}_test --gtest_output=xml:${PROJECT_BINARY_DIR}/junit/${name}.xml
             WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(unit/${name} PROPERTIES LABELS "unit;quick" TIMEOUT 120)
  endif()
endfunction()
