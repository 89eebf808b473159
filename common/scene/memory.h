// Whether a grid fits into this machine, asked before anything of it is allocated.
#pragma once
#include <array>
#include <optional>
#include <string>

// Bytes that a scene with this grid takes before a solver adds its own.
double bytes_of_grid(const std::array<int, 2>& cells);

// Why a grid is too large: what it would need and what there is; nothing where it fits.
std::optional<std::string> too_large(const std::array<int, 2>& cells);
