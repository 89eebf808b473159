// The film of a run as one picture: its frames side by side, in reading order.
#pragma once
#include <vector>

#include "picture/image.h"

// The frames must be of one size. The sheet is about 1290 pixels wide; frames are never enlarged.
Image film_strip(const std::vector<Image>& frames, int columns);
