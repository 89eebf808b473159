// What the fuzz targets share. A target has one function, LLVMFuzzerTestOneInput. libFuzzer calls it with inputs
// that it invents; replay.cpp calls it with the files of a corpus.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "scene/scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

// Prints what is false, and aborts: a find of the fuzzer.
void require(bool holds, std::string_view what);

// Writes a file for the readers, which take a path, and returns the path.
std::filesystem::path input_file(std::string_view name, std::string_view text);

// A scene and its files in one text: the scene, and for each file a line === NAME and its text. The files are
// mesh.obj, start.obj and velocities.csv, in this order. Returns the path of the scene.
std::filesystem::path input_scene(std::string_view text);

// Does the scene ask for more cells than a fuzzer has time for?
bool has_many_cells(const std::filesystem::path& scene, int most);

// A refusal is one line that names a file of the input.
void require_clear(const BadInput&);
