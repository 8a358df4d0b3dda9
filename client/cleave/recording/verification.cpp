#include "cleave/recording/verification.hpp"

#include <utility>

#include "recording/error.hpp"
#include "recording/frames/frame_writer.hpp"

namespace cleave::client {
namespace {

// Enough for every worker to be busy until the last one has done.
constexpr std::size_t clouds_a_worker = 4;

struct Segmented {
  std::int64_t log_time_ns;
  SegmentedCloud result;
};

// Calls on_frame for every cloud of the recording, in order. What of the file is damaged.
std::vector<std::string> segment_all(const std::filesystem::path& input,
                                     OfflineSegmenter& segmenter,
                                     const std::function<void(Segmented)>& on_frame,
                                     const std::function<void(std::size_t)>& on_progress) {
  recording::FrameReader reader(input, {{recording::Kind::cloud}, "", 0, {}});
  std::size_t done = 0;
  bool more = true;
  while (more) {
    std::vector<std::int64_t> times_ns;
    std::vector<recording::Cloud> clouds;
    while (clouds.size() < clouds_a_worker * segmenter.workers()) {
      auto frame = reader.next();
      more = frame.has_value();
      if (!more) break;
      times_ns.push_back(frame->log_time_ns);
      clouds.push_back(std::get<recording::Cloud>(std::move(frame->content)));
    }
    std::vector<SegmentedCloud> results = segmenter.segment(clouds);
    for (std::size_t i = 0; i < results.size(); ++i) {
      on_frame({times_ns[i], std::move(results[i])});
    }
    done += results.size();
    on_progress(done);
  }
  return reader.problems();
}

}  // namespace

VerificationResult verify(const std::filesystem::path& input, const std::filesystem::path& golden,
                          OfflineSegmenter& segmenter, const Tolerances& tolerances,
                          const std::function<void(const FrameDifference&)>& on_difference,
                          const std::function<void(std::size_t)>& on_progress) {
  GoldenFrames expected(golden);
  VerificationResult result;
  const auto compare = [&](const Segmented& frame) {
    ++result.frames;
    const recording::FrameHeader& header = frame.result.labels.header;
    const auto known = expected.take(header);
    if (!known) {
      ++result.not_expected;
      on_difference({header, {"is not in " + golden.string()}});
      return;
    }
    std::vector<std::string> lines = differences(*known, frame.result, tolerances);
    if (lines.empty()) return;
    ++result.different;
    on_difference({header, std::move(lines)});
  };
  result.problems = segment_all(input, segmenter, compare, on_progress);
  result.missing = expected.left();
  for (std::string& problem : expected.problems()) {
    result.problems.push_back(golden.string() + ": " + std::move(problem));
  }
  return result;
}

std::size_t write_golden(const std::filesystem::path& input, const std::filesystem::path& golden,
                         OfflineSegmenter& segmenter,
                         const std::function<void(std::size_t)>& on_progress) {
  std::filesystem::path partial = golden;
  partial += ".partial";
  std::size_t frames = 0;
  try {
    recording::FrameWriter writer(partial);
    const auto write = [&](Segmented frame) {
      writer.write({frame.log_time_ns, std::move(frame.result.labels)});
      writer.write({frame.log_time_ns, std::move(frame.result.list)});
      ++frames;
    };
    const auto problems = segment_all(input, segmenter, write, on_progress);
    if (!problems.empty()) {
      throw recording::FileError(input.string() + ": is damaged: " + problems.front() +
                                 "; `cleave recover` keeps what is intact");
    }
    writer.close();
    std::filesystem::rename(partial, golden);
  } catch (...) {
    std::error_code ignored;  // the failure that is reported is the first one
    std::filesystem::remove(partial, ignored);
    throw;
  }
  return frames;
}

}  // namespace cleave::client
