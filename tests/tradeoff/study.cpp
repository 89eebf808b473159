#include "tradeoff/study.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "program/progress.h"
#include "support/text.h"
#include "text/text_file.h"

namespace tradeoff {

namespace {

struct Task {
  size_t mesh;
  Trial trial;
  double seconds;  // an estimate, for the order of the tasks and the progress line
};

// The time of a step in explicit steps.
double work(const Configuration& configuration, const Cloth& cloth) {
  if (configuration.scheme == Scheme::xpbd) return 8 * configuration.sweeps;
  if (configuration.scheme == Scheme::vbd) return 40 * configuration.sweeps;
  if (is_explicit(configuration)) return 1;
  const bool inverse = configuration.step == 3 && configuration.method.solver == "inverse";
  return (40 + (inverse ? cloth.vertices() : 0)) * (configuration.method.newton > 1 ? 12 : 1);
}

// The estimated time of one run: an explicit step takes about 20 ns per triangle.
double guess(const Trial& trial, const Cloth& cloth) {
  return 2e-8 * work(trial.configuration, cloth) * double(trial.steps) *
         double(cloth.triangles.elements.size());
}

double patience_of(const Plan& plan) {
  return plan.quick ? 0.1 : 0.25;  // s, for the repetitions of one trial
}

std::vector<Task> tasks_of(const Plan& plan, const Study& study) {
  std::vector<Task> tasks;
  for (size_t i = 0; i < study.meshes.size(); ++i) {
    const StudyScene& mesh = study.meshes[i];
    for (const Configuration& configuration : configurations_of(mesh.steps, plan.quick))
      for (long steps : step_counts(configuration, mesh.scene.time.end, study.h_crit[i])) {
        const double once = guess({configuration, steps}, mesh.scene.cloth), baseline = 0.004;
        const double times = std::clamp(patience_of(plan) / once, 3.0, 9.0);
        tasks.push_back({i, {configuration, steps}, times * (once + baseline)});
      }
  }
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const Task& a, const Task& b) { return a.seconds < b.seconds; });
  return tasks;
}

// A hash (FNV-1a) of everything that a score depends on: this program, because it contains the
// steps that are judged; the scene; and the reference.
std::string fingerprint(const Plan& plan, const Study& study) {
  std::uint64_t hash = 14695981039346656037u;
  const auto add = [&](const void* data, size_t size) {
    for (size_t i = 0; i < size; ++i)
      hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211u;
  };
  const auto add_text = [&](const std::string& text) { add(text.data(), text.size()); };
  if (no_file("/proc/self/exe").empty()) add_text(read_text("/proc/self/exe"));
  for (size_t i = 0; i < study.meshes.size(); ++i) {
    const StudyScene& mesh = study.meshes[i];
    add_text(read_text(mesh.scene.file) + mesh.options);
    for (const VecX* numbers : {&mesh.scene.start.x, &mesh.scene.start.v, &mesh.scene.cloth.mass})
      add(numbers->data(), sizeof(double) * size_t(numbers->size()));
    add_text(std::to_string(study.references[i].steps) + study.references[i].refusal());
  }
  add(&plan.quick, sizeof plan.quick);  // a quick study takes fewer rounds
  return format("%016llx", static_cast<unsigned long long>(hash));
}

size_t mesh_of(const Study& study, const Score& score) {
  size_t mesh = 0;
  while (mesh + 1 < study.meshes.size() && cells_of(study.meshes[mesh]) != score.cells) ++mesh;
  return mesh;
}

}  // namespace

bool Study::can_judge() const {
  return std::all_of(references.begin(), references.end(),
                     [](const Reference& r) { return r.refusal().empty(); });
}

double Study::h_crit_of(const Score& score) const {
  return h_crit[mesh_of(*this, score)];
}

Study prepare(const Plan& plan) {
  std::error_code error;
  std::filesystem::create_directories(plan.out, error);
  if (error)
    throw BadInput("--out " + plan.out.string() + ": " + error.message() +
                   "; name a directory that can be written");
  Study study;
  study.out = plan.out;
  for (const Choice& choice : meshes_of(plan.choice)) {
    const std::string mesh = "scene" + (choice.cells ? std::to_string(*choice.cells) : "");
    study.meshes.push_back(make_study_scene(choice, plan.out / mesh));
    const StudyScene& scene = study.meshes.back();
    Cloth cloth = scene.scene.cloth;
    const auto simulator = make_simulator({scene.steps.front() < 3 ? 2 : 5}, cloth);
    study.h_crit.push_back(critical_step(*simulator, cloth, scene.scene.start));
  }
  return study;
}

void find_references(const Plan& plan, Study& study) {
  const double patience = plan.reference_seconds() / double(study.meshes.size());
  for (const StudyScene& mesh : study.meshes) {
    std::printf(
        "reference%s: steps of order 4, RMS distance to half as many, order seen, growth of 1 nm\n",
        study.meshes.size() > 1 ? format(", %d cells", cells_of(mesh)).c_str() : "");
    const Reference reference = find_reference(mesh, patience, [](const Reference& r) {
      std::printf("  %9ld  %.1e of the size  %5.2f  %.3g-fold\n", r.steps, r.self_check, r.order,
                  r.growth);
      std::fflush(stdout);
    });
    const std::string refusal = reference.refusal();
    if (refusal.empty())
      std::printf("  errors from %.0e of the size on can be told\n", reference.floor());
    else
      std::printf("  no error is told: %s\n", refusal.c_str());
    study.references.push_back(reference);
  }
}

void run_trials(const Plan& plan, Study& study) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  Record record(plan.out / "tradeoff.csv", fingerprint(plan, study));
  if (record.found() > 0)
    std::printf("%zu runs of an earlier study are kept: %s\n", record.found(),
                (plan.out / "tradeoff.csv").c_str());
  std::vector<Task> tasks = tasks_of(plan, study);
  std::erase_if(tasks, [&](const Task& task) {
    return record.find(cells_of(study.meshes[task.mesh]), task.trial) != nullptr;
  });
  double total = 0, done = 0;
  for (const Task& task : tasks) total += task.seconds;
  Baseline baseline;
  for (int i = 0; i < 9; ++i) baseline.run();
  Progress progress{1000};
  study.left_out = tasks.size();
  for (const Task& task : tasks) {
    if (std::chrono::duration<double>(Clock::now() - begin).count() > plan.trial_seconds()) break;
    const Score score = run_trial(study.meshes[task.mesh], study.references[task.mesh], task.trial,
                                  patience_of(plan), baseline);
    record.add(score, score.baselines * baseline.median_seconds());
    --study.left_out;
    done += task.seconds;
    progress.show(long(1000 * done / total));
  }
  progress.end();
  study.scores = record.scores();
  study.baseline_seconds = baseline.median_seconds();
}

}  // namespace tradeoff
