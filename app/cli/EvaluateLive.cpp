#include "app/cli/Evaluate.h"

#ifdef HUNAV_ROS2

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include "app/bridge/nodes/Recorder.h"
#include "app/cli/Console.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPollInterval(100);  // for Ctrl-C
constexpr std::size_t kMaxTagLength = 100;

/// Whether a tag is a safe folder name: letters, digits, _ - and inner dots. Tags arrive over the
/// network and must not lead to other folders.
bool isFolderName(const std::string& tag) {
  const auto isFine = [](char c) {
    return base::isLetter(c) || base::isDigit(c) || c == '_' || c == '-' || c == '.';
  };
  return !tag.empty() && tag.size() <= kMaxTagLength && tag.front() != '.' &&
         std::all_of(tag.begin(), tag.end(), isFine);
}

class LiveEvaluation {
 public:
  LiveEvaluation(const EvaluateOptions& options, const Invocation& given)
      : options_(options), given_(given) {}

  int run();

 private:
  std::unique_ptr<bridge::Recorder> listen();
  /// Error: the folder cannot be used.
  base::Diagnostics begin(const EvaluateOptions& recording);
  bool beginRequested(const bridge::RecordingRequest& asked);
  void end();
  void measure();
  void keepRecording();
  bool isTimeOver() const;
  void printStatus(const std::string& line) const {
    if (!given_.quiet && !given_.json) {
      printError(line);
    }
  }

  const EvaluateOptions& options_;
  const Invocation& given_;
  std::unique_ptr<bridge::Recorder> recorder_;
  // The active recording.
  EvaluateOptions recording_;
  std::unique_ptr<OutputFolder> output_;
  Clock::time_point startTime_;
  int code_ = ExitFine;
  bool isOver_ = false;
};

std::unique_ptr<bridge::Recorder> LiveEvaluation::listen() {
  const base::Result<bridge::DomainSettings> domain = domainSettingsOf(options_.ros2);
  requireFine(domain.diagnostics());
  SourceOptions parsed;
  requireFine(parseEvaluateOptions(options_, parsed), ExitWrongCommandLine);
  bridge::Recorder::Services services;
  services.start = [this](const bridge::RecordingRequest& asked) { return beginRequested(asked); };
  services.stop = [this] { end(); };
  auto made = bridge::Recorder::create(
      {*domain, options_.space, parsed.use}, services, [this](const base::Diagnostic& diagnostic) {
        printDiagnostics({diagnostic},
                         given_.quiet ? base::Severity::Warning : base::Severity::Info);
      });
  requireFine(made.diagnostics());
  printStatus("listening in domain " + std::to_string(domain->domain) +
              (domain->localhostOnly ? " on this machine" : " on the network") +
              (options_.byServices ? "; hunav_start_recording starts a recording, Ctrl-C quits"
                                   : "; Ctrl-C stops the recording and computes its metrics"));
  return *std::move(made);
}

base::Diagnostics LiveEvaluation::begin(const EvaluateOptions& recording) {
  base::Diagnostics problems;
  recording_ = recording;
  output_ = openEvaluation(recording_, {}, problems);
  if (output_ != nullptr) {
    recording_.source = (fs::path(output_->staging()) / kRecording).string();
    recorder_->begin(recording_.source);
    startTime_ = Clock::now();
  }
  return problems;
}

bool LiveEvaluation::beginRequested(const bridge::RecordingRequest& asked) {
  EvaluateOptions recording = options_;
  recording.tag = asked.tag;
  recording.runId = asked.runId;
  if (asked.goal) {
    recording.robotGoal =
        base::formatDouble(asked.goal->x()) + " " + base::formatDouble(asked.goal->y());
  }
  if (!options_.byServices || !isFolderName(asked.tag)) {
    printDiagnostics({base::error("ros2.bad-tag", {asked.tag})});
    return false;
  }
  const std::string name = asked.tag + "_" + std::to_string(asked.runId);
  recording.output = (fs::path(options_.output) / name).string();
  recording.layoutFolder = options_.output;
  const base::Diagnostics problems = begin(recording);
  printDiagnostics(problems);
  printStatus("recording " + name);
  return !base::hasErrors(problems);
}

/// Called by the stop service or after Ctrl-C: problems end only this recording.
void LiveEvaluation::end() {
  printStatus(std::to_string(recorder_->messages()) + " messages recorded");
  base::Diagnostics problems = recorder_->end();
  isOver_ = !options_.byServices;
  try {
    requireFine(output_->withFinalPaths(problems), ExitRunFailed);
    evaluateRecording(recording_, *output_, given_);
    printStatus("results written to " + recording_.output);
  } catch (const CommandEnd& ended) {
    code_ = ended.code;
    keepRecording();
  } catch (const std::exception& problem) {
    code_ = ExitRunFailed;
    printError("error: " + base::exceptionMessage(problem));
    keepRecording();
  }
  output_.reset();
}

void LiveEvaluation::keepRecording() {
  base::Diagnostics problems;
  const std::string manifest = manifestOf(recording_, given_, problems);
  base::append(problems, output_->commit(manifest, OutputFolder::EarlierFiles::Removed));
  if (printDiagnostics(problems)) {
    printStatus("the recording is kept: " + (fs::path(recording_.output) / kRecording).string());
  }
}

bool LiveEvaluation::isTimeOver() const {
  return recorder_->isRecording() && options_.duration &&
         std::chrono::duration<double>(Clock::now() - startTime_).count() >= *options_.duration;
}

int LiveEvaluation::run() {
  recorder_ = listen();
  catchInterrupts();
  if (!options_.byServices) {
    requireFine(begin(options_));
  }
  Progress progress(given_.quiet);
  while (!isOver_ && !wasInterrupted()) {
    recorder_->spin(kPollInterval);
    if (recorder_->isRecording() && progress.isDue()) {
      progress.show(std::to_string(recorder_->messages()) + " messages");
    }
    if (isTimeOver() || recorder_->hasFailed()) {
      end();
    }
  }
  if (recorder_->isRecording()) {
    end();
  }
  return code_;
}

}  // namespace

int evaluateLive(const EvaluateOptions& options, const Invocation& given) {
  return LiveEvaluation(options, given).run();
}

}  // namespace app

#else

namespace app {

int evaluateLive(const EvaluateOptions& options, const Invocation& /*given*/) {
  requireFine(domainSettingsOf(options.ros2).diagnostics());
  return ExitBadInput;  // reported by requireFine above
}

}  // namespace app

#endif
