#pragma once

#include <string>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

/// What the tests of scenarios share.
namespace scenariotest {

inline std::string dataFile(const std::string& name) {
  return std::string(TEST_DATA_DIR) + "/scenario/" + name;
}

inline std::string textOf(const std::string& path) {
  const auto text = base::readTextFile(path);
  return text ? *text : std::string();
}

inline QString shown(const base::Diagnostics& diagnostics) {
  QString all;
  for (const base::Diagnostic& diagnostic : diagnostics) {
    all += QString::fromStdString(diagnostic.text()) + QLatin1Char('\n');
  }
  return all;
}

/// Folder of the real files of HuNavSim; empty = not there.
inline std::string interopFolder() {
  const QByteArray given = qgetenv("HUNAV_INTEROP_DIR");
  const QString folder = given.isEmpty() ? QStringLiteral(SOURCE_DIR "/../shared/interop")
                                         : QString::fromLocal8Bit(given);
  return QFileInfo::exists(folder + QStringLiteral("/hunavsim2"))
             ? (folder + QStringLiteral("/hunavsim2/")).toStdString()
             : std::string();
}

}  // namespace scenariotest
