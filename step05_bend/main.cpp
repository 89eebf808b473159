// Step 5, bending: one more condition, the angle between two triangles.
//
// Read time_step.h first: everything that this step teaches stands there.
#include "explain/explain.h"
#include "program/run.h"
#include "time_step.h"

int simulate(const Options& options) {
  Scene scene = read_scene(options.scene, options.program, options.overrides);
  if (options.explain)
    return explain<step05::System>(options, scene, step05::time_step, step05::forces);
  Cloth& cloth = scene.cloth;
  State state = scene.start;
  step05::System system(cloth, options.method);

  Run run(options, scene);

  for (int frame = 0; frame <= scene.time.frames; ++frame) {
    while (run.before_frame(frame)) {
      step05::time_step(cloth, scene.time.h, state, system);
      run.check(state, system.counts);
    }
    run.record(frame, state);
  }
  return run.finish(state);
}

int main(int argc, char** argv) {
  return run_program(argc, argv,
                     {"step05_bend", "bending: the dihedral angle", STEP_DIRECTORY,
                      Concepts{.implicit = true, .iterative = true}},
                     simulate);
}
