#include <QDir>
#include <QtTest>

#include "bt/engine/Program.h"
#include "bt/human/TreeBehavior.h"
#include "bt/human/TreeGenerator.h"
#include "bt/human/TreeLoader.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/support/Interop.h"

namespace {

/// The model block documents nodes and is ours; everything behind it is to be equal.
QByteArray behindTheModel(const QByteArray& text) {
  const int at = text.indexOf("</TreeNodesModel>");
  return at < 0 ? QByteArray() : text.mid(at);
}

}  // namespace

/// Real files of HuNavSim.
class HumanInteropTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void goalsOfTheTree_areThoseOfTheScenario_data() {
    QTest::addColumn<QString>("scenario");
    QTest::newRow("own") << QStringLiteral("own/scenarios/agents_yard.yaml");
    QTest::newRow("isaac") << QStringLiteral("isaac/scenarios/warehouse_agents.yaml");
    for (const char* name : {"cafe", "house", "warehouse"}) {
      QTest::newRow(name)
          << QStringLiteral("gazebo_classic/scenarios/agents_%1.yaml").arg(QString::fromUtf8(name));
    }
    QTest::newRow("fortress") << QStringLiteral("gazebo_fortress/scenarios/cafe_agents.yaml");
  }
  void goalsOfTheTree_areThoseOfTheScenario() {
    QFETCH(QString, scenario);
    const QString path = interopFile(QStringLiteral("hunavsim2/") + scenario);
    if (path.isEmpty()) {
      QSKIP("the interoperability files are not here");
    }
    const sim2d::ScenarioReading reading = sim2d::readScenario(path.toStdString());
    QVERIFY(reading.ok());
    const bt::NodeLibrary library = bt::humanNodes();
    const QDir trees(QFileInfo(path).dir().filePath(QStringLiteral("../behavior_trees")));
    int compared = 0;
    for (const sim2d::Human& human : reading.scenario.humans) {
      const QString tree = trees.filePath(QString::fromStdString(
          bt::treeFileName(reading.scenario.yamlBaseName.value_or(""), human.id)));
      if (!human.listed || !QFile::exists(tree)) {
        continue;
      }
      const auto table = bt::loadAgentTrees(bt::readTree(tree.toStdString()));
      QVERIFY2(table, qPrintable(tree));
      QVERIFY2(bt::compile(*table, library), qPrintable(tree));
      QVERIFY2(bt::treeGoals(*table) == human.goals, qPrintable(tree));
      ++compared;
      base::Diagnostics problems;
      bt::TreeLoader(reading.scenario).load(human, tree.toStdString(), problems);
      for (const base::Diagnostic& found : problems) {
        QWARN(found.text().c_str());
        QVERIFY(found.severity != base::Severity::Error);
      }
    }
    QVERIFY(compared > 0);
  }
  void hunav2Tree_ofAnInteropScenario_isTheOneShipped_data() {
    goalsOfTheTree_areThoseOfTheScenario_data();
  }
  void hunav2Tree_ofAnInteropScenario_isTheOneShipped() {
    QFETCH(QString, scenario);
    const QString path = interopFile(QStringLiteral("hunavsim2/") + scenario);
    if (path.isEmpty()) {
      QSKIP("the interoperability files are not here");
    }
    const sim2d::ScenarioReading reading = sim2d::readScenario(path.toStdString());
    const bt::NodeLibrary library = bt::humanNodes();
    const QDir trees(QFileInfo(path).dir().filePath(QStringLiteral("../behavior_trees")));
    int compared = 0;
    for (const sim2d::Human& human : reading.scenario.humans) {
      QFile shipped(trees.filePath(QString::fromStdString(
          bt::treeFileName(reading.scenario.yamlBaseName.value_or(""), human.id))));
      if (!human.listed || !shipped.open(QIODevice::ReadOnly)) {
        continue;
      }
      const QByteArray ours = QByteArray::fromStdString(
          bt::makeTreeText(reading.scenario, human, bt::TreeStyle::Hunav2, library.catalogue()));
      QCOMPARE(behindTheModel(ours), behindTheModel(shipped.readAll()));
      ++compared;
    }
    QVERIFY(compared > 0);
  }
};

QTEST_APPLESS_MAIN(HumanInteropTest)
#include "tst_HumanInterop.moc"
