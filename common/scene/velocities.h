// Velocities as a table: the header vx,vy,vz and a row per vertex, m/s. Together with an OBJ
// file of the positions it restarts a run.
#pragma once
#include <filesystem>

#include "math/types.h"

// 17 significant digits; throws std::runtime_error like write_text.
void write_velocities(const std::filesystem::path&, const VecX& v);

// Throws BadInput, naming file and line, where a row is not three numbers or the number of rows is
// not the number of vertices.
VecX read_velocities(const std::filesystem::path&, int vertices);
