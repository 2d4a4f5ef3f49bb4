#include "app/cli/Console.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <string_view>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <QtGlobal>

#include "editor/document/MapEdit.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

// Set by the signal handler only.
volatile std::sig_atomic_t interruptFlag = 0;
volatile std::sig_atomic_t hasCtrlC = 0;
base::StopFlag* stopAtInterrupt = nullptr;  // set before the handler is installed

const std::shared_ptr<base::StopFlag>& interruptStopFlag() {
  static const auto kFlag = std::make_shared<base::StopFlag>();
  return kFlag;
}

/// Only SIGINT counts as Ctrl-C: a terminal and a parent may send SIGTERM in addition.
void onInterrupt(int signal) {
  if (signal == SIGINT && hasCtrlC != 0) {
    std::_Exit(128 + signal);
  }
  hasCtrlC = signal == SIGINT ? 1 : hasCtrlC;
  interruptFlag = 1;
  if (stopAtInterrupt != nullptr) {
    stopAtInterrupt->stop();  // sets an atomic flag, which is async-signal-safe
  }
}

/// Colours the severity for terminals (no-color.org).
std::string inColor(const base::Diagnostic& diagnostic) {
  constexpr const char* kColors[] = {"36", "33", "31"};  // of Severity: cyan, yellow, red
  std::string text = base::escapedControls(diagnostic.text());
  const std::string word = std::string(base::severityName(diagnostic.severity)) + ":";
  const std::size_t at = text.find(word);
  if (at != std::string::npos) {
    const char* color = kColors[static_cast<int>(diagnostic.severity)];
    text.replace(at, word.size(), "\033[1;" + std::string(color) + "m" + word + "\033[0m");
  }
  return text;
}

bool isColorful() {
  const char* const none = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  const bool isPlain = (none != nullptr && *none != '\0') ||
                       (terminal != nullptr && std::string_view(terminal) == "dumb");
  return !isPlain && isatty(STDERR_FILENO) != 0;
}

}  // namespace

void print(const std::string& text) {
  std::cout << text << std::flush;
}
void printLine(const std::string& line) {
  std::cout << base::escapedControls(line, "\n\t") << '\n' << std::flush;
}
void printError(const std::string& line) {
  std::cerr << base::escapedControls(line, "\n\t") << '\n';
}

bool wroteAllOutput() {
  return std::cout.flush().good();
}

void printTable(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::vector<std::string>> shown(rows);
  std::vector<std::size_t> widths;
  for (std::vector<std::string>& row : shown) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) {
      row[i] = base::escapedControls(row[i]);
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  for (const std::vector<std::string>& row : shown) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
    }
    printLine(line.substr(0, line.find_last_not_of(' ') + 1));
  }
}

bool printDiagnostics(const base::Diagnostics& diagnostics, base::Severity minSeverity) {
  for (const base::Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity >= minSeverity) {
      std::cerr << (isColorful() ? inColor(diagnostic) : base::escapedControls(diagnostic.text()))
                << '\n';
    }
  }
  return !base::hasErrors(diagnostics);
}

void printJson(const base::Diagnostics& diagnostics) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const base::Diagnostic& diagnostic : diagnostics) {
    const auto known = [](int number) {
      return number > 0 ? nlohmann::ordered_json(number) : nlohmann::ordered_json();
    };
    all.push_back({{"file", diagnostic.file},
                   {"line", known(diagnostic.line)},
                   {"column", known(diagnostic.column)},
                   {"severity", base::severityName(diagnostic.severity)},
                   {"code", diagnostic.code},
                   {"message", diagnostic.message}});
  }
  print(base::jsonText(all) + "\n");
}

void catchInterrupts() {
  stopAtInterrupt = interruptStopFlag().get();
  struct sigaction action = {};
  action.sa_handler = onInterrupt;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction before = {};
  if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) {  // not nohup
    sigaction(SIGHUP, &action, nullptr);
  }
}

void ignoreFileSizeSignal() {
  struct sigaction action = {};
  action.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &action, nullptr);
}

bool wasInterrupted() {
  return interruptFlag != 0;
}

base::StopFlagPtr interruptStop() {
  return interruptStopFlag();
}

Progress::Progress(bool quiet) : visible_(!quiet && isatty(STDERR_FILENO) != 0) {}

void Progress::clear() {
  if (width_ > 0) {
    std::cerr << '\r' << std::string(width_, ' ') << '\r' << std::flush;
    width_ = 0;
  }
}

bool Progress::isDue() const {
  return visible_ && std::chrono::steady_clock::now() - last_ >= std::chrono::milliseconds(100);
}

void Progress::show(const std::string& text) {
  if (!isDue()) {
    return;
  }
  last_ = std::chrono::steady_clock::now();
  const std::size_t padding = width_ > text.size() ? width_ - text.size() : 0;
  std::cerr << '\r' << text << std::string(padding, ' ') << std::flush;
  width_ = text.size();
}

std::string durationText(double seconds) {
  const long long whole = std::llround(std::max(0.0, seconds));
  const auto two = [](long long value) { return (value < 10 ? "0" : "") + std::to_string(value); };
  if (whole < 60) {
    return std::to_string(whole) + " s";
  }
  if (whole < 3600) {
    return std::to_string(whole / 60) + " min " + two(whole % 60) + " s";
  }
  return std::to_string(whole / 3600) + " h " + two(whole % 3600 / 60) + " min";
}

namespace {

/// Redirects standard error to /dev/null (RAII).
class SilencedStderr {
 public:
  SilencedStderr() : kept_(::dup(STDERR_FILENO)) {
    const base::FileDescriptor nowhere(::open("/dev/null", O_WRONLY | O_CLOEXEC));
    if (kept_.isOpen() && nowhere.isOpen()) {
      std::fflush(stderr);
      ::dup2(nowhere.number(), STDERR_FILENO);
    }
  }
  ~SilencedStderr() {
    if (kept_.isOpen()) {
      std::fflush(stderr);
      ::dup2(kept_.number(), STDERR_FILENO);
    }
  }
  Q_DISABLE_COPY_MOVE(SilencedStderr)

 private:
  base::FileDescriptor kept_;
};

}  // namespace

base::Result<sim2d::MapImage> loadMapImage(const std::string& path) {
  const SilencedStderr silent;
  return editor::loadMapImage(path);
}

}  // namespace app
