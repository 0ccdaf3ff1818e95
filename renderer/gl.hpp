#pragma once

// The library that makes the context (OSMesa, or EGL with libOpenGL) exports these functions itself: no
// loader.
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
