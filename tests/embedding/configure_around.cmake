# Configures the examples with this checkout as a folder of its own.
#   cmake -D CHECKOUT=... -D WORK=... -D GENERATOR=... -D COMPILER=... -D FLAGS=... -D TYPE=... -P configure_around.cmake
include("${CMAKE_CURRENT_LIST_DIR}/run_command.cmake")
file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" -S "${CHECKOUT}/examples" -B "${WORK}" ${example_options} "-DKERF_CHECKOUT=${CHECKOUT}")
