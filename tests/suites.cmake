# Run by CMake when a test program is built: lists its suites as tests of CTest, a suite a process, so that
# thousands of tests do not each start a program. Suites whose name begins with Slow are left out.
#   cmake -D PROGRAM=<test program> -D LABEL=<label> -D OUT=<file for TEST_INCLUDE_FILES> -P suites.cmake
# A suite with more tests is begun sooner, that none of the long ones runs alone at the end.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE list COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "[;[]|]" "_" list "${list}")  # which CMake's lists take for their own
string(REPLACE "\n" ";" list "${list}")
set(tests "")
set(suite "")
set(count 0)
macro(close_suite)
  if(suite AND NOT suite MATCHES "(^|/)Slow")
    string(APPEND tests "add_test([[${suite}]] [[${PROGRAM}]] [[--gtest_filter=${suite}.*]])\n"
      "set_tests_properties([[${suite}]] PROPERTIES LABELS ${LABEL} TIMEOUT 1200 COST ${count})\n")
  endif()
endmacro()
foreach(line IN LISTS list)
  if(line MATCHES "^([^ ]+)[.]( |$)")
    set(name ${CMAKE_MATCH_1})
    close_suite()
    set(suite ${name})
    set(count 0)
  elseif(line MATCHES "^  ")
    math(EXPR count "${count} + 1")
  endif()
endforeach()
close_suite()
file(WRITE ${OUT} "${tests}")
