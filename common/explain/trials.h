// The runs that --explain compares: the baseline, which is the scene as it stands, runs with
// smaller steps, runs without one of the parts, and cheaper runs.
#pragma once
#include "explain/explain.h"
#include "explain/parts.h"
#include "explain/time_budget.h"

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
  double seconds = 0;                    // CPU time of all steps
  double seconds_to_stop = 0;            // of the steps to the last stop
  std::vector<double> distance_at = {};  // at every stop, from the positions compared with, m
  std::string ended = {};                // why it ended early

  bool is_late() const;                  // has neither ended nor come to the next stop
  void advance(const TimeBudget&);       // to the next stop; late if the time ends before
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
  Trials(const Options&, const Scene&, const std::vector<Part>&, const Simulate&,
         const TimeBudget&);

  Trial trial(const std::string& name, const Cloth&, const Method&, double factor_h = 1) const;
  Trial perturbed(double by) const;  // m, RMS over the vertices
  std::vector<std::function<Trial()>> cheaper() const;
  std::vector<NamedMethod> other_methods() const;  // with the same and with looser tolerance
  NamedMethod tighter() const;                     // with a tenth of the tolerance
  double forecast() const;  // s on the wall, of everything that has to be measured

  const Options& options;
  const Scene& scene;
  const std::vector<Part>& parts;
  const Simulate simulate;
  const TimeBudget& time;
  long stride;

 private:
  std::string options_of(const Method&) const;
  Trial fewer_cells() const;
  double seconds_of_a_step() const;

  double step_seconds;  // on the wall, of one step
};
