// Draws a cloth in a photographer's studio: the same light for every frame, so that frames can be
// compared. A picture depends on the arguments of draw alone, not on earlier pictures.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "math/types.h"
#include "picture/image.h"

struct Surface {  // the same in all frames
  std::vector<Face> faces;
  // m, per face corner: where the corner lies on the flat cloth; the checker is drawn in these.
  std::vector<std::array<Vec2, 3>> texture;
  double checker = 0.1;   // m, side of a square of the checker
  std::vector<int> pins;  // vertices marked with a sphere
};

struct Stage {  // m; y is up. The camera sees 35 degrees from the lower to the upper border.
  Vec3 eye, target;
  double ground;  // height of the floor
  double size;    // the scene's typical length: scales pins, floor grid and shadows
};

struct Style {
  int width = 1280, height = 720;  // pixels
  int supersampling = 3;           // every pixel is the mean of 3 × 3
  bool wireframe = false;          // readable up to about 40 × 40 cells
  // The strain at the end of the colour scale; absent: the checker is drawn.
  std::optional<double> strain_scale = {};
};

// Throws std::invalid_argument for a picture that no Renderer can draw with 3 × 3 supersampling.
// Call it before a long simulation.
void check_size(int width, int height);

class Renderer {
 public:
  explicit Renderer(Surface surface);
  ~Renderer();

  // x: m, three numbers per vertex; strain: one number >= 0 per vertex, for style.strain_scale.
  // Throws std::invalid_argument where they cannot be drawn, e.g. "vertex 12 is not finite".
  Image draw(const Stage& stage, const VecX& x, const Style& style, const VecX& strain = VecX());

  std::string description() const;  // of the OpenGL that draws

 private:
  struct Parts;
  std::unique_ptr<Parts> parts;
};
