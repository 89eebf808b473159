// One run of a program: its directory, its log, its pictures, its progress and its end. The loop
// over frames and time steps stays in the main.cpp of each step.
#pragma once
#include <memory>

#include "math/counters.h"
#include "program/options.h"
#include "scene/scene.h"

class Run {
 public:
  // Prints what is being run. Throws BadInput if the output directory cannot be written.
  Run(const Options&, const Scene&);
  ~Run();

  // Prints the longest stable step of an explicit method, and warns if h is beyond 0.9 of it.
  void report_critical_step(double h_crit);

  // True until the step that frame k shows is done, or the user stops the run.
  bool before_frame(int frame) const;

  // After every time step: counts it, shows progress, and throws if the cloth has exploded: a
  // position is not finite, or a thread is over 1000 times its length.
  void check(const State&, const Counters& = {});

  // Frame k: a row of log.csv, the pictures, with --export a mesh.
  void record(int frame, const State&);

  // Writes film.png, with --motion the animation, final.obj and final_velocities.csv, and prints the last lines. Returns the
  // exit code. Throws, once all is written, if the linear systems of every step failed.
  int finish(const State&);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl;
};
