# The library: what a program that embeds Kerf links and includes. find_package(kerf) or pkg-config, the target kerf::kerf,
# #include <kerf/kerf.hpp>. All folders become one library, static, or shared with BUILD_SHARED_LIBS; only include/kerf is installed.
option(KERF_INSTALL "Install the library" ${PROJECT_IS_TOP_LEVEL})

get_property(folders GLOBAL PROPERTY KERF_LIBRARIES)
set(objects)
foreach(folder IN LISTS folders)
  list(APPEND objects $<TARGET_OBJECTS:${folder}>)
endforeach()
add_library(kerf_front ${objects})
add_library(kerf::kerf ALIAS kerf_front)
set_target_properties(kerf_front PROPERTIES OUTPUT_NAME kerf EXPORT_NAME kerf LINKER_LANGUAGE CXX
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_compile_features(kerf_front PUBLIC cxx_std_20)
target_link_libraries(kerf_front PUBLIC tl::expected)
target_include_directories(kerf_front PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)

if(NOT KERF_INSTALL)
  return()
endif()

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/kerf")

install(TARGETS kerf_front EXPORT kerf)
install(EXPORT kerf NAMESPACE kerf:: FILE kerfTargets.cmake DESTINATION "${package_folder}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/kerf" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/programs/machines" DESTINATION "${CMAKE_INSTALL_DATADIR}/kerf" FILES_MATCHING PATTERN "*.toml")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/kerfConfig.cmake.in" "${PROJECT_BINARY_DIR}/kerfConfig.cmake"
  INSTALL_DESTINATION "${package_folder}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/kerfConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/kerfConfig.cmake" "${PROJECT_BINARY_DIR}/kerfConfigVersion.cmake"
  DESTINATION "${package_folder}")
file(RELATIVE_PATH includes_from_pkgconfig "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/${CMAKE_INSTALL_INCLUDEDIR}")
configure_file("${PROJECT_SOURCE_DIR}/cmake/kerf.pc.in" "${PROJECT_BINARY_DIR}/kerf.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/kerf.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
