// Checks of everything that a Renderer draws: each throws std::invalid_argument, one line with
// numbers.
#pragma once
#include "picture/renderer.h"

void check_surface(const Surface& surface);
void check_stage(const Stage& stage);
void check_style(const Style& style, int largest_side);
void check_vertices(const Surface& surface, const VecX& x);
void check_strain(const VecX& strain, const VecX& x);
