# The program compare_runs, and what compares runs. The copies that tests/assignments hands out have it as well.
find_package_of(libcli11-dev CLI11)
find_package_of(libtomlplusplus-dev tomlplusplus)
find_package_of(nlohmann-json3-dev nlohmann_json)
set(here ${CMAKE_CURRENT_LIST_DIR})
add_library(runs_comparison STATIC
  ${here}/run_directory.cpp ${here}/comparison.cpp ${here}/comparison_text.cpp ${here}/contact_sheet.cpp
  ${here}/sheet_of_runs.cpp ${here}/report_json.cpp ${here}/page.cpp ${here}/report_page.cpp)
cloth_target(runs_comparison)
set_source_files_properties(${here}/report_json.cpp PROPERTIES
  COMPILE_OPTIONS $<$<CONFIG:Release>:-O0>)  # compiling is the cost
target_include_directories(runs_comparison PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(runs_comparison PUBLIC cloth_image cloth_scene Eigen3::Eigen PRIVATE
  nlohmann_json::nlohmann_json tomlplusplus::tomlplusplus)
define_path(runs_comparison PROGRAM_DIRECTORY ${PROJECT_BINARY_DIR})
define_path(runs_comparison PAGE_DIRECTORY ${here}/page)

add_executable(compare_runs ${here}/compare_runs.cpp)
cloth_target(compare_runs)
target_compile_options(compare_runs PRIVATE $<$<CONFIG:Release>:-O0>)  # compiling is the cost
target_link_libraries(compare_runs PRIVATE runs_comparison cloth_text CLI11::CLI11)
