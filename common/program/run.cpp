#include "program/run.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "program/diagnostics.h"
#include "program/log.h"
#include "program/pictures.h"
#include "program/progress.h"
#include "scene/velocities.h"

namespace {

constexpr double exploded_stretch = 1000;  // of a thread's length
constexpr int explicit_looks = 10;         // explicit steps between two looks at stretch and energy

volatile std::sig_atomic_t interrupted = 0;

// The first Ctrl-C ends the run after the step it is in; the second ends it at once.
void stop_on_ctrl_c() {
  for (const int signal : {SIGINT, SIGTERM})
    std::signal(signal, [](int number) {
      interrupted = 1;
      std::signal(number, SIG_DFL);
    });
}

void require_writable(const std::filesystem::path& directory) {
  const auto refuse = [&](const std::string& reason) {
    throw BadInput("--out " + directory.string() + ": " + reason +
                   "; name a directory that can be written");
  };
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) refuse(error.message());
  const std::filesystem::path probe = directory / ".probe.part";
  const bool written = std::ofstream(probe).put('\n').flush().good();
  const int reason = errno;
  std::filesystem::remove(probe, error);
  if (!written) refuse(std::strerror(reason));
}

// What a change of energy is compared with: the weight times the size, or without gravity the
// energy at the start.
double energy_scale(const Scene& scene, const Energies& start) {
  if (!scene.cloth.gravity) return std::max(start.total(), 1e-12);
  Eigen::AlignedBox3d box;
  for (int i = 0; i < scene.cloth.vertices(); ++i) box.extend(scene.start.x.segment<3>(3 * i));
  return scene.cloth.mass.sum() / 3 * scene.cloth.gravity->norm() * box.diagonal().norm();
}

double lowest(const VecX& x) {
  double y = x[1];
  for (int i = 4; i < x.size(); i += 3) y = std::min(y, x[i]);
  return y;
}

bool pins_move(const Cloth& cloth) {
  return std::any_of(cloth.pins.begin(), cloth.pins.end(),
                     [](const Pin& pin) { return !pin.velocity.isZero(0); });
}

// 1 step, 2 steps.
std::string count(long number, const std::string& thing) {
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

std::vector<std::string> columns(const Energies& start) {
  std::vector<std::string> names = {"frame",         "time",  "kinetic",     "elastic",
                                    "gravitational", "total", "max_stretch", "lowest"};
  for (const auto& [term, energy] : start.by_term) names.emplace_back(term);
  for (const char* name :
       {"iterations", "indefinite", "capped", "gained", "unconverged", "milliseconds"})
    names.emplace_back(name);
  return names;
}

}  // namespace

struct Run::Files {
  using Clock = std::chrono::steady_clock;

  Files(const Options& options_, const Scene& scene_)
      : options(options_), scene(scene_), start(energies(scene.cloth, scene.start)),
        scale(energy_scale(scene, start)),
        pictures(options.pictures ? std::make_unique<Pictures>(options, scene) : nullptr),
        log(options.out / "log.csv", columns(start)), progress(scene.time.steps()) {
    const double moment = scene.camera.still.value_or(scene.time.end);
    still_frame = int(std::lround(std::min(1.0, moment / scene.time.end) * scene.time.frames));
  }

  double time() const { return double(step) * scene.time.h; }
  double seconds_stepping() const {
    return std::chrono::duration<double>(Clock::now() - stepping_since).count();
  }

  void close() {
    progress.end();
    if (pictures) pictures->film();
    log.close();
  }

  [[noreturn]] void explode(std::string seen, const Counters& counts) {
    close();
    if (counts.indefinite > 0)
      seen += ", after " +
              count(counts.indefinite, options.concepts.iterative ? "system" : "step") +
              " whose matrix was not positive definite";
    char text[256];
    std::snprintf(text, sizeof text, "the cloth exploded in step %ld (t = %.6g s): %s; ", step,
                  time(), seen.c_str());
    std::string message = text;
    if (h_crit > 0)
      std::snprintf(
          text, sizeof text,
          "h = %g s is %.2f of the stable step: try --h %.2g, a smaller k or fewer cells",
          scene.time.h, scene.time.h / h_crit,
          scene.time.h > h_crit ? 0.8 * h_crit : std::min(0.8 * h_crit, 0.5 * scene.time.h));
    else
      std::snprintf(text, sizeof text, "try %sa smaller h than %g s", other_method().c_str(),
                    scene.time.h);
    throw std::runtime_error(message + text);
  }

  // What of the method can be to blame for an explosion.
  std::string other_method() const {
    const Method& method = options.method;
    if (method.jacobian == Jacobian::bw98) return "--jacobian definite, or ";
    if (method.newton == 1) return "--newton 20, or ";
    return options.concepts.iterative ? "a smaller --tolerance, or " : "";
  }

  void say_end(const Energies& end) const {
    std::printf(
        "%s: %ld steps in %.3g s (%.3g ms each), largest stretch %.4f, energy %.4g J at the "
        "start, %.4g J at the end\n",
        interrupted ? "stopped" : "done", step, seconds,
        1000 * seconds / double(std::max(step, 1L)), most_stretch, start.total(), end.total());
  }

  void say_iterations(const Counters& counts) const {
    if (!options.concepts.iterative) return;
    std::printf("  %.1f iterations of conjugate gradients per %s (%s, tolerance %g)\n",
                double(counts.iterations) / double(std::max(step, 1L)),
                options.method.newton == 1 ? "system" : "step",
                options.method.preconditioner.c_str(), options.method.tolerance);
  }

  // What is not fatal, but should not pass for a result unnoticed.
  void say_doubts(const Counters& counts, long gained) const {
    const bool iterative = options.concepts.iterative;
    const auto doubt = [](const std::string& text) {
      std::printf("  worth a doubt: %s\n", text.c_str());
    };
    if (gained > 0) {
      char text[128];
      std::snprintf(text, sizeof text,
                    "up to %.3g J more than at the start, %.2g of weight times size", most_gained,
                    most_gained / scale);
      doubt(text);
    }
    if (counts.indefinite > 0 && iterative)
      doubt("conjugate gradients met pᵀAp ≤ 0, or not a number, and gave up in " +
            count(counts.indefinite, "system"));
    if (counts.indefinite > 0 && !iterative)
      doubt("the matrix was not positive definite in " + count(counts.indefinite, "step"));
    if (counts.capped > 0)
      doubt("conjugate gradients stopped at " + count(options.method.max_iterations, "iteration") +
            " in " + count(counts.capped, "system") +
            ", as if the cloth were stiffer; raise --max-iterations or take another "
            "--preconditioner");
    if (counts.unconverged > 0)
      doubt("Newton did not converge in " + count(counts.unconverged, "step"));
  }

  const Options& options;
  const Scene& scene;
  Energies start;
  double scale;  // J
  bool pins_work = pins_move(scene.cloth);
  std::unique_ptr<Pictures> pictures;
  Log log;
  Progress progress;
  int still_frame;
  int look_every = options.concepts.implicit ? 1 : explicit_looks;

  long step = 0;
  double h_crit = 0;  // s, 0 where the method has none
  double most_stretch = 0, most_gained = 0;
  double seconds = 0;  // of stepping so far
  Clock::time_point stepping_since = Clock::now();
};

Run::Run(const Options& options, const Scene& scene) {
  require_writable(options.out);
  files = std::make_unique<Files>(options, scene);
  std::printf("%s: %s, %d vertices, %zu triangles, h = %g s, %ld steps to t = %g s\n",
              options.program.c_str(), scene.file.string().c_str(), scene.cloth.vertices(),
              scene.mesh.faces.size(), scene.time.h, scene.time.steps(), scene.time.end);
}

Run::~Run() = default;

long Run::steps() const {
  return files->step;
}

void Run::report_critical_step(double h_crit) {
  const double h = files->scene.time.h;
  files->h_crit = h_crit;
  if (std::isinf(h_crit)) {
    std::printf("  every h is stable: nothing pulls back\n");
    return;
  }
  std::printf("  stable below h_crit = %.4g s; h is %.2f of it\n", h_crit, h / h_crit);
  if (h > 0.9 * h_crit)
    std::fprintf(stderr,
                 "warning: h = %g s is beyond 0.9 h_crit: expect the cloth to %s; try --h %.2g\n",
                 h, h > h_crit ? "explode" : "come to grief on the way", 0.8 * h_crit);
  std::fflush(stdout);
  files->stepping_since = Files::Clock::now();
}

bool Run::before_frame(int frame) const {
  return !interrupted && files->step < files->scene.time.step_of_frame(frame);
}

void Run::check(const State& state, const Counters& counts) {
  counters = counts;
  ++files->step;
  files->progress.show(files->step);
  if (!state.x.allFinite()) files->explode("a position is not finite", counters);
  if (files->step % files->look_every == 0) look(state);
}

// Looks at the state as a whole: has it exploded, has it gained energy?
Measures Run::look(const State& state) {
  if (files->step == looked_step) return latest;
  const Measures now = {energies(files->scene.cloth, state),
                        max_stretch(files->scene.mesh, state.x)};
  if (!(now.max_stretch <= exploded_stretch)) {
    char seen[64] = "a thread is longer than a number can say";
    if (std::isfinite(now.max_stretch))
      std::snprintf(seen, sizeof seen, "a thread is %.3g times its length", now.max_stretch);
    files->explode(seen, counters);
  }
  files->most_stretch = std::max(files->most_stretch, now.max_stretch);
  const double gain = now.energies.total() - files->start.total();
  files->most_gained = std::max(files->most_gained, gain);
  if (gain > 1e-3 * files->scale && !files->pins_work) ++gained;
  looked_step = files->step;
  return latest = now;
}

void Run::record(int frame, const State& state) {
  if (frame == 0) stop_on_ctrl_c();  // from now on there is something to finish
  Files& r = *files;
  if (r.step != r.scene.time.step_of_frame(frame)) return;  // stopped on the way to this frame
  const double seconds = r.seconds_stepping();
  r.seconds += seconds;

  const auto [energy, stretch] = look(state);
  std::vector<double> row = {double(frame),        r.time(),       energy.kinetic, energy.elastic(),
                             energy.gravitational, energy.total(), stretch,        lowest(state.x)};
  for (const auto& [term, joule] : energy.by_term) row.push_back(joule);
  for (long count :
       {counters.iterations, counters.indefinite, counters.capped, gained, counters.unconverged})
    row.push_back(double(count));
  row.push_back(1000 * seconds);
  r.log.row(row);

  if (r.pictures) {
    r.pictures->frame(frame, state.x, r.time());
    if (frame == r.still_frame) r.pictures->still(state.x, r.time());
  }
  if (r.options.export_obj) {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%04d.obj", frame);
    write_obj(r.options.out / name, r.scene.mesh, state.x);
  }
  r.progress.show_frame(frame, r.scene.time.frames, r.step, r.time());
  r.stepping_since = Files::Clock::now();
}

int Run::finish(const State& state) {
  Files& r = *files;
  r.close();
  write_obj(r.options.out / "final.obj", r.scene.mesh, state.x);
  write_velocities(r.options.out / "final_velocities.csv", state.v);

  r.say_end(energies(r.scene.cloth, state));
  r.say_iterations(counters);
  r.say_doubts(counters, gained);
  std::printf("  see %s\n",
              (r.pictures ? r.options.out / "film.png" : r.options.out / "log.csv").c_str());
  if (!interrupted) return 0;
  std::printf("  final.obj and final_velocities.csv hold the cloth at t = %.6g s\n", r.time());
  return 130;
}
