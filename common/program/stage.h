// Where the camera stands and where the floor is, once for a whole run.
#pragma once
#include "picture/renderer.h"
#include "scene/scene.h"

// The box that holds every place where the cloth can swing, fall or fly to during the run, and a
// camera that sees all of it, unless the scene's [camera] says otherwise.
Stage make_stage(const Scene&);
