// Step 1, explicit: a cloth of threads that stretch and shear, moved on by symplectic Euler.
//
// Read time_step.h first: everything that this step teaches stands there.
#include "explain/explain.h"
#include "math/stable_step.h"
#include "program/run.h"
#include "time_step.h"

int simulate(const Options& options) {
  const Scene scene = read_scene(options.scene, options.program, options.overrides);
  if (options.explain)
    return explain<step01::System>(options, scene, step01::time_step, step01::forces);
  const Cloth& cloth = scene.cloth;
  State state = scene.start;
  step01::System system(cloth);

  Run run(options, scene);
  run.report_critical_step(critical_step(cloth, state, step01::forces, system));

  for (int frame = 0; frame <= scene.time.frames; ++frame) {
    while (run.before_frame(frame)) {
      step01::time_step(cloth, scene.time.h, state, system);
      run.check(state);
    }
    run.record(frame, state);
  }
  return run.finish(state);
}

int main(int argc, char** argv) {
  return run_program(argc, argv, {"step01_explicit", "explicit stretch and shear", STEP_DIRECTORY},
                     simulate);
}
