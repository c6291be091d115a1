# Installs a build to a folder of its own, builds the example against what was installed there, and runs it.
#   cmake -D BUILD=... -D SOURCE=... -D WORK=... -D GENERATOR=... -D COMPILER=... -D FLAGS=... -D TYPE=... -P run.cmake
include("${CMAKE_CURRENT_LIST_DIR}/run_command.cmake")

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/installed")
run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${WORK}/build" ${example_options} -DCMAKE_DISABLE_FIND_PACKAGE_tomlplusplus=ON
  "-DCMAKE_PREFIX_PATH=${WORK}/installed")
run("${CMAKE_COMMAND}" --build "${WORK}/build")

execute_process(COMMAND "${WORK}/build/embedding" RESULT_VARIABLE status OUTPUT_VARIABLE ticks ERROR_VARIABLE errors)
if(NOT status EQUAL 0 OR NOT errors STREQUAL "")
  message(FATAL_ERROR "the example ended with ${status}: ${errors}")
endif()
# 30 mm, half a circle of 10 mm radius and 30 mm at 50 mm/s take 1.83 s without any ramp.
string(REGEX MATCHALL "\n" rows "${ticks}")
list(LENGTH rows count)
if(count LESS 1828 OR count GREATER 3000)
  message(FATAL_ERROR "the example printed ${count} setpoints")
endif()
if(NOT ticks MATCHES "\n[0-9]+,3,39[.][0-9]+,[0-9.]+,0[.]000000\n")
  message(FATAL_ERROR "no setpoint lies on the arc, right of x = 39:\n${ticks}")
endif()
message("${count} setpoints")
