#pragma once

#include <string>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/support/Interop.h"

/// What the tests of scenarios share.
namespace scenariotest {

inline std::string dataFile(const std::string& name) {
  return std::string(TEST_DATA_DIR) + "/scenario/" + name;
}

/// What every build of the program has.
inline sim2d::KnownNames usualNames() {
  return {{"sfm", "sfm-hunav2", "das", "orca"}, {"pursuit"}, {"generic"}, {}, {}};
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
