#pragma once

#include <memory>
#include <string>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/external/hunavsim_planner.h"

namespace sim2d {

/// A planner in a shared library (hunavsim_planner.h). `file`: argument of dlopen; without a slash
/// it is searched in the system's library folders. Errors, which contain the robot's name:
/// library.not-allowed, .no-file, .not-loaded, .no-symbol (each one), .other-version, .refused; of
/// `command()`: library.failed, .no-number.
base::Result<std::shared_ptr<Planner>> makeLibraryPlanner(const PlannerSetup& setup,
                                                          const std::string& file);

/// A shared library with a planner, loaded while an instance exists. Thread-safe.
class PlannerLibrary {
 public:
  /// Errors: library.not-loaded, library.no-symbol (each one), library.other-version.
  static base::Result<std::shared_ptr<const PlannerLibrary>> load(const std::string& file);
  ~PlannerLibrary();
  PlannerLibrary(const PlannerLibrary&) = delete;
  PlannerLibrary& operator=(const PlannerLibrary&) = delete;
  PlannerLibrary(PlannerLibrary&&) = delete;
  PlannerLibrary& operator=(PlannerLibrary&&) = delete;

  const std::string& file() const { return file_; }

  decltype(&hunavsim_planner_create) create = nullptr;
  decltype(&hunavsim_planner_command) command = nullptr;
  decltype(&hunavsim_planner_error) error = nullptr;
  decltype(&hunavsim_planner_destroy) destroy = nullptr;
  decltype(&hunavsim_planner_path) path = nullptr;  // null: not exported

 private:
  PlannerLibrary(std::string file, void* handle);
  base::Diagnostics check();

  const std::string file_;
  void* const handle_;
};

}  // namespace sim2d
