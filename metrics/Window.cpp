#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "metrics/Samples.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Arrival.h"

namespace metrics {

namespace {

constexpr double kMotionSpeed = 0.01;  // [m/s]
constexpr double kNever = std::numeric_limits<double>::infinity();

/// "time 3.5" or "event say": the word after the first.
std::string argumentOf(const std::string& text, const std::string& word) {
  const std::string start = word + " ";
  return text.compare(0, start.size(), start) == 0 ? base::trimmed(text.substr(start.size())) : "";
}

std::optional<base::Diagnostic> boundProblem(const std::string& text,
                                             const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), text) != words.end()) {
    return std::nullopt;
  }
  if (const std::string time = argumentOf(text, "time"); !time.empty()) {
    const std::optional<double> value = base::parseDouble(time);
    return value && std::isfinite(*value) ? std::nullopt
                                          : std::optional(base::error("metrics.no-time", {time}));
  }
  if (const std::string kind = argumentOf(text, "event"); !kind.empty()) {
    return sim2d::eventKindOf(kind) ? std::nullopt
                                    : std::optional(base::error("metrics.unknown-event", {kind}));
  }
  return base::error("metrics.unknown-bound", {text, base::join(words, ", ")});
}

/// Kind of "event KIND".
std::optional<sim2d::EventKind> kindOf(const std::string& text) {
  const std::string kind = argumentOf(text, "event");
  return kind.empty() ? std::nullopt : sim2d::eventKindOf(kind);
}

/// Time that a text tells in advance.
std::optional<double> toldTime(const std::string& text) {
  const std::string time = argumentOf(text, "time");
  return time.empty() ? std::nullopt : base::parseDouble(time);
}

}  // namespace

std::optional<base::Diagnostic> windowProblem(const Window& window) {
  if (auto wrong = boundProblem(window.from, {"begin", "goal", "motion"})) {
    return base::within("from", *std::move(wrong));
  }
  if (auto wrong = boundProblem(window.until, {"end", "arrival"})) {
    return base::within("until", *std::move(wrong));
  }
  if (!(window.frequency >= 0.0) || std::isinf(window.frequency)) {
    return base::error("metrics.negative-frequency");
  }
  return std::nullopt;
}

WindowGate::WindowGate(Window window, const RunContext& context)
    : window_(std::move(window)),
      robotId_(context.robotId),
      begin_(toldTime(window_.from)),
      end_(toldTime(window_.until)),
      newest_(-kNever),
      next_(-kNever) {
  if (window_.from == "begin") {
    begin_ = -kNever;
  } else if (window_.from == "goal") {
    begin_ = context.robotStartTime;
  }
  end_ = window_.until == "end" ? kNever : end_;
}

void WindowGate::begin(double time) {
  if (begin_) {
    return;
  }
  begin_ = time;
  if (!end_ && lastEnding_ && *lastEnding_ >= time) {
    end_ = lastEnding_;
  }
}

bool WindowGate::ends(const sim2d::Event& event) const {
  return window_.until == "arrival" ? sim2d::isRobotsArrival(event, robotId_)
                                    : kindOf(window_.until) == event.kind;
}

void WindowGate::note(double time, const sim2d::Event& event) {
  if (kindOf(window_.from) == event.kind) {
    begin(time);
  }
  if (end_ || !ends(event)) {
    return;
  }
  lastEnding_ = time;
  if (begin_ && time >= *begin_) {
    end_ = time;
  }
}

/// Of an arrival between two samples the second is the last.
bool WindowGate::isPast(double time) const {
  const bool isMet = end_ && (window_.until != "arrival" || newest_ >= *end_ - kTimeSlack);
  return isMet && time > *end_ + kTimeSlack;
}

bool WindowGate::isOver(double time) const {
  return begin_ && isPast(time);
}

bool WindowGate::takes(const Sample& sample) {
  if (window_.from == "motion" && sample.robot.speed > kMotionSpeed) {
    begin(sample.time);
  }
  const bool isInside = begin_ && sample.time >= *begin_ - kTimeSlack && !isPast(sample.time);
  if (!isInside || sample.time < next_ - kTimeSlack) {
    return false;
  }
  newest_ = sample.time;
  if (window_.frequency > 0.0) {
    // The grid starts at the first sample and does not drift when steps do not fit it.
    first_ = taken_ == 0 ? sample.time : first_;
    const double place = std::floor((sample.time - first_ + kTimeSlack) * window_.frequency);
    taken_ = std::max(taken_, static_cast<long long>(place)) + 1;
    next_ = first_ + static_cast<double>(taken_) / window_.frequency;
  }
  return true;
}

}  // namespace metrics
