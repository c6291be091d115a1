# The example of tests/embedding, a project of its own, against the installed library.
if(KERF_INSTALL)
  add_test(NAME embedding.builds_against_the_installed_library
    COMMAND "${CMAKE_COMMAND}" -D "BUILD=${PROJECT_BINARY_DIR}" -D "SOURCE=${CMAKE_CURRENT_LIST_DIR}"
      -D "WORK=${PROJECT_BINARY_DIR}/embedding" -D "GENERATOR=${CMAKE_GENERATOR}" -D "COMPILER=${CMAKE_CXX_COMPILER}"
      -D "FLAGS=${CMAKE_CXX_FLAGS}" -D "TYPE=${CMAKE_BUILD_TYPE}" -P "${CMAKE_CURRENT_LIST_DIR}/run.cmake")
  set_tests_properties(embedding.builds_against_the_installed_library PROPERTIES TIMEOUT 300)
endif()
