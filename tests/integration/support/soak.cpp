// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/support/soak.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/integration/support/daemons.hpp"

namespace cleave::test {
namespace {

constexpr std::size_t scenes = 8;
constexpr std::chrono::milliseconds sample_interval{250};
constexpr char fastest_fps[] = "240";

std::size_t resident_kb(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string word; status >> word;) {
    std::size_t kb = 0;
    if (word == "VmRSS:" && status >> kb) return kb;
  }
  return 0;
}

void add_sample(SoakResult::Memory& memory, pid_t process) {
  const std::size_t kb = resident_kb(process);
  if (kb == 0) return;  // it has ended
  memory.smallest_kb = memory.samples == 0 ? kb : std::min(memory.smallest_kb, kb);
  memory.largest_kb = std::max(memory.largest_kb, kb);
  ++memory.samples;
}

void render_scenes(const Daemons& daemons, const std::filesystem::path& folder) {
  Process render =
      daemons.run("cleave-render", {"medium", "--count", std::to_string(scenes), folder.string()});
  if (render.wait() != 0) throw std::runtime_error("cannot render the scenes: " + render.log());
}

// "frame id, hash" a line, as label_hasher writes them. Ids count from 1 in the loop's order.
void compare_labels(const std::string& lines, SoakResult& result) {
  std::istringstream stream(lines);
  std::map<std::size_t, std::string> of_frame;
  std::map<std::size_t, std::string> of_scene;
  std::string hash;
  for (std::size_t id = 0; stream >> id >> hash;) {
    if (!of_frame.emplace(id, hash).second) ++result.resends;
    if (of_scene.emplace(id % scenes, hash).first->second != hash) ++result.differing;
  }
  result.frames = of_frame.size();
  result.scenes = of_scene.size();
}

std::size_t count_lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

SoakResult soak(std::size_t frames, std::uint32_t domain,
                const std::function<void(std::size_t)>& on_progress) {
  const Daemons daemons(domain, true);
  const TemporaryFolder folder;
  render_scenes(daemons, folder.path());
  Process segmenter = daemons.segmenter({"--lossless"});
  Process hasher = daemons.run("label_hasher", {"camera", std::to_string(frames)});
  if (!segmenter.logs("ready") || !hasher.logs("ready")) {
    throw std::runtime_error("not ready: " + segmenter.log() + hasher.log());
  }
  Process grabber = daemons.grabber(
      "pcd:" + folder.path().string(),
      {"--lossless", "--loop", "--fps", fastest_fps, "--frames", std::to_string(frames)});
  SoakResult result;
  result.memory = {{"cleave-segmenter"}, {"cleave-grabber"}};
  while (hasher.running()) {
    const std::size_t so_far = count_lines(hasher.output());
    on_progress(so_far);
    if (so_far >= soak_warm_up_frames && so_far < frames) {
      add_sample(result.memory[0], segmenter.id());
      add_sample(result.memory[1], grabber.id());
    }
    std::this_thread::sleep_for(sample_interval);
  }
  if (hasher.wait() != 0) {
    throw std::runtime_error("the frames stopped coming: " + hasher.log() + segmenter.log() +
                             grabber.log());
  }
  compare_labels(hasher.output(), result);
  return result;
}

}  // namespace cleave::test
