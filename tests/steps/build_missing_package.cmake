# Where a package is missing, configuring ends with one error that names the Debian package.
#   cmake -DSOURCE=… -DHIDDEN=CLI11 -DDEBIAN=libcli11-dev -DCOMPILER=… -DGENERATOR=… -DDIRECTORY=…
#     [-DOPTIONS=…] -P build_missing_package.cmake
file(REMOVE_RECURSE ${DIRECTORY})
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${DIRECTORY} -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_DISABLE_FIND_PACKAGE_${HIDDEN}=ON ${OPTIONS}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
file(REMOVE_RECURSE ${DIRECTORY})
if(result EQUAL 0)
  message(FATAL_ERROR "configured without ${HIDDEN}:\n${output}")
endif()
string(REGEX MATCHALL "CMake Error" errors "${output}")
list(LENGTH errors count)
if(NOT count EQUAL 1 OR NOT output MATCHES "apt(-get)? install [^\n]*${DEBIAN}")
  message(FATAL_ERROR "without ${HIDDEN}, not one error with ${DEBIAN} in it:\n${output}")
endif()
