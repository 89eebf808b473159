# What every target of the project shares. A step includes this file whether it is built alone or from
# the top: whoever comes first adds the common libraries.
include_guard(GLOBAL)

# The programs, in the order of the lessons.
set(LARGE_STEPS_PROGRAMS step01_explicit step02_damping step03_implicit step04_cg step05_bend)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug or Release" FORCE)  # Eigen without -O is 20 times slower
endif()

option(LARGE_STEPS_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)

# A message that names the Debian package beats one that names a CMake variable.
macro(find_package_of debian_package)
  find_package(${ARGN} QUIET)
  if(NOT ${ARGV1}_FOUND)
    message(FATAL_ERROR "${ARGV1} was not found: sudo apt-get install ${debian_package}")
  endif()
endmacro()

# No contraction into fused multiply-adds: the same scene gives the same bytes with every compiler.
function(cloth_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wshadow -Wconversion
    -Wno-missing-field-initializers  # what a braced list leaves out has its default
    $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>  # g++'s -Wconversion does not ask for it either
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)  # false alarms in std::string of g++ 12
  target_include_directories(${target} PRIVATE ${LARGE_STEPS_COMMON})
  if(LARGE_STEPS_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all
      -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()

# A step: its program, which finds its scene in the step's own directory, and its pictures in the gallery.
function(add_step step)
  add_executable(${step} ${CMAKE_CURRENT_SOURCE_DIR}/main.cpp)
  cloth_target(${step})
  target_link_libraries(${step} PRIVATE cloth_explain)
  target_compile_definitions(${step} PRIVATE STEP_DIRECTORY="${CMAKE_CURRENT_SOURCE_DIR}")
  if(NOT TARGET gallery)
    add_custom_target(gallery)
  endif()
  add_custom_target(gallery_${step}
    COMMAND ${step} --out ${CMAKE_BINARY_DIR}/gallery/${step} USES_TERMINAL)
  add_dependencies(gallery gallery_${step})
endfunction()

set(LARGE_STEPS_VERSION 1.0)
get_filename_component(LARGE_STEPS_COMMON ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
add_subdirectory(${LARGE_STEPS_COMMON} ${CMAKE_BINARY_DIR}/common)
