// Lettering on a finished picture.
#pragma once
#include <string_view>

#include "picture/image.h"

// (x, y): the upper left corner of the first capital; height: of a capital. All in pixels.
// Characters outside printable ASCII become '?'.
void draw_text(Image& image, double x, double y, double height, std::string_view text,
               Colour colour);
double text_width(double height, std::string_view text);

// Upper left: a title, and a smaller line of numbers.
void draw_caption(Image& image, std::string_view title, std::string_view line);

// Right: the colours of a strain map, from 0 to the strain at the end of the scale.
void draw_legend(Image& image, double strain_scale);
