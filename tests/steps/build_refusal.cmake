# Configuring ends with one error, whose text (with single spaces instead of line breaks) matches EXPECTED.
#   cmake -DSOURCE=… -DOPTIONS="…;…" -DEXPECTED="apt-get install .*libcli11-dev" -DDIRECTORY=… -P build_refusal.cmake
file(REMOVE_RECURSE "${DIRECTORY}")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B "${DIRECTORY}" ${OPTIONS}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
file(REMOVE_RECURSE "${DIRECTORY}")
if(result EQUAL 0)
  message(FATAL_ERROR "configured with ${OPTIONS}:\n${output}")
endif()
string(REGEX MATCHALL "CMake Error" errors "${output}")
list(LENGTH errors count)
string(REGEX REPLACE "[ \n]+" " " text "${output}")
if(NOT count EQUAL 1 OR NOT text MATCHES "${EXPECTED}")
  message(FATAL_ERROR "with ${OPTIONS}, not one error with ${EXPECTED} in it:\n${output}")
endif()
