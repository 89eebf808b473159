#include "program/run.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>

#include "program/log.h"
#include "program/out_directory.h"
#include "program/pictures.h"
#include "program/point_cache.h"
#include "program/progress.h"
#include "program/report.h"
#include "program/run_toml.h"
#include "program/video.h"
#include "scene/velocities.h"
#include "text/text.h"
#include "text/text_file.h"

namespace {

constexpr int explicit_steps_per_sample = 10;

volatile std::sig_atomic_t interrupted = 0;

// The first Ctrl-C, and a terminal or a reader of the output that goes away, end the run after the step it is
// in. A second Ctrl-C ends it at once.
void stop_on_ctrl_c() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE})
    std::signal(signal, [](int number) {
      interrupted = 1;
      std::signal(number, number == SIGPIPE ? SIG_IGN : SIG_DFL);
    });
}

// The frame at the moment that the scene names, or else the last one.
int still_frame_of(const Scene& scene) {
  const double moment = scene.camera.still.value_or(scene.time.end);
  return int(std::lround(std::min(1.0, moment / scene.time.end) * scene.time.frames));
}

std::string describe_stretch(double stretch) {
  if (!std::isfinite(stretch)) return "the length of a thread is not finite";
  return text("a thread is %.3g times its length", stretch);
}

// Every column of log.csv.
LogRow log_row(int frame, double time, const Sample& sample, const Counters& counts, long gained,
               double seconds) {
  const Energies& energy = sample.energies;
  LogRow row = {{"frame", frame},
                {"time", time},
                {"kinetic", energy.kinetic},
                {"elastic", energy.elastic()},
                {"gravitational", energy.gravitational},
                {"total", energy.total()},
                {"max_stretch", sample.max_stretch},
                {"lowest", sample.lowest}};
  for (const auto& [term, joule] : energy.by_term) row.emplace_back(term, joule);
  row.emplace_back("iterations", counts.iterations);
  row.emplace_back("indefinite", counts.indefinite);
  row.emplace_back("capped", counts.capped);
  row.emplace_back("gained", gained);
  row.emplace_back("redone", counts.redone);
  row.emplace_back("unconverged", counts.unconverged);
  row.emplace_back("milliseconds", 1000 * seconds);
  return row;
}

}  // namespace

struct Run::Impl {
  using Clock = std::chrono::steady_clock;

  Impl(const Options& options_, const Scene& scene_)
      : options(options_), scene(scene_), directory(options.out), report(options, scene),
        watch(scene),
        pictures(options.pictures ? std::make_unique<Pictures>(options, scene) : nullptr),
        log(options.out / "log.csv"), points(options.out / "points.pc2"),
        progress(scene.time.steps()), still_frame(still_frame_of(scene)) {}

  double time() const { return double(run.steps) * scene.time.h; }
  double seconds_of_stepping() const {
    return std::chrono::duration<double>(Clock::now() - stepping_since).count();
  }

  const Sample& sample(const State& state) {
    const Sample& now = watch.sample(run.steps, state);
    if (now.exploded()) explode(describe_stretch(now.max_stretch));
    return now;
  }

  void close() {
    progress.end();
    if (pictures) pictures->film();
    log.close();
    points.close();
  }

  // Draws the next picture of motion.png, if it is due. The time of stepping does not include it. A cloth that has
  // exploded since the last sample is not drawn.
  void draw_motion(const State& state) {
    if (!pictures || !pictures->motion_is_due(run.steps)) return;
    if (has_exploded(max_stretch(scene.mesh, state.x))) return;
    const Clock::time_point begin = Clock::now();
    pictures->add_to_motion(state.x, time());
    stepping_since += Clock::now() - begin;
  }

  void make_video() {
    if (pictures && pictures->has_motion())
      report.video(::make_video(options.out), video_command(options.out));
  }

  [[noreturn]] void explode(const std::string& seen) {
    close();
    make_video();
    throw std::runtime_error(report.explosion(run, seen));
  }

  const Options& options;
  const Scene& scene;
  OutDirectory directory;
  Report report;
  Watch watch;
  std::unique_ptr<Pictures> pictures;
  Log log;
  PointCache points;
  Progress progress;
  int still_frame;
  int steps_per_sample = options.concepts.implicit ? 1 : explicit_steps_per_sample;

  RunTotals run;
  Clock::time_point stepping_since = Clock::now();
};

Run::Run(const Options& options, const Scene& scene) {
  alarm(0);  // the set-up is done (options.cpp)
  impl = std::make_unique<Impl>(options, scene);
  impl->report.start();
}

Run::~Run() = default;

void Run::report_critical_step(double h_crit) {
  impl->report.critical_step(h_crit);
  if (std::isfinite(h_crit)) impl->run.h_crit = h_crit;
  impl->stepping_since = Impl::Clock::now();
}

bool Run::before_frame(int frame) const {
  return !interrupted && impl->run.steps < impl->scene.time.step_of_frame(frame);
}

void Run::check(const State& state, const Counters& counts) {
  Impl& r = *impl;
  if (counts.indefinite > r.run.counts.indefinite) ++r.run.failed;
  r.run.counts = counts;
  r.progress.show(++r.run.steps);
  if (!state.x.allFinite()) r.explode("a position is not finite");
  if (r.run.steps % r.steps_per_sample == 0) r.sample(state);
  r.draw_motion(state);
}

void Run::record(int frame, const State& state) {
  if (frame == 0) stop_on_ctrl_c();  // from now on there is something to finish
  Impl& r = *impl;
  if (r.run.steps != r.scene.time.step_of_frame(frame)) return;  // stopped on the way to this frame
  const double seconds = r.seconds_of_stepping();
  r.run.seconds += seconds;

  const Sample& sample = r.sample(state);
  if (frame == 0) {
    r.directory.remove_earlier_run();
    write_text(r.options.out / "run.toml", run_toml(r.options, r.scene.effective));
  }
  r.log.write(log_row(frame, r.time(), sample, r.run.counts, r.watch.gained, seconds));
  if (r.pictures) {
    r.pictures->frame(frame, state.x, r.time());
    if (frame == r.still_frame) r.pictures->still(state.x, r.time());
    if (frame == 0) r.draw_motion(state);
  }
  if (r.options.export_obj)
    write_obj(r.options.out / text("frame_%04d.obj", frame), r.scene.mesh, state.x);
  if (r.options.export_pc2) r.points.write(state.x);
  r.progress.show_frame(frame, r.scene.time.frames, r.run.steps, r.time());
  r.stepping_since = Impl::Clock::now();
}

int Run::finish(const State& state) {
  Impl& r = *impl;
  if (interrupted) r.run.seconds += r.seconds_of_stepping();  // since the last frame
  r.close();
  write_obj(r.options.out / "final.obj", r.scene.mesh, state.x);
  write_velocities(r.options.out / "final_velocities.csv", state.v);
  r.report.end(r.run, r.watch, state, interrupted);
  r.make_video();
  if (r.run.steps > 0 && r.run.failed == r.run.steps &&
      r.options.method.jacobian == Jacobian::definite)
    throw std::runtime_error(no_result(r.run.steps));
  return interrupted ? 130 : 0;
}
