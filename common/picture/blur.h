// Softens a mask: what makes a shadow look like one of a large lamp.
#pragma once
#include <vector>

// Three means over 2 radius + 1 pixels along x and along y come close to a Gaussian. The mask is
// square; beyond its border it is empty.
void blur(std::vector<unsigned char>& mask, int side, int radius);
