// Does a grid fit into the memory of this machine? To be asked before the grid is allocated.
#pragma once
#include <array>
#include <optional>
#include <string>

// Bytes that a scene with this grid takes before a solver adds its own.
double bytes_of_grid(const std::array<int, 2>& cells);

// Why a grid is too large: the memory that it needs, and the memory of the machine. Nothing where
// it fits.
std::optional<std::string> too_large(const std::array<int, 2>& cells);
