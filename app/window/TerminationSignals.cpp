#include "app/window/TerminationSignals.h"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace app {

namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

/// The ends of a pipe: a signal handler may only call functions such as write().
std::array<int, 2> pipeEnds = {-1, -1};
std::array<struct sigaction, kSignals.size()> actionsBefore;

void onSignal(int /*signal*/) {
  const char mark = 1;
  [[maybe_unused]] const ssize_t written = ::write(pipeEnds[1], &mark, 1);
}

}  // namespace

TerminationSignals::TerminationSignals(QObject* parent) : QObject(parent) {
  if (::pipe2(pipeEnds.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    return;
  }
  notifier_ = new QSocketNotifier(pipeEnds[0], QSocketNotifier::Read, this);
  connect(notifier_, &QSocketNotifier::activated, this, [this] {
    std::array<char, kSignals.size()> marks{};
    if (::read(pipeEnds[0], marks.data(), marks.size()) > 0) {
      Q_EMIT received();
    }
  });
  struct sigaction action = {};
  action.sa_handler = onSignal;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (std::size_t k = 0; k < kSignals.size(); ++k) {
    const bool isKnown = ::sigaction(kSignals.at(k), nullptr, &actionsBefore.at(k)) == 0;
    if (isKnown && actionsBefore.at(k).sa_handler != SIG_IGN) {
      ::sigaction(kSignals.at(k), &action, nullptr);
    }
  }
}

TerminationSignals::~TerminationSignals() {
  if (notifier_ == nullptr) {
    return;
  }
  for (std::size_t k = 0; k < kSignals.size(); ++k) {
    ::sigaction(kSignals.at(k), &actionsBefore.at(k), nullptr);
  }
  for (int& end : pipeEnds) {
    ::close(std::exchange(end, -1));
  }
}

}  // namespace app
