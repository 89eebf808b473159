# Programs from copies of headers, with a piece of text cut out. The copies lie in
# <build>/tests/absent/cut/PROGRAM, which comes before common/ and the top in the include path. If the piece is
# not found, configuring fails. After an edit of the original, CMake cuts again.

# The text of FILE with the cuts of PROGRAM so far. FILE, or the file that FROM names, lies below common/
# or below the top directory.
function(cut_text program file from result)
  get_property(known GLOBAL PROPERTY cut_${program}_${file} SET)
  if(NOT known)
    set(source ${LARGE_STEPS_COMMON}/${from})
    if(NOT EXISTS ${source})
      set(source ${PROJECT_SOURCE_DIR}/${from})
    endif()
    file(READ ${source} text)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    set_property(GLOBAL APPEND PROPERTY cut_${program} ${file})
    set_property(GLOBAL PROPERTY cut_${program}_${file} "${text}")
  endif()
  get_property(text GLOBAL PROPERTY cut_${program}_${file})
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

# cut(PROGRAM FILE text [WITH text] [TIMES n] [FROM file]): removes the text from FILE, or replaces it. The
# text must occur n times, by default once.
function(cut program file piece)
  cmake_parse_arguments(PARSE_ARGV 3 ARG "" "WITH;TIMES;FROM" "")
  if(NOT ARG_TIMES)
    set(ARG_TIMES 1)
  endif()
  if(NOT ARG_FROM)
    set(ARG_FROM ${file})
  endif()
  cut_text(${program} ${file} ${ARG_FROM} text)
  string(REPLACE "${piece}" "" rest "${text}")
  string(LENGTH "${text}" whole)
  string(LENGTH "${rest}" left)
  string(LENGTH "${piece}" one)
  math(EXPR found "(${whole} - ${left}) / ${one}")
  if(NOT found EQUAL ARG_TIMES)
    message(FATAL_ERROR "${program}: to be cut from ${ARG_FROM}, ${ARG_TIMES} times, but found ${found} times:\n"
      "${piece}\nSay in tests/absent/CMakeLists.txt where this code stands now.")
  endif()
  string(REPLACE "${piece}" "${ARG_WITH}" text "${text}")
  set_property(GLOBAL PROPERTY cut_${program}_${file} "${text}")
endfunction()

# Writes the copies. A copy that does not change keeps its time, so that nothing is compiled again.
function(write_cuts program)
  get_property(files GLOBAL PROPERTY cut_${program})
  foreach(file IN LISTS files)
    get_property(text GLOBAL PROPERTY cut_${program}_${file})
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/cut/${program}/${file} CONTENT "${text}" @ONLY)
  endforeach()
endfunction()
