#include <fstream>

#include <QDir>
#include <QFileInfo>
#include <QtTest>

#include "app/run/TreePlay.h"
#include "tests/support/Interop.h"

namespace {

struct Trace {
  QString folder, tree;        // "…/bt-vectors", "003"
  std::vector<QString> ticks;  // "RUNNING | L1:RUNNING L2:HALTED"
};

constexpr char kOurs[] = TEST_DATA_DIR "/bt/vectors";

/// Of the other engine, beside the files of other programs: it need not be there.
QString engineFolder() {
  return QDir::cleanPath(interopFolder() + QStringLiteral("/../bt-vectors"));
}

/// traces.txt: "@ 003", then one line per tick that begins with its number.
std::vector<Trace> readTraces(const QString& folder) {
  std::vector<Trace> traces;
  std::ifstream file((folder + QStringLiteral("/traces.txt")).toStdString());
  std::string line;
  while (std::getline(file, line)) {
    const QString text = QString::fromStdString(line).simplified();
    if (text.startsWith(QStringLiteral("@ "))) {
      traces.push_back({folder, text.mid(2), {}});
    } else if (!text.isEmpty() && !traces.empty()) {
      traces.back().ticks.push_back(text.section(QLatin1Char(' '), 1));
    }
  }
  return traces;
}

/// Names of the trees of a folder, in order.
QStringList treesOf(const QString& folder) {
  QStringList names;
  const QDir trees(folder + QStringLiteral("/trees"));
  for (const QString& file : trees.entryList({QStringLiteral("*.xml")}, QDir::Files, QDir::Name)) {
    names.append(QFileInfo(file).completeBaseName());
  }
  return names;
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

/// Trees of control nodes, decorators, conditions, scripts and sub-trees: the same leaves are
/// called, in the same order, with the same ends, as by the rules (a few trees of ours, worked out
/// by hand) and as by BehaviorTree.CPP 4.10 (hundreds of random ones, where its traces are).
class OtherEngineTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void traces_ofEachTree_areThere_data() {
    QTest::addColumn<QString>("folder");
    QTest::addColumn<int>("trees");  // at least
    QTest::addColumn<int>("ticks");
    QTest::newRow("ours") << QString::fromLatin1(kOurs) << 8 << 3;
    QTest::newRow("the other engine") << engineFolder() << 200 << 15;
  }
  /// A trace that is cut off, or left out, would be a test that is passed.
  void traces_ofEachTree_areThere() {
    QFETCH(QString, folder);
    QFETCH(int, trees);
    QFETCH(int, ticks);
    if (folder != QLatin1String(kOurs) && !QFileInfo::exists(folder)) {
      QSKIP(qPrintable(QStringLiteral("only our own trees were compared: no traces of "
                                      "BehaviorTree.CPP in %1 (HUNAV_INTEROP_DIR names the folder "
                                      "beside it)")
                           .arg(folder)));
    }
    QStringList traced;
    for (const Trace& trace : readTraces(folder)) {
      traced.append(trace.tree);
      QVERIFY2(trace.ticks.size() >= static_cast<std::size_t>(ticks), qPrintable(trace.tree));
    }
    traced.sort();
    QCOMPARE(traced, treesOf(folder));
    QVERIFY2(traced.size() >= trees, qPrintable(QString::number(traced.size())));
  }

  void tick_tree_callsWhatTheOtherEngineCalled_data() {
    QTest::addColumn<int>("index");
    traces_ = readTraces(QString::fromLatin1(kOurs));
    const std::size_t ours = traces_.size();
    const std::vector<Trace> theirs = readTraces(engineFolder());
    traces_.insert(traces_.end(), theirs.begin(), theirs.end());
    for (std::size_t i = 0; i < traces_.size(); ++i) {
      const QString whose = i < ours ? QStringLiteral("ours ") : QStringLiteral("theirs ");
      QTest::newRow(qPrintable(whose + traces_[i].tree)) << static_cast<int>(i);
    }
  }
  void tick_tree_callsWhatTheOtherEngineCalled() {
    QFETCH(int, index);
    const Trace& trace = traces_[static_cast<std::size_t>(index)];
    const QString file = trace.folder + QStringLiteral("/trees/") + trace.tree;
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
