# Installs a build to a folder of its own, builds the examples against what was installed there, and runs them.
#   cmake -D BUILD=... -D CHECKOUT=... -D WORK=... -D GENERATOR=... -D COMPILER=... -D FLAGS=... -D TYPE=... -P run.cmake
include("${CMAKE_CURRENT_LIST_DIR}/run_command.cmake")

set(prefix "${WORK}/installed")
file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")
foreach(project examples tests/embedding)
  run("${CMAKE_COMMAND}" -S "${CHECKOUT}/${project}" -B "${WORK}/${project}" ${example_options} -DCMAKE_DISABLE_FIND_PACKAGE_tomlplusplus=ON
    -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON "-DCMAKE_PREFIX_PATH=${prefix}")
endforeach()
run("${CMAKE_COMMAND}" --build "${WORK}/examples")

# example(NAME STATUS [ARGUMENT...]): its output, in `output`.
function(example name expected)
  execute_process(COMMAND "${WORK}/examples/${name}" ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT status EQUAL expected OR NOT errors STREQUAL "")
    message(FATAL_ERROR "${name} ended with ${status}: ${errors}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

example(dry_run 0)
# 30 mm, half a circle of 10 mm radius and 30 mm at 50 mm/s take 1.83 s without any ramp.
string(REGEX MATCHALL "\n" rows "${output}")
list(LENGTH rows count)
if(count LESS 1828 OR count GREATER 3000)
  message(FATAL_ERROR "dry_run printed ${count} setpoints")
endif()
if(NOT output MATCHES "\n[0-9]+,3,39[.][0-9]+,[0-9.]+,0[.]000000\n")
  message(FATAL_ERROR "no setpoint lies on the arc, right of x = 39:\n${output}")
endif()

# The same program, every tenth of a second or so.
example(two_threads 0)
if(NOT output MATCHES "39[.][0-9]+ +[0-9.]+ +0[.]000\n")
  message(FATAL_ERROR "two_threads was never on the arc, right of x = 39:\n${output}")
endif()

example(check 0 "${CHECKOUT}/programs/circle.ngc")
if(NOT output MATCHES "^x [0-9.-]+ to [0-9.]+ mm\ny [0-9.-]+ to [0-9.]+ mm\nz ")
  message(FATAL_ERROR "check printed\n${output}")
endif()
file(WRITE "${WORK}/wrong.ngc" "G1 X10 F-100\nM2\n")
example(check 1 "${WORK}/wrong.ngc")
if(NOT output MATCHES ":1:8: error: .*\\[E0120\\]")
  message(FATAL_ERROR "check printed\n${output}")
endif()
