#include <yaml-cpp/yaml.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"
#include "tests/support/TreeAttributes.h"

using namespace outside;

/// `hunavsim convert` from outside; what it wrote is read by yaml-cpp and Qt alone.
class ConvertProgramTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void convert_shippedScenario_everyTargetTakesIt_data();
  void convert_shippedScenario_everyTargetTakesIt();
  void convert_interopScenario_keepsPeopleAndGoals_data();
  void convert_interopScenario_keepsPeopleAndGoals();
  void convert_nativeOfNative_isByteIdentical();
  void convert_gapsAndNames_areMended();
  void convert_ownTree_followsTheNewGoalNumbers();
  void convert_otherInTheOriginal_isTold_data();
  void convert_otherInTheOriginal_isTold();
  void convert_whatOnlyWeHave_isListed();
  void convert_withoutMap_startsAWorldThatIsThere_data();
  void convert_withoutMap_startsAWorldThatIsThere();
  void convert_blankInTheName_standsInQuotes();
  void convert_again_saysWhatBecameOfEachFile();
  void convert_fileInTheWay_writesNothing();
  void convert_folderByWayOfAnother_isThatFolder();
  void convert_ontoItself_isRefused();
  void convert_badInput_isTold_data();
  void convert_badInput_isTold();
  void run_convertedScenario_manifestListsIncludedTrees();
  void words_wrong_exitWith64_data();
  void words_wrong_exitWith64();

 private:
  static Finished convert(const QString& scenario, const QString& folder, const char* target,
                          const QStringList& more = {}) {
    return runProgram(
        list("convert % -o % --target %", {scenario, folder, QString::fromUtf8(target)}) + more);
  }
};

namespace {

YAML::Node loaderOf(const QString& path) {
  return YAML::Load(bytesOf(path).toStdString())["hunav_loader"]["ros__parameters"];
}

QString shipped(const char* name) {
  return text(SOURCE_DIR "/maps/") + text(name);
}

/// A scenario with all that must be mended: gaps, ids from 7, names with blanks, nobody's goal.
const char* const kOdd =
    "hunav_loader:\n  ros__parameters:\n    map: cafe.yaml\n    global_goals:\n"
    "      2:\n        x: 1.0\n        y: 2.0\n      5:\n        x: 3.0\n        y: 4.0\n"
    "    agents:\n      - Ana Maria\n      - 2nd\n"
    "    Ana Maria:\n      id: 7\n      skin: 14\n      init_pose:\n        x: 0.5\n        y: "
    "0.5\n"
    "        h: 0.0\n      behavior:\n        type: Regular\n      goals:\n        - 5\n        - "
    "2\n"
    "    2nd:\n      id: 9\n      init_pose:\n        x: 2.5\n        y: 0.5\n        h: 0.0\n"
    "      behavior:\n        type: Curious\n"
    "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n    robots:\n"
    "      - robot1\n    robot1:\n      start:\n        x: 1.0\n        y: 1.0\n        h: 0.0\n"
    "      goal:\n        x: 5.0\n        y: 5.0\n";

}  // namespace

void ConvertProgramTest::convert_shippedScenario_everyTargetTakesIt_data() {
  QTest::addColumn<QByteArray>("target");
  QTest::addColumn<QByteArray>("simulator");
  QTest::addColumn<double>("z");
  QTest::addColumn<bool>("isB");
  QTest::newRow("classic") << QByteArray("gazebo-classic") << QByteArray("Gazebo Classic") << 1.25
                           << false;
  QTest::newRow("fortress") << QByteArray("gazebo-fortress") << QByteArray("Gazebo Fortress")
                            << 0.03 << true;
  QTest::newRow("isaac") << QByteArray("isaac") << QByteArray("Isaac Sim") << 0.0 << false;
  QTest::newRow("webots") << QByteArray("webots") << QByteArray("Webots") << 0.01 << true;
}

void ConvertProgramTest::convert_shippedScenario_everyTargetTakesIt() {
  QFETCH(QByteArray, target);
  QFETCH(QByteArray, simulator);
  QFETCH(double, z);
  QFETCH(bool, isB);
  const QTemporaryDir folder;
  const Finished found =
      convert(shipped("corner_cafe/corner_cafe_agents.yaml"), folder.path(), target.constData());
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  const YAML::Node loader = loaderOf(folder.filePath(text("scenarios/corner_cafe_agents.yaml")));
  QVERIFY(isB || loader["simulator"].as<std::string>() == simulator.toStdString());
  int number = 0;
  for (const YAML::Node& listed : loader["agents"]) {
    const YAML::Node agent = loader[listed.as<std::string>()];
    QCOMPARE(agent["id"].as<int>(), ++number);
    QCOMPARE(agent["init_pose"]["z"].as<double>(), z);
    QVERIFY(agent["goals"].size() > 0);
    QVERIFY(agent["goal_radius"] && agent["group_id"] && agent["skin"] && agent["max_vel"]);
    for (const char* factor : {"goal_force_factor", "obstacle_force_factor", "social_force_factor",
                               "other_force_factor"}) {
      QVERIFY(agent["behavior"][factor]);
    }
    QVERIFY(isB == (agent["behavior"]["type"].as<std::string>().size() == 1));
    QVERIFY(QFile::exists(
        folder.filePath(text("behavior_trees/corner_cafe_agents__agent_%1_bt.xml").arg(number))));
  }
  QVERIFY(number >= 1);
  QVERIFY(QFile::exists(folder.filePath(text("behavior_trees/BTRegularNav.xml"))));
  const YAML::Node map =
      YAML::Load(bytesOf(folder.filePath(text("maps/corner_cafe.yaml"))).toStdString());
  QVERIFY(QFile::exists(folder.filePath(text("maps/")) +
                        QString::fromStdString(map["image"].as<std::string>())));
  QVERIFY(found.out.contains(text("ros2 ")));
  QCOMPARE(failureOf("check %", {folder.filePath(text("scenarios/corner_cafe_agents.yaml"))}),
           QString());
}

void ConvertProgramTest::convert_interopScenario_keepsPeopleAndGoals_data() {
  QTest::addColumn<QByteArray>("file");
  QTest::addColumn<QByteArray>("target");
  for (const char* target : {"gazebo-classic", "gazebo-fortress", "isaac", "webots", "native"}) {
    for (const char* file :
         {"gazebo_classic/scenarios/agents_cafe.yaml", "isaac/scenarios/warehouse_agents.yaml",
          "hunav_sim_2024/config/agents.yaml", "hunav_sim_v1/config/agents.yaml"}) {
      QTest::addRow("%s to %s", file, target) << QByteArray(file) << QByteArray(target);
    }
  }
}

void ConvertProgramTest::convert_interopScenario_keepsPeopleAndGoals() {
  QFETCH(QByteArray, file);
  QFETCH(QByteArray, target);
  const QString path = interop(text("hunavsim2/") + QString::fromUtf8(file));
  if (!QFile::exists(path)) {
    QSKIP("the stored scenarios of HuNavSim are not here");
  }
  const QTemporaryDir folder;
  const Finished found = convert(path, folder.path(), target.constData());
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  const QString written = folder.filePath(text("scenarios/")) + QFileInfo(path).fileName();
  const YAML::Node before = loaderOf(path);
  const YAML::Node after = loaderOf(written);
  QCOMPARE(after["agents"].size(), before["agents"].size());
  for (std::size_t i = 0; i < before["agents"].size(); ++i) {
    const YAML::Node was = before[before["agents"][i].as<std::string>()];
    const YAML::Node is = after[after["agents"][i].as<std::string>()];
    QCOMPARE(is["goals"].size(), was["goals"].size());
    QCOMPARE(is["init_pose"]["x"].as<double>(), was["init_pose"]["x"].as<double>());
    QCOMPARE(is["init_pose"]["y"].as<double>(), was["init_pose"]["y"].as<double>());
    QCOMPARE(is["max_vel"].as<double>(1.0), was["max_vel"].as<double>(1.0));
  }
  // there and back: what our own reader takes out of it is the same scenario again
  const QTemporaryDir again;
  const Finished back = convert(written, again.path(), "native");
  QVERIFY2(back.exitCode == 0, qPrintable(back.err));
  const YAML::Node home = loaderOf(again.filePath(text("scenarios/")) + QFileInfo(path).fileName());
  QCOMPARE(home["agents"].size(), before["agents"].size());
  QVERIFY(home["global_goals"].size() > 0);
}

void ConvertProgramTest::convert_nativeOfNative_isByteIdentical() {
  const QTemporaryDir first;
  const QTemporaryDir second;
  const QString name = text("scenarios/corner_cafe_agents.yaml");
  QCOMPARE(convert(shipped("corner_cafe/corner_cafe_agents.yaml"), first.path(), "native").exitCode,
           0);
  QCOMPARE(convert(first.filePath(name), second.path(), "native").exitCode, 0);
  QDirIterator files(first.path(), QDir::Files, QDirIterator::Subdirectories);
  int count = 0;
  while (files.hasNext()) {
    const QString file = files.next();
    const QString other = second.path() + file.mid(first.path().size());
    QVERIFY2(bytesOf(file) == bytesOf(other), qPrintable(file));
    ++count;
  }
  QVERIFY(count > 4);
}

void ConvertProgramTest::convert_gapsAndNames_areMended() {
  const QTemporaryDir folder;
  const QString path = folder.filePath(text("in/odd.yaml"));
  writeText(path, kOdd);
  const Finished found =
      convert(path, folder.filePath(text("out")), "webots", {text("--dialect"), text("C")});
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  const YAML::Node loader = loaderOf(folder.filePath(text("out/scenarios/odd.yaml")));
  QCOMPARE(loader["agents"][0].as<std::string>().c_str(), "Ana_Maria");
  QCOMPARE(loader["agents"][1].as<std::string>().c_str(), "agent_2nd");
  QCOMPARE(loader["map"].as<std::string>().c_str(), "cafe");
  const YAML::Node ana = loader["Ana_Maria"];
  QCOMPARE(ana["id"].as<int>(), 1);
  QCOMPARE(ana["skin"].as<int>(), 2);  // 14 modulo the four of Webots
  QCOMPARE(ana["goals"][0].as<int>(), 2);
  QCOMPARE(ana["goals"][1].as<int>(), 1);
  QCOMPARE(loader["global_goals"]["1"]["x"].as<double>(), 1.0);
  QCOMPARE(loader["global_goals"]["2"]["y"].as<double>(), 4.0);
  QCOMPARE(loader["agent_2nd"]["goals"][0].as<int>(), 3);  // a place to stand at
  QCOMPARE(loader["global_goals"]["3"]["x"].as<double>(), 2.5);
  QVERIFY(found.err.contains(text("has no goal")));
  QVERIFY(found.err.contains(text("3-D world 'cafe'")));
}

void ConvertProgramTest::convert_ownTree_followsTheNewGoalNumbers() {
  const QTemporaryDir folder;
  const QString path = folder.filePath(text("odd.yaml"));
  writeText(path, kOdd);
  writeText(folder.filePath(text("odd__agent_7_bt.xml")),
            "<root BTCPP_format='4'><BehaviorTree ID='T'><Sequence>"
            "<SetGoal agent_id='7' goal_id='5'/><GoTo agent_id='{id}' goal_id='2' "
            "time_step='{dt}'/><LookAtAgent observer_id='7' target_id='9'/>"
            "<WanderInArea agent_id='{id}' area='hall'/>"
            "</Sequence></BehaviorTree></root>");
  const Finished found = convert(path, folder.filePath(text("out")), "gazebo-classic");
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  const QString tree = folder.filePath(text("out/behavior_trees/odd__agent_1_bt.xml"));
  QCOMPARE(attributesIn(bytesOf(tree), "goal_id"), (QStringList{text("2"), text("1")}));
  QCOMPARE(attributesIn(bytesOf(tree), "target_id"), QStringList{text("2")});
  QCOMPARE(attributesIn(bytesOf(tree), "observer_id"), QStringList{text("1")});
  QVERIFY(attributesIn(bytesOf(tree), "agent_id").contains(text("{id}")));
  QVERIFY2(found.err.contains(text("WanderInArea")), qPrintable(found.err));
}

/// Each row of the table of differences (bt/engine/README.md) that `check` notes.
void ConvertProgramTest::convert_otherInTheOriginal_isTold_data() {
  QTest::addColumn<QByteArray>("trees");
  QTest::addColumn<QString>("told");
  const auto row = [](const char* name, const char* trees, const char* told) {
    QTest::newRow(name) << QByteArray(trees) << text(told);
  };
  row("clock", "<BehaviorTree ID='T'>\n<Delay delay_msec='500'>GOTO</Delay></BehaviorTree>",
      ": info: Delay, Timeout and Sleep use the system clock in BehaviorTree.CPP");
  row("stale",
      "<BehaviorTree ID='T'>\n<IfThenElse>GOTO<AlwaysSuccess/></IfThenElse></BehaviorTree>",
      ":3: warning: T: IfThenElse: in BehaviorTree.CPP the condition of an IfThenElse with two "
      "children is not reset");
  row("emptied",
      "<BehaviorTree ID='T'><Sequence>\n<Script code='k := 1'/>\n"
      "<SetBlackboard value='5' output_key='k'/>GOTO</Sequence></BehaviorTree>",
      ":4: warning: T: SetBlackboard: BehaviorTree.CPP may leave 'k' without a value");
  row("kept",
      "<BehaviorTree ID='T'><Sequence>\n<SubTree ID='Sub' x='{a}'/>\n<UnsetBlackboard key='a'/>GOTO"
      "</Sequence></BehaviorTree><BehaviorTree ID='Sub'><Script code='x := 1'/></BehaviorTree>",
      ":4: warning: T: UnsetBlackboard: in BehaviorTree.CPP a SubTree that received 'a' keeps it");
  row("refused",
      "<BehaviorTree ID='T'><SubTree ID='Sub' x='7' id='{id}' dt='{dt}'/></BehaviorTree>\n"
      "<BehaviorTree ID='Sub'><Sequence>\n"
      "<StopAndWaitTimerAction agent_id='{id}' wait_duration='{x}'/>GOTO</Sequence></BehaviorTree>",
      ":4: warning: Sub: StopAndWaitTimerAction: BehaviorTree.CPP 4.10 rejects the file: port "
      "'wait_duration' is double, but {x} is int");
  row("shared",
      "<BehaviorTree ID='T'><Sequence><LoopInt queue='{q}' value='{v}'><AlwaysSuccess/></LoopInt>\n"
      "<SetBlackboard value='{q}' output_key='m'/>GOTO</Sequence></BehaviorTree>",
      ":3: warning: T: SetBlackboard: in BehaviorTree.CPP 'q' and its copy share one queue");
  row("nothing", "<BehaviorTree ID='T'><Sequence>GOTO</Sequence></BehaviorTree>", "");
}

void ConvertProgramTest::convert_otherInTheOriginal_isTold() {
  QFETCH(QByteArray, trees);
  QFETCH(QString, told);
  const QTemporaryDir folder;
  const QString path = folder.filePath(text("odd.yaml"));
  const QString tree = folder.filePath(text("odd__agent_7_bt.xml"));
  writeText(path, kOdd);
  trees.replace("GOTO", "<GoTo agent_id='{id}' goal_id='5' time_step='{dt}'/>");
  writeText(tree, "<root BTCPP_format='4' main_tree_to_execute='T'>\n" + trees + "</root>\n");
  const Finished found = convert(path, folder.filePath(text("out")), "gazebo-classic");
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  const int count = found.err.count(text("BehaviorTree.CPP"));
  QVERIFY2(count == (told.isEmpty() ? 0 : 1), qPrintable(found.err));
  QVERIFY2(told.isEmpty() || found.err.contains(tree + told), qPrintable(found.err));
}

void ConvertProgramTest::convert_whatOnlyWeHave_isListed() {
  const QTemporaryDir folder;
  const QString path = folder.filePath(text("odd.yaml"));
  writeText(path, QByteArray("# a remark\n") + kOdd + "    Ana Maria:\n      start_time: 3.0\n");
  const Finished found = convert(path, folder.filePath(text("out")), "isaac", {text("--json")});
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  const QJsonObject json = QJsonDocument::fromJson(found.out.toUtf8()).object();
  QString report;
  for (const auto& line : json[text("report")].toArray()) {
    report += line.toObject()[text("message")].toString() + QLatin1Char('\n');
  }
  for (const char* word : {"robot1", "start_time", "comment"}) {
    QVERIFY2(report.contains(text(word)), qPrintable(report));
  }
  // and it is not lost: our block has it
  const QByteArray text = bytesOf(folder.filePath(QStringLiteral("out/scenarios/odd.yaml")));
  const YAML::Node ours = YAML::Load(text.toStdString())["hunavsim_desktop"]["ros__parameters"];
  QCOMPARE(ours["robot1"]["goal"]["x"].as<double>(), 5.0);
  QCOMPARE(ours["Ana_Maria"]["start_time"].as<double>(), 3.0);
  QVERIFY(json[QStringLiteral("start")].toString().contains(QStringLiteral("odd.yaml")));
}

/// No argument without a value: what a launch file takes then is said.
void ConvertProgramTest::convert_withoutMap_startsAWorldThatIsThere_data() {
  QTest::addColumn<QByteArray>("target");
  QTest::addColumn<QString>("start");
  QTest::addColumn<QString>("world");
  QTest::newRow("classic") << QByteArray("gazebo-classic")
                           << text(
                                  "ros2 launch hunav_gazebo_wrapper simulation.launch.py "
                                  "configuration_file:=odd.yaml gzpose_x:=1.000 gzpose_y:=1.000 "
                                  "gzpose_Y:=0.000")
                           << text("'cafe'");
  QTest::newRow("webots") << QByteArray("webots")
                          << text(
                                 "ros2 launch hunav_webots_wrapper hunavsim_webots.launch.py "
                                 "configuration_file:=odd.yaml")
                          << text("'factory'");
  QTest::newRow("fortress") << QByteArray("gazebo-fortress")
                            << text(
                                   "ros2 launch hunav_gazebo_fortress_wrapper "
                                   "cafe_fortress_test.launch.py configuration_file:=odd.yaml")
                            << text("'cafe'");
  QTest::newRow("isaac") << QByteArray("isaac")
                         << text(
                                "ros2 run hunav_isaac_wrapper hunav_isaac_launcher --config "
                                "odd.yaml --world empty_world --batch")
                         << text("'empty_world'");
}

void ConvertProgramTest::convert_withoutMap_startsAWorldThatIsThere() {
  QFETCH(QByteArray, target);
  QFETCH(QString, start);
  QFETCH(QString, world);
  const QTemporaryDir folder;
  const QString path = folder.filePath(text("odd.yaml"));
  writeText(path, QByteArray(kOdd).replace("    map: cafe.yaml\n", ""));
  const Finished found =
      convert(path, folder.filePath(text("out")), target.constData(), {text("--json")});
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  const QJsonObject json = QJsonDocument::fromJson(found.out.toUtf8()).object();
  QCOMPARE(json[text("start")].toString(), start);
  QVERIFY2(found.err.contains(text("names no map: ")) && found.err.contains(world),
           qPrintable(found.err));
}

void ConvertProgramTest::convert_blankInTheName_standsInQuotes() {
  const QTemporaryDir folder;
  const QString path = folder.filePath(text("odd.yaml"));
  writeText(path, QByteArray(kOdd).replace("    map: ", "    yaml_base_name: it's odd\n    map: "));
  const Finished found =
      convert(path, folder.filePath(text("out")), "gazebo-fortress", {text("--json")});
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  const QJsonObject json = QJsonDocument::fromJson(found.out.toUtf8()).object();
  QCOMPARE(json[text("start")].toString(),
           text("ros2 launch hunav_gazebo_fortress_wrapper cafe_fortress_test.launch.py "
                "'configuration_file:=it'\\''s odd.yaml'"));
}

void ConvertProgramTest::convert_again_saysWhatBecameOfEachFile() {
  const QTemporaryDir folder;
  const QString path = folder.filePath(text("odd.yaml"));
  const QString out = folder.filePath(text("out"));
  writeText(path, kOdd);
  QVERIFY(convert(path, out, "isaac").out.contains(text("written   ")));
  const Finished again = convert(path, out, "isaac");
  QVERIFY(!again.out.contains(text("written")));
  QVERIFY(again.out.contains(text("unchanged ")));
  const Finished other = convert(path, out, "webots");
  QVERIFY(other.out.contains(text("replaced  ")));
}

void ConvertProgramTest::convert_fileInTheWay_writesNothing() {
  const QTemporaryDir folder;
  const QString path = folder.filePath(text("odd.yaml"));
  writeText(path, kOdd);
  QVERIFY(QDir().mkpath(folder.filePath(text("out/scenarios/odd.yaml"))));
  const Finished found = convert(path, folder.filePath(text("out")), "isaac");
  QCOMPARE(found.exitCode, 2);
  QVERIFY(found.err.contains(text("error:")));
  QDirIterator files(folder.filePath(text("out")), QDir::Files | QDir::Hidden,
                     QDirIterator::Subdirectories);
  QVERIFY(!files.hasNext());
}

void ConvertProgramTest::convert_folderByWayOfAnother_isThatFolder() {
  const QTemporaryDir folder;
  const QString path = folder.filePath(text("odd.yaml"));
  writeText(path, kOdd);
  QVERIFY(QDir(folder.path()).mkdir(text("other")));
  const Finished found = convert(path, folder.path() + text("/./other/../out"), "isaac");
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  const QDir out(folder.filePath(text("out")));
  QCOMPARE(out.entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
           (list("behavior_trees scenarios")));
}

void ConvertProgramTest::convert_ontoItself_isRefused() {
  const QTemporaryDir folder;
  const QString path = folder.filePath(text("scenarios/odd.yaml"));
  writeText(path, kOdd);
  const Finished found = convert(path, folder.path(), "webots");
  QCOMPARE(found.exitCode, 2);
  QCOMPARE(bytesOf(path), QByteArray(kOdd));
}

void ConvertProgramTest::convert_badInput_isTold_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("says");
  QTest::newRow("no yaml") << QByteArray("hunav_loader: [") << QByteArray("in.yaml:1:");
  QTest::newRow("empty") << QByteArray() << QByteArray("in.yaml: error");
  QTest::newRow("wrong type") << QByteArray(kOdd).replace("id: 7", "id: seven")
                              << QByteArray("in.yaml:15:11: error:");
  QTest::newRow("goal that is not there")
      << QByteArray(kOdd).replace("- 5", "- 55") << QByteArray("error");
  QTest::newRow("name out of the folder")
      << QByteArray(kOdd).replace("    map: ", "    yaml_base_name: ../../x\n    map: ")
      << QByteArray("is not a valid prefix of file names");
  QTest::newRow("missing") << QByteArray("-") << QByteArray("cannot read the file");
}

void ConvertProgramTest::convert_badInput_isTold() {
  QFETCH(QByteArray, text);
  QFETCH(QByteArray, says);
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("in.yaml"));
  if (text != "-") {
    writeText(path, text);
  }
  QCOMPARE(unexpected(convert(path, folder.filePath(QStringLiteral("out")), "isaac"), 2,
                      QString::fromUtf8(says)),
           QString());
  QVERIFY(!QDir(folder.filePath(QStringLiteral("out"))).exists());
}

void ConvertProgramTest::run_convertedScenario_manifestListsIncludedTrees() {
  const QTemporaryDir folder;
  QCOMPARE(
      convert(shipped("corner_cafe/corner_cafe_agents.yaml"), folder.path(), "native").exitCode, 0);
  QCOMPARE(failureOf("run % -o % --duration 0.2",
                     {folder.filePath(text("scenarios/corner_cafe_agents.yaml")),
                      folder.filePath(text("run"))}),
           QString());
  const QJsonObject manifest = readJson(folder.filePath(text("run/manifest.json")));
  int included = 0;
  int trees = 0;
  for (const auto& input : manifest[text("inputs")].toArray()) {
    const QString path = input.toObject()[text("path")].toString();
    included += path.endsWith(text("BTRegularNav.xml")) ? 1 : 0;
    trees += path.contains(text("__agent_")) ? 1 : 0;
    QVERIFY(input.toObject()[text("sha256")].toString().size() == 64);
  }
  QCOMPARE(included, 1);
  QVERIFY(trees > 1);
}

void ConvertProgramTest::words_wrong_exitWith64_data() {
  QTest::addColumn<QStringList>("words");
  const QString file = shipped("corner_cafe/corner_cafe_agents.yaml");
  QTest::newRow("no target") << QStringList{file, text("-o"), text("x")};
  QTest::newRow("no folder") << QStringList{file, text("--target"), text("isaac")};
  QTest::newRow("no scenario") << QStringList{text("-o"), text("x"), text("--target"),
                                              text("isaac")};
  QTest::newRow("unknown target") << QStringList{file, text("-o"), text("x"), text("--target"),
                                                 text("unity")};
}

void ConvertProgramTest::words_wrong_exitWith64() {
  QFETCH(QStringList, words);
  QCOMPARE(runProgram(list("convert") + words).exitCode, 64);
}

QTEST_GUILESS_MAIN(ConvertProgramTest)
#include "tst_ConvertProgram.moc"
