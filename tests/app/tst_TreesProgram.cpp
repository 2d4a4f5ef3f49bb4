#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"
#include "tests/support/TreeAttributes.h"

using outside::Finished;

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
};

namespace {

QString utf8(const char* text) {
  return QString::fromUtf8(text);
}

QString ofTheOriginal(const QString& file) {
  return outside::interop(QStringLiteral("hunavsim2/") + file);
}

/// Goal ids of the SetGoal nodes of a tree file, in order.
QStringList goalsIn(const QString& path) {
  return attributesIn(outside::bytesOf(path), "goal_id", [](const QXmlStreamReader& xml) {
    return xml.name() == QLatin1String("SetGoal") ||
           xml.attributes().value(QStringLiteral("ID")) == QLatin1String("SetGoal");
  });
}

QStringList makeWords(const QString& scenario, const QString& folder, const char* style) {
  return {QStringLiteral("trees"),   scenario,   QStringLiteral("-o"), folder,
          QStringLiteral("--style"), utf8(style)};
}

}  // namespace

void TreesProgramTest::words_wrong_exitWith64_data() {
  QTest::addColumn<QString>("words");
  QTest::newRow("nothing") << utf8("trees");
  QTest::newRow("both") << utf8("trees a.yaml --play b.xml");
  QTest::newRow("style of nothing") << utf8("trees a.yaml --style mine");
  QTest::newRow("folder for a play") << utf8("trees --play b.xml -o out");
  QTest::newRow("script without play") << utf8("trees a.yaml --script s.yaml");
  QTest::newRow("no ticks") << utf8("trees --play b.xml --ticks 0");
  QTest::newRow("half ticks") << utf8("trees --play b.xml --ticks 1.5");
  QTest::newRow("no step") << utf8("trees --play b.xml --dt 0");
  QTest::newRow("nan step") << utf8("trees --play b.xml --dt nan");
  QTest::newRow("seed below 0") << utf8("trees --play b.xml --seed -1");
  QTest::newRow("quirk") << utf8("trees --play b.xml --compat Q-99");
}

void TreesProgramTest::words_wrong_exitWith64() {
  QFETCH(QString, words);
  const Finished found = outside::runProgram(words.split(QLatin1Char(' ')));
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
  const QString scenario = utf8(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
  const QString out = folder.filePath(QStringLiteral("a/b"));
  const Finished made = outside::runProgram(makeWords(scenario, out, style.constData()));
  QVERIFY2(made.exitCode == 0, qPrintable(made.err));
  QStringList files;
  for (const QFileInfo& info : QDir(out).entryInfoList(QDir::Files)) {
    QVERIFY2(made.out.contains(utf8("written   ") + info.filePath() + QLatin1Char('\n')),
             qPrintable(made.out));
    files << info.filePath();
  }
  QVERIFY(files.size() >= 3);
  QVERIFY(QFile::exists(out + utf8("/BTRegularNav.xml")));
  QVERIFY(QFile::exists(out + utf8("/corner_cafe_agents__agent_1_bt.xml")));
  const Finished alone = outside::runProgram(QStringList{QStringLiteral("check")} + files);
  QVERIFY2(alone.exitCode == 0 && alone.err.isEmpty(), qPrintable(alone.err));
  const Finished together =
      outside::runProgram({QStringLiteral("check"), scenario, QStringLiteral("--trees"), out});
  QVERIFY2(together.exitCode == 0, qPrintable(together.err));
}

void TreesProgramTest::make_again_saysWhatBecameOfEachFile() {
  QTemporaryDir folder;
  const QString scenario = utf8(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
  QStringList words = makeWords(scenario, folder.path(), "corrected");
  QCOMPARE(outside::runProgram(words).exitCode, 0);
  const QString edited = folder.filePath(QStringLiteral("corner_cafe_agents__agent_1_bt.xml"));
  const QByteArray original = outside::bytesOf(edited);
  QVERIFY(!original.isEmpty());
  outside::writeText(edited, "<root/>");
  outside::writeText(folder.filePath(QStringLiteral("mine.xml")), "mine");
  const Finished refused = outside::runProgram(words);
  QCOMPARE(refused.exitCode, 2);
  QVERIFY2(refused.err.contains(edited + utf8(": error: ")), qPrintable(refused.err));
  QCOMPARE(outside::bytesOf(edited), QByteArray("<root/>"));
  const Finished text = outside::runProgram(words + QStringList{QStringLiteral("--force")});
  QVERIFY(text.out.contains(utf8("replaced  ") + edited));
  QCOMPARE(text.out.count(utf8("replaced")), 1);
  QVERIFY(text.out.contains(utf8("unchanged ")) && !text.out.contains(utf8("written")));
  QCOMPARE(outside::bytesOf(edited), original);
  QCOMPARE(outside::bytesOf(folder.filePath(QStringLiteral("mine.xml"))), QByteArray("mine"));
  words << QStringLiteral("--json");
  const Finished json = outside::runProgram(words);
  for (const auto& file : QJsonDocument::fromJson(json.out.toUtf8()).array()) {
    QCOMPARE(file.toObject()[QStringLiteral("state")].toString(), utf8("unchanged"));
  }
}

void TreesProgramTest::make_withoutFolder_printsAll() {
  QTemporaryDir folder;
  const QString scenario = utf8(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
  QCOMPARE(outside::runProgram(makeWords(scenario, folder.path(), "corrected")).exitCode, 0);
  const Finished text = outside::runProgram({QStringLiteral("trees"), scenario});
  const Finished json =
      outside::runProgram({QStringLiteral("trees"), scenario, QStringLiteral("--json")});
  const QJsonArray all = QJsonDocument::fromJson(json.out.toUtf8()).array();
  QCOMPARE(all.size(), QDir(folder.path()).entryList(QDir::Files).size());
  for (const QJsonValue& value : all) {
    const QString name = value.toObject()[QStringLiteral("file")].toString();
    const QString content = QString::fromUtf8(outside::bytesOf(folder.filePath(name)));
    QCOMPARE(value.toObject()[QStringLiteral("text")].toString(), content);
    QVERIFY(text.out.contains(utf8("==> ") + name + utf8(" <==\n") + content));
  }
}

void TreesProgramTest::make_intoAFile_isAnError() {
  QTemporaryDir folder;
  const QString inTheWay = folder.filePath(QStringLiteral("file"));
  outside::writeText(inTheWay, "x");
  const Finished found = outside::runProgram(makeWords(
      utf8(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml"), inTheWay, "corrected"));
  QCOMPARE(found.exitCode, 2);
  QVERIFY2(found.err.contains(utf8("error: ")), qPrintable(found.err));
  QCOMPARE(outside::bytesOf(inTheWay), QByteArray("x"));
}

void TreesProgramTest::make_baseNameWithFolder_isAnError() {
  QTemporaryDir folder;
  QByteArray text = outside::bytesOf(utf8(TEST_DATA_DIR "/scenario/canonical.yaml"));
  const int at = text.indexOf("yaml_base_name:");
  QVERIFY(at > 0);
  text.replace(at, text.indexOf('\n', at) - at, "yaml_base_name: ../outside");
  const QString scenario = folder.filePath(QStringLiteral("s.yaml"));
  outside::writeText(scenario, text);
  const QString out = folder.filePath(QStringLiteral("out"));
  const Finished found = outside::runProgram(makeWords(scenario, out, "corrected"));
  QCOMPARE(found.exitCode, 2);
  QVERIFY(!QFile::exists(out));
  QVERIFY(QDir(folder.path()).entryList({QStringLiteral("outside*")}).isEmpty());
}

void TreesProgramTest::make_mistypedName_getsTheNearest() {
  const Finished found =
      outside::runProgram({QStringLiteral("trees"), QStringLiteral("two_workers_agent")});
  QCOMPARE(found.exitCode, 2);
  QVERIFY(found.out.isEmpty());
  QVERIFY2(found.err.contains(utf8("two_workers_agents")), qPrintable(found.err));
  // a path is a path
  const Finished path =
      outside::runProgram({QStringLiteral("trees"), QStringLiteral("./two_workers_agent")});
  QCOMPARE(path.exitCode, 2);
  QVERIFY2(!path.err.contains(utf8("two_workers_agents")), qPrintable(path.err));
}

void TreesProgramTest::make_hunav2_hasTheGoalsOfTheShippedTrees_data() {
  QTest::addColumn<QString>("place");
  QTest::addColumn<QString>("base");
  QTest::newRow("isaac") << utf8("isaac") << utf8("warehouse_agents");
  for (const char* name : {"agents_cafe", "agents_house", "agents_warehouse"}) {
    QTest::newRow(name) << utf8("gazebo_classic") << utf8(name);
  }
  QTest::newRow("fortress") << utf8("gazebo_fortress") << utf8("cafe_agents");
}

void TreesProgramTest::make_hunav2_hasTheGoalsOfTheShippedTrees() {
  QFETCH(QString, place);
  QFETCH(QString, base);
  const QString root = ofTheOriginal(place);
  if (!QFile::exists(root)) {
    QSKIP("the interoperability files are not here");
  }
  QTemporaryDir folder;
  const Finished made = outside::runProgram(
      makeWords(root + utf8("/scenarios/") + base + utf8(".yaml"), folder.path(), "hunav2"));
  QVERIFY2(made.exitCode == 0, qPrintable(made.err));
  int compared = 0;
  for (const QString& name : QDir(folder.path()).entryList({base + utf8("__agent_*_bt.xml")})) {
    const QString shipped = root + utf8("/behavior_trees/") + name;
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
  QTest::newRow("regular") << 1 << utf8("BTRegularNav.xml") << utf8("1 2 3") << QString();
  QTest::newRow("impassive") << 2 << utf8("BTRegularNav.xml") << utf8("3 1") << QString();
  QTest::newRow("surprised") << 3 << utf8("BTSurprisedNav.xml") << utf8("2 1")
                             << utf8("dist=4 duration=30 once=true");
  QTest::newRow("scared") << 4 << utf8("BTScaredNav.xml") << utf8("1 3")
                          << utf8("dist=4 duration=40 maxvel=1.5 safe_distance=5");
  QTest::newRow("curious") << 5 << utf8("BTCuriousNav.xml") << utf8("2")
                           << utf8("dist=10 duration=40 maxvel=1.5 stopdist=1.5");
  QTest::newRow("threatening") << 6 << utf8("BTThreateningNav.xml") << utf8("3")
                               << utf8("dist=4 duration=40 frontdist=1.4");
}

namespace {

/// Tags with their attributes in the order of the file, from the first tree on; comments and blanks
/// do not count.
QStringList tagsOf(const QString& text) {
  QStringList tags;
  const QString body = QStringLiteral("<root>") + text.mid(text.indexOf(utf8("<BehaviorTree")));
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

QString filledTemplate(QString text, const QString& goals, const QString& values) {
  QString block = QStringLiteral("<Sequence name='SetGoals'>");
  const QStringList ids = goals.split(QLatin1Char(' '));
  for (int i = 0; i < ids.size(); ++i) {
    const QString goal =
        QStringLiteral("<RunOnce><SetGoal agent_id='{id}' goal_id='%1'/></RunOnce>").arg(ids[i]);
    const bool isLast = i + 1 == ids.size();
    block += isLast ? QStringLiteral("<Inverter>%1</Inverter>").arg(goal) : goal;
  }
  text.replace(utf8("{GOAL_SEQUENCE}"), block + QStringLiteral("</Sequence>"));
  for (const QString& pair : values.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    const QStringList both = pair.split(QLatin1Char('='));
    text.replace(QLatin1Char('{') + both[0] + QLatin1Char('}'), both[1]);
  }
  return text;
}

}  // namespace

void TreesProgramTest::make_hunav2_bodyIsTheFilledTemplate() {
  QFETCH(int, agent);
  QFETCH(QString, file);
  QFETCH(QString, goals);
  QFETCH(QString, values);
  const QString path = ofTheOriginal(utf8("hunav_sim_v2/behavior_trees/") + file);
  if (!QFile::exists(path)) {
    QSKIP("the interoperability files are not here");
  }
  QTemporaryDir folder;
  QByteArray scenario = outside::bytesOf(utf8(TEST_DATA_DIR "/scenario/canonical.yaml"));
  scenario.replace("simulator: Gazebo Classic", "simulator: Webots");  // the panel's own layout
  QFile copy(folder.filePath(utf8("canonical.yaml")));
  QVERIFY(copy.open(QIODevice::WriteOnly) && copy.write(scenario) == scenario.size());
  copy.close();
  const Finished made = outside::runProgram(makeWords(copy.fileName(), folder.path(), "hunav2"));
  QVERIFY2(made.exitCode == 0, qPrintable(made.err));
  const QString ours = QString::fromUtf8(
      outside::bytesOf(folder.filePath(utf8("canonical__agent_%1_bt.xml").arg(agent))));
  const QString theirs = filledTemplate(QString::fromUtf8(outside::bytesOf(path)), goals, values);
  const QStringList tags = tagsOf(ours);
  QVERIFY(tags.size() > 10);
  QCOMPARE(tags, tagsOf(theirs));
}

QTEST_GUILESS_MAIN(TreesProgramTest)
#include "tst_TreesProgram.moc"
