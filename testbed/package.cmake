# What is installed of the testbed. The shaders are in the program.
install(TARGETS scree_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)

# The licence of what else is in the program asks to be beside it.
install(FILES testbed/picture/font_licence.txt DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# The manual pages tell what --help tells, hence by the program itself.
set(SCREE_MANUAL ${PROJECT_BINARY_DIR}/testbed/man1)
add_custom_command(OUTPUT ${SCREE_MANUAL}/scree.1 COMMAND scree_cli man -o ${SCREE_MANUAL}
  DEPENDS scree_cli COMMENT "Writing the manual pages" VERBATIM)
add_custom_target(scree_manual ALL DEPENDS ${SCREE_MANUAL}/scree.1)
install(DIRECTORY ${SCREE_MANUAL} DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program)

# `scree env` says what lies beside the program.
set_property(SOURCE testbed/cli/command_env.cpp TARGET_DIRECTORY scree_testbed APPEND PROPERTY COMPILE_DEFINITIONS
  SCREE_INCLUDE_FOLDER="${CMAKE_INSTALL_INCLUDEDIR}" SCREE_MANUAL_FOLDER="${CMAKE_INSTALL_MANDIR}/man1")
