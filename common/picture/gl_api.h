// OpenGL's functions. Both libOSMesa and libOpenGL export all of them, so no loader is needed.
#pragma once
#define GL_GLEXT_PROTOTYPES 1
#include <GL/gl.h>
#include <GL/glext.h>
