// Step 3, implicit: a linear system in every step, and steps fifty times longer.
//
// Read time_step.h first: everything that this step teaches stands there.
#include "explain/explain.h"
#include "program/run.h"
#include "time_step.h"

int simulate(const Options& options) {
  const Scene scene = read_scene(options.scene, options.program, options.overrides);
  if (options.explain)
    return explain<step03::System>(options, scene, step03::time_step, step03::forces);
  const Cloth& cloth = scene.cloth;
  State state = scene.start;
  step03::System system(cloth, options.method);

  Run run(options, scene);

  for (int frame = 0; frame <= scene.time.frames; ++frame) {
    while (run.before_frame(frame)) {
      step03::time_step(cloth, scene.time.h, state, system);
      run.check(state, system.counts);
    }
    run.record(frame, state);
  }
  return run.finish(state);
}

int main(int argc, char** argv) {
  return run_program(argc, argv,
                     {"step03_implicit", "backward Euler, solved directly", STEP_DIRECTORY,
                      Concepts{.implicit = true, .direct = true}},
                     simulate);
}
