// Step 4, conjugate gradients: the linear system without a factorisation.
//
// Read time_step.h first: everything that this step teaches stands there.
#include "explain/explain.h"
#include "program/run.h"
#include "time_step.h"

int simulate(const Options& options) {
  const Scene scene = read_scene(options.scene, options.program, options.overrides);
  if (options.explain)
    return explain<step04::System>(options, scene, step04::time_step, step04::forces);
  const Cloth& cloth = scene.cloth;
  State state = scene.start;
  step04::System system(cloth, options.method);

  Run run(options, scene);

  for (int frame = 0; frame <= scene.time.frames; ++frame) {
    while (run.before_frame(frame)) {
      step04::time_step(cloth, scene.time.h, state, system);
      run.check(state, system.counts);
    }
    run.record(frame, state);
  }
  return run.finish(state);
}

int main(int argc, char** argv) {
  return run_program(argc, argv,
                     {"step04_cg", "backward Euler, solved by conjugate gradients", STEP_DIRECTORY,
                      Concepts{.implicit = true, .iterative = true}},
                     simulate);
}
