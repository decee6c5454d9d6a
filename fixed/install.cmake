# What `cmake --install` copies: the headers, and how find_package and pkg-config find them. There is
# nothing of one processor in it, so all of it lies under include/ and share/. It may be moved afterwards.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

install(DIRECTORY ${CMAKE_CURRENT_LIST_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fixproof/fixed
  FILES_MATCHING PATTERN "*.hpp")
if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/../LICENSE)  # not where only this folder was copied
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/../LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/licenses/fixproof)
endif()

set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/fixproof)
install(TARGETS fixproof_fixed EXPORT fixproof INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fixproof)
install(EXPORT fixproof FILE fixproof-config.cmake NAMESPACE fixproof:: DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/fixproof-config-version.cmake
  COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/fixproof-config-version.cmake DESTINATION ${package_dir})

file(RELATIVE_PATH include_from_pc
  ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig ${CMAKE_INSTALL_FULL_INCLUDEDIR})
configure_file(${CMAKE_CURRENT_LIST_DIR}/fixproof.pc.in ${CMAKE_CURRENT_BINARY_DIR}/fixproof.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/fixproof.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig)
