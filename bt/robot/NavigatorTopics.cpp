#include "bt/robot/NavigatorTopics.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sim2d/base/Text.h"

namespace bt {
namespace {

std::string bareName(const std::string& topic) {
  return !topic.empty() && topic.front() == '/' ? topic.substr(1) : topic;
}

/// Removes and returns the first word.
std::string takeWord(std::string& line) {
  const std::size_t end = std::min(line.find(' '), line.size());
  std::string word = line.substr(0, end);
  line = base::trimmed(line.substr(end));
  return word;
}

}  // namespace

base::Result<NavigatorTopics> NavigatorTopics::read(const std::string& text) {
  NavigatorTopics topics;
  base::Diagnostics problems;
  for (const std::string& part : base::split(text, ';')) {
    std::string rest = base::trimmed(part);
    if (rest.empty()) {
      continue;
    }
    const std::optional<double> time = base::parseDouble(takeWord(rest));
    const std::string name = bareName(takeWord(rest));
    if (!time || !(*time >= 0.0) || !std::isfinite(*time) || name.empty()) {
      problems.push_back(base::error("nav2.topic", {base::trimmed(part)}));
      continue;
    }
    topics.topics_[name].push_back({*time, rest});
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  for (auto& [name, messages] : topics.topics_) {
    std::stable_sort(messages.begin(), messages.end(),
                     [](const Published& a, const Published& b) { return a.time < b.time; });
  }
  return topics;
}

std::vector<TopicMessage> NavigatorTopics::after(const std::string& topic, int number,
                                                 double now) const {
  constexpr double kRounding = 1e-9;  // [s]
  std::vector<TopicMessage> messages;
  const auto found = topics_.find(bareName(topic));
  if (found == topics_.end()) {
    return messages;
  }
  int count = 0;
  for (const Published& each : found->second) {
    ++count;
    if (count > number && each.time <= now + kRounding) {
      messages.push_back({each.time, each.text, count});
    }
  }
  return messages;
}

TopicMessage NavigatorTopics::lastOf(const std::string& topic, double now) const {
  const std::vector<TopicMessage> messages = after(topic, 0, now);
  return messages.empty() ? TopicMessage() : messages.back();
}

}  // namespace bt
