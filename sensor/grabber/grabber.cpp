// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/grabber/grabber.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace cleave::sensor {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds tick(50);           // how often the grabber looks up from waiting
constexpr milliseconds chunk_retry(5);     // lossless: until a reader gives a chunk back
constexpr milliseconds live_linger(1000);  // after the last frame
constexpr milliseconds signal_linger(1000);
constexpr milliseconds no_limit = std::chrono::hours(24 * 365);

// Beyond what can be in flight, so that unacknowledged clouds are not overwritten.
constexpr WriterDepth lossless_depth{8};
constexpr WriterDepth live_depth{2};

std::uint32_t unix_time_s() {
  return static_cast<std::uint32_t>(wall_now_ns() / 1'000'000'000);
}

}  // namespace

Grabber::Grabber(const GrabberOptions& options, Stream& stream, Source& source, Shutdown& shutdown)
    : options_(options),
      source_(source),
      shutdown_(shutdown),
      book_(unix_time_s()),
      publisher_(stream, options.sensor,
                 {options.coordinate_frame, options.parent_frame, options.pose},
                 options.window ? lossless_depth : live_depth),
      supervisor_(stream, options.sensor,
                  [this](NodeReport& report, Clock::time_point now) {
                    book_.fill(report, source_.counts(), now);
                    report.frames_in_flight = flow_ ? flow_->in_flight() : 0;
                  }),
      link_(source, supervisor_, book_),
      pacer_(options.fps) {
  if (options.window) {
    flow_.emplace(stream, options.sensor, *options.window);
    wait_set_.attach(flow_->segments());
  }
  shutdown_.on_request([this] { wait_set_.wake(); });
}

Grabber::~Grabber() {
  shutdown_.on_request([] {});
}

Ending Grabber::run() {
  if (!link_.start()) return Ending::failed;
  while (!shutdown_.requested() && !ended() && !must_start_anew()) step();
  if (must_start_anew()) return Ending::start_anew;
  if (ended()) linger(flow_ ? no_limit : live_linger);
  if (shutdown_.requested()) {
    supervisor_.set_state(NodeState::stopping);
    linger(flow_ ? signal_linger : milliseconds(0));
  }
  supervisor_.publish();
  spdlog::info("stopped sensor '{}': {} frames published", options_.sensor,
               book_.published_count());
  return shutdown_.roudi() != 0 && options_.endless ? Ending::start_anew : Ending::done;
}

bool Grabber::must_start_anew() const {
  const RouDiWatch& roudi = supervisor_.roudi();
  return roudi.restart_joins() && (options_.endless || !roudi.works_without());
}

void Grabber::step() {
  const auto now = Clock::now();
  update(now);
  if (link_.is_down()) {
    link_.reopen(now);
    if (link_.is_down()) wait_set_.wait(tick);
  } else if (const milliseconds wait = until_next(now); wait > milliseconds(0)) {
    wait_set_.wait(std::min(wait, tick));
  } else {
    take_frame();
  }
}

void Grabber::update(Clock::time_point now) {
  if (flow_) flow_->update(now, publisher_.writer());
  supervisor_.update(now);
}

bool Grabber::has_readers() const {
  return publisher_.readers() > 0 && (!flow_ || flow_->segmenters() > 0);
}

// How long to wait before a frame is taken from the source; zero = take one.
milliseconds Grabber::until_next(Clock::time_point now) {
  const bool served = has_readers();
  if (!std::exchange(said_waiting_, !served) && !served) {
    spdlog::info("waiting for a segmenter on sensor '{}'", options_.sensor);
  }
  if (flow_ && served && !flow_->ready()) return tick;
  if (source_.realtime()) return milliseconds(0);
  if (!served) return tick;
  return std::chrono::ceil<milliseconds>(pacer_.until_due(now));
}

void Grabber::take_frame() {
  Frame frame;
  switch (link_.next(tick, frame)) {
    case Poll::frame:
      frame.arrival_time_ns = monotonic_now_ns();
      if (frame.begins_epoch) book_.begin_epoch();
      pacer_.advance(Clock::now(), flow_ ? std::nullopt : frame.until_next);
      handle(frame);
      break;
    case Poll::timeout:
    case Poll::lost:
      break;
    case Poll::end:
      spdlog::info("the source has ended");
      supervisor_.set_state(NodeState::ended);
      break;
  }
}

void Grabber::handle(const Frame& frame) {
  if (!has_readers()) return book_.dropped("no reader");
  if (std::uint64_t{frame.width} * frame.height > capacity_points) return drop_too_large(frame);
  const Publication result = publish(frame);
  if (result == Publication::refused) book_.dropped("refused by DDS");
  if (result == Publication::no_large_chunks) book_.dropped("no chunks for large clouds");
  if (result == Publication::no_free_chunk) {
    book_.dropped("no free chunk");
    if (std::uint64_t suppressed = 0; log_limiter_.allow(suppressed)) {
      spdlog::warn("dropped a frame: readers hold all chunks of shared memory ({} more before)",
                   suppressed);
    }
  }
  if (options_.max_frames && book_.published_count() >= *options_.max_frames) {
    supervisor_.set_state(NodeState::ended);
  }
}

// Whatever a source promised: its points would be written behind the end of the published memory.
void Grabber::drop_too_large(const Frame& frame) {
  book_.dropped("too many points");
  if (std::uint64_t suppressed = 0; log_limiter_.allow(suppressed)) {
    spdlog::warn(
        "dropped a frame: {} x {} points, more than the {} that the stream carries{} ({} "
        "more before)",
        frame.width, frame.height, capacity_points,
        frame.height > 1 ? "; --decimate makes an image smaller" : "", suppressed);
  }
}

// In lossless mode a frame is tried until it is out.
Publication Grabber::publish(const Frame& frame) {
  KeptFrame copy;
  Publication result = publisher_.publish(frame, book_.next(), source_, flow_ ? &copy : nullptr);
  while (flow_ && result != Publication::done && result != Publication::no_large_chunks &&
         !shutdown_.requested()) {
    wait_set_.wait(chunk_retry);
    update(Clock::now());
    result = publisher_.publish(frame, book_.next(), source_, &copy);
  }
  if (result != Publication::done) return result;
  const auto now = Clock::now();
  book_.published(publisher_.zero_copy(), now);
  if (flow_) flow_->published(std::move(copy), now);
  return result;
}

void Grabber::linger(milliseconds at_most) {
  const bool asked_before = shutdown_.requested();
  const auto deadline = Clock::now() + at_most;
  for (auto now = Clock::now(); now < deadline; now = Clock::now()) {
    update(now);
    if (flow_ && flow_->in_flight() == 0) return;
    if (shutdown_.requested() && !asked_before) return;
    wait_set_.wait(tick);
  }
}

}  // namespace cleave::sensor
