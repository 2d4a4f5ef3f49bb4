#include "sim2d/nav/external/ExternalProcess.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <string_view>
#include <sys/socket.h>
#include <sys/un.h>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/external/CommandWords.h"
#include "sim2d/nav/external/ShownText.h"

namespace sim2d {
namespace {

using std::chrono::milliseconds;

constexpr std::string_view kSocketPrefix = "unix:";
constexpr milliseconds kSocketPatience{2000};    // while others stand in the line of the socket
constexpr milliseconds kBetweenAttempts{10};     // idem
constexpr milliseconds kToEndByItself{1000};     // after the last line
constexpr milliseconds kBetweenLooks{20};        // at the stop flag
constexpr milliseconds kToTakeLastLine{500};     // idem
constexpr milliseconds kToEndAfterClosing{200};  // who closes its output mostly is about to end
constexpr std::size_t kShownErrors = 500;        // [B]

LineChannel::Clock::time_point externalDeadline(double seconds) {
  return LineChannel::Clock::now() + std::chrono::duration_cast<LineChannel::Clock::duration>(
                                         std::chrono::duration<double>(seconds));
}

/// The end of what it wrote to its standard error, on one line.
std::string lastWords(const std::string& errors) {
  std::string text = base::trimmed(errors);
  if (text.size() > kShownErrors) {
    text = "…" + text.substr(text.size() - kShownErrors);
  }
  std::string line;
  for (const char c : text) {
    line += c == '\n' ? std::string(" / ") : std::string(1, c);
  }
  return shownText(line, line.size());
}

/// 0, or why nobody is met there (errno).
int connectTo(const std::string& path, const base::StopFlag& stop, Descriptor& socket) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) {
    return path.empty() ? ENOENT : ENAMETOOLONG;
  }
  path.copy(address.sun_path, path.size());  // the zero at its end is there
  Descriptor end(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!end.isOpen()) {
    return errno;
  }
  const auto deadline = LineChannel::Clock::now() + kSocketPatience;
  while (::connect(end.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) !=
         0) {
    const bool mayWork = errno == EAGAIN || errno == EINTR;
    if (!mayWork || LineChannel::Clock::now() > deadline) {
      return errno;
    }
    stop.check();
    std::this_thread::sleep_for(kBetweenAttempts);
  }
  socket = std::move(end);
  return 0;
}

}  // namespace

bool ExternalProcess::isSocket(const std::string& command) {
  return command.compare(0, kSocketPrefix.size(), kSocketPrefix) == 0;
}

base::Result<std::unique_ptr<ExternalProcess>> ExternalProcess::start(const std::string& command,
                                                                      base::StopFlagPtr stop) {
  std::unique_ptr<ExternalProcess> made(new ExternalProcess(command, stop));
  LineChannel::Ends ends;
  if (isSocket(command)) {
    const std::string path = command.substr(kSocketPrefix.size());
    if (const int why = connectTo(path, *stop, made->socket_); why != 0) {
      return base::error("external.not-connected", {path, std::generic_category().message(why)});
    }
    ends = {made->socket_.number(), made->socket_.number(), -1};
  } else {
    base::Result<std::vector<std::string>> words = commandWords(command);
    if (!words) {
      return words.diagnostics();
    }
    auto child = ChildProcess::start(*std::move(words));
    if (!child) {
      return child.diagnostics();
    }
    made->child_ = *std::move(child);
    ends = {made->child_->input(), made->child_->output(), made->child_->errors()};
  }
  made->channel_ = std::make_unique<LineChannel>(
      ends, [process = made.get()] { return process->hasEnded(); }, std::move(stop));
  return made;
}

base::Result<std::string> ExternalProcess::ask(const std::string& line, double timeout) {
  if (error_) {
    return *error_;
  }
  std::string answer;
  LineChannel::Outcome outcome = LineChannel::Outcome::Done;
  try {
    outcome = channel_->exchange(line, externalDeadline(timeout), answer);
  } catch (const base::Stopped&) {
    abandon();
    throw;
  }
  if (outcome == LineChannel::Outcome::Done) {
    return answer;
  }
  error_ = errorOf(outcome, timeout);
  abandon();
  return *error_;
}

base::Diagnostic ExternalProcess::errorOf(LineChannel::Outcome outcome, double timeout) {
  switch (outcome) {
    case LineChannel::Outcome::TimeUp:
      return base::error("external.too-slow",
                         {command_, timeout, lastWords(channel_->errorTail())});
    case LineChannel::Outcome::NotRead:
      return base::error("external.not-reading", {command_, timeout});
    case LineChannel::Outcome::TooLong:
      return base::error("external.line-too-long", {command_, LineChannel::kLongestLine});
    case LineChannel::Outcome::Unasked:
      return base::error("external.unasked", {command_, shownText(channel_->received())});
    default:
      return lossOf(outcome);
  }
}

base::Diagnostic ExternalProcess::lossOf(LineChannel::Outcome outcome) {
  const auto how = child_ ? child_->ending(kToEndAfterClosing) : std::nullopt;
  const std::string words = lastWords(channel_->errorTail());
  if (how) {
    return base::error("external.died", {command_, *how, words});
  }
  const char* what = outcome == LineChannel::Outcome::InputClosed ? "input" : "output";
  return base::error("external.closed", {command_, child_ ? what : "connection", words});
}

void ExternalProcess::finish(const std::string& line) {
  if (!channel_) {
    return;
  }
  channel_->send(line, LineChannel::Clock::now() + kToTakeLastLine);  // it may have gone: all right
  if (child_) {
    child_->closeInput();
    const auto patience = LineChannel::Clock::now() + kToEndByItself;
    while (!stop_->isHeeded() && !child_->ending(kBetweenLooks) &&
           LineChannel::Clock::now() < patience) {
    }
  }
  abandon();
}

void ExternalProcess::abandon() {
  channel_.reset();
  child_.reset();
  socket_.close();
  if (!error_) {
    error_ = base::error("external.closed", {command_, "connection", ""});
  }
}

}  // namespace sim2d
