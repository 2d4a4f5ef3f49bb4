#include <set>

#include <QJsonArray>
#include <QProcess>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

#include "bt/human/TreeLoader.h"
#include "bt/robot/RobotNodes.h"
#include "bt/tree/TreeXml.h"
#include "tests/app/RunFiles.h"

using namespace outside;

/// `hunavsim list` from outside: nodes as a model file for Groot2, metrics as METRICS.md.
class ListProgramTest : public QObject {
  Q_OBJECT

 private:
  Finished found_;

 private Q_SLOTS:
  void initTestCase() {
    found_ = runProgram("list nodes --format xml");
    QVERIFY2(found_.exitCode == 0, qPrintable(found_.err));
  }

  void shortOptions_areTheLongOnes() {
    for (const auto& [brief, full] : {std::pair("-h", "--help"), std::pair("-V", "--version")}) {
      const Finished one = runProgram({QString::fromUtf8(brief)});
      QCOMPARE(one.exitCode, 0);
      QVERIFY(!one.out.isEmpty());
      QCOMPARE(one.out, runProgram({QString::fromUtf8(full)}).out);
    }
    const Finished quiet =
        runProgram("check -q %", {text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml")});
    QCOMPARE(quiet.exitCode, 0);
    QVERIFY(quiet.out.isEmpty());
  }

  void fullStandardOutput_isAnError() {
    const QString scenario = text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
    const QStringList lines = {text("--help"),
                               text("list nodes --json"),
                               text("list metrics"),
                               text("check ") + scenario,
                               text("run --duration 0.1 ") + scenario,
                               text("trees ") + scenario};
    for (const QString& line : lines) {
      QProcess program;
      program.setStandardOutputFile(text("/dev/full"));
      program.start(text(HUNAVSIM_PROGRAM), line.split(QLatin1Char(' ')));
      QVERIFY(program.waitForFinished(60000));
      QVERIFY2(program.exitCode() == 2, qPrintable(line));
      QVERIFY2(program.readAllStandardError().contains("standard output"), qPrintable(line));
    }
  }

  void mistypedScenario_namesTheNearest() {
    for (const QStringList& words : {list("run"), list("check"), QStringList()}) {
      QCOMPARE(unexpected(runProgram(words + list("corner_cafe_agent")), 2,
                          "(did you mean 'corner_cafe_agents'?)"),
               QString());
    }
    QCOMPARE(failureOf("check corner_cafe_agents"), QString());
    QCOMPARE(unexpected(runProgram("chekc"), 2, "(did you mean 'check'?)"), QString());
  }

  void everyList_namesWhatThereIs_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<QStringList>("known");
    const auto row = [](const char* what, const QStringList& known) {
      QTest::newRow(what) << QString::fromUtf8(what) << known;
    };
    row("nodes", {text("Sequence"), text("IsRobotVisible")});
    row("metrics", {text("path_length"), text("spl")});
    row("keys", {text("ROBOT.planner"), text("seed")});
    row("models", {text("sfm"), text("das"), text("orca")});
    row("robots", {text("generic"), text("tiago"), text("pepper")});
    row("planners",
        {text("pursuit"), text("dwa"), text("social_mppi"), text("external"), text("library"),
         text("onnx"), text("replay"), text("teleop"), text("ros2"), text("nav2")});
    row("scenarios", {text("corner_cafe_agents"), text("two_workers_agents")});
  }
  void everyList_namesWhatThereIs() {
    QFETCH(QString, what);
    QFETCH(QStringList, known);
    const Finished plain = runProgram("list %", {what});
    QVERIFY2(plain.exitCode == 0, qPrintable(plain.err));
    QStringList first;
    for (const QString& line : plain.out.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
      first << line.section(QLatin1Char(' '), 0, 0);
    }
    QStringList named;
    const Finished json = runProgram("list % --format json", {what});
    for (const auto& each : QJsonDocument::fromJson(json.out.toUtf8()).array()) {
      named << each.toObject()[text("name")].toString();
    }
    QCOMPARE(first, named);
    for (const QString& name : known) {
      QVERIFY2(named.contains(name), qPrintable(named.join(QLatin1Char(' '))));
    }
  }

  void scenarios_haveCardAndCertificate() {
    const Finished json = runProgram("list scenarios --format json");
    int withCard = 0;
    for (const auto& each : QJsonDocument::fromJson(json.out.toUtf8()).array()) {
      const QJsonObject scenario = each.toObject();
      QVERIFY(scenario.contains(text("certificate")));
      const QJsonObject card = scenario[text("card")].toObject();
      withCard += card.contains(text("purpose")) ? 1 : 0;
      if (scenario[text("name")] == text("doorway_agents")) {
        QCOMPARE(card[text("title")].toString(), text("Doorway"));
        QCOMPARE(card[text("difficulty")].toString(), text("hard"));
        QVERIFY(card[text("metrics")].toArray().contains(text("success")));
      }
    }
    QVERIFY2(withCard >= 120, qPrintable(QString::number(withCard)));
    const Finished page = runProgram("list scenarios --format md");
    QVERIFY(page.out.contains(text("### francis_blind_corner_hard\n")));
    QVERIFY(page.out.contains(text("| `doorway_agents` | Doorway | hard |")));
  }

  void parameters_textAndNumber_tellTheirType() {
    const Finished json = runProgram("list planners --format json");
    QStringList types;
    for (const auto& planner : QJsonDocument::fromJson(json.out.toUtf8()).array()) {
      const QJsonObject found = planner.toObject();
      if (found[text("name")] == text("replay")) {
        for (const auto& each : found[text("parameters")].toArray()) {
          types << each.toObject()[text("name")].toString() + QLatin1Char(' ') +
                       each.toObject()[text("type")].toString();
        }
      }
    }
    QCOMPARE(types, QStringList({text("file text"), text("robot number")}));
  }

  void parameters_ofAPlanner_areTold() {
    const Finished json = runProgram("list planners --format json");
    for (const auto& planner : QJsonDocument::fromJson(json.out.toUtf8()).array()) {
      const QJsonObject found = planner.toObject();
      for (const auto& each : found[text("parameters")].toArray()) {
        const QJsonObject parameter = each.toObject();
        if (found[text("name")] == text("pursuit") &&
            parameter[text("name")] == text("lookahead")) {
          QCOMPARE(parameter[text("unit")].toString(), text("m"));
          QCOMPARE(parameter[text("default")].toDouble(), 0.6);
          return;
        }
      }
    }
    QFAIL(qPrintable(json.out));
  }

  /// By a reader of the tests' own: well-formed, every node once, with the tag of its kind.
  void xml_nodes_areAllThatAreNotBuiltIn() {
    QXmlStreamReader xml(found_.out);
    std::set<std::string> seen;
    int depth = 0;
    while (!xml.atEnd()) {
      const QXmlStreamReader::TokenType token = xml.readNext();
      depth += token == QXmlStreamReader::StartElement ? 1 : 0;
      if (token == QXmlStreamReader::StartElement && depth == 1) {
        QCOMPARE(xml.name().toString(), text("root"));
        QCOMPARE(xml.attributes().value(text("BTCPP_format")).toString(), text("4"));
      }
      if (token == QXmlStreamReader::StartElement && depth == 3) {
        const std::string entry = xml.name().toString().toStdString() + " " +
                                  xml.attributes().value(text("ID")).toString().toStdString();
        QVERIFY2(seen.insert(entry).second, entry.c_str());
      }
      depth -= token == QXmlStreamReader::EndElement ? 1 : 0;
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    std::set<std::string> expected;
    const bt::NodeLibrary people = bt::humanNodes(), robots = bt::robotNodes();
    for (const bt::NodeLibrary* library : {&people, &robots}) {
      for (const bt::NodeManifest& node : library->catalogue().all()) {
        const bool isKnown = library == &robots && people.catalogue().find(node.id) != nullptr;
        if (node.origin != bt::NodeOrigin::BehaviorTreeCpp && !isKnown) {
          expected.insert(std::string(bt::nodeKindName(node.kind)) + " " + node.id);
        }
      }
    }
    QVERIFY(seen == expected);
    for (const char* id :
         {"Action FollowPath", "Action ComputePathToPose", "Action Spin", "Control RecoveryNode",
          "Decorator RateController", "Condition GoalReached"}) {  // Nav2's own
      QVERIFY2(seen.count(id) == 1, id);
    }
    for (const char* id :
         {"Condition TimeExpiredCondition", "Action AvoidRobot", "Decorator TimeDelay",
          "Control ProbabilityChoice", "Action GoTo", "Condition IsSpeaking"}) {
      QVERIFY2(seen.count(id) == 1, id);
    }
  }

  void xml_isAModelFileForTheReader() {
    const base::Result<bt::TreeFile> file = bt::readTreeText(found_.out.toStdString(), "model.xml");
    QVERIFY(file && file->model);
    QVERIFY(file->trees.empty() && file.diagnostics().empty());
    QVERIFY(file->model->children.size() > 45);
    QTemporaryDir folder;
    const QString path = folder.filePath(text("model.xml"));
    QFile out(path);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(found_.out.toUtf8());
    out.close();
    QVERIFY(bt::readTree(path.toStdString()));
  }

  void xml_ofOtherThings_isAWrongWord() {
    const Finished wrong = runProgram("list robots --format xml");
    QCOMPARE(wrong.exitCode, 64);
    QVERIFY(wrong.out.isEmpty());
  }

  void markdown_metrics_isWhatIsCommitted() {
    const Finished written = runProgram("list metrics --format markdown");
    QCOMPARE(written.exitCode, 0);
    const QByteArray committed = bytesOf(text(SOURCE_DIR "/metrics/METRICS.md"));
    QVERIFY(!committed.isEmpty() && written.out.toUtf8() == committed);
    // The same metrics in both, with all their columns.
    const Finished listed = runProgram("list metrics --format json");
    const QJsonArray metrics = QJsonDocument::fromJson(listed.out.toUtf8()).array();
    QVERIFY(metrics.size() > 64);
    QCOMPARE(committed.count("\n|  | `") + 34, metrics.size());
    for (const QJsonValue& value : metrics) {
      const QJsonObject metric = value.toObject();
      const QByteArray name = metric[text("name")].toString().toUtf8();
      QVERIFY2(committed.contains(" | `" + name + "` | "), name.constData());
      for (const char* column : {"range", "better", "formula", "source"}) {
        QVERIFY2(!metric[QString::fromUtf8(column)].toString().isEmpty(), name.constData());
      }
      QVERIFY2(metric.contains(text("unit")), name.constData());
    }
  }

  void json_metrics_haveTheirParameters() {
    const Finished listed = runProgram("list metrics --format json");
    const QByteArray committed = bytesOf(text(SOURCE_DIR "/metrics/METRICS.md"));
    QJsonObject lanes;
    std::set<QString> names;
    for (const auto& metric : QJsonDocument::fromJson(listed.out.toUtf8()).array()) {
      for (const auto& value : metric.toObject()[text("parameters")].toArray()) {
        const QJsonObject parameter = value.toObject();
        names.insert(parameter[text("name")].toString());
        lanes = parameter[text("name")] == text("lane_width") ? parameter : lanes;
      }
    }
    QCOMPARE(lanes[text("default")].toDouble(), 0.75);
    QCOMPARE(lanes[text("unit")].toString(), text("m"));
    QCOMPARE(lanes[text("minimum")].toDouble(-1.0), 0.0);
    QCOMPARE(lanes[text("maximum")].toDouble(), 1e6);
    QVERIFY(!lanes[text("description")].toString().isEmpty());
    // All of the table of parameters.
    const QByteArray table = committed.mid(committed.indexOf("## Parameters"));
    QCOMPARE(static_cast<int>(names.size()), table.count("\n| `"));
  }

  void markdown_keys_isWhatIsCommitted() {
    const Finished written = runProgram("list keys --format markdown");
    QCOMPARE(written.exitCode, 0);
    const QByteArray committed = bytesOf(text(SOURCE_DIR "/sim2d/scenario/FORMAT.md"));
    QVERIFY(committed.contains("markdown -->\n" + written.out.toUtf8() + "<!-- end -->"));
    const Finished listed = runProgram("list keys --format json");
    const QJsonArray keys = QJsonDocument::fromJson(listed.out.toUtf8()).array();
    QCOMPARE(written.out.count(text("\n| `")), keys.size());
  }

  void markdown_parameters_isWhatIsCommitted_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("row");  // by hand: one whole row, with all of its columns
    QTest::newRow("planners") << text("sim2d/nav/PLANNERS.md")
                              << QByteArray(
                                     "| `window` | s | 0.25 | 0.01 to 2 | Time within which a "
                                     "sampled velocity must be reachable. | Fox, Burgard & Thrun "
                                     "1997, 0.25 |\n");
    QTest::newRow("models") << text("sim2d/world/MODELS.md") << QByteArray("\n## das\n");
  }
  void markdown_parameters_isWhatIsCommitted() {
    QFETCH(QString, file);
    QFETCH(QByteArray, row);
    const QString what = QString::fromUtf8(QTest::currentDataTag());
    const Finished written = runProgram("list % --format markdown", {what});
    QCOMPARE(written.exitCode, 0);
    const QByteArray committed = bytesOf(text(SOURCE_DIR) + QLatin1Char('/') + file);
    QVERIFY(!committed.isEmpty() && written.out.toUtf8() == committed);
    QVERIFY(committed.contains(row));
    // The same names in both.
    const Finished listed = runProgram("list % --format json", {what});
    int parameters = 0;
    for (const auto& value : QJsonDocument::fromJson(listed.out.toUtf8()).array()) {
      const QJsonObject thing = value.toObject();
      const QByteArray name = thing[text("name")].toString().toUtf8();
      QVERIFY2(committed.contains("\n## " + name + "\n"), name.constData());
      parameters += thing[text("parameters")].toArray().size();
    }
    QCOMPARE(committed.count("\n| `"), parameters);
  }

  void markdown_ofOtherThings_isAWrongWord() {
    const Finished wrong = runProgram("list scenarios --format man");
    QCOMPARE(wrong.exitCode, 64);
  }
};

QTEST_GUILESS_MAIN(ListProgramTest)
#include "tst_ListProgram.moc"
