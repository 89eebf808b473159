// Are two pictures the same? Numbers and a verdict.
#pragma once
#include <string>

#include "picture/image.h"

struct Difference {
  long pixels = 0;
  int largest = 0;                          // difference of any channel, of 255
  double rmse = 0;                          // over all channels, of 255
  long above0 = 0, above2 = 0, above8 = 0;  // pixels whose largest channel differs by more
  // Pixels above 2 in the square of 16 × 16 that has the most: few where noise is scattered, many where
  // an edge has moved.
  int window = 0;
  // The box around the pixels above 8, empty if right < left, and their mean position.
  int left = 0, top = 0, right = -1, bottom = -1;
  double centre_x = 0, centre_y = 0;
};

enum class Verdict { IDENTICAL, EQUIVALENT, DIFFERENT };

// The largest difference of a channel; a and b: the three bytes of a pixel.
int pixel_difference(const unsigned char* a, const unsigned char* b);

// Throws std::invalid_argument where the sizes differ.
Difference compare(const Image& a, const Image& b);

Verdict verdict(const Difference& difference);

// One line: verdict, then the numbers.
std::string describe(const Difference& difference);

// The first picture in pale grey; pale blue where the second differs by 1 or 2, orange to dark red
// where by more.
Image difference_picture(const Image& a, const Image& b);
