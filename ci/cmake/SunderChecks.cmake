# The checks that are no C++ program: style, and the report's own tests. They need Debian's Python with matplotlib, which
# need not be the first python3 on the path.
set(SUNDER_PYTHON "" CACHE FILEPATH "Python with matplotlib, numpy, h5py and jinja2; found where empty")
if(NOT SUNDER_PYTHON)
  foreach(candidate /usr/bin/python3 python3 /usr/local/bin/python3)
    execute_process(COMMAND ${candidate} -c "import matplotlib, numpy, h5py, jinja2, sys; print(sys.executable, end='')"
                    RESULT_VARIABLE status OUTPUT_VARIABLE interpreter ERROR_QUIET)
    if(status EQUAL 0)
      set(SUNDER_PYTHON ${interpreter} CACHE FILEPATH "" FORCE)
      break()
    endif()
  endforeach()
  if(NOT SUNDER_PYTHON)
    message(FATAL_ERROR "no python3 with matplotlib, numpy, h5py and jinja2 was found; ci/setup installs them")
  endif()
endif()

add_test(NAME style/layers COMMAND ${SUNDER_PYTHON} ${PROJECT_SOURCE_DIR}/ci/check-layers ${PROJECT_BINARY_DIR}/layers.txt)
add_test(NAME style/format COMMAND ${PROJECT_SOURCE_DIR}/ci/check-format)
add_test(NAME style/citations COMMAND ${SUNDER_PYTHON} ${PROJECT_SOURCE_DIR}/ci/check-citations)
add_test(NAME style/checks-notice
         COMMAND ${SUNDER_PYTHON} -B -m unittest discover --start-directory ${PROJECT_SOURCE_DIR}/ci/tests --pattern *_test.py)
set_tests_properties(style/layers style/format style/citations style/checks-notice PROPERTIES LABELS "style;quick" TIMEOUT 60)

# The report's tests open its page in headless Chromium.
add_test(NAME report/tests
         COMMAND ${SUNDER_PYTHON} -B -m unittest discover --start-directory reports/tests --top-level-directory . --pattern *_test.py
         WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
set_tests_properties(report/tests PROPERTIES LABELS "report;quick" TIMEOUT 300)
