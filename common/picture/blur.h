// Softens a mask, so that a shadow looks like the shadow of a large lamp.
#pragma once
#include <vector>

// Three means over 2 radius + 1 pixels along x and along y come close to a Gaussian. The mask is
// square; beyond its border it is empty.
void blur(std::vector<unsigned char>& mask, int side, int radius);
