#include "bt/robot/NavigatorHost.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim2d/base/Text.h"

namespace bt {
namespace {

/// Removes and returns the first word.
std::string takeWord(std::string& line) {
  const std::size_t end = std::min(line.find(' '), line.size());
  std::string word = line.substr(0, end);
  line = base::trimmed(line.substr(end));
  return word;
}

}  // namespace

std::string bareName(const std::string& name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

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

PathId PathStore::add(sim2d::nav2::Path path) {
  poses_ += path.size();
  paths_.push_back(std::make_unique<const sim2d::nav2::Path>(std::move(path)));
  constexpr std::size_t kAlways = 1;  // the new path is always kept
  while (paths_.size() > kAlways && (paths_.size() > kMost || poses_ > kMostPoses)) {
    poses_ -= paths_.front()->size();
    paths_.pop_front();
  }
  return ++newest_;
}

PathId PathStore::addUnlessEqual(sim2d::nav2::Path path, PathId known) {
  const sim2d::nav2::Path& before = get(known);
  const bool isSame = known > 0 && path == before;
  return isSame ? known : add(std::move(path));
}

const sim2d::nav2::Path& PathStore::get(PathId id) const {
  static const sim2d::nav2::Path kNone;
  const PathId first = newest_ - static_cast<PathId>(paths_.size()) + 1;
  const bool isKept = id >= first && id <= newest_ && id > 0;
  return isKept ? *paths_[static_cast<std::size_t>(id - first)] : kNone;
}

double lengthOf(const sim2d::nav2::Path& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += (path[i].position - path[i - 1].position).norm();
  }
  return length;
}

}  // namespace bt
