// Which pixels of a picture show the cloth? Most of a picture is the stage, so a part of all pixels says
// little about two cloths.
#pragma once
#include "picture/image.h"

// Wall, floor and shadow of the stage (common/picture/shaders.h) are bright and a little bluer than grey: red
// >= 120 and 3 <= blue − red <= 25, with green between. Cloth is red, blue, or a colour of the strain scale.
// rgb: the three bytes of a pixel. Pins, which are grey, count with the cloth where they are dark, as
// lettering does.
inline bool shows_cloth(const unsigned char* rgb) {
  const int red = rgb[0], green = rgb[1], blue = rgb[2];
  const bool is_grey = green >= red && green <= blue && blue - red >= 3 && blue - red <= 25;
  return !(is_grey && red >= 120);
}
