#include "explain/explain.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "explain/page_layout.h"
#include "explain/sections.h"

void print_explicit_limit(const Scene& scene, const std::vector<Part>& parts, const Limit& limit) {
  if (std::isinf(limit.h_crit)) return print_wrapped("every h is stable: nothing pulls back");
  print_wrapped(text("stable below h_crit = %.4g s; h is %.2f of it", limit.h_crit,
                     scene.time.h / limit.h_crit));
  std::vector<std::string> without;
  std::string setter;
  double longest = 1.001 * limit.h_crit;
  for (size_t p = 0; p < parts.size(); ++p) {
    const double h = limit.without[p];
    if (std::abs(h / limit.h_crit - 1) > 0.001)
      without.push_back("without " + parts[p].name +
                        (std::isinf(h) ? " every h is stable" : text(" %.4g s", h)));
    if (h <= longest) continue;
    longest = h;
    setter = parts[p].name;
  }
  if (!setter.empty()) print_wrapped(joined(without, ", ") + ": " + setter + " sets it most");
}

void print_implicit_limit(const Scene& scene) {
  const double omega = largest_frequency(scene), h = scene.time.h;
  if (!(omega > 0)) return print_wrapped("every h is stable: nothing pulls back");
  print_wrapped(text("h ω_max = %.3g; an explicit step would have to stay below 2, h_crit = %.3g s",
                     h * omega, 2 / omega));
  print_wrapped("backward Euler does not: it is the error that sets h");
}

namespace {

constexpr double large_error = 0.05;  // of the size

bool drowns(const Trial& trial, const Survey& s) {
  return trial.ended.empty() && trial.distance_at[s.last()] < s.error_of_h(s.last());
}

double seconds_of_scene(const Survey& s) {
  return (s.as_is.seconds + s.nudged.seconds) / 2;
}

void print_one_left_out(const Part& part, const Trial& trial, const Survey& s) {
  std::string says = trial.ended;
  if (says.empty()) {
    const double change = trial.distance_at[s.last()];
    says = padded(length(change), 11) + padded(per_cent(change / s.size), 10) +
           padded(percent(1 - trial.seconds / seconds_of_scene(s)), 6) +
           (drowns(trial, s) ? "less than the error of h" : "");
  }
  print_row("    " + padded(part.name, 19) + padded(part.option, 26) + says);
}

// Damping as a whole stands for that of every term.
std::vector<std::string> drowning(const std::vector<Part>& parts, const Survey& s) {
  std::vector<std::string> names;
  for (size_t p = 0; p < parts.size(); ++p)
    if (drowns(s.left_out[p], s)) names.push_back(parts[p].name);
  if (!names.empty() && names.back() == "all damping")
    std::erase_if(names, [](const std::string& name) { return name.starts_with("damping of"); });
  return names;
}

}  // namespace

void print_left_out(const std::vector<Part>& parts, const Survey& s) {
  print_row(padded("What could be left out", 49) + "moves      of size   time  " +
            text("by t = %.6g s", s.times[s.last()]));
  for (size_t p = 0; p < parts.size(); ++p) print_one_left_out(parts[p], s.left_out[p], s);
  const double noise = std::abs(s.as_is.seconds - s.nudged.seconds) / seconds_of_scene(s);
  print_wrapped(text("moves: RMS over the vertices; time: saved, where two equal runs differ by %s",
                     percent(noise).c_str()));
}

void print_advice(const Options& options, const std::vector<Part>& parts, const Survey& s) {
  if (s.nothing_moves()) return print_wrapped("Nothing moves: any h will do.");
  std::vector<std::string> advice;
  const size_t stop = s.told().value_or(s.last());
  if (s.error_of_h(stop) > large_error * s.size)
    advice.push_back("A smaller h comes first: the error is " +
                     per_cent(s.error_of_h(stop) / s.size) + " of the size.");
  if (const auto names = drowning(parts, s); !names.empty())
    advice.push_back("With this h, " + joined(names, " and ") +
                     " can be left out: that changes less than h does.");
  if (const Probe* other = better_method(s, options.method.tolerance))
    advice.push_back(text("With %s a step takes %.3g ms, at the same tolerance.",
                          other->way.options.c_str(), 1000 * other->median()));
  if (s.told() != s.last())
    advice.push_back("Judge how it ends by energies and the lowest point, not by positions.");
  if (advice.empty()) advice.push_back("All that is modelled changes more than h does.");
  advice.resize(std::min<size_t>(advice.size(), 2));
  print_wrapped(joined(advice, " "));
}

int explain(const Options& options, const Scene& scene, const Simulate& simulate) {
  const std::vector<Part> parts = parts_of(scene.cloth);
  print_scene(options, scene);
  std::fflush(stdout);
  const Survey s = survey(options, scene, parts, simulate);
  print_costs(options, scene, parts, s);
  std::printf("What sets h\n");
  if (options.concepts.implicit)
    print_implicit_limit(scene);
  else
    print_explicit_limit(scene, parts, explicit_limit(scene, parts, simulate, options.method));
  if (s.times.empty()) {
    print_wrapped("the cloth " + s.as_is.ended +
                  ": there is no error to tell, nor what to leave out");
    return 0;
  }
  std::printf("The error of h, RMS\n");
  print_error(options, scene, s);
  if (!parts.empty()) print_left_out(parts, s);
  std::printf("So\n");
  print_advice(options, parts, s);
  return 0;
}
