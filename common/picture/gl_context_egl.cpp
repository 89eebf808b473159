#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdlib>
#include <stdexcept>

#include "picture/gl_context.h"

namespace {

// One display serves all contexts of the process; closing it would close them all.
EGLDisplay surfaceless_display() {
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);  // a graphics card would draw other pixels
  const EGLDisplay display =
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
    throw std::runtime_error("EGL has no surfaceless display: install libegl-mesa0");
  return display;
}

}  // namespace

struct GlContext::Handle {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  ~Handle() {
    if (context == EGL_NO_CONTEXT) return;
    if (eglGetCurrentContext() == context)
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
  }
};

GlContext::GlContext() : handle(std::make_unique<Handle>()) {
  require_cpu_driver_choice();
  handle->display = surfaceless_display();
  const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                           3,
                           EGL_CONTEXT_MINOR_VERSION,
                           3,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                           EGL_NONE};
  if (eglBindAPI(EGL_OPENGL_API))
    handle->context = eglCreateContext(handle->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
  if (handle->context == EGL_NO_CONTEXT)
    throw std::runtime_error("EGL gives no OpenGL 3.3 context: install libgl1-mesa-dri");
  make_current();
  require_cpu_renderer();
}

GlContext::~GlContext() = default;

void GlContext::make_current() {
  if (!eglMakeCurrent(handle->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handle->context))
    throw std::runtime_error("EGL cannot make its context current");
}
