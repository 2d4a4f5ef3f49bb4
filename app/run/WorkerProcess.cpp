#include "app/run/WorkerProcess.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"

namespace app {

namespace {

using Length = std::uint32_t;  // in host byte order: both ends are on one machine

/// Sends all bytes; false: the other end has closed.
bool sendAll(int socket, const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = ::send(socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR) {
      return false;
    }
    sent += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  return true;
}

bool sendMessage(int socket, const std::string& text) {
  const auto length = static_cast<Length>(text.size());
  std::string bytes(sizeof length, '\0');
  std::memcpy(bytes.data(), &length, sizeof length);
  return sendAll(socket, bytes + text);
}

/// Moves the first complete message from `bytes` to `text`.
bool takeMessage(std::string& bytes, std::string& text) {
  Length length = 0;
  if (bytes.size() < sizeof length) {
    return false;
  }
  std::memcpy(&length, bytes.data(), sizeof length);
  if (bytes.size() < sizeof length + length) {
    return false;
  }
  text = bytes.substr(sizeof length, length);
  bytes.erase(0, sizeof length + length);
  return true;
}

/// Appends the available data; 0 = the other end has closed, negative = no data now.
ssize_t receive(int socket, std::string& bytes, int flags) {
  std::array<char, 16384> piece;  // NOLINT: written before it is read
  const ssize_t count = ::recv(socket, piece.data(), piece.size(), flags);
  if (count > 0) {
    bytes.append(piece.data(), static_cast<std::size_t>(count));
  } else if (count < 0 && errno != EINTR && errno != EAGAIN) {
    return 0;
  }
  return count;
}

/// In the worker: keeps only its socket, as file descriptor `kSocket`.
constexpr int kSocket = 3;
void isolateFromParent(int socket, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) {
    ::_exit(0);  // the parent has ended already
  }
  ::setpgid(0, 0);
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  ::signal(SIGHUP, SIG_IGN);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    ::dup2(nowhere, standard);
  }
  ::dup2(socket, kSocket);
  ::close_range(kSocket + 1, ~0U, 0);  // including locks and the sockets of other workers
}

[[noreturn]] void serveRequests(const WorkerProcess::RequestHandler& serve) noexcept {
  std::string bytes, request;
  const WorkerProcess::SendMessage tell = [](const std::string& text) {
    sendMessage(kSocket, text);
  };
  while (true) {
    if (!takeMessage(bytes, request)) {
      if (receive(kSocket, bytes, 0) == 0) {
        ::_exit(0);
      }
      continue;
    }
    if (!sendMessage(kSocket, serve(request, tell))) {
      ::_exit(0);
    }
  }
}

}  // namespace

std::optional<WorkerProcess> WorkerProcess::start(const RequestHandler& serve) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return std::nullopt;
  }
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process == 0) {
    isolateFromParent(ends[1], parent);
    serveRequests(serve);
  }
  ::close(ends[1]);
  if (process < 0) {
    ::close(ends[0]);
    return std::nullopt;
  }
  return WorkerProcess(process, ends[0]);
}

WorkerProcess::~WorkerProcess() {
  end();
}

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      socket_(std::exchange(other.socket_, -1)),
      buffer_(std::move(other.buffer_)) {}

WorkerProcess& WorkerProcess::operator=(WorkerProcess&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(socket_, other.socket_);
  std::swap(buffer_, other.buffer_);
  return *this;
}

bool WorkerProcess::sendRequest(const std::string& request) const {
  return sendMessage(socket_, request);
}

WorkerProcess::ReadResult WorkerProcess::readMessage(std::string& answer) {
  if (takeMessage(buffer_, answer)) {
    return ReadResult::Answer;  // it arrived together with the previous one
  }
  if (receive(socket_, buffer_, MSG_DONTWAIT) == 0) {
    return ReadResult::End;
  }
  return takeMessage(buffer_, answer) ? ReadResult::Answer : ReadResult::Part;
}

int WorkerProcess::end() {
  int status = 0;
  if (process_ > 0) {
    ::kill(process_, SIGKILL);  // no effect if it has ended: waitpid follows
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    ::close(socket_);
    process_ = socket_ = -1;
  }
  return status;
}

std::size_t WorkerProcess::residentBytes() const {
  const base::Result<std::string> text =
      base::readTextFile("/proc/" + std::to_string(process_) + "/statm");
  const std::vector<std::string> words =
      base::split(text ? *text : std::string(), ' ');  // pages: all, resident, …
  const std::optional<long long> pages = words.size() > 1 ? base::parseInt(words[1]) : std::nullopt;
  return pages ? static_cast<std::size_t>(*pages) * static_cast<std::size_t>(::getpagesize()) : 0;
}

}  // namespace app
