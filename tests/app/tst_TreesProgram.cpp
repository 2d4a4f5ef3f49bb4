#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"
#include "tests/support/TreeAttributes.h"

using namespace outside;

/// `hunavsim trees` from outside: its words, and the trees that it writes.
class TreesProgramTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void words_wrong_exitWith64_data();
  void words_wrong_exitWith64();
  void make_shippedScenario_treesPassTheCheck_data();
  void make_shippedScenario_treesPassTheCheck();
  void make_again_saysWhatBecameOfEachFile();
  void make_withoutFolder_printsAll();
  void make_intoAFile_isAnError();
  void make_baseNameWithFolder_isAnError();
  void make_mistypedName_getsTheNearest();
  void make_hunav2_hasTheGoalsOfTheShippedTrees_data();
  void make_hunav2_hasTheGoalsOfTheShippedTrees();
  void make_hunav2_bodyIsTheFilledTemplate_data();
  void make_hunav2_bodyIsTheFilledTemplate();
  void picture_ofAnAgent_isOneVectorFile_data();
  void picture_ofAnAgent_isOneVectorFile();
  void picture_ofATreeFile_hasItsIncludedTrees();
  void picture_impossible_isAnError_data();
  void picture_impossible_isAnError();
};

namespace {

QString ofTheOriginal(const QString& file) {
  return interop(text("hunavsim2/") + file);
}

/// Goal ids of the SetGoal nodes of a tree file, in order.
QStringList goalsIn(const QString& path) {
  return attributesIn(bytesOf(path), "goal_id", [](const QXmlStreamReader& xml) {
    return xml.name() == QLatin1String("SetGoal") ||
           xml.attributes().value(text("ID")) == QLatin1String("SetGoal");
  });
}

QStringList makeWords(const QString& scenario, const QString& folder, const char* style) {
  return {text("trees"), scenario, text("-o"), folder, text("--style"), text(style)};
}

}  // namespace

void TreesProgramTest::words_wrong_exitWith64_data() {
  QTest::addColumn<QString>("words");
  QTest::newRow("nothing") << text("trees");
  QTest::newRow("both") << text("trees a.yaml --play b.xml");
  QTest::newRow("style of nothing") << text("trees a.yaml --style mine");
  QTest::newRow("folder for a play") << text("trees --play b.xml -o out");
  QTest::newRow("script without play") << text("trees a.yaml --script s.yaml");
  QTest::newRow("picture of a play") << text("trees --play b.xml --picture p.svg");
  QTest::newRow("picture and folder") << text("trees a.yaml --picture p.svg -o out");
  QTest::newRow("agent without picture") << text("trees a.yaml --agent 1");
  QTest::newRow("no ticks") << text("trees --play b.xml --ticks 0");
  QTest::newRow("half ticks") << text("trees --play b.xml --ticks 1.5");
  QTest::newRow("no step") << text("trees --play b.xml --dt 0");
  QTest::newRow("nan step") << text("trees --play b.xml --dt nan");
  QTest::newRow("seed below 0") << text("trees --play b.xml --seed -1");
  QTest::newRow("quirk") << text("trees --play b.xml --compat Q-99");
}

void TreesProgramTest::words_wrong_exitWith64() {
  QFETCH(QString, words);
  const Finished found = runProgram(words.split(QLatin1Char(' ')));
  QCOMPARE(found.exitCode, 64);
  QVERIFY(found.out.isEmpty());
  QVERIFY(!found.err.isEmpty());
}

void TreesProgramTest::make_shippedScenario_treesPassTheCheck_data() {
  QTest::addColumn<QByteArray>("style");
  QTest::newRow("corrected") << QByteArray("corrected");
  QTest::newRow("hunav2") << QByteArray("hunav2");
}

void TreesProgramTest::make_shippedScenario_treesPassTheCheck() {
  QFETCH(QByteArray, style);
  QTemporaryDir folder;
  const QString scenario = text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
  const QString out = folder.filePath(text("a/b"));
  const Finished made = runProgram(makeWords(scenario, out, style.constData()));
  QVERIFY2(made.exitCode == 0, qPrintable(made.err));
  QStringList files;
  for (const QFileInfo& info : QDir(out).entryInfoList(QDir::Files)) {
    QVERIFY2(made.out.contains(text("written   ") + info.filePath() + QLatin1Char('\n')),
             qPrintable(made.out));
    files << info.filePath();
  }
  QVERIFY(files.size() >= 3);
  QVERIFY(QFile::exists(out + text("/BTRegularNav.xml")));
  QVERIFY(QFile::exists(out + text("/corner_cafe_agents__agent_1_bt.xml")));
  const Finished alone = runProgram(list("check") + files);
  QVERIFY2(alone.exitCode == 0 && alone.err.isEmpty(), qPrintable(alone.err));
  QCOMPARE(failureOf("check % --trees %", {scenario, out}), QString());
}

void TreesProgramTest::make_again_saysWhatBecameOfEachFile() {
  QTemporaryDir folder;
  const QString scenario = text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
  QStringList words = makeWords(scenario, folder.path(), "corrected");
  QCOMPARE(runProgram(words).exitCode, 0);
  const QString edited = folder.filePath(text("corner_cafe_agents__agent_1_bt.xml"));
  const QByteArray original = bytesOf(edited);
  QVERIFY(!original.isEmpty());
  writeText(edited, "<root/>");
  writeText(folder.filePath(text("mine.xml")), "mine");
  QCOMPARE(unexpected(runProgram(words), 2, edited + text(": error: ")), QString());
  QCOMPARE(bytesOf(edited), QByteArray("<root/>"));
  const Finished plain = runProgram(words + list("--force"));
  QVERIFY(plain.out.contains(text("replaced  ") + edited));
  QCOMPARE(plain.out.count(text("replaced")), 1);
  QVERIFY(plain.out.contains(text("unchanged ")) && !plain.out.contains(text("written")));
  QCOMPARE(bytesOf(edited), original);
  QCOMPARE(bytesOf(folder.filePath(text("mine.xml"))), QByteArray("mine"));
  words << text("--json");
  const Finished json = runProgram(words);
  for (const auto& file : QJsonDocument::fromJson(json.out.toUtf8()).array()) {
    QCOMPARE(file.toObject()[text("state")].toString(), text("unchanged"));
  }
}

void TreesProgramTest::make_withoutFolder_printsAll() {
  QTemporaryDir folder;
  const QString scenario = text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
  QCOMPARE(runProgram(makeWords(scenario, folder.path(), "corrected")).exitCode, 0);
  const Finished plain = runProgram("trees %", {scenario});
  const Finished json = runProgram("trees % --json", {scenario});
  const QJsonArray all = QJsonDocument::fromJson(json.out.toUtf8()).array();
  QCOMPARE(all.size(), QDir(folder.path()).entryList(QDir::Files).size());
  for (const QJsonValue& value : all) {
    const QString name = value.toObject()[text("file")].toString();
    const QString content = QString::fromUtf8(bytesOf(folder.filePath(name)));
    QCOMPARE(value.toObject()[text("text")].toString(), content);
    QVERIFY(plain.out.contains(text("==> ") + name + text(" <==\n") + content));
  }
}

void TreesProgramTest::make_intoAFile_isAnError() {
  QTemporaryDir folder;
  const QString inTheWay = folder.filePath(text("file"));
  writeText(inTheWay, "x");
  QCOMPARE(
      unexpected(runProgram(makeWords(text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml"),
                                      inTheWay, "corrected")),
                 2, text("error: ")),
      QString());
  QCOMPARE(bytesOf(inTheWay), QByteArray("x"));
}

void TreesProgramTest::make_baseNameWithFolder_isAnError() {
  QTemporaryDir folder;
  QByteArray scenarioText = bytesOf(text(TEST_DATA_DIR "/scenario/canonical.yaml"));
  const int at = scenarioText.indexOf("yaml_base_name:");
  QVERIFY(at > 0);
  scenarioText.replace(at, scenarioText.indexOf('\n', at) - at, "yaml_base_name: ../outside");
  const QString scenario = folder.filePath(text("s.yaml"));
  writeText(scenario, scenarioText);
  const QString out = folder.filePath(text("out"));
  const Finished found = runProgram(makeWords(scenario, out, "corrected"));
  QCOMPARE(found.exitCode, 2);
  QVERIFY(!QFile::exists(out));
  QVERIFY(QDir(folder.path()).entryList({text("outside*")}).isEmpty());
}

void TreesProgramTest::make_mistypedName_getsTheNearest() {
  const Finished found = runProgram("trees two_workers_agent");
  QCOMPARE(found.exitCode, 2);
  QVERIFY(found.out.isEmpty());
  QVERIFY2(found.err.contains(text("two_workers_agents")), qPrintable(found.err));
  // a path is a path
  const Finished path = runProgram("trees ./two_workers_agent");
  QCOMPARE(path.exitCode, 2);
  QVERIFY2(!path.err.contains(text("two_workers_agents")), qPrintable(path.err));
}

void TreesProgramTest::make_hunav2_hasTheGoalsOfTheShippedTrees_data() {
  QTest::addColumn<QString>("place");
  QTest::addColumn<QString>("base");
  QTest::newRow("isaac") << text("isaac") << text("warehouse_agents");
  for (const char* name : {"agents_cafe", "agents_house", "agents_warehouse"}) {
    QTest::newRow(name) << text("gazebo_classic") << text(name);
  }
  QTest::newRow("fortress") << text("gazebo_fortress") << text("cafe_agents");
}

void TreesProgramTest::make_hunav2_hasTheGoalsOfTheShippedTrees() {
  QFETCH(QString, place);
  QFETCH(QString, base);
  const QString root = ofTheOriginal(place);
  if (!QFile::exists(root)) {
    QSKIP("the interoperability files are not here");
  }
  QTemporaryDir folder;
  QCOMPARE(failureOf(makeWords(root + text("/scenarios/") + base + text(".yaml"), folder.path(),
                               "hunav2")),
           QString());
  int compared = 0;
  for (const QString& name : QDir(folder.path()).entryList({base + text("__agent_*_bt.xml")})) {
    const QString shipped = root + text("/behavior_trees/") + name;
    if (QFile::exists(shipped)) {
      QCOMPARE(goalsIn(folder.filePath(name)), goalsIn(shipped));
      ++compared;
    }
  }
  QVERIFY(compared > 0);
}

/// People of canonical.yaml with the values that belong into the placeholders.
void TreesProgramTest::make_hunav2_bodyIsTheFilledTemplate_data() {
  QTest::addColumn<int>("agent");
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("goals");
  QTest::addColumn<QString>("values");
  QTest::newRow("regular") << 1 << text("BTRegularNav.xml") << text("1 2 3") << QString();
  QTest::newRow("impassive") << 2 << text("BTRegularNav.xml") << text("3 1") << QString();
  QTest::newRow("surprised") << 3 << text("BTSurprisedNav.xml") << text("2 1")
                             << text("dist=4 duration=30 once=true");
  QTest::newRow("scared") << 4 << text("BTScaredNav.xml") << text("1 3")
                          << text("dist=4 duration=40 maxvel=1.5 safe_distance=5");
  QTest::newRow("curious") << 5 << text("BTCuriousNav.xml") << text("2")
                           << text("dist=10 duration=40 maxvel=1.5 stopdist=1.5");
  QTest::newRow("threatening") << 6 << text("BTThreateningNav.xml") << text("3")
                               << text("dist=4 duration=40 frontdist=1.4");
}

namespace {

/// Tags with their attributes in the order of the file, from the first tree on; comments and blanks
/// do not count.
QStringList tagsOf(const QString& tree) {
  QStringList tags;
  const QString body = text("<root>") + tree.mid(tree.indexOf(text("<BehaviorTree")));
  QXmlStreamReader xml(body);
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isStartElement()) {
      QString tag = xml.name().toString();
      for (const QXmlStreamAttribute& attribute : xml.attributes()) {
        tag += QLatin1Char(' ') + attribute.name() + QLatin1Char('=') + attribute.value();
      }
      tags << tag;
    } else if (xml.isEndElement()) {
      tags << QLatin1Char('/') + xml.name().toString();
    }
  }
  return xml.hasError() ? QStringList{xml.errorString()} : tags;
}

QString filledTemplate(QString tree, const QString& goals, const QString& values) {
  QString block = text("<Sequence name='SetGoals'>");
  const QStringList ids = goals.split(QLatin1Char(' '));
  for (int i = 0; i < ids.size(); ++i) {
    const QString goal =
        text("<RunOnce><SetGoal agent_id='{id}' goal_id='%1'/></RunOnce>").arg(ids[i]);
    const bool isLast = i + 1 == ids.size();
    block += isLast ? text("<Inverter>%1</Inverter>").arg(goal) : goal;
  }
  tree.replace(text("{GOAL_SEQUENCE}"), block + text("</Sequence>"));
  for (const QString& pair : values.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    const QStringList both = pair.split(QLatin1Char('='));
    tree.replace(QLatin1Char('{') + both[0] + QLatin1Char('}'), both[1]);
  }
  return tree;
}

}  // namespace

void TreesProgramTest::make_hunav2_bodyIsTheFilledTemplate() {
  QFETCH(int, agent);
  QFETCH(QString, file);
  QFETCH(QString, goals);
  QFETCH(QString, values);
  const QString path = ofTheOriginal(text("hunav_sim_v2/behavior_trees/") + file);
  if (!QFile::exists(path)) {
    QSKIP("the interoperability files are not here");
  }
  QTemporaryDir folder;
  QByteArray scenario = bytesOf(text(TEST_DATA_DIR "/scenario/canonical.yaml"));
  scenario.replace("simulator: Gazebo Classic", "simulator: Webots");  // the panel's own layout
  QFile copy(folder.filePath(text("canonical.yaml")));
  QVERIFY(copy.open(QIODevice::WriteOnly) && copy.write(scenario) == scenario.size());
  copy.close();
  QCOMPARE(failureOf(makeWords(copy.fileName(), folder.path(), "hunav2")), QString());
  const QString ours =
      QString::fromUtf8(bytesOf(folder.filePath(text("canonical__agent_%1_bt.xml").arg(agent))));
  const QString theirs = filledTemplate(QString::fromUtf8(bytesOf(path)), goals, values);
  const QStringList tags = tagsOf(ours);
  QVERIFY(tags.size() > 10);
  QCOMPARE(tags, tagsOf(theirs));
}

void TreesProgramTest::picture_ofAnAgent_isOneVectorFile_data() {
  QTest::addColumn<QString>("ending");
  QTest::addColumn<QByteArray>("begin");
  QTest::newRow("svg") << text("svg") << QByteArray("<?xml");
  QTest::newRow("pdf") << text("pdf") << QByteArray("%PDF-");
  QTest::newRow("png") << text("png") << QByteArray("\x89PNG");
}

void TreesProgramTest::picture_ofAnAgent_isOneVectorFile() {
  QFETCH(QString, ending);
  QFETCH(QByteArray, begin);
  QTemporaryDir folder;
  const QString scenario = text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
  const QString file = folder.filePath(text("tree.") + ending);
  const QString again = folder.filePath(text("again.") + ending);
  const Finished made = runProgram("trees % --agent Chloe --picture %", {scenario, file});
  QVERIFY2(made.exitCode == 0 && made.err.isEmpty(), qPrintable(made.err));
  QCOMPARE(made.out, file + QLatin1Char('\n'));
  const QByteArray bytes = bytesOf(file);
  QVERIFY2(bytes.startsWith(begin), bytes.left(8).constData());
  QCOMPARE(failureOf("trees % --agent Chloe --picture %", {scenario, again}), QString());
  QCOMPARE(bytesOf(again), bytes);
  if (ending == text("svg")) {
    QVERIFY(!bytes.contains("<image"));  // Vectors only.
    QVERIFY(bytes.contains("IsRobotVisible"));
    QVERIFY(bytes.contains("RegularNavTree") && bytes.contains("UpdateGoal"));  // Expanded.
    QVERIFY(bytes.contains("#ffffff"));                                         // Light.
  }
}

void TreesProgramTest::picture_ofATreeFile_hasItsIncludedTrees() {
  QTemporaryDir folder;
  const QString tree = folder.filePath(text("mine.xml"));
  writeText(folder.filePath(text("part.xml")),
            "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Part\">"
            "<AlwaysSuccess name=\"Deep inside\"/></BehaviorTree></root>");
  writeText(tree,
            "<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\">"
            "<include path=\"part.xml\"/><BehaviorTree ID=\"Main\"><Sequence name=\"Top\">"
            "<SubTree ID=\"Part\"/></Sequence></BehaviorTree></root>");
  const QString file = folder.filePath(text("p.svg"));
  QCOMPARE(failureOf("trees % --picture %", {tree, file}), QString());
  const QByteArray svg = bytesOf(file);
  QVERIFY(svg.contains("Top") && svg.contains("Part") && svg.contains("Deep inside"));
  writeText(file, "mine");
  QCOMPARE(unexpected(runProgram("trees % --picture %", {tree, file}), 2, text("p.svg: error: ")),
           QString());
  QCOMPARE(failureOf("trees % --picture % --force", {tree, file}), QString());
  QCOMPARE(bytesOf(file), svg);
}

void TreesProgramTest::picture_impossible_isAnError_data() {
  QTest::addColumn<QString>("words");
  QTest::addColumn<int>("code");
  QTest::addColumn<QString>("message");
  QTest::newRow("of whom") << text("%1 --picture p.svg") << 64 << text("choose one with --agent (");
  QTest::newRow("unknown agent") << text("%1 --agent Cloe --picture p.svg") << 64
                                 << text("there is no agent 'Cloe' (did you mean 'Chloe'?)");
  QTest::newRow("format") << text("%1 --agent Chloe --picture p.gif") << 64
                          << text("cannot draw a tree as '.gif'");
  QTest::newRow("no agents") << text("nobody.yaml --picture p.svg") << 2
                             << text("the scenario has no agents");
  QTest::newRow("no node") << text("empty.xml --picture p.svg") << 2 << text("error: ");
  QTest::newRow("tree file alone")
      << text("empty.xml") << 64 << text("a tree file can be drawn (--picture FILE)");
}

void TreesProgramTest::picture_impossible_isAnError() {
  QFETCH(QString, words);
  QFETCH(int, code);
  QFETCH(QString, message);
  QTemporaryDir folder;
  writeText(folder.filePath(text("nobody.yaml")),
            "hunav_loader:\n  ros__parameters:\n    map: none\n    agents: []\n");
  writeText(folder.filePath(text("empty.xml")), "<root BTCPP_format=\"4\"/>");
  const QString scenario = text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
  const QString line = words.contains(text("%1")) ? words.arg(scenario) : words;
  const Finished found =
      runProgram(QStringList(text("trees")) + line.split(QLatin1Char(' ')), folder.path());
  QCOMPARE(unexpected(found, code, message), QString());
  QVERIFY(!QFile::exists(folder.filePath(text("p.svg"))));
}

QTEST_GUILESS_MAIN(TreesProgramTest)
#include "tst_TreesProgram.moc"
