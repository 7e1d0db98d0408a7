# Writes OUTPUT, a header that names the commit of SOURCE; touches it only when that changes.
cmake_minimum_required(VERSION 3.25)
find_package(Git QUIET)
set(COMMIT "unknown")
if(GIT_EXECUTABLE)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
    OUTPUT_VARIABLE found ERROR_QUIET RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT failed)
    set(COMMIT "${found}")
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define SCREE_COMMIT \"@COMMIT@\"\n" @ONLY)
