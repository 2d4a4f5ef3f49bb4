#pragma once

#include "tests/bt/TreeProbe.h"

/// Data rows of a tree and what is called and returned in each step: "a b -> SUCCESS|a -> RUNNING".
/// A step written as "!text" is one that stops the tree with a fault that holds the text.
namespace traces {

inline void columns() {
  QTest::addColumn<QString>("xml");
  QTest::addColumn<QString>("steps");
}

inline void row(const char* name, const std::string& xml, const char* steps) {
  QTest::newRow(name) << QString::fromStdString(xml) << QString::fromUtf8(steps);
}

inline void checkRow() {
  QFETCH(QString, xml);
  QFETCH(QString, steps);
  probe::Run run(xml.toStdString());
  QVERIFY2(run.state, run.problems.c_str());
  for (const QString& step : steps.split(QLatin1Char('|'))) {
    const QString trace = QString::fromStdString(run.trace());
    if (step.startsWith(QLatin1Char('!'))) {
      QVERIFY2(run.state->fault(), qPrintable(trace));
      const std::string message = run.state->fault()->message;
      QVERIFY2(QString::fromStdString(message).contains(step.mid(1)), message.c_str());
      return;
    }
    QCOMPARE(trace, step);
    const bt::TreeFault* const fault = run.state->fault();
    QVERIFY2(fault == nullptr, fault != nullptr ? fault->message.c_str() : "");
  }
}

}  // namespace traces
