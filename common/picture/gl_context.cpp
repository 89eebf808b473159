// The part of the context that OSMesa and EGL share.
#include "picture/gl_context.h"

#include <cstdlib>
#include <stdexcept>

#include "picture/gl_api.h"

namespace {

std::string gl_string(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

}  // namespace

std::string GlContext::description() const {
  return gl_string(GL_RENDERER) + ", OpenGL " + gl_string(GL_VERSION);
}

void require_cpu_driver_choice() {
  const char* driver = std::getenv("GALLIUM_DRIVER");
  if (driver == nullptr) return;
  const std::string name = driver;
  if (name != "llvmpipe" && name != "softpipe")
    throw std::runtime_error("GALLIUM_DRIVER is \"" + name +
                             "\": unset it, or set it to llvmpipe or softpipe");
}

void require_cpu_renderer() {
  const std::string name = gl_string(GL_RENDERER);
  if (name.find("llvmpipe") == std::string::npos && name.find("softpipe") == std::string::npos)
    throw std::runtime_error(
        "pictures are drawn by Mesa's llvmpipe or softpipe, but here OpenGL is \"" + name +
        "\": install libegl-mesa0 and libgl1-mesa-dri");
}
