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

constexpr milliseconds kSlice{20};  // between looks at the stop flag and the process
constexpr std::size_t kPiece = std::size_t{1} << 14U;  // [B], of one reading
constexpr int kMostPieces = 64;                        // of the errors: more than a pipe holds

/// As long as it lives, a write to a pipe that nobody reads gives EPIPE and no signal, in this
/// thread; the rest of the program keeps its own idea of SIGPIPE.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    ::sigemptyset(&pipe_);
    ::sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    ::sigpending(&pending);
    wasPending_ = ::sigismember(&pending, SIGPIPE) == 1;
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~NoPipeSignal() {
    const timespec noTime{};
    if (!wasPending_) {
      while (::sigtimedwait(&pipe_, nullptr, &noTime) < 0 && errno == EINTR) {
      }
    }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;
  NoPipeSignal(NoPipeSignal&&) = delete;
  NoPipeSignal& operator=(NoPipeSignal&&) = delete;

 private:
  sigset_t pipe_{};
  sigset_t before_{};
  bool wasPending_ = false;
};

/// Appends one piece of what there is to read. Null: nothing at the moment; else its size, 0 at the
/// end.
std::optional<std::size_t> appendPiece(int from, std::string& to) {
  const std::size_t before = to.size();
  to.resize(before + kPiece);
  ssize_t count = 0;
  do {
    count = ::read(from, to.data() + before, kPiece);
  } while (count < 0 && errno == EINTR);
  const bool isEmpty = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
  const std::size_t got = count > 0 ? static_cast<std::size_t>(count) : 0;
  to.resize(before + got);
  return isEmpty ? std::nullopt : std::make_optional(got);  // other errors: there comes no more
}

}  // namespace

void LineChannel::begin(std::string_view line) {
  out_.assign(line);
  out_ += '\n';
  sent_ = 0;
}

void LineChannel::wait(Clock::time_point deadline) const {
  const auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
  const auto slice = std::clamp(left, milliseconds{0}, kSlice);
  pollfd all[3] = {{ends_.from, POLLIN, 0}, {ends_.errors, POLLIN, 0}, {-1, POLLOUT, 0}};
  if (!isSent()) {
    all[2].fd = ends_.to;
  }
  ::poll(all, 3, static_cast<int>(slice.count()));  // what it tells, the calls below find out
}

void LineChannel::writeSome() {
  while (!isSent() && !isRefused_) {
    const NoPipeSignal noSignal;
    const ssize_t count = ::write(ends_.to, out_.data() + sent_, out_.size() - sent_);
    if (count >= 0) {
      sent_ += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      return;
    } else if (errno != EINTR) {
      isRefused_ = true;
    }
  }
}

void LineChannel::readSome() {
  std::optional<std::size_t> got = 1;
  while (got && *got > 0 && in_.size() <= kLongestLine) {
    got = appendPiece(ends_.from, in_);
  }
  isAtEnd_ = isAtEnd_ || got == std::size_t{0};
}

/// One piece at a time: who floods his errors must not keep us. False: there is nothing.
bool LineChannel::readErrors() {
  if (ends_.errors < 0) {
    return false;
  }
  const std::optional<std::size_t> got = appendPiece(ends_.errors, tail_);
  if (got == std::size_t{0}) {
    ends_.errors = -1;
  }
  if (tail_.size() > kTail) {
    tail_.erase(0, tail_.size() - kTail);
  }
  return got && *got > 0;
}

const std::string& LineChannel::errorTail() {
  for (int i = 0; i < kMostPieces && readErrors(); ++i) {
  }
  return tail_;
}

/// TimeUp and NotRead: nothing speaks against waiting, if there is time left.
LineChannel::Outcome LineChannel::outcome(bool hasEnded) const {
  const std::size_t end = in_.find('\n');
  if (end <= kLongestLine && isSent()) {
    return end + 1 == in_.size() ? Outcome::Done : Outcome::Unasked;
  }
  if (in_.size() > kLongestLine) {
    return Outcome::TooLong;
  }
  if (isAtEnd_ || hasEnded) {
    return isAtEnd_ ? Outcome::OutputClosed : Outcome::Ended;
  }
  if (isRefused_) {
    return Outcome::InputClosed;
  }
  if (isSent()) {
    return Outcome::TimeUp;
  }
  return in_.empty() ? Outcome::NotRead : Outcome::Unasked;
}

LineChannel::Outcome LineChannel::exchange(std::string_view line, Clock::time_point deadline,
                                           std::string& answer) {
  readSome();
  if (!in_.empty()) {
    return in_.size() > kLongestLine ? Outcome::TooLong : Outcome::Unasked;
  }
  begin(line);
  while (true) {
    stop_->check();
    const bool hasEnded = hasEnded_();  // asked first: what it wrote before is read below
    const bool isTimeUp = Clock::now() >= deadline;
    writeSome();
    wait(hasEnded ? Clock::now() : deadline);
    readErrors();
    readSome();
    const Outcome now = outcome(hasEnded);
    if (now == Outcome::Done) {
      const std::size_t end = in_.find('\n');
      answer.assign(in_, 0, end > 0 && in_[end - 1] == '\r' ? end - 1 : end);
      in_.clear();
      return now;
    }
    if (isTimeUp || (now != Outcome::TimeUp && now != Outcome::NotRead)) {
      return now;
    }
  }
}

LineChannel::Outcome LineChannel::send(std::string_view line, Clock::time_point deadline) {
  begin(line);
  while (!hasEnded_()) {
    writeSome();
    if (isSent() || isRefused_) {
      return isRefused_ ? Outcome::InputClosed : Outcome::Done;
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
