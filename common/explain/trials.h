// The runs that --explain compares: the baseline, which is the scene as it stands, runs with
// smaller steps, runs without one of the parts, and cheaper runs.
#pragma once
#include "explain/explain.h"
#include "explain/parts.h"

// One run, and how far it has come. It goes from stop to stop; all runs have the same stops.
struct Trial {
  std::string options;  // of the command line, that make a program run like this
  double h;             // s
  long stride;          // steps from stop to stop
  Simulation simulation;
  State state;
  const Mesh* mesh;
  std::function<VecX(const VecX&)> at_own_vertices =
      {};  // from the scene's vertices, where they differ

  long steps = 0;
  double seconds = 0;                   // CPU time
  std::vector<double> seconds_at = {};  // at every stop
  std::vector<double> distance_at =
      {};                  // at every stop, from the positions that it is compared with, m
  std::string ended = {};  // why it ended early

  void advance();                        // to the next stop, unless it has ended
  void compare_with(const VecX& other);  // records time and distance of this stop
};

double seconds_of(const std::function<void()>& work);  // CPU time

// A method, and the options of the command line that choose it.
struct NamedMethod {
  std::string options;
  Method method;
};

class Trials {
 public:
  Trials(const Options&, const Scene&, const Simulate&);

  Trial trial(const std::string& name, const Cloth&, const Method&, double factor_h = 1) const;
  Trial perturbed(double by) const;  // m, RMS over the vertices
  std::vector<std::function<Trial()>> cheaper() const;
  std::vector<NamedMethod> other_methods() const;  // with the same and with looser tolerance
  NamedMethod tighter() const;                     // with a tenth of the tolerance

  const Options& options;
  const Scene& scene;
  const Simulate simulate;
  const long stride;

 private:
  std::string options_of(const Method&) const;
  Trial fewer_cells() const;
};
