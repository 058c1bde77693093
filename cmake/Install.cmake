# SPDX-License-Identifier: BSD-3-Clause

include(CMakePackageConfigHelpers)
set(package_dir lib/cmake/Latchwork)
configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/LatchworkConfig.cmake.in ${PROJECT_BINARY_DIR}/LatchworkConfig.cmake
  INSTALL_DESTINATION ${package_dir})
# Before 1.0 the interface of plugins may change with every minor version.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/LatchworkConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)

install(TARGETS latchwork latchwork_sdk EXPORT LatchworkTargets
        LIBRARY DESTINATION lib COMPONENT runtime)
install(TARGETS latchwork_xml LIBRARY DESTINATION lib COMPONENT runtime)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/include/ DESTINATION include COMPONENT sdk)
install(EXPORT LatchworkTargets NAMESPACE Latchwork:: DESTINATION ${package_dir} COMPONENT sdk)
install(FILES ${PROJECT_BINARY_DIR}/LatchworkConfig.cmake
              ${PROJECT_BINARY_DIR}/LatchworkConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/LatchworkPlugin.cmake
        DESTINATION ${package_dir} COMPONENT sdk)
