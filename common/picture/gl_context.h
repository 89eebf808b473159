// An OpenGL 3.3 context without a window. The CPU draws, so the same version of Mesa draws the same
// picture on every machine.
#pragma once
#include <memory>
#include <string>

class GlContext {
 public:
  // The context is current afterwards. Throws std::runtime_error that names the missing package.
  GlContext();
  ~GlContext();

  void make_current();
  std::string description() const;  // e.g. "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 …"

 private:
  struct Handle;  // OSMesa's or EGL's
  std::unique_ptr<Handle> handle;
};

// Throws unless the environment leaves Mesa a driver that draws on the CPU. libOSMesa crashes on
// a GALLIUM_DRIVER that it does not know, so this comes before the context.
void require_cpu_driver_choice();

// Throws unless the current context is drawn by llvmpipe or softpipe.
void require_cpu_renderer();
