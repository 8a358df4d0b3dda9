// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/trials/trial.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include "workbench/bench/thread_clock.hpp"
#include "workbench/cloud/option_setter.hpp"
#include "workbench/trials/sheet.hpp"

namespace cleave::workbench {
namespace {

using evaluation::LabelledCloud;

struct Runner {
  std::size_t method;
  float grid_offset;
  std::unique_ptr<peers::Peer> peer;
};

// Runners in the order of methods and offsets; the work memory of one thread.
std::vector<Runner> make_runners(const TrialPlan& plan) {
  std::vector<Runner> runners;
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    const Method& method = plan.methods[m];
    const std::uint32_t offsets = method.has_grid_offset ? plan.grid_offsets : 1;
    for (std::uint32_t i = 0; i < offsets; ++i) {
      const float grid_offset = even_grid_offset(i, offsets);
      runners.push_back({m, grid_offset, method.make_runner(grid_offset)});
    }
  }
  return runners;
}

// What all threads share. The mutex guards done_ and failure_, and lets one thread at a time tell
// of progress; a scene is written by the one thread that has taken its index.
class Trial {
 public:
  Trial(const TrialPlan& plan, const std::vector<std::filesystem::path>& files,
        const TrialProgress& progress)
      : plan_(plan), progress_(progress), scenes_(files.size()) {
    for (std::size_t i = 0; i < files.size(); ++i) scenes_[i].file = files[i];
  }

  std::vector<Scene> run() {
    const std::size_t threads = std::min<std::size_t>(plan_.jobs, scenes_.size());
    std::vector<std::vector<Runner>> runners;
    for (std::size_t i = 0; i < threads; ++i) runners.push_back(make_runners(plan_));
    if (threads > 0) all_runs_ = scenes_.size() * runners.front().size();
    {
      std::vector<std::jthread> workers;
      workers.reserve(runners.size());
      for (auto& own : runners) workers.emplace_back([this, &own] { work(own); });
    }
    if (failure_) std::rethrow_exception(failure_);
    return std::move(scenes_);
  }

 private:
  void work(std::vector<Runner>& runners) {
    try {
      while (!failed_) {
        const std::size_t index = next_scene_++;
        if (index >= scenes_.size()) return;
        try_scene(index, runners);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      failed_ = true;
    }
  }

  void try_scene(std::size_t index, std::vector<Runner>& runners) {
    Scene& scene = scenes_[index];
    LabelledCloud cloud;
    try {
      cloud = evaluation::load_labelled_cloud(scene.file, plan_.unit);
    } catch (const std::runtime_error& error) {
      scene.problem = error.what();
      add_done(runners.size());
      return;
    }
    std::optional<Sheet> sheet;
    if (!plan_.pictures.empty()) sheet.emplace(cloud);
    scene.points = cloud.size();
    scene.runs.resize(plan_.methods.size());
    std::vector<std::uint16_t> labels(cloud.size());
    for (Runner& runner : runners) {
      const Run run = run_once(runner, cloud, labels);
      auto& runs = scene.runs[runner.method];
      if (sheet && runs.empty()) sheet->add_result(labels);
      runs.push_back(run);
      scene.true_segments = run.quality.true_segments;
      add_done(1);
    }
    if (sheet) sheet->write(plan_.pictures / sheet_name(index, scene.file));
  }

  // Leaves the labels as they were judged.
  static Run run_once(Runner& runner, const LabelledCloud& cloud,
                      std::vector<std::uint16_t>& labels) {
    Run run{.grid_offset = runner.grid_offset, .quality = {}, .boundary = {}};
    runner.peer->prepare(cloud.view());
    const double began_ms = thread_ms();
    runner.peer->segment(labels);
    run.milliseconds = thread_ms() - began_ms;
    run.quality = evaluation::judge(cloud, labels);
    run.boundary = evaluation::judge_boundaries(cloud, labels);
    return run;
  }

  void add_done(std::size_t runs) {
    const std::lock_guard lock(mutex_);
    done_ += runs;
    progress_(done_, all_runs_);
  }

  const TrialPlan& plan_;
  const TrialProgress& progress_;
  std::vector<Scene> scenes_;
  std::size_t all_runs_ = 0;
  std::atomic<std::size_t> next_scene_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

std::vector<Scene> try_scenes(const TrialPlan& plan,
                              const std::vector<std::filesystem::path>& files,
                              const TrialProgress& progress) {
  return Trial(plan, files, progress).run();
}

}  // namespace cleave::workbench
