#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "sim2d/base/StopFlag.h"

namespace sim2d {

/// Exchange of lines with another process in lock-step: one out, one in. No call exceeds its
/// deadline. Not thread-safe.
class LineChannel {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMaxLineLength = std::size_t{1} << 20U;  // [B], of an incoming line
  static constexpr std::size_t kErrorTailSize = 4096;                   // [B]

  /// Non-blocking descriptors, owned by the caller. `errors` -1: none.
  struct Ends {
    int to = -1, from = -1, errors = -1;
  };
  enum class Outcome {
    Done,
    Timeout,         // the line was accepted, but no answer came
    NotRead,         // the line was not accepted completely
    InputClosed,     // the peer no longer reads
    OutputClosed,    // the peer no longer writes
    Ended,           // the process has ended, but its output is held open
    TooLong,         // more than `kMaxLineLength` without a line ending
    UnexpectedLine,  // more than one line, or a line before ours was sent
  };

  /// `hasEnded`: whether the other process has ended; `stop` interrupts every wait with
  /// `base::Stopped`.
  LineChannel(const Ends& ends, std::function<bool()> hasEnded, base::StopFlagPtr stop)
      : ends_(ends), hasEnded_(std::move(hasEnded)), stop_(std::move(stop)) {}

  /// Sends the line (without line ending), waits for one line and stores it in `answer` without its
  /// ending (LF or CR LF).
  Outcome exchange(std::string_view line, Clock::time_point deadline, std::string& answer);
  /// Sends a last line that has no answer.
  Outcome send(std::string_view line, Clock::time_point deadline);
  /// Received data that was not consumed as an answer.
  const std::string& received() const { return received_; }
  /// The last `kErrorTailSize` bytes read from `errors`.
  const std::string& errorTail();

 private:
  void begin(std::string_view line);
  void wait(Clock::time_point deadline) const;
  void writeSome();
  void readSome();
  bool readErrors();
  bool isSent() const { return sent_ == outgoing_.size(); }
  Outcome outcome(bool hasEnded) const;

  Ends ends_;
  std::function<bool()> hasEnded_;
  base::StopFlagPtr stop_;
  std::string outgoing_;         // line being sent
  std::size_t sent_ = 0;         // bytes sent
  std::string received_;         // received, not consumed yet
  std::string errorTail_;        // of the error stream
  bool isInputClosed_ = false;   // the peer does not read
  bool isOutputClosed_ = false;  // the peer does not write
};

}  // namespace sim2d
