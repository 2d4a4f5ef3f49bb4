#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"
#include "sim2d/nav/nav2/params/ParameterPatch.h"

using sim2d::nav2::withParameter;

namespace {

// A file as people write it: comments, several layouts of the same things.
const std::string kFile =
    "# our robot\n"
    "controller_server:  # drives\n"
    "  ros__parameters:\n"
    "    controller_frequency: 20.0  # Hz, see the wiki\n"
    "    controller_plugins: [\"FollowPath\"]\n"
    "    FollowPath:\n"
    "      plugin: 'nav2_mppi_controller::MPPIController'\n"
    "\n"
    "      # tuned on 3 May\n"
    "      vx_max: 0.5 # m/s\n"
    "      critics:\n"
    "        - GoalCritic\n"
    "        # no PathAlign\n"
    "        - CostCritic\n"
    "      GoalCritic: {enabled: true, cost_weight: 5.0}\n"
    "    last: 1\n"
    "\n"
    "# below are costmaps\n"
    "local_costmap:\n"
    "  local_costmap:\n"
    "    ros__parameters:\n"
    "      width: 3\n"
    "      footprint: \"[[0.1, 0.2], [-0.1, 0.2], [-0.1, -0.2]]\"\n"
    "/**:\n"
    "  ros__parameters:\n"
    "    use_sim_time: false\n";

QString patched(const std::string& text, const char* node, const char* name, const char* yaml) {
  const auto found = withParameter(text, {node, name, yaml});
  return found ? QString::fromStdString(*found) : QStringLiteral("none");
}

/// The file with one piece of text exchanged.
QString with(const char* before, const char* now) {
  QString text = QString::fromStdString(kFile);
  const int count = text.count(QLatin1String(before));
  return count == 1 ? text.replace(QLatin1String(before), QLatin1String(now))
                    : QStringLiteral("not one %1").arg(QLatin1String(before));
}

}  // namespace

/// Values are changed in their places; every other byte of the file stays.
class ParameterPatchTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void value_inTheFile_isReplaced_data() {
    QTest::addColumn<QByteArray>("node");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("yaml");
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("now");
    const auto row = [](const char* what, const char* node, const char* name, const char* yaml,
                        const char* before, const char* now) {
      QTest::newRow(what) << QByteArray(node) << QByteArray(name) << QByteArray(yaml)
                          << QByteArray(before) << QByteArray(now);
    };
    const char* controller = "controller_server";
    row("before a comment", controller, "controller_frequency", "30.0", "20.0  #", "30.0  #");
    row("nested", controller, "FollowPath.vx_max", "0.75", "vx_max: 0.5 #", "vx_max: 0.75 #");
    row("in quotes", controller, "FollowPath.plugin", "\"dwb_core::DWBLocalPlanner\"",
        "'nav2_mppi_controller::MPPIController'", "\"dwb_core::DWBLocalPlanner\"");
    row("list in brackets", controller, "controller_plugins", "[\"A\", \"B\"]", "[\"FollowPath\"]",
        "[\"A\", \"B\"]");
    row("in a flow map", controller, "FollowPath.GoalCritic.enabled", "false", "enabled: true",
        "enabled: false");
    row("last of a flow map", controller, "FollowPath.GoalCritic.cost_weight", "7.5", "5.0}",
        "7.5}");
    row("list of dashes", controller, "FollowPath.critics", "[\"GoalCritic\"]",
        "critics:\n        - GoalCritic\n        # no PathAlign\n        - CostCritic\n",
        "critics: [\"GoalCritic\"]\n");
    row("costmap", "local_costmap", "width", "5", "width: 3\n", "width: 5\n");
    row("text with brackets", "local_costmap", "footprint", "\"[]\"",
        "\"[[0.1, 0.2], [-0.1, 0.2], [-0.1, -0.2]]\"", "\"[]\"");
  }
  void value_inTheFile_isReplaced() {
    QFETCH(QByteArray, node);
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, yaml);
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, now);
    QCOMPARE(patched(kFile, node, name, yaml), with(before, now));
  }

  /// Behind its siblings (not in a map on one line), before the empty line and the comment of what
  /// follows.
  void value_notInTheFile_isAddedToItsMap() {
    QCOMPARE(patched(kFile, "controller_server", "FollowPath.temperature", "0.2"),
             with("- CostCritic\n", "- CostCritic\n      temperature: 0.2\n"));
    QCOMPARE(patched(kFile, "controller_server", "failure_tolerance", "0.4"),
             with("    last: 1\n", "    last: 1\n    failure_tolerance: 0.4\n"));
    QCOMPARE(patched(kFile, "local_costmap", "inflation_layer.inflation_radius", "0.6"),
             with("-0.2]]\"\n", "-0.2]]\"\n      inflation_layer.inflation_radius: 0.6\n"));
  }

  /// That of all nodes stays as it is for the others.
  void value_belowTheWildcard_isAddedToTheNode() {
    QCOMPARE(patched(kFile, "controller_server", "use_sim_time", "true"),
             with("    last: 1\n", "    last: 1\n    use_sim_time: true\n"));
  }

  void node_notInTheFile_isAddedAtTheEnd() {
    QCOMPARE(
        patched(kFile, "planner_server", "expected_planner_frequency", "5.0"),
        QString::fromStdString(kFile) + QStringLiteral("planner_server:\n  ros__parameters:\n"
                                                       "    expected_planner_frequency: 5.0\n"));
  }

  void values_oneAfterTheOther_areAllRead() {
    std::string text = kFile;
    for (const auto& [name, yaml] :
         {std::pair("FollowPath.vx_max", "0.9"), std::pair("FollowPath.temperature", "0.2"),
          std::pair("FollowPath.GoalCritic.cost_power", "2"), std::pair("last", "7")}) {
      const auto next = withParameter(text, {"controller_server", name, yaml});
      QVERIFY2(next.has_value(), name);
      text = *next;
    }
    const auto file = sim2d::nav2::ParameterFile::parse(text, "f");
    QVERIFY(bool(file));
    const auto node = file->parametersOf("controller_server");
    QCOMPARE(node.find("FollowPath.vx_max")->value->text, std::string("0.9"));
    QCOMPARE(node.find("FollowPath.temperature")->value->text, std::string("0.2"));
    QCOMPARE(node.find("FollowPath.GoalCritic.cost_power")->value->text, std::string("2"));
    QCOMPARE(node.find("last")->value->text, std::string("7"));
    QVERIFY(text.find("# tuned on 3 May") != std::string::npos);
  }

  /// The value of an anchor counts elsewhere too; a block scalar has no place of one line.
  void value_thatCannotBeReplaced_isLeftAlone() {
    const std::string anchor =
        "a:\n  ros__parameters:\n    x: &v 1.0\n    y: *v\n    text: |\n      many\n      lines\n";
    QCOMPARE(patched(anchor, "a", "y", "2.0"), QStringLiteral("none"));
    QCOMPARE(patched(anchor, "a", "text", "one"), QStringLiteral("none"));
    QCOMPARE(patched("a: [1", "a", "x", "2"), QStringLiteral("none"));
  }

  void file_withoutLineBreakAtItsEnd_isContinued() {
    const std::string text = "a:\n  ros__parameters:\n    x: 1.0";
    QCOMPARE(patched(text, "a", "x", "2.0"), QStringLiteral("a:\n  ros__parameters:\n    x: 2.0"));
    QCOMPARE(patched(text, "a", "y", "2.0"),
             QStringLiteral("a:\n  ros__parameters:\n    x: 1.0\n    y: 2.0\n"));
  }

  /// Of all shipped files every value can be written again: nothing else changes.
  void shippedFiles_everyValue_isFoundInItsPlace() {
    const QDir folder(QStringLiteral(SOURCE_DIR "/resources/nav2_params"));
    int values = 0;
    for (const QString& name : folder.entryList({QStringLiteral("*.yaml")}, QDir::Files)) {
      const std::string text = *base::readTextFile(folder.filePath(name).toStdString());
      const auto file = sim2d::nav2::ParameterFile::parse(text, "f");
      QVERIFY2(bool(file), qPrintable(name));
      for (const auto& node : file->nodes()) {
        for (std::size_t k = 0; k < node.given.size(); k += 7) {
          const auto& given = node.given[k];
          if (given.isWildcard || node.node == "/**" || !given.value->isScalar() ||
              given.isPlaceholder) {
            continue;
          }
          const std::string yaml = given.value->quoted ? "\"other\"" : "12345.5";
          QVERIFY2(withParameter(text, {node.node, given.name, yaml}).has_value(),
                   qPrintable(name + QStringLiteral(": ") + QString::fromStdString(given.name)));
          ++values;
        }
      }
    }
    QVERIFY(values > 50);
  }
};

QTEST_APPLESS_MAIN(ParameterPatchTest)
#include "tst_ParameterPatch.moc"
