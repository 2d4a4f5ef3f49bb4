#include "sim2d/nav/external/ExternalProcess.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <linux/close_range.h>
#include <string_view>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/external/CommandLine.h"

namespace sim2d {
namespace {

using Milliseconds = ChildProcess::Milliseconds;

constexpr Milliseconds kTermToKillDelay{500};  // between SIGTERM and SIGKILL
constexpr Milliseconds kExitPollInterval{1};   // between checks for its end
constexpr int kNotStarted = 127;

/// Data of the new process, prepared before the fork: between fork and exec nothing may be
/// allocated.
struct Launch {
  const char* file = nullptr;
  char* const* words = nullptr;
  int standard[3] = {-1, -1, -1};  // its standard input, output and error
  int report = -1;                 // receives errno if it cannot be started
  pid_t parent = -1;
  int mostFiles = 1024;
};

/// Moves a descriptor above the standard numbers, so that dup2 never meets its own target.
int moveAboveStandard(FileDescriptor& descriptor) {
  if (descriptor.number() > STDERR_FILENO) {
    return 0;
  }
  FileDescriptor higher(::fcntl(descriptor.number(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  if (!higher.isOpen()) {
    return errno;
  }
  std::swap(descriptor, higher);
  return 0;
}

int openPipe(FileDescriptor& readEnd, FileDescriptor& writeEnd) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    return errno;
  }
  readEnd = FileDescriptor(ends[0]);
  writeEnd = FileDescriptor(ends[1]);
  const int error = moveAboveStandard(readEnd);
  return error != 0 ? error : moveAboveStandard(writeEnd);
}

int setNonBlocking(const FileDescriptor& descriptor) {
  const int flags = ::fcntl(descriptor.number(), F_GETFL);
  return flags >= 0 && ::fcntl(descriptor.number(), F_SETFL, flags | O_NONBLOCK) == 0 ? 0 : errno;
}

/// In the child, between fork and exec: async-signal-safe calls only.
void closeOtherDescriptors(int mostFiles) {
  if (::syscall(SYS_close_range, STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC) == 0) {
    return;
  }
  for (int file = STDERR_FILENO + 1; file < mostFiles; ++file) {  // kernels before 5.11
    ::fcntl(file, F_SETFD, FD_CLOEXEC);
  }
}

/// In the child: default signal handling, independent of signals that the parent ignores or blocks.
void resetSignals() {
  struct sigaction usual = {};
  usual.sa_handler = SIG_DFL;
  for (int signal = 1; signal < NSIG; ++signal) {
    ::sigaction(signal, &usual,
                nullptr);  // refused for SIGKILL, SIGSTOP and those of the C library
  }
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// In the child, with all signals blocked.
[[noreturn]] void becomeChild(const Launch& launch) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != launch.parent) {  // the parent died before prctl
    ::_exit(kNotStarted);
  }
  for (int standard = 0; standard < 3; ++standard) {
    ::dup2(launch.standard[standard], standard);
  }
  closeOtherDescriptors(launch.mostFiles);
  resetSignals();
  ::execve(launch.file, launch.words, environ);
  const int why = errno;
  [[maybe_unused]] const ssize_t told = ::write(launch.report, &why, sizeof why);
  ::_exit(kNotStarted);
}

/// 0, or the errno reported by the child; a successful exec closes the pipe without a report.
int readChildError(const FileDescriptor& report) {
  int why = 0;
  ssize_t count = 0;
  do {
    count = ::read(report.number(), &why, sizeof why);
  } while (count < 0 && errno == EINTR);
  return count == static_cast<ssize_t>(sizeof why) ? why : 0;
}

void reap(pid_t process) {
  while (::waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
  }
}

/// Forks with all signals blocked, so that no handler of the parent runs in the child. Returns
/// errno, with `process` -1, if the fork fails; for a failed exec see `readChildError`.
int forkFor(const Launch& launch, pid_t& process) {
  sigset_t all;
  sigset_t before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  process = ::fork();
  if (process == 0) {
    becomeChild(launch);
  }
  const int why = process < 0 ? errno : 0;
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return why;
}

/// How the process ended; none: it still runs. Does not reap it.
std::optional<siginfo_t> exitInfo(pid_t process) {
  siginfo_t info = {};
  const int failed =
      ::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT);
  return failed != 0 || info.si_pid == process ? std::make_optional(info) : std::nullopt;
}

std::string exitText(const siginfo_t& info) {
  if (info.si_code == CLD_EXITED) {
    return "with exit code " + std::to_string(info.si_status);
  }
  if (info.si_code == 0) {  // already reaped, because SIGCHLD is ignored in this program
    return "unseen";
  }
  const char* name = ::sigdescr_np(info.si_status);
  return "by signal " + std::to_string(info.si_status) +
         (name == nullptr ? "" : " (" + std::string(name) + ")");
}

}  // namespace

base::Result<std::unique_ptr<ChildProcess>> ChildProcess::start(std::vector<std::string> words) {
  const base::Result<std::string> file = resolveExecutable(words.front());
  if (!file) {
    return file.diagnostics();
  }
  std::unique_ptr<ChildProcess> child(new ChildProcess);
  int why = 0;
  try {
    why = child->startBy(*file, words);
  } catch (const std::system_error& error) {  // the thread could not be created
    why = error.code().value();
  }
  if (why != 0) {
    return base::error("external.not-started",
                       {words.front(), std::generic_category().message(why)});
  }
  return child;
}

int ChildProcess::openPipes(FileDescriptor (&theirs)[3]) {
  int why = openPipe(theirs[0], input_);
  why = why != 0 ? why : openPipe(output_, theirs[1]);
  why = why != 0 ? why : openPipe(errors_, theirs[2]);
  for (const FileDescriptor* ours : {&input_, &output_, &errors_}) {
    why = why != 0 ? why : setNonBlocking(*ours);
  }
  return why;
}

int ChildProcess::startBy(const std::string& file, std::vector<std::string>& words) {
  FileDescriptor theirs[3];
  FileDescriptor report;
  FileDescriptor reportEnd;
  int why = openPipes(theirs);
  why = why != 0 ? why : openPipe(report, reportEnd);
  if (why != 0) {
    return why;
  }
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  Launch launch;
  launch.file = file.c_str();
  launch.words = pointers.data();
  launch.report = reportEnd.number();
  launch.parent = ::getpid();
  launch.mostFiles = static_cast<int>(std::min(::sysconf(_SC_OPEN_MAX), 1L << 16));
  for (int i = 0; i < 3; ++i) {
    launch.standard[i] = theirs[i].number();
  }
  std::promise<int> forked;
  std::future<int> outcome = forked.get_future();
  starterThread_ = std::thread(
      [forked = std::move(forked), &launch, this, over = isOver_.get_future()]() mutable {
        forked.set_value(forkFor(launch, id_));
        over.wait();
      });
  why = outcome.get();
  reportEnd.close();
  return why != 0 ? why : readChildError(report);
}

ChildProcess::~ChildProcess() {
  if (id_ > 0) {
    closeInput();
    if (!hasEnded()) {
      ::kill(-id_, SIGTERM);
      waitForExit(kTermToKillDelay);
    }
    ::kill(-id_, SIGKILL);  // before reaping: until then its process id cannot be reused
    reap(id_);
  }
  isOver_.set_value();
  if (starterThread_.joinable()) {
    starterThread_.join();
  }
}

bool ChildProcess::hasEnded() const {
  return exitInfo(id_).has_value();
}

std::optional<std::string> ChildProcess::waitForExit(Milliseconds patience) const {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  std::optional<siginfo_t> info = exitInfo(id_);
  while (!info && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(kExitPollInterval);
    info = exitInfo(id_);
  }
  return info ? std::make_optional(exitText(*info)) : std::nullopt;
}

namespace {

using std::chrono::milliseconds;

constexpr std::string_view kSocketPrefix = "unix:";
constexpr milliseconds kConnectTimeout{2000};      // while the backlog of the socket is full
constexpr milliseconds kConnectRetryInterval{10};  // same
constexpr milliseconds kExitTimeout{1000};         // after the last line
constexpr milliseconds kStopPollInterval{20};      // between checks of the stop flag
constexpr milliseconds kSendTimeout{500};
constexpr milliseconds kExitAfterCloseTimeout{200};  // closing its output usually precedes the exit
constexpr std::size_t kShownErrors = 500;            // [B]

LineChannel::Clock::time_point externalDeadline(double seconds) {
  return LineChannel::Clock::now() + std::chrono::duration_cast<LineChannel::Clock::duration>(
                                         std::chrono::duration<double>(seconds));
}

/// End of its standard error output, on one line.
std::string errorSummary(const std::string& errors) {
  std::string text = base::trimmed(errors);
  if (text.size() > kShownErrors) {
    text = "…" + text.substr(text.size() - kShownErrors);
  }
  std::string line;
  for (const char c : text) {
    line += c == '\n' ? std::string(" / ") : std::string(1, c);
  }
  return printableText(line, line.size());
}

/// 0, or the errno of the connection.
int connectTo(const std::string& path, const base::StopFlag& stop, FileDescriptor& socket) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) {
    return path.empty() ? ENOENT : ENAMETOOLONG;
  }
  path.copy(address.sun_path, path.size());  // the address is zero-terminated by initialisation
  FileDescriptor end(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!end.isOpen()) {
    return errno;
  }
  const auto deadline = LineChannel::Clock::now() + kConnectTimeout;
  while (::connect(end.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) !=
         0) {
    const bool mayWork = errno == EAGAIN || errno == EINTR;
    if (!mayWork || LineChannel::Clock::now() > deadline) {
      return errno;
    }
    stop.check();
    std::this_thread::sleep_for(kConnectRetryInterval);
  }
  socket = std::move(end);
  return 0;
}

}  // namespace

bool ExternalProcess::isSocket(const std::string& command) {
  return base::startsWith(command, kSocketPrefix);
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
    base::Result<std::vector<std::string>> words = splitCommandLine(command);
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
    case LineChannel::Outcome::Timeout:
      return base::error("external.too-slow",
                         {command_, timeout, errorSummary(channel_->errorTail())});
    case LineChannel::Outcome::NotRead:
      return base::error("external.not-reading", {command_, timeout});
    case LineChannel::Outcome::TooLong:
      return base::error("external.line-too-long", {command_, LineChannel::kMaxLineLength});
    case LineChannel::Outcome::UnexpectedLine:
      return base::error("external.unasked", {command_, printableText(channel_->received())});
    default:
      return connectionLoss(outcome);
  }
}

base::Diagnostic ExternalProcess::connectionLoss(LineChannel::Outcome outcome) {
  const auto how = child_ ? child_->waitForExit(kExitAfterCloseTimeout) : std::nullopt;
  const std::string words = errorSummary(channel_->errorTail());
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
  channel_->send(line, LineChannel::Clock::now() + kSendTimeout);  // errors are ignored
  if (child_) {
    child_->closeInput();
    const auto patience = LineChannel::Clock::now() + kExitTimeout;
    while (!stop_->isStopRequested() && !child_->waitForExit(kStopPollInterval) &&
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
