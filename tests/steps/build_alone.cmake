# A step builds alone, and the project from the top has it as a target. -O0: compiling is the cost here.
#   cmake -DSOURCE=… -DSTEP=step01_explicit -DCOMPILER=… -DGENERATOR=… -DDIRECTORY=… -P build_alone.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(options -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0)
file(REMOVE_RECURSE ${DIRECTORY})
run(${CMAKE_COMMAND} -S ${SOURCE}/${STEP} -B ${DIRECTORY}/alone ${options})
# Its libraries are those that it is linked with from the top.
run(${CMAKE_COMMAND} --build ${DIRECTORY}/alone --target CMakeFiles/${STEP}.dir/main.cpp.o)

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${DIRECTORY}/top ${options} -DLARGE_STEPS_TESTS=OFF)
run(${CMAKE_COMMAND} --build ${DIRECTORY}/top --target help)
if(NOT output MATCHES "${STEP}")
  message(FATAL_ERROR "from the top there is no target ${STEP}:\n${output}")
endif()
file(REMOVE_RECURSE ${DIRECTORY})
