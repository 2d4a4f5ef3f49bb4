#pragma once

#include <string>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/support/Interop.h"

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

/// A real file of HuNavSim, or one of ours; empty = not there.
inline std::string hunavFile(const QByteArray& name) {
  return interopFile(QStringLiteral("hunavsim2/") + QString::fromUtf8(name)).toStdString();
}

}  // namespace scenariotest
