// Step 2, damping: a thread whose length changes loses energy.
//
// Read time_step.h first: everything that this step teaches stands there.
#include "explain/explain.h"
#include "math/stable_step.h"
#include "program/run.h"
#include "time_step.h"

int simulate(const Options& options) {
  const Scene scene = read_scene(options.scene, options.program, options.overrides);
  if (options.explain)
    return explain<step02::System>(options, scene, step02::time_step, step02::forces);
  const Cloth& cloth = scene.cloth;
  State state = scene.start;
  step02::System system(cloth);

  Run run(options, scene);
  run.report_critical_step(critical_step(cloth, state, step02::forces, system));

  for (int frame = 0; frame <= scene.time.frames; ++frame) {
    while (run.before_frame(frame)) {
      step02::time_step(cloth, scene.time.h, state, system);
      run.check(state);
    }
    run.record(frame, state);
  }
  return run.finish(state);
}

int main(int argc, char** argv) {
  return run_program(argc, argv, {"step02_damping", "damping of stretch and shear", STEP_DIRECTORY},
                     simulate);
}
