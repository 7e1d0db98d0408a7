# What is installed of the testbed, and a Debian package of all: `cpack -G DEB` in the build folder. The shaders are in
# the program.
install(TARGETS scree_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})

# The manual pages tell what --help tells, hence by the program itself.
set(SCREE_MANUAL ${PROJECT_BINARY_DIR}/testbed/man1)
add_custom_command(OUTPUT ${SCREE_MANUAL}/scree.1 COMMAND scree_cli man -o ${SCREE_MANUAL}
  DEPENDS scree_cli COMMENT "Writing the manual pages" VERBATIM)
add_custom_target(scree_manual ALL DEPENDS ${SCREE_MANUAL}/scree.1)
install(DIRECTORY ${SCREE_MANUAL} DESTINATION ${CMAKE_INSTALL_MANDIR})

# `scree env` says what lies beside the program.
set_property(SOURCE testbed/cli/command_env.cpp TARGET_DIRECTORY scree_testbed APPEND PROPERTY COMPILE_DEFINITIONS
  SCREE_INCLUDE_FOLDER="${CMAKE_INSTALL_INCLUDEDIR}" SCREE_MANUAL_FOLDER="${CMAKE_INSTALL_MANDIR}/man1")

set(CPACK_PACKAGE_NAME scree)
set(CPACK_PACKAGE_VENDOR "the Scree authors")
set(CPACK_PACKAGE_CONTACT "the Scree authors <scree@localhost>")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libosmesa6, libegl1, gnuplot-nox")
include(CPack)
