// OpenGL's objects, freed when they leave scope. A context must be current throughout.
#pragma once
#include <array>
#include <Eigen/Dense>
#include <span>
#include <string>
#include <vector>

#include "picture/image.h"

// The name of one object, and the function that frees it.
class GlName {
 public:
  using Free = void (*)(unsigned);
  GlName(unsigned owned, Free release) : name(owned), free(release) {}
  GlName(const GlName&) = delete;
  GlName& operator=(const GlName&) = delete;
  ~GlName() { free(name); }
  operator unsigned() const { return name; }

 private:
  unsigned name;
  Free free;
};

class GlProgram {
 public:
  // Throws with the compiler's log and the numbered source if GLSL refuses it.
  GlProgram(const std::string& vertex_source, const std::string& fragment_source);
  void use() const;
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const Eigen::Vector2f& value) const;
  void set(const char* uniform, const Eigen::Vector3f& value) const;
  void set(const char* uniform, const Eigen::Matrix4f& value) const;
  void set(const char* uniform, std::span<const std::array<float, 3>> values) const;

 private:
  int location(const char* uniform) const;
  GlName program;
};

// Vertices in one buffer of floats. The attributes 0, 1, … of a program read them.
class GlVertices {
 public:
  // sizes: numbers per attribute. per_instance: one vertex for each copy that is drawn.
  GlVertices(const std::vector<int>& sizes, bool per_instance = false);
  void upload(std::span<const float> numbers);
  void bind() const;

 private:
  GlName array, buffer;
};

// One picture in the graphics memory and, if wanted, a depth for each of its pixels.
class GlFramebuffer {
 public:
  enum class Kind { COLOUR_AND_DEPTH, MASK, SHADOW };  // 8-bit RGB; one byte; 24-bit depth only
  GlFramebuffer(Kind what, int wide, int high);
  void bind() const;  // from now on drawing goes here, to all of the picture
  void bind_texture(int unit) const;
  std::vector<unsigned char> bytes() const;  // the pixels, bottom row first
  void upload(std::span<const unsigned char> mask) const;

 private:
  Kind kind;
  int width, height;
  GlName framebuffer, texture, depth;
};

// The largest width and height that a framebuffer may have.
int largest_framebuffer_side();
