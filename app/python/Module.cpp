#include "app/python/Bindings.h"
#include "app/python/Callbacks.h"
#include "app/python/Problems.h"
#include "app/python/RunBinding.h"
#include "app/python/ScenarioBinding.h"
#include "app/run/DataPaths.h"

PYBIND11_MODULE(_hunavsim, module) {  // NOLINT: a macro of pybind11
  module.doc() = "Simulation of people and robots: the compiled part of the package hunavsim.";
  module.attr("__version__") = app::programVersion();
  python::addProblems(module);
  python::addScenario(module);
  python::addCallbacks(module);
  python::addRuns(module);
  python::addSimulation(module);
  python::addStatistics(module);
  python::addEnvironment(module);
}
