# The examples, a project of their own, against the installed library, and configured as a project around this checkout.
set(example -D "CHECKOUT=${PROJECT_SOURCE_DIR}" -D "GENERATOR=${CMAKE_GENERATOR}" -D "COMPILER=${CMAKE_CXX_COMPILER}"
  -D "FLAGS=${CMAKE_CXX_FLAGS}" -D "TYPE=${CMAKE_BUILD_TYPE}")
if(KERF_INSTALL)
  add_test(NAME embedding.builds_and_runs_the_examples_against_the_installed_library
    COMMAND "${CMAKE_COMMAND}" ${example} -D "BUILD=${PROJECT_BINARY_DIR}" -D "WORK=${PROJECT_BINARY_DIR}/embedding"
      -P "${CMAKE_CURRENT_LIST_DIR}/run.cmake")
  set_tests_properties(embedding.builds_and_runs_the_examples_against_the_installed_library PROPERTIES
    TIMEOUT 600 FIXTURES_SETUP kerf_installed)
  separate_arguments(flags NATIVE_COMMAND "${CMAKE_CXX_FLAGS}")
  add_test(NAME embedding.installs_a_front_door_of_its_own
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_LIST_DIR}/front_door_test.py" "${PROJECT_BINARY_DIR}/embedding/installed"
      "${CMAKE_CXX_COMPILER}" "$<TARGET_FILE:kerf_front>" ${flags})
  set_tests_properties(embedding.installs_a_front_door_of_its_own PROPERTIES TIMEOUT 300 FIXTURES_REQUIRED kerf_installed)
endif()
add_test(NAME embedding.configures_around_the_checkout_without_what_the_program_needs
  COMMAND "${CMAKE_COMMAND}" ${example} -D "WORK=${PROJECT_BINARY_DIR}/embedding_around"
    -P "${CMAKE_CURRENT_LIST_DIR}/configure_around.cmake")
set_tests_properties(embedding.configures_around_the_checkout_without_what_the_program_needs PROPERTIES TIMEOUT 300)
