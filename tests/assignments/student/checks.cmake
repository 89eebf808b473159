# check(TASK FILE [libraries]): the program check_TASK, which checks one task. It compiles to be run once: with
# little optimisation. An index beyond the end of an array or of a matrix of Eigen stops it.
find_package_of(libgtest-dev GTest)
set(CHECKS ${CMAKE_CURRENT_LIST_DIR}/checks)
set(HAND_IN "" CACHE PATH "Of the grader: a directory for each task, with the files that it changes")

function(check_includes target)
  cloth_target(${target})
  target_compile_options(${target} PRIVATE -O0 -UNDEBUG -D_GLIBCXX_ASSERTIONS)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${target} PRIVATE Eigen3::Eigen GTest::gtest)
endfunction()

add_library(check_main OBJECT ${CHECKS}/main.cpp)
check_includes(check_main)

function(check task file)
  string(REPLACE "." "_" target check_${task})
  add_executable(${target} ${CHECKS}/${file} $<TARGET_OBJECTS:check_main>)
  check_includes(${target})
  if(HAND_IN)
    target_include_directories(${target} BEFORE PRIVATE ${HAND_IN}/${task}/common ${HAND_IN}/${task})
  endif()
  target_link_libraries(${target} PRIVATE ${ARGN})
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/checks)
endfunction()
