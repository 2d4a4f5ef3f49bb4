#include "app/python/Problems.h"

namespace python {

namespace {

// Lives as long as the interpreter: Python owns the class.
PyObject* scenarioError = nullptr;  // NOLINT

std::string textOf(const base::Diagnostics& problems) {
  std::string text;
  for (const base::Diagnostic& problem : problems) {
    text += (text.empty() ? "" : "\n") + problem.text();
  }
  return text;
}

}  // namespace

void addProblems(py::module_& module) {
  py::class_<base::Diagnostic>(module, "Problem",
                               "A problem of a scenario, its files or its options.")
      .def_property_readonly(
          "severity", [](const base::Diagnostic& p) { return base::severityName(p.severity); },
          "'info', 'warning' or 'error'.")
      .def_readonly("file", &base::Diagnostic::file, "File as given; empty: none.")
      .def_readonly("line", &base::Diagnostic::line, "Line from 1; 0: unknown.")
      .def_readonly("column", &base::Diagnostic::column, "Column from 1; 0: unknown.")
      .def_readonly("message", &base::Diagnostic::message, "One sentence.")
      .def_property_readonly(
          "code", [](const base::Diagnostic& p) { return std::string(p.code); },
          "Identifier that does not change between versions, such as 'scenario.goal-undefined'.")
      .def("__str__", &base::Diagnostic::text)
      .def("__repr__", [](const base::Diagnostic& p) { return "<Problem " + p.text() + ">"; });
  scenarioError = PyErr_NewExceptionWithDoc(
      "hunavsim.ScenarioError",
      "A scenario, its files or its options are wrong; `problems` lists all problems.",
      PyExc_ValueError, nullptr);
  module.attr("ScenarioError") = py::handle(scenarioError);
}

py::list toList(const base::Diagnostics& problems) {
  py::list list;
  for (const base::Diagnostic& problem : problems) {
    list.append(py::cast(problem));
  }
  return list;
}

void requireNoErrors(const base::Diagnostics& problems) {
  if (base::hasErrors(problems)) {
    throwProblems(problems);
  }
}

void throwProblems(const base::Diagnostics& problems) {
  const py::object error = py::handle(scenarioError)(textOf(problems));
  error.attr("problems") = toList(problems);
  PyErr_SetObject(scenarioError, error.ptr());
  throw py::error_already_set();
}

}  // namespace python
