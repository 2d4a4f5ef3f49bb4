#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "app/run/Experiment.h"
#include "app/run/PlannerFiles.h"

namespace app {

/// Code of others that runs of the experiment would start: that of the first values, and of each
/// other value beside them, as `batch` tells it. Nothing is started.
std::vector<ForeignCode> codeOf(const Experiment& experiment);

/// What somebody has allowed to be started, for one file of an experiment.
class StudyCode {
 public:
  /// None of it is left to be asked for.
  bool allows(const std::vector<ForeignCode>& code) const;
  /// What goes on after a yes; a later question takes the place of an earlier one.
  void ask(std::function<void()> then) { then_ = std::move(then); }
  void allow(const std::vector<ForeignCode>& code);
  void forget();  // another file

 private:
  std::vector<ForeignCode> allowed_;
  std::function<void()> then_;
};

}  // namespace app
