#include "sim2d/nav/external/ChildProcess.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <linux/close_range.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "sim2d/nav/external/CommandWords.h"

namespace sim2d {
namespace {

using Milliseconds = ChildProcess::Milliseconds;

constexpr Milliseconds kAfterTerm{500};  // between SIGTERM and SIGKILL
constexpr Milliseconds kGlance{1};       // between looks whether it has ended
constexpr int kNotStarted = 127;

/// What the new process needs, made ready before: between fork and exec nothing may be allocated.
struct Launch {
  const char* file = nullptr;
  char* const* words = nullptr;
  int standard[3] = {-1, -1, -1};  // its standard input, output and error
  int report = -1;                 // takes errno when it cannot be started
  pid_t parent = -1;
  int mostFiles = 1024;
};

/// Standard numbers are left to those they belong to: then dup2 never meets its own target.
int aboveStandard(Descriptor& descriptor) {
  if (descriptor.number() > STDERR_FILENO) {
    return 0;
  }
  Descriptor higher(::fcntl(descriptor.number(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  if (!higher.isOpen()) {
    return errno;
  }
  std::swap(descriptor, higher);
  return 0;
}

int openPipe(Descriptor& readEnd, Descriptor& writeEnd) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    return errno;
  }
  readEnd = Descriptor(ends[0]);
  writeEnd = Descriptor(ends[1]);
  const int error = aboveStandard(readEnd);
  return error != 0 ? error : aboveStandard(writeEnd);
}

int setNonBlocking(const Descriptor& descriptor) {
  const int flags = ::fcntl(descriptor.number(), F_GETFL);
  return flags >= 0 && ::fcntl(descriptor.number(), F_SETFL, flags | O_NONBLOCK) == 0 ? 0 : errno;
}

/// In the new process: only calls that are safe there.
void keepStandardFilesOnly(int mostFiles) {
  if (::syscall(SYS_close_range, STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC) == 0) {
    return;
  }
  for (int file = STDERR_FILENO + 1; file < mostFiles; ++file) {  // kernels before 5.11
    ::fcntl(file, F_SETFD, FD_CLOEXEC);
  }
}

/// In the new process: as a shell would start it, whatever we ignore or block.
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

/// In the new process, with all signals blocked.
[[noreturn]] void becomeChild(const Launch& launch) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != launch.parent) {  // died before the line above
    ::_exit(kNotStarted);
  }
  for (int standard = 0; standard < 3; ++standard) {
    ::dup2(launch.standard[standard], standard);
  }
  keepStandardFilesOnly(launch.mostFiles);
  resetSignals();
  ::execve(launch.file, launch.words, environ);
  const int why = errno;
  [[maybe_unused]] const ssize_t told = ::write(launch.report, &why, sizeof why);
  ::_exit(kNotStarted);
}

/// 0, or what the new process reports; it says nothing when the program has taken its place.
int reportOf(const Descriptor& report) {
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

/// Forks with all signals blocked, so that none of our handlers runs in the new process. Gives
/// errno, `process` -1, when that fails; the program may not start either, see `reportOf`.
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

/// How the process ended; none: not yet. It stays to be reaped.
std::optional<siginfo_t> endedInfo(pid_t process) {
  siginfo_t info = {};
  const int failed =
      ::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT);
  return failed != 0 || info.si_pid == process ? std::make_optional(info) : std::nullopt;
}

std::string endingText(const siginfo_t& info) {
  if (info.si_code == CLD_EXITED) {
    return "with exit code " + std::to_string(info.si_status);
  }
  if (info.si_code == 0) {  // somebody of this program has reaped it: it ignores SIGCHLD
    return "unseen";
  }
  const char* name = ::sigdescr_np(info.si_status);
  return "by signal " + std::to_string(info.si_status) +
         (name == nullptr ? "" : " (" + std::string(name) + ")");
}

}  // namespace

base::Result<std::unique_ptr<ChildProcess>> ChildProcess::start(std::vector<std::string> words) {
  const base::Result<std::string> file = programFile(words.front());
  if (!file) {
    return file.diagnostics();
  }
  std::unique_ptr<ChildProcess> child(new ChildProcess);
  int why = 0;
  try {
    why = child->startBy(*file, words);
  } catch (const std::system_error& error) {  // no more threads
    why = error.code().value();
  }
  if (why != 0) {
    return base::error("external.not-started",
                       {words.front(), std::generic_category().message(why)});
  }
  return child;
}

int ChildProcess::openPipes(Descriptor (&theirs)[3]) {
  int why = openPipe(theirs[0], input_);
  why = why != 0 ? why : openPipe(output_, theirs[1]);
  why = why != 0 ? why : openPipe(errors_, theirs[2]);
  for (const Descriptor* ours : {&input_, &output_, &errors_}) {
    why = why != 0 ? why : setNonBlocking(*ours);
  }
  return why;
}

int ChildProcess::startBy(const std::string& file, std::vector<std::string>& words) {
  Descriptor theirs[3];
  Descriptor report;
  Descriptor reportEnd;
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
  starter_ = std::thread(
      [forked = std::move(forked), &launch, this, over = isOver_.get_future()]() mutable {
        forked.set_value(forkFor(launch, id_));
        over.wait();
      });
  why = outcome.get();
  reportEnd.close();
  return why != 0 ? why : reportOf(report);
}

ChildProcess::~ChildProcess() {
  if (id_ > 0) {
    closeInput();
    if (!hasEnded()) {
      ::kill(-id_, SIGTERM);
      ending(kAfterTerm);
    }
    ::kill(-id_, SIGKILL);  // before it is reaped: until then nobody else can have its number
    reap(id_);
  }
  isOver_.set_value();
  if (starter_.joinable()) {
    starter_.join();
  }
}

bool ChildProcess::hasEnded() const {
  return endedInfo(id_).has_value();
}

std::optional<std::string> ChildProcess::ending(Milliseconds patience) const {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  std::optional<siginfo_t> info = endedInfo(id_);
  while (!info && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(kGlance);
    info = endedInfo(id_);
  }
  return info ? std::make_optional(endingText(*info)) : std::nullopt;
}

}  // namespace sim2d
