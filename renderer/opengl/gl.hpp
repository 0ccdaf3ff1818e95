#pragma once

// OSMesa and libOpenGL export these functions, so no loader is needed.
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
