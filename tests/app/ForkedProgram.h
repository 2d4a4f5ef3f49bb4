#pragma once

#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "app/cli/CommandRegistry.h"
#include "app/window/WindowCommand.h"
#include "tests/app/RunFiles.h"
#include "tests/support/Sanitizers.h"

namespace outside {

struct Ended {
  int status = 0;        // of waitpid
  double seconds = 0.0;  // of processors
  QString out, err;
};

/// Runs the program in a child of this process, which takes a tenth of the time of starting it. The
/// memory [GB] and time [s] are limited; beyond them it receives a signal.
inline Ended runForked(const QString& folder, const QStringList& words, unsigned seconds,
                       std::size_t gigabytes = 4) {
  const QByteArray outPath = QFile::encodeName(folder + text(".out"));
  const QByteArray errPath = QFile::encodeName(folder + text(".err"));
  const pid_t child = ::fork();
  if (child == 0) {
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    ::dup2(::open(outPath.constData(), flags, 0600), STDOUT_FILENO);
    ::dup2(::open(errPath.constData(), flags, 0600), STDERR_FILENO);
    if (::chdir(QFile::encodeName(folder).constData()) != 0) {
      ::_exit(98);
    }
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    const rlimit bytes{gigabytes << 30U, gigabytes << 30U};
    if (!kIsSanitized) {
      ::setrlimit(RLIMIT_AS, &bytes);
    }
    ::alarm(seconds);
    std::vector<QByteArray> given = {"hunavsim"};
    for (const QString& word : words) {
      given.push_back(word.toUtf8());
    }
    std::vector<char*> argv;
    argv.reserve(given.size() + 1);
    for (QByteArray& word : given) {
      argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    const int code = app::runProgram(static_cast<int>(given.size()), argv.data(), app::addWindow);
    std::fflush(nullptr);
    ::_exit(code);
  }
  Ended ended;
  rusage used{};
  ::wait4(child, &ended.status, 0, &used);
  const auto secondsOf = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  ended.seconds = secondsOf(used.ru_utime) + secondsOf(used.ru_stime);
  ended.out = QString::fromUtf8(outside::bytesOf(QString::fromLocal8Bit(outPath)));
  ended.err = QString::fromUtf8(outside::bytesOf(QString::fromLocal8Bit(errPath)));
  return ended;
}

/// By whom or what it was ended; empty: it ended itself.
inline QString signalOf(const Ended& ended) {
  if (!WIFSIGNALED(ended.status)) {
    return {};
  }
  return WTERMSIG(ended.status) == SIGALRM
             ? text("hangs")
             : text("killed by signal %1").arg(WTERMSIG(ended.status));
}

}  // namespace outside
