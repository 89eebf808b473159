#include "picture/gl_objects.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "picture/gl_api.h"

namespace {

template <class Create>
unsigned created(Create create) {
  unsigned name = 0;
  create(1, &name);
  return name;
}

std::string numbered(const std::string& source) {
  std::istringstream lines(source);
  std::string result, line;
  for (int number = 1; std::getline(lines, line); ++number)
    result += std::to_string(number) + ": " + line + "\n";
  return result;
}

unsigned compiled(GLenum stage, const std::string& source) {
  const unsigned shader = glCreateShader(stage);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  int ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  char log[2000] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  glDeleteShader(shader);
  throw std::runtime_error("GLSL: " + std::string(log) + numbered(source));
}

unsigned linked(const std::string& vertex_source, const std::string& fragment_source) {
  const GlName vertex(compiled(GL_VERTEX_SHADER, vertex_source), glDeleteShader);
  const GlName fragment(compiled(GL_FRAGMENT_SHADER, fragment_source), glDeleteShader);
  const unsigned program = glCreateProgram();
  glAttachShader(program, vertex);
  glAttachShader(program, fragment);
  glLinkProgram(program);
  int ok = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  if (ok) return program;
  char log[2000] = "";
  glGetProgramInfoLog(program, sizeof log, nullptr, log);
  glDeleteProgram(program);
  throw std::runtime_error("GLSL: " + std::string(log));
}

const void* offset(int floats) {
  return reinterpret_cast<const void*>(static_cast<std::size_t>(floats) * sizeof(float));
}

GLsizeiptr byte_count(std::span<const float> numbers) {
  return static_cast<GLsizeiptr>(numbers.size_bytes());
}

void free_vertex_array(unsigned name) {
  glDeleteVertexArrays(1, &name);
}
void free_buffer(unsigned name) {
  glDeleteBuffers(1, &name);
}
void free_texture(unsigned name) {
  glDeleteTextures(1, &name);
}
void free_framebuffer(unsigned name) {
  glDeleteFramebuffers(1, &name);
}
void free_renderbuffer(unsigned name) {
  glDeleteRenderbuffers(1, &name);
}

}  // namespace

GlProgram::GlProgram(const std::string& vertex_source, const std::string& fragment_source)
    : program(linked(vertex_source, fragment_source), glDeleteProgram) {}

void GlProgram::use() const {
  glUseProgram(program);
}

int GlProgram::location(const char* uniform) const {
  return glGetUniformLocation(program, uniform);
}
void GlProgram::set(const char* uniform, int value) const {
  glUniform1i(location(uniform), value);
}
void GlProgram::set(const char* uniform, float value) const {
  glUniform1f(location(uniform), value);
}
void GlProgram::set(const char* uniform, const Eigen::Vector2f& value) const {
  glUniform2fv(location(uniform), 1, value.data());
}
void GlProgram::set(const char* uniform, const Eigen::Vector3f& value) const {
  glUniform3fv(location(uniform), 1, value.data());
}
void GlProgram::set(const char* uniform, const Eigen::Matrix4f& value) const {
  glUniformMatrix4fv(location(uniform), 1, GL_FALSE, value.data());
}
void GlProgram::set(const char* uniform, std::span<const std::array<float, 3>> values) const {
  glUniform3fv(location(uniform), static_cast<int>(values.size()), values.front().data());
}

GlVertices::GlVertices(const std::vector<int>& sizes, bool per_instance)
    : array(created(glGenVertexArrays), free_vertex_array),
      buffer(created(glGenBuffers), free_buffer) {
  bind();
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  int floats = 0;
  for (const int size : sizes) floats += size;
  int before = 0;
  for (unsigned i = 0; i < sizes.size(); ++i) {
    glEnableVertexAttribArray(i);
    glVertexAttribPointer(i, sizes[i], GL_FLOAT, GL_FALSE, floats * static_cast<int>(sizeof(float)),
                          offset(before));
    glVertexAttribDivisor(i, per_instance ? 1 : 0);
    before += sizes[i];
  }
}

void GlVertices::upload(std::span<const float> numbers) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, byte_count(numbers), numbers.data(), GL_STREAM_DRAW);
}

void GlVertices::bind() const {
  glBindVertexArray(array);
}

GlFramebuffer::GlFramebuffer(Kind what, int wide, int high)
    : kind(what), width(wide), height(high),
      framebuffer(created(glGenFramebuffers), free_framebuffer),
      texture(created(glGenTextures), free_texture),
      depth(created(glGenRenderbuffers), free_renderbuffer) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  if (kind == Kind::SHADOW) {
    const std::array<float, 4> far = {1, 1, 1, 1};  // nothing outside the map casts a shadow
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, far.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, width, height, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT, nullptr);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  } else {
    const bool mask = kind == Kind::MASK;
    glTexImage2D(GL_TEXTURE_2D, 0, mask ? GL_R8 : GL_RGBA8, width, height, 0,
                 mask ? GL_RED : GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  }
  if (kind == Kind::COLOUR_AND_DEPTH) {
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  }
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("OpenGL has no room for a picture of " + std::to_string(width) + "x" +
                             std::to_string(height));
}

void GlFramebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, height);
}

void GlFramebuffer::bind_texture(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

std::vector<unsigned char> GlFramebuffer::bytes() const {
  const bool mask = kind == Kind::MASK;
  std::vector<unsigned char> result(static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(height) * (mask ? 1 : 3));
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, mask ? GL_RED : GL_RGB, GL_UNSIGNED_BYTE, result.data());
  return result;
}

void GlFramebuffer::upload(std::span<const unsigned char> mask) const {
  bind_texture(0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RED, GL_UNSIGNED_BYTE, mask.data());
}

int largest_framebuffer_side() {
  int texture = 0, renderbuffer = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  return std::min(texture, renderbuffer);
}
