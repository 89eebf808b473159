// Shrinking a picture: every new pixel is the mean light of the area it covers.
#pragma once
#include "picture/image.h"

// Never enlarges: width and height are at most the image's own. Exact integer arithmetic, so the
// result is the same on every machine.
Image box_reduce(const Image& image, int width, int height);
