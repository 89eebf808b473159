#include <GL/osmesa.h>

#include <array>
#include <stdexcept>

#include "picture/gl_api.h"
#include "picture/gl_context.h"

struct GlContext::Handle {
  OSMesaContext context = nullptr;
  std::array<unsigned char, 4> pixel{};  // OSMesa wants a window; we draw into framebuffers
  ~Handle() { OSMesaDestroyContext(context); }
};

GlContext::GlContext() : handle(std::make_unique<Handle>()) {
  require_cpu_driver_choice();
  const int wanted[] = {OSMESA_FORMAT,
                        OSMESA_RGBA,
                        OSMESA_PROFILE,
                        OSMESA_CORE_PROFILE,
                        OSMESA_CONTEXT_MAJOR_VERSION,
                        3,
                        OSMESA_CONTEXT_MINOR_VERSION,
                        3,
                        0};
  handle->context = OSMesaCreateContextAttribs(wanted, nullptr);
  if (handle->context == nullptr)
    throw std::runtime_error(
        "OSMesa gives no OpenGL 3.3 context: is libosmesa6 broken or too old?");
  make_current();
  require_cpu_renderer();
}

GlContext::~GlContext() = default;

void GlContext::make_current() {
  if (!OSMesaMakeCurrent(handle->context, handle->pixel.data(), GL_UNSIGNED_BYTE, 1, 1))
    throw std::runtime_error("OSMesa cannot make its context current");
}
