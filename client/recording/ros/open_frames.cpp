// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ros/open_frames.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "recording/frames/frame_reader.hpp"
#include "recording/ros/cloud_reader.hpp"
#include "recording/ros/topic_survey.hpp"

namespace cleave::recording {
namespace {

using ros::TopicKind;
using ros::TopicSurvey;
using ros::TopicUse;

// Whether the file's other messages can change what is to be opened.
bool is_decided(const TopicSurvey& survey, const Contents& contents, const std::string& topic) {
  if (!topic.empty()) return survey.is_settled(topic) || survey.is_settled("/" + topic);
  if (survey.has_cleave_cloud()) return true;
  // Only an index says which topics there are.
  return !contents.message_counts.empty() &&
         std::ranges::all_of(contents.message_counts, [&](const auto& entry) {
           return entry.second == 0 || survey.is_settled(entry.first);
         });
}

// Reads no further than it must.
std::vector<TopicUse> survey_of(McapReader& reader, const std::string& topic) {
  TopicSurvey survey;
  while (const auto message = reader.next()) {
    survey.add(*message);
    // Only a topic's first messages, and those of a camera, can decide anything.
    if (is_decided(survey, reader.contents(), topic)) break;
  }
  std::vector<TopicUse> uses = survey.topics();
  for (TopicUse& use : uses) {
    const auto counted = reader.contents().message_counts.find(use.topic);
    if (counted != reader.contents().message_counts.end()) use.messages = counted->second;
  }
  return uses;
}

std::string line_of(const TopicUse& use) {
  return "\n  " + use.topic + " (" + (use.type.empty() ? "no type" : use.type) + ", " +
         std::to_string(use.messages) + (use.messages == 1 ? " message)" : " messages)") +
         (use.why.empty() ? "" : ": " + use.why);
}

std::string lines_of(const std::vector<TopicUse>& uses) {
  std::string lines;
  for (const TopicUse& use : uses) lines += line_of(use);
  return lines;
}

[[noreturn]] void refuse_without_topics(const std::filesystem::path& file,
                                        const McapReader& reader) {
  throw FileError(file.string() + ": holds no messages" +
                  (reader.problems().empty() ? "" : ": " + reader.problems().front()));
}

// The topic of that name, with or without ROS's slash before it. Throws FileError.
const TopicUse& named(const FileTopic& from, const std::vector<TopicUse>& uses) {
  auto found = std::ranges::find(uses, from.topic, &TopicUse::topic);
  if (found == uses.end()) found = std::ranges::find(uses, "/" + from.topic, &TopicUse::topic);
  if (found == uses.end()) {
    throw FileError(from.file.string() + ": has no topic '" + from.topic + "', but" +
                    lines_of(uses));
  }
  if (found->usable()) return *found;
  throw FileError(from.file.string() + ": this topic cannot be segmented:" + line_of(*found));
}

// The only topic that can be segmented. Throws FileError.
const TopicUse& only(const FileTopic& from, const std::vector<TopicUse>& uses) {
  std::vector<TopicUse> usable;
  std::ranges::copy_if(uses, std::back_inserter(usable), &TopicUse::usable);
  if (usable.empty()) {
    throw FileError(from.file.string() + ": holds no cloud that can be used:" + lines_of(uses));
  }
  if (usable.size() > 1) {
    throw FileError(
        from.file.string() + ": has several topics that can be segmented; name one, as in '" +
        from.file.string() + "?topic=" + usable.front().topic + "':" + lines_of(usable));
  }
  return *std::ranges::find_if(uses, &TopicUse::usable);
}

// "camera" of "cleave/camera/cloud"
std::string sensor_of(const std::string& topic) {
  const std::size_t first = topic.find('/') + 1;
  return topic.substr(first, topic.find('/', first) - first);
}

}  // namespace

std::unique_ptr<FrameInput> open_frames(const FileTopic& from, const std::set<Kind>& kinds,
                                        const std::string& sensor) {
  McapReader reader(from.file);
  const std::vector<TopicUse> uses = survey_of(reader, from.topic);
  if (uses.empty()) refuse_without_topics(from.file, reader);
  const bool clouds_alone = kinds == std::set{Kind::cloud};
  const bool ours = std::ranges::any_of(uses, [&](const TopicUse& use) {
    return use.kind == TopicKind::cleave_cloud ||
           (!clouds_alone && use.type.starts_with("cleave::"));  // labels or segments
  });
  if (from.topic.empty() && ours) {
    return std::make_unique<FrameReader>(from.file, Selection{kinds, "", 0, {}});
  }
  const TopicUse& topic = from.topic.empty() ? only(from, uses) : named(from, uses);
  if (topic.kind == TopicKind::cleave_cloud) {
    return std::make_unique<FrameReader>(from.file,
                                         Selection{kinds, sensor_of(topic.topic), 0, {}});
  }
  return std::make_unique<ros::CloudReader>(from.file, topic, sensor);
}

}  // namespace cleave::recording
