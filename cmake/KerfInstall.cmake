# What a program that embeds Kerf uses: find_package(kerf), the target kerf::kerf, #include <kerf/kerf.hpp>.
# The target kerf::kerf and its header are there inside the build too, for add_subdirectory().
#
# Headers go to include/kerf/FOLDER/..., so inside them "FOLDER/..." is found as in the checkout.
option(KERF_INSTALL "Install the library" ${PROJECT_IS_TOP_LEVEL})

add_library(kerf_front INTERFACE)
add_library(kerf::kerf ALIAS kerf_front)
set_target_properties(kerf_front PROPERTIES EXPORT_NAME kerf)
target_link_libraries(kerf_front INTERFACE kerf::kernel)
target_include_directories(kerf_front INTERFACE
  $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:include>)
set(front_header "${PROJECT_BINARY_DIR}/include/kerf/kerf.hpp")
file(CONFIGURE OUTPUT "${front_header}" CONTENT "#pragma once\n\n#include \"kernel/kerf.hpp\"\n")

if(NOT KERF_INSTALL)
  return()
endif()

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/kerf")

get_property(libraries GLOBAL PROPERTY KERF_LIBRARIES)
install(TARGETS ${libraries} kerf_front EXPORT kerf ARCHIVE)
install(EXPORT kerf NAMESPACE kerf:: FILE kerfTargets.cmake DESTINATION "${package_folder}")

foreach(folder profiles curves interp machine diagnostics parser smoothing lookahead kernel)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/${folder}" DESTINATION include/kerf FILES_MATCHING PATTERN "*.hpp"
    PATTERN "machine_file_reader.hpp" EXCLUDE)  # toml++ is compiled into the kernel, and nobody else needs it
endforeach()
install(FILES "${front_header}" DESTINATION include/kerf)

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/kerfConfig.cmake.in" "${PROJECT_BINARY_DIR}/kerfConfig.cmake"
  INSTALL_DESTINATION "${package_folder}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/kerfConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/kerfConfig.cmake" "${PROJECT_BINARY_DIR}/kerfConfigVersion.cmake"
  DESTINATION "${package_folder}")
