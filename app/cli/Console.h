#pragma once

#include <chrono>
#include <exception>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/StopFlag.h"
#include "sim2d/map/MapReader.h"

/// Standard output and standard error of the commands, and Ctrl-C.

namespace app {

void print(const std::string& text);       // to standard output
void printLine(const std::string& line);   // likewise, with a line end
void printError(const std::string& line);  // to standard error
bool wroteAllOutput();                     // whether all writes to standard output have succeeded
/// Prints columns separated by two spaces to standard output.
void printTable(const std::vector<std::vector<std::string>>& rows);
/// Prints one line per diagnostic of severity `minSeverity` or higher to standard error. Returns
/// false if an error is among them.
bool printDiagnostics(const base::Diagnostics& diagnostics,
                      base::Severity minSeverity = base::Severity::Info);

/// Prints all of them as a JSON array of objects to standard output.
void printJson(const base::Diagnostics& diagnostics);

/// Makes Ctrl-C, SIGTERM and SIGHUP only set a flag; a second Ctrl-C terminates the program
/// immediately. Under nohup, SIGHUP stays ignored.
void catchInterrupts();
/// Ignores SIGXFSZ: exceeding the file size limit becomes a write error.
void ignoreFileSizeSignal();
bool wasInterrupted();
/// A stop flag that the same signals set, for code that waits.
base::StopFlagPtr interruptStop();

/// A progress line on standard error, updated in place; disabled unless that is a terminal.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;
  /// Updates the line at most ten times a second.
  void show(const std::string& text);
  /// Whether the next show() would update the line; lets callers skip formatting the text.
  bool isDue() const;
  /// Removes the line, before other output on the terminal. The next show() writes it again.
  void clear();

 private:
  bool visible_;
  std::chrono::steady_clock::time_point last_;
  std::size_t width_ = 0;
};

/// "12 s", "3 min 20 s", "2 h 05 min".
std::string durationText(double seconds);

/// Calls editor::loadMapImage, but discards what image libraries write to standard error; problems
/// are in the result. No other thread may write to standard error meanwhile.
base::Result<sim2d::MapImage> loadMapImage(const std::string& path);

}  // namespace app
