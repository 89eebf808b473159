#include "tradeoff/study.h"

#include <algorithm>
#include <cstdio>

#include "program/progress.h"
#include "scene/text_file.h"

namespace tradeoff {

namespace {

struct Task {
  size_t mesh;
  Trial trial;
  double seconds;  // that it may take: a guess, for the order and the progress
};

// Of one run: explicit steps take some 20 ns a triangle, plain implicit ones forty times that.
double guess(const Trial& trial, const Cloth& cloth) {
  double work = trial.way.step < 3 ? 1 : 40;
  if (trial.way.step == 3 && trial.way.method.solver == "inverse") work += cloth.vertices();
  if (trial.way.method.newton > 1) work *= 12;
  return 2e-8 * work * double(trial.steps) * double(cloth.triangles.elements.size());
}

double patience_of(const Plan& plan) {
  return plan.quick ? 0.1 : 0.25;  // s, for the repetitions of one trial
}

std::vector<Task> tasks_of(const Plan& plan, const Study& study) {
  std::vector<Task> tasks;
  for (size_t i = 0; i < study.meshes.size(); ++i) {
    const StudyScene& mesh = study.meshes[i];
    for (const Way& way : ways_of(mesh.steps, plan.quick))
      for (long steps : step_counts(way, mesh.scene.time.end, study.h_crit[i])) {
        const double once = guess({way, steps}, mesh.scene.cloth);
        const double baseline = 0.004;
        const double times = std::clamp(patience_of(plan) / once, 3.0, 9.0);
        tasks.push_back({i, {way, steps}, times * (once + baseline)});
      }
  }
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const Task& a, const Task& b) { return a.seconds < b.seconds; });
  return tasks;
}

// Everything that a score depends on, in a short word (FNV-1a).
std::string fingerprint(const Plan& plan, const Study& study) {
  std::uint64_t hash = 14695981039346656037u;
  const auto add = [&](const void* data, size_t size) {
    for (size_t i = 0; i < size; ++i)
      hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211u;
  };
  for (const StudyScene& mesh : study.meshes) {
    const std::string text = read_text(mesh.scene.file);
    add(text.data(), text.size());
    for (const VecX* numbers : {&mesh.scene.start.x, &mesh.scene.start.v, &mesh.scene.cloth.mass})
      add(numbers->data(), sizeof(double) * size_t(numbers->size()));
  }
  add(&plan.quick, sizeof plan.quick);  // its times are of fewer rounds
  char word[20];
  std::snprintf(word, sizeof word, "%016llx", static_cast<unsigned long long>(hash));
  return word;
}

}  // namespace

bool Study::can_judge() const {
  return std::all_of(references.begin(), references.end(),
                     [](const Reference& r) { return r.refusal().empty(); });
}

Study prepare(const Plan& plan) {
  Study study;
  study.out = plan.out;
  for (const Choice& choice : meshes_of(plan.choice)) {
    const std::string mesh = "scene" + (choice.cells ? std::to_string(*choice.cells) : "");
    study.meshes.push_back(make_study_scene(choice, plan.out / mesh));
    const StudyScene& scene = study.meshes.back();
    Cloth cloth = scene.scene.cloth;
    study.h_crit.push_back(critical_step(*make_simulator({scene.steps.front() < 3 ? 2 : 5}, cloth),
                                         cloth, scene.scene.start));
    study.references.push_back(find_reference(scene, plan.quick ? 15 : 100));
  }
  return study;
}

void run_trials(const Plan& plan, Study& study) {
  Record record(plan.out / "tradeoff.csv", fingerprint(plan, study));
  if (record.found() > 0)
    std::printf("  %zu runs of an earlier study are kept: %s\n", record.found(),
                (plan.out / "tradeoff.csv").c_str());
  const std::vector<Task> tasks = tasks_of(plan, study);
  double total = 0, done = 0;
  for (const Task& task : tasks) total += task.seconds;
  Baseline baseline;
  baseline.seconds();
  Progress progress{1000};
  for (const Task& task : tasks) {
    if (!record.find(cells_of(study.meshes[task.mesh]), task.trial)) {
      const Score score = run_trial(study.meshes[task.mesh], study.references[task.mesh],
                                    task.trial, patience_of(plan), baseline);
      record.add(score, score.baselines * baseline.median_seconds());
    }
    done += task.seconds;
    progress.show(long(1000 * done / total));
  }
  progress.end();
  study.scores = record.scores();
  study.baseline_seconds = baseline.median_seconds();
}

}  // namespace tradeoff
