#include "sim2d/base/Result.h"

#include <algorithm>

namespace base {
namespace {

Diagnostic make(Severity severity, std::string message, std::string file, int line, int column) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.file = std::move(file);
  diagnostic.line = line;
  diagnostic.column = column;
  diagnostic.message = std::move(message);
  return diagnostic;
}

}  // namespace

std::string Diagnostic::text() const {
  std::string place = file;
  for (const int number : {line, line > 0 ? column : 0}) {
    if (number > 0) {
      place += (place.empty() ? "" : ":") + std::to_string(number);
    }
  }
  return place + (place.empty() ? "" : ": ") + severityName(severity) + ": " + message;
}

const char* severityName(Severity severity) {
  switch (severity) {
    case Severity::Info:
      return "info";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "error";
}

bool hasErrors(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

void append(Diagnostics& to, const Diagnostics& more) {
  const std::size_t count = more.size();  // also right when both are the same list
  to.reserve(to.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    to.push_back(more[i]);
  }
}

Diagnostic makeError(std::string message, std::string file, int line, int column) {
  return make(Severity::Error, std::move(message), std::move(file), line, column);
}

Diagnostic makeWarning(std::string message, std::string file, int line, int column) {
  return make(Severity::Warning, std::move(message), std::move(file), line, column);
}

}  // namespace base
