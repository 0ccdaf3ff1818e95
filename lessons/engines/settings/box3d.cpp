#include "lessons/engines/settings.hpp"

// Box3D. Its knobs are Box2D 3's, of b3JointDef and b3WorldDef, and stand where those do.
namespace byhand::engines {

Settings box3d_settings() {
  return soft_step_settings("box3d.h, b3World_Step: more substeps can increase accuracy, usually 4");
}

}  // namespace byhand::engines
