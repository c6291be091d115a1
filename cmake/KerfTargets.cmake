# kerf_library(NAME DEPENDS ... PRIVATE_DEPENDS ... PRECOMPILED HEADER...)
#   the folder's *.cpp, those of its subfolders too, as one static library, target kerf_NAME, alias kerf::NAME
# kerf_precompile(TARGET HEADER...)
#   headers that most sources of it include, and that take longer to read than the sources
# kerf_unity(TARGET SOURCE...)
#   up to eight sources of one folder are compiled as one: names of their own are different within a folder
# kerf_tests(NAME DEPENDS ...)
#   the folder's *.cpp as one GoogleTest executable NAME_tests, every test in it known to CTest

add_library(kerf_warnings INTERFACE)
target_compile_options(kerf_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wold-style-cast -Wdouble-promotion
  # GCC 12 warns of std::string's own operator+ (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${KERF_STRICT}>:-Werror>)

function(kerf_precompile target)
  if(KERF_PRECOMPILED_HEADERS)
    if(NOT ARGV1 STREQUAL "REUSE_FROM")
      set(visibility PRIVATE)
    endif()
    target_precompile_headers(${target} ${visibility} ${ARGN})
    # In what it inlines from a precompiled standard header, GCC 12 no longer knows a system header, whose warnings it leaves out.
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-maybe-uninitialized;-Wno-stringop-overflow;-Wno-stringop-overread>)
  endif()
endfunction()

function(kerf_unity target)
  if(NOT KERF_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set(count 0)
  foreach(source ${ARGN})
    get_filename_component(folder "${source}" DIRECTORY)
    if(NOT folder STREQUAL last_folder)
      set(count 0)
      set(last_folder "${folder}")
    endif()
    get_filename_component(name "${folder}" NAME)
    math(EXPR part "${count} / 8")
    math(EXPR count "${count} + 1")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${name}_${part}")
  endforeach()
endfunction()

function(kerf_library name)
  cmake_parse_arguments(arg "" "" "DEPENDS;PRIVATE_DEPENDS;PRECOMPILED" ${ARGN})
  set(target kerf_${name})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  add_library(${target} STATIC ${sources})
  add_library(kerf::${name} ALIAS ${target})
  # All of them become one library, which may be a shared one (KerfInstall), and shows what KERF_API marks.
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}" "${PROJECT_SOURCE_DIR}/include")
  target_link_libraries(${target} PUBLIC ${arg_DEPENDS}
    PRIVATE kerf_warnings ${arg_PRIVATE_DEPENDS})
  if(arg_PRECOMPILED)
    kerf_precompile(${target} ${arg_PRECOMPILED})
  endif()
  set_property(GLOBAL APPEND PROPERTY KERF_LIBRARIES ${target})
endfunction()

# What all tests are compiled with. Reading headers takes most of that time: it is done once, for all of them (kerf_test_headers).
function(kerf_test_options target)
  target_link_libraries(${target} PRIVATE kerf_warnings GTest::gtest_main Eigen3::Eigen tl::expected)
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}" "${PROJECT_SOURCE_DIR}/include")
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_compile_definitions(${target} PRIVATE KERF_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  # Quicker to build; it is the libraries that need to be fast.
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1> $<$<CONFIG:Debug>:-Og>)
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize" OR CMAKE_BUILD_TYPE STREQUAL "Debug")
    target_compile_definitions(${target} PRIVATE KERF_SLOW_BUILD)  # fewer random cases
  endif()
endfunction()

function(kerf_tests name)
  cmake_parse_arguments(arg "" "" "DEPENDS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  if(NOT sources)
    return()
  endif()
  add_executable(${name}_tests ${sources})
  kerf_unity(${name}_tests ${sources})
  target_link_libraries(${name}_tests PRIVATE ${arg_DEPENDS})
  kerf_test_options(${name}_tests)
  if(NOT TARGET kerf_test_headers)
    file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/test_headers.cpp" CONTENT "")
    add_library(kerf_test_headers OBJECT "${PROJECT_BINARY_DIR}/test_headers.cpp")
    kerf_test_options(kerf_test_headers)
    kerf_precompile(kerf_test_headers <algorithm> <array> <cmath> <cstdint> <fstream> <functional> <limits>
      <map> <memory> <optional> <random> <sstream> <string> <vector> <gtest/gtest.h> <kerf/kerf.hpp>
      "${PROJECT_SOURCE_DIR}/curves/curve.hpp")
  endif()
  kerf_precompile(${name}_tests REUSE_FROM kerf_test_headers)
  # Far beyond what a test takes: under a sanitizer, on a slow and busy machine, ten minutes are not.
  set(timeout_s 600)
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    set(timeout_s 1800)
  endif()
  gtest_discover_tests(${name}_tests NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT ${timeout_s})
endfunction()
