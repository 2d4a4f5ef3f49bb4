#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "sim2d/base/Stop.h"

namespace sim2d {

/// Lines to and from another process, in lock-step: one out, one in. Whatever that process does, no
/// call lasts longer than its deadline. Thread: one at a time.
class LineChannel {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kLongestLine = std::size_t{1} << 20U;  // [B], of what comes in
  static constexpr std::size_t kTail = 4096;                          // [B]

  /// Descriptors that do not block; they stay those of the caller. `errors` -1: there are none.
  struct Ends {
    int to = -1, from = -1, errors = -1;
  };
  enum class Outcome {
    Done,
    TimeUp,        // the line was taken, no answer came
    NotRead,       // the line was not even taken
    InputClosed,   // nobody reads any more
    OutputClosed,  // nobody writes any more
    Ended,         // the process has ended, though somebody holds its output open
    TooLong,       // more than `kLongestLine` without an end
    Unasked,       // more than one line, or one before ours was taken
  };

  /// `hasEnded`: of the other process; `stop` ends every wait at once, by `base::Stopped`.
  LineChannel(const Ends& ends, std::function<bool()> hasEnded, base::StopFlagPtr stop)
      : ends_(ends), hasEnded_(std::move(hasEnded)), stop_(std::move(stop)) {}

  /// Sends the line (without its end), waits for one and puts it into `answer` without its end (LF
  /// or CR LF).
  Outcome exchange(std::string_view line, Clock::time_point deadline, std::string& answer);
  /// Sends a last line, to which there is no answer.
  Outcome send(std::string_view line, Clock::time_point deadline);
  /// What has come and was not taken as an answer.
  const std::string& received() const { return in_; }
  /// The last `kTail` bytes that came from `errors`, as far as they have been read.
  const std::string& errorTail();

 private:
  void begin(std::string_view line);
  void wait(Clock::time_point deadline) const;
  void writeSome();
  void readSome();
  bool readErrors();
  bool isSent() const { return sent_ == out_.size(); }
  Outcome outcome(bool hasEnded) const;

  Ends ends_;
  std::function<bool()> hasEnded_;
  base::StopFlagPtr stop_;
  std::string out_;         // the line that is sent
  std::size_t sent_ = 0;    // so much of it
  std::string in_;          // read, not taken yet
  std::string tail_;        // of the errors
  bool isRefused_ = false;  // nobody reads
  bool isAtEnd_ = false;    // nobody writes
};

}  // namespace sim2d
