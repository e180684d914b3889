# cmake --install: headers, one static library per layer, and a package for find_package(carom).
include(CMakePackageConfigHelpers)
install(TARGETS carom_flags EXPORT carom)
install(EXPORT carom NAMESPACE carom:: FILE caromTargets.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/carom)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/caromConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/caromConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/carom)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/caromConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/caromConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/caromConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/carom)
