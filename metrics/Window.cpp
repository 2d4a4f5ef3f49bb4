#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/Recording.h"
#include "sim2d/base/Text.h"

namespace metrics {

namespace {

constexpr double kMotionSpeed = 0.01;  // [m/s]
constexpr double kTimeSlack = 1e-9;    // [s]
constexpr double kNever = std::numeric_limits<double>::infinity();

/// "time 3.5" or "event say": the word after the first.
std::string argumentOf(const std::string& text, const std::string& word) {
  const std::string start = word + " ";
  return text.compare(0, start.size(), start) == 0 ? base::trimmed(text.substr(start.size())) : "";
}

std::string boundProblem(const std::string& text, const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), text) != words.end()) {
    return "";
  }
  if (const std::string time = argumentOf(text, "time"); !time.empty()) {
    const std::optional<double> value = base::parseDouble(time);
    return value && std::isfinite(*value) ? "" : "'" + time + "' is not a time";
  }
  if (const std::string kind = argumentOf(text, "event"); !kind.empty()) {
    return sim2d::eventKindOf(kind) ? "" : "unknown kind of event '" + kind + "'";
  }
  std::string known;
  for (const std::string& word : words) {
    known += word + ", ";
  }
  return "'" + text + "' is none of " + known + "time T, event KIND";
}

template <class Holds>
double firstEvent(const Recording& recording, double after, Holds holds) {
  for (const auto& [time, event] : recording.events) {
    if (time >= after && holds(event)) {
      return time;
    }
  }
  return kNever;
}

/// Time of "time T" and "event KIND"; nothing for the other words.
std::optional<double> timeOf(const Recording& recording, const std::string& text, double after) {
  if (const std::string time = argumentOf(text, "time"); !time.empty()) {
    return base::parseDouble(time).value_or(kNever);
  }
  if (const std::string kind = argumentOf(text, "event"); !kind.empty()) {
    const std::optional<sim2d::EventKind> wanted = sim2d::eventKindOf(kind);
    return firstEvent(recording, after,
                      [&](const sim2d::Event& event) { return event.kind == wanted; });
  }
  return std::nullopt;
}

double beginOf(const Recording& recording, const std::string& from) {
  if (from == "goal") {
    return recording.robotStartTime;
  }
  if (from == "motion") {
    for (const Sample& sample : recording.samples) {
      if (sample.robot.speed > kMotionSpeed) {
        return sample.time;
      }
    }
    return kNever;
  }
  return timeOf(recording, from, -kNever).value_or(-kNever);
}

double endOf(const Recording& recording, const std::string& until, double begin) {
  if (until == "arrival") {
    const int robot =
        recording.hasRobot && !recording.samples.empty() ? recording.samples.front().robot.id : -1;
    return firstEvent(recording, begin, [robot](const sim2d::Event& event) {
      return event.kind == sim2d::EventKind::Arrived && event.id == robot;
    });
  }
  return timeOf(recording, until, begin).value_or(kNever);
}

}  // namespace

std::string windowProblem(const Window& window) {
  if (const std::string problem = boundProblem(window.from, {"begin", "goal", "motion"});
      !problem.empty()) {
    return "from: " + problem;
  }
  if (const std::string problem = boundProblem(window.until, {"end", "arrival"});
      !problem.empty()) {
    return "until: " + problem;
  }
  if (!(window.frequency >= 0.0) || std::isinf(window.frequency)) {
    return "frequency must be 0 or greater";
  }
  return "";
}

Recording cut(const Recording& recording, const Window& window) {
  const double begin = beginOf(recording, window.from);
  const double end = endOf(recording, window.until, begin);
  Recording part = recording;
  part.samples.clear();
  double next = -kNever;
  double first = 0.0;
  long long taken = 0;
  for (const Sample& sample : recording.samples) {
    if (sample.time < begin - kTimeSlack || sample.time > end + kTimeSlack ||
        sample.time < next - kTimeSlack) {
      continue;
    }
    first = part.samples.empty() ? sample.time : first;
    part.samples.push_back(sample);
    if (window.frequency > 0.0) {
      // The grid starts at the first sample and does not drift when steps do not fit it.
      taken = std::max(taken + 1, static_cast<long long>(std::floor(
                                      (sample.time - first + kTimeSlack) * window.frequency)) +
                                      1);
      next = first + static_cast<double>(taken) / window.frequency;
    }
  }
  return part;
}

}  // namespace metrics
