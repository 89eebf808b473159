// The ways to compute a scene that --explain compares: as it is, with smaller steps, without each of its
// parts, and cheaper.
#pragma once
#include "explain/explain.h"
#include "explain/parts.h"

// One way, and how far it has come. It goes from stop to stop; all ways have the same stops.
struct Trial {
  std::string options;  // that a program is given for it
  double h;             // s
  long stride;          // steps from stop to stop
  Simulation simulation;
  State state;
  const Mesh* mesh;
  std::function<VecX(const VecX&)> seen;  // the scene's vertices, where this one has its own

  long steps = 0;
  double seconds = 0;                    // of the processor
  std::vector<double> seconds_at = {};   // at every stop
  std::vector<double> distance_at = {};  // at every stop, RMS to what it is compared with, m
  std::string ended = {};                // why, where it did not go on

  void advance();                        // to the next stop, unless it has ended
  void note(const VecX& compared_with);  // seconds and distance of this stop
};

double seconds_of(const std::function<void()>& work);  // of the processor

struct NamedMethod {
  std::string options;
  Method method;
};

class Trials {
 public:
  Trials(const Options&, const Scene&, const Simulate&);

  Trial trial(const std::string& name, const Cloth&, const Method&, double factor_h = 1) const;
  Trial nudged(double by) const;  // m
  std::vector<std::function<Trial()>> cheaper() const;
  std::vector<NamedMethod> other_methods() const;  // with the same error, and with looser tolerance
  NamedMethod tighter() const;                     // a tenth of the tolerance

  const Options& options;
  const Scene& scene;
  const Simulate& simulate;
  const long stride;

 private:
  std::string options_of(const Method&) const;
  Trial fewer_cells() const;
};
