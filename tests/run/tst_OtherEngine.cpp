#include <fstream>

#include <QDir>
#include <QtTest>

#include "app/run/TreePlay.h"
#include "tests/support/Interop.h"

namespace {

struct Trace {
  QString tree;                // "003"
  std::vector<QString> ticks;  // "RUNNING | L1:RUNNING L2:HALTED"
};

QString vectorsFolder() {
  return QDir::cleanPath(interopFolder() + QStringLiteral("/../bt-vectors"));
}

/// traces.txt: "@ 003", then one line per tick that begins with its number.
std::vector<Trace> readTraces() {
  std::vector<Trace> traces;
  std::ifstream file((vectorsFolder() + QStringLiteral("/traces.txt")).toStdString());
  std::string line;
  while (std::getline(file, line)) {
    const QString text = QString::fromStdString(line).simplified();
    if (text.startsWith(QStringLiteral("@ "))) {
      traces.push_back({text.mid(2), {}});
    } else if (!text.isEmpty() && !traces.empty()) {
      traces.back().ticks.push_back(text.section(QLatin1Char(' '), 1));
    }
  }
  return traces;
}

QString tickText(app::TreePlay& play) {
  QString text = QString::fromLatin1(base::nodeStatusName(play.tick())) + QStringLiteral(" |");
  for (const app::LeafCall& call : play.calls()) {
    text += QLatin1Char(' ') + QString::fromStdString(play.program().label(call.node)) +
            QLatin1Char(':') +
            QString::fromLatin1(call.isHalt ? "HALTED" : base::nodeStatusName(call.status));
  }
  return text;
}

}  // namespace

/// Random trees of control nodes, decorators, conditions, scripts and sub-trees, ticked here and by
/// BehaviorTree.CPP 4.10: the same leaves are called, in the same order, with the same ends.
class OtherEngineTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tick_randomTree_callsWhatTheOtherEngineCalled_data() {
    QTest::addColumn<int>("index");
    traces_ = readTraces();
    if (traces_.empty()) {
      QSKIP("no traces of the other engine: set HUNAV_INTEROP_DIR");
    }
    for (std::size_t i = 0; i < traces_.size(); ++i) {
      QTest::newRow(qPrintable(traces_[i].tree)) << static_cast<int>(i);
    }
  }
  void tick_randomTree_callsWhatTheOtherEngineCalled() {
    QFETCH(int, index);
    const Trace& trace = traces_[static_cast<std::size_t>(index)];
    const QString file = vectorsFolder() + QStringLiteral("/trees/") + trace.tree;
    app::PlaySetup setup;
    setup.tree = (file + QStringLiteral(".xml")).toStdString();
    setup.script = (file + QStringLiteral(".yaml")).toStdString();
    setup.dt = 0.1;
    const auto play = app::TreePlay::create(setup);
    QVERIFY2(play, play.diagnostics().empty() ? "" : play.diagnostics().front().text().c_str());
    QVERIFY(!trace.ticks.empty());
    for (const QString& tick : trace.ticks) {
      QCOMPARE(tickText(**play), tick);
      QVERIFY((*play)->fault().empty());
    }
  }

 private:
  std::vector<Trace> traces_;
};

QTEST_APPLESS_MAIN(OtherEngineTest)
#include "tst_OtherEngine.moc"
