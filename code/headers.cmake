# The headers of code/integrate and code/shelf as a target of other projects, one-step-at-a-time::integrate, and as a package
# that `cmake --install` puts somewhere. They need nothing; the three that solve with Eigen (band_system.h, dense_system.h and
# sparse_system.h) take the Eigen that the other project has.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(name one-step-at-a-time)
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/${name})
set(package ${CMAKE_INSTALL_DATADIR}/cmake/${name})

add_library(${name}-integrate INTERFACE)
add_library(${name}::integrate ALIAS ${name}-integrate)
target_compile_features(${name}-integrate INTERFACE cxx_std_17)
target_include_directories(${name}-integrate INTERFACE
  $<BUILD_INTERFACE:${CMAKE_CURRENT_LIST_DIR}> $<INSTALL_INTERFACE:${headers}>)
set_target_properties(${name}-integrate PROPERTIES EXPORT_NAME integrate)

if(PROJECT_IS_TOP_LEVEL)
  install(DIRECTORY ${CMAKE_CURRENT_LIST_DIR}/integrate ${CMAKE_CURRENT_LIST_DIR}/shelf DESTINATION ${headers} FILES_MATCHING PATTERN "*.h")
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${headers})
  install(TARGETS ${name}-integrate EXPORT ${name})
  install(EXPORT ${name} DESTINATION ${package} NAMESPACE ${name}:: FILE ${name}-config.cmake)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/${name}-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
  install(FILES ${PROJECT_BINARY_DIR}/${name}-config-version.cmake DESTINATION ${package})
endif()
