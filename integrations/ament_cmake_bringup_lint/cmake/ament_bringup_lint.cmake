# Add a test that checks with bringup-lint how a robot comes up.
#
# :param TESTNAME: the name of the test, by default "bringup_lint"
# :param CONFIG_FILE: the configuration file, by default the one that bringup-lint finds, or
#   ${ament_cmake_bringup_lint_CONFIG_FILE}
# :param FAIL_ON: the lowest severity that fails, by default "warning", or ${ament_cmake_bringup_lint_FAIL_ON}
# :param TIMEOUT: the seconds after which the test fails, by default 120
# :param EXCLUDE: patterns of files that are not checked, as in .gitignore
# :param ARGN: the files and folders to check, by default the folder of the package
#
# @public
function(ament_bringup_lint)
  cmake_parse_arguments(ARG "" "TESTNAME;CONFIG_FILE;FAIL_ON;TIMEOUT" "EXCLUDE" ${ARGN})
  if(NOT ARG_TESTNAME)
    set(ARG_TESTNAME "bringup_lint")
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  foreach(option CONFIG_FILE FAIL_ON)
    if(NOT ARG_${option} AND DEFINED ament_cmake_bringup_lint_${option})
      set(ARG_${option} "${ament_cmake_bringup_lint_${option}}")
    endif()
  endforeach()

  find_program(ament_bringup_lint_BIN NAMES "ament_bringup_lint")
  if(NOT ament_bringup_lint_BIN)
    message(FATAL_ERROR "ament_bringup_lint() could not find program 'ament_bringup_lint'")
  endif()

  set(result_file "${AMENT_TEST_RESULTS_DIR}/${PROJECT_NAME}/${ARG_TESTNAME}.xunit.xml")
  set(cmd "${ament_bringup_lint_BIN}" "--xunit-file" "${result_file}")
  if(ARG_CONFIG_FILE)
    list(APPEND cmd "--config" "${ARG_CONFIG_FILE}")
  endif()
  if(ARG_FAIL_ON)
    list(APPEND cmd "--fail-on" "${ARG_FAIL_ON}")
  endif()
  if(ARG_EXCLUDE)
    list(APPEND cmd "--exclude" ${ARG_EXCLUDE})
  endif()
  list(APPEND cmd "--" ${ARG_UNPARSED_ARGUMENTS})

  file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/ament_bringup_lint")
  ament_add_test(
    "${ARG_TESTNAME}"
    COMMAND ${cmd}
    TIMEOUT ${ARG_TIMEOUT}
    OUTPUT_FILE "${CMAKE_BINARY_DIR}/ament_bringup_lint/${ARG_TESTNAME}.txt"
    RESULT_FILE "${result_file}"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
  )
  set_tests_properties("${ARG_TESTNAME}" PROPERTIES LABELS "bringup_lint;linter")
endfunction()
