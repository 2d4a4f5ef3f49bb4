#include "sim2d/nav/external/LineChannel.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <optional>
#include <poll.h>
#include <pthread.h>
#include <unistd.h>

namespace sim2d {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kChannelPollInterval{20};  // between checks of the stop flag and the process
constexpr std::size_t kReadBlockSize = std::size_t{1} << 14U;  // [B], per read call
constexpr int kMaxErrorBlocks = 64;                            // of the error stream

/// While it lives, a write to a pipe without reader gives EPIPE instead of SIGPIPE in this thread;
/// the signal handling of the rest of the program is unchanged.
class SigpipeBlocker {
 public:
  SigpipeBlocker() {
    ::sigemptyset(&pipe_);
    ::sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    ::sigpending(&pending);
    wasPending_ = ::sigismember(&pending, SIGPIPE) == 1;
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~SigpipeBlocker() {
    const timespec noTime{};
    if (!wasPending_) {
      while (::sigtimedwait(&pipe_, nullptr, &noTime) < 0 && errno == EINTR) {
      }
    }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  SigpipeBlocker(const SigpipeBlocker&) = delete;
  SigpipeBlocker& operator=(const SigpipeBlocker&) = delete;
  SigpipeBlocker(SigpipeBlocker&&) = delete;
  SigpipeBlocker& operator=(SigpipeBlocker&&) = delete;

 private:
  sigset_t pipe_{};
  sigset_t before_{};
  bool wasPending_ = false;
};

/// Appends one block of available data. Null: none at the moment; otherwise its size, 0 at the end
/// of the stream.
std::optional<std::size_t> readBlock(int from, std::string& to) {
  const std::size_t before = to.size();
  to.resize(before + kReadBlockSize);
  ssize_t count = 0;
  do {
    count = ::read(from, to.data() + before, kReadBlockSize);
  } while (count < 0 && errno == EINTR);
  const bool isEmpty = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
  const std::size_t got = count > 0 ? static_cast<std::size_t>(count) : 0;
  to.resize(before + got);
  return isEmpty ? std::nullopt : std::make_optional(got);  // other errors: end of the stream
}

}  // namespace

void LineChannel::begin(std::string_view line) {
  outgoing_.assign(line);
  outgoing_ += '\n';
  sent_ = 0;
}

void LineChannel::wait(Clock::time_point deadline) const {
  const auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
  const auto slice = std::clamp(left, milliseconds{0}, kChannelPollInterval);
  pollfd all[3] = {{ends_.from, POLLIN, 0}, {ends_.errors, POLLIN, 0}, {-1, POLLOUT, 0}};
  if (!isSent()) {
    all[2].fd = ends_.to;
  }
  ::poll(all, 3, static_cast<int>(slice.count()));  // results are found by the calls below
}

void LineChannel::writeSome() {
  while (!isSent() && !isInputClosed_) {
    const SigpipeBlocker noSignal;
    const ssize_t count = ::write(ends_.to, outgoing_.data() + sent_, outgoing_.size() - sent_);
    if (count >= 0) {
      sent_ += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      return;
    } else if (errno != EINTR) {
      isInputClosed_ = true;
    }
  }
}

void LineChannel::readSome() {
  std::optional<std::size_t> got = 1;
  while (got && *got > 0 && received_.size() <= kMaxLineLength) {
    got = readBlock(ends_.from, received_);
  }
  isOutputClosed_ = isOutputClosed_ || got == std::size_t{0};
}

/// Reads one block of the error stream, so that a program that floods it cannot block the exchange.
/// Returns false if there was nothing to read.
bool LineChannel::readErrors() {
  if (ends_.errors < 0) {
    return false;
  }
  const std::optional<std::size_t> got = readBlock(ends_.errors, errorTail_);
  if (got == std::size_t{0}) {
    ends_.errors = -1;
  }
  if (errorTail_.size() > kErrorTailSize) {
    errorTail_.erase(0, errorTail_.size() - kErrorTailSize);
  }
  return got && *got > 0;
}

const std::string& LineChannel::errorTail() {
  for (int i = 0; i < kMaxErrorBlocks && readErrors(); ++i) {
  }
  return errorTail_;
}

/// Timeout and NotRead mean that waiting can continue if time is left.
LineChannel::Outcome LineChannel::outcome(bool hasEnded) const {
  const std::size_t end = received_.find('\n');
  if (end <= kMaxLineLength && isSent()) {
    return end + 1 == received_.size() ? Outcome::Done : Outcome::UnexpectedLine;
  }
  if (received_.size() > kMaxLineLength) {
    return Outcome::TooLong;
  }
  if (isOutputClosed_ || hasEnded) {
    return isOutputClosed_ ? Outcome::OutputClosed : Outcome::Ended;
  }
  if (isInputClosed_) {
    return Outcome::InputClosed;
  }
  if (isSent()) {
    return Outcome::Timeout;
  }
  return received_.empty() ? Outcome::NotRead : Outcome::UnexpectedLine;
}

LineChannel::Outcome LineChannel::exchange(std::string_view line, Clock::time_point deadline,
                                           std::string& answer) {
  readSome();
  if (!received_.empty()) {
    return received_.size() > kMaxLineLength ? Outcome::TooLong : Outcome::UnexpectedLine;
  }
  begin(line);
  while (true) {
    stop_->check();
    const bool hasEnded = hasEnded_();  // checked first, so that its last output is read below
    const bool isTimeUp = Clock::now() >= deadline;
    writeSome();
    wait(hasEnded ? Clock::now() : deadline);
    readErrors();
    readSome();
    const Outcome now = outcome(hasEnded);
    if (now == Outcome::Done) {
      const std::size_t end = received_.find('\n');
      answer.assign(received_, 0, end > 0 && received_[end - 1] == '\r' ? end - 1 : end);
      received_.clear();
      return now;
    }
    if (isTimeUp || (now != Outcome::Timeout && now != Outcome::NotRead)) {
      return now;
    }
  }
}

LineChannel::Outcome LineChannel::send(std::string_view line, Clock::time_point deadline) {
  begin(line);
  while (!hasEnded_()) {
    writeSome();
    if (isSent() || isInputClosed_) {
      return isInputClosed_ ? Outcome::InputClosed : Outcome::Done;
    }
    if (Clock::now() >= deadline) {
      return Outcome::NotRead;
    }
    wait(deadline);
    readErrors();
  }
  return Outcome::Ended;
}

}  // namespace sim2d
