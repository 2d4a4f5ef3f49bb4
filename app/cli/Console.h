#pragma once

#include <chrono>
#include <exception>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/Stop.h"

/// Standard output and standard error of the commands, and Ctrl-C.
namespace app {

void print(const std::string& text);       // to standard output
void printLine(const std::string& line);   // idem, with a line end
void printError(const std::string& line);  // to standard error
bool isPrinted();                          // the standard output took everything so far
/// Columns two blanks apart, to standard output.
void printTable(const std::vector<std::vector<std::string>>& rows);
/// A line each, to standard error; of `least` severity and above. False when an error is among
/// them.
bool printDiagnostics(const base::Diagnostics& diagnostics,
                      base::Severity least = base::Severity::Info);

/// The same as an array of objects, all of it to standard output.
void printJson(const base::Diagnostics& diagnostics);

/// From now on Ctrl-C, SIGTERM and the end of the terminal only set a flag; a second Ctrl-C ends
/// the program at once. Under nohup the end of the terminal stays without effect.
void catchInterrupts();
/// A file beyond the limit of its size is an error of the write, not the end of the program.
void keepAliveWhenFilesAreFull();
bool wasInterrupted();
/// Stopped by the same: for what waits.
base::StopFlagPtr interruptStop();

/// A line on standard error that is renewed in place; silent unless that is a terminal.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;
  /// At most ten times a second.
  void show(const std::string& text);
  /// True when the next show would be drawn: spare the work of making the text otherwise.
  bool isDue() const;

 private:
  bool visible_;
  std::chrono::steady_clock::time_point last_;
  std::size_t width_ = 0;
};

/// "12 s", "3 min 20 s", "2 h 05 min".
std::string durationText(double seconds);

}  // namespace app
