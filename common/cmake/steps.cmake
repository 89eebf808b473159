# Settings and functions that all targets of the project share. A step includes this file before project(),
# both when it is built alone and when it is built from the top. The first step adds the common libraries.
include_guard(GLOBAL)

# If a tool is missing, project() stops with a message that names no package. So the
# tools are looked for first.
function(require_tool debian_package chosen)
  find_program(tool NAMES ${ARGN} NO_CACHE)
  if(NOT tool AND NOT chosen)
    list(GET ARGN 0 name)
    message(FATAL_ERROR "${name} was not found: sudo apt-get install ${debian_package}")
  endif()
endfunction()
if(CMAKE_GENERATOR MATCHES "Ninja")
  require_tool(ninja-build "${CMAKE_MAKE_PROGRAM}" ninja ninja-build samu)
elseif(CMAKE_GENERATOR MATCHES "Makefiles")
  require_tool(make "${CMAKE_MAKE_PROGRAM}" make gmake smake)
endif()
require_tool(g++ "${CMAKE_CXX_COMPILER}${CMAKE_TOOLCHAIN_FILE}$ENV{CXX}" g++ c++ clang++)

if(CMAKE_BINARY_DIR MATCHES "\"")
  message(FATAL_ERROR "CMake cannot build in a directory whose path contains a double quote: ${CMAKE_BINARY_DIR}")
endif()

# The programs, in the order of the lessons.
set(LARGE_STEPS_PROGRAMS step01_explicit step02_damping step03_implicit step04_cg step05_bend)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug or Release" FORCE)  # Eigen without -O is 20 times slower
endif()

# Compiles the files of a target as one: they share their instances of Eigen's templates. This halves the time.
option(CMAKE_UNITY_BUILD "Compile the files of a target in batches" ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 20 CACHE STRING "The most files in a batch")

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)  # for editors and clang-tidy

option(LARGE_STEPS_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(LARGE_STEPS_FUZZ "Build for libFuzzer, with clang++" OFF)

# Finds a package. If it is missing, the message names the Debian package, which helps more than a CMake
# variable: find_package_of(libeigen3-dev Eigen3 [AT_LEAST 3.4] [options of find_package]). A version that is
# given to find_package itself would also refuse the next major version.
macro(find_package_of debian_package package)
  cmake_parse_arguments(find "" "AT_LEAST" "" ${ARGN})
  find_package(${package} QUIET ${find_UNPARSED_ARGUMENTS})
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "${package} was not found: sudo apt-get install ${debian_package}")
  elseif(find_AT_LEAST AND ${package}_VERSION VERSION_LESS find_AT_LEAST)
    message(FATAL_ERROR "${package} ${find_AT_LEAST} or newer is needed. Version ${${package}_VERSION} was found in "
      "${${package}_DIR}: sudo apt-get install ${debian_package}, or -D${package}_DIR=… to choose another one")
  endif()
endmacro()

# -ffp-contract=off forbids fused multiply-adds: with the same Eigen, the same scene gives the same positions
# to the last bit with every compiler. -fno-math-errno: no square root sets errno; so an energy does not
# compute the gradients that it does not use.
function(cloth_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -ffp-contract=off -fno-math-errno -Wall -Wextra -Wshadow -Wconversion
    -Wno-missing-field-initializers  # members that a braced list leaves out have their defaults
    $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>  # g++'s -Wconversion does not include it either
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # false alarms in std::string of g++ 12
    # g++ keeps its garbage below 4 GB: an eighth less time, and a fifth more memory.
    $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=4000000>)
  target_include_directories(${target} PRIVATE ${LARGE_STEPS_COMMON})
  if(LARGE_STEPS_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    target_link_options(${target} PUBLIC -fsanitize=fuzzer-no-link)
  endif()
  if(LARGE_STEPS_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all
      -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
    # With its checks, the flattened function of step 5 would compile for ten minutes: no attribute flatten here.
    target_compile_definitions(${target} PRIVATE flatten=unused)
  endif()
endfunction()

# g++ limits how much a file may grow by inlining. The forces of a step, with the conditions of every term, are
# beyond that limit: with it, the assembly of steps 3 and 4 takes a third longer.
function(inline_as_a_step target)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=inline-unit-growth=400>)
endfunction()

# Defines NAME for the compiler as a string that holds a path. It is a raw string,
# because a path may have quotes.
function(define_path target name path)
  target_compile_definitions(${target} PRIVATE "${name}=R\"path(${path})path\"")
endfunction()

# The gallery's runs write films for its page, and meshes: so the page can say how far two cloths are apart.
set(LARGE_STEPS_GALLERY_OPTIONS --motion --export obj)

# A step: its program, which finds its scene in the step's own directory, and its pictures in the gallery.
function(add_step step)
  if(NOT TARGET cloth_explain)
    add_subdirectory(${LARGE_STEPS_COMMON} ${CMAKE_BINARY_DIR}/common)
  endif()
  add_executable(${step} ${CMAKE_CURRENT_SOURCE_DIR}/main.cpp)
  cloth_target(${step})
  inline_as_a_step(${step})
  set_target_properties(${step} PROPERTIES UNITY_BUILD OFF)
  target_link_libraries(${step} PRIVATE cloth_explain)
  define_path(${step} STEP_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  if(NOT TARGET gallery)
    add_custom_target(gallery)
  endif()
  add_custom_target(gallery_${step}
    COMMAND ${step} --out ${CMAKE_BINARY_DIR}/gallery/${step} ${LARGE_STEPS_GALLERY_OPTIONS} USES_TERMINAL VERBATIM)
  add_dependencies(gallery gallery_${step})
endfunction()

set(LARGE_STEPS_VERSION 1.0)
get_filename_component(LARGE_STEPS_COMMON ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
