#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/external/CommandLine.h"
#include "sim2d/nav/external/ExternalPlanner.h"
#include "tests/nav/ExternalScene.h"

using namespace external;

namespace {

QByteArray bytes(const std::string& text) {
  return QByteArray::fromStdString(text);
}

QByteArray codesOf(const base::Diagnostics& problems) {
  QByteArray codes;
  for (const base::Diagnostic& problem : problems) {
    codes += (codes.isEmpty() ? "" : " ") + bytes(std::string(problem.code));
  }
  return codes;
}

}  // namespace

class PlannerProtocolTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void greeting_disc_isWrittenAsDocumented() {
    Scene scene;
    scene.observation.dt = 0.1;
    QCOMPARE(bytes(greetingLine(setupOf(), scene.observation)),
             QByteArray("{\"hunavsim\":1,\"robot\":{\"name\":\"amy\",\"id\":3,"
                        "\"kinematics\":\"differential\",\"radius\":0.25,"
                        "\"footprint\":{\"radius\":0.25},\"mass\":50.0,"
                        "\"limits\":{\"max_vel\":0.8,\"max_reverse\":1.0,\"max_acc\":1.0,"
                        "\"max_omega\":1.5,\"max_alpha\":3.0,\"turning_radius\":0.0}},"
                        "\"dt\":0.1,\"seed\":18446744073709551615,"
                        "\"walls\":[[[2.0,3.0],[3.0,3.0],[3.0,4.0],[2.0,4.0]],"
                        "[[-1.0,3.0],[0.0,3.0],[0.0,3.1],[-1.0,3.1]]]}"));
  }

  void greeting_polygon_hasItsCorners() {
    Scene scene;
    PlannerSetup setup = setupOf();
    setup.body.kinematics = Kinematics::Ackermann;
    setup.body.footprint.corners = {{0.4, 0.3}, {-0.1, 0.3}, {-0.1, -0.3}, {0.4, -0.3}};
    const QByteArray line = bytes(greetingLine(setup, scene.observation));
    QVERIFY2(line.contains("\"kinematics\":\"ackermann\",\"radius\":0.5,\"footprint\":"
                           "{\"corners\":[[0.4,0.3],[-0.1,0.3],[-0.1,-0.3],[0.4,-0.3]]}"),
             line);
  }

  void observation_everything_isWrittenAsDocumented() {
    Scene scene;
    LaserScan scan;
    scan.sensor = {{0.1, 0.0}, 0.5};
    scan.time = 1.2;
    scan.angleMin = -1.5;
    scan.angleIncrement = 0.25;
    scan.range = 10.0;
    scan.distances = {10.0, 2.5};
    Observation& seen = scene.observation;
    seen.time = 1.25;
    seen.pose = {{0.5, -0.25}, 1e-7};
    seen.motion = {0.5, -0.125, 0.0};
    seen.bodies[0].heading = -1.5;
    seen.bodies.push_back({-2, BodyKind::Robot, Vec2(1e22, 0.1), Vec2::Zero(), 0.0, 0.5});
    seen.scan = &scan;
    const QByteArray plain(
        "{\"time\":1.25,\"dt\":0.05,\"pose\":{\"x\":0.5,\"y\":-0.25,\"heading\":1e-07},"
        "\"motion\":{\"linear\":0.5,\"angular\":-0.125,\"lateral\":0.0},\"goal\":[4.0,1.0],"
        "\"goal_radius\":0.2,\"bodies\":["
        "{\"id\":7,\"kind\":\"person\",\"position\":[1.5,1.0],\"velocity\":[0.0,-0.5],"
        "\"heading\":-1.5,\"radius\":0.3},"
        "{\"id\":-2,\"kind\":\"robot\",\"position\":[1e+22,0.1],\"velocity\":[0.0,0.0],"
        "\"heading\":0.0,\"radius\":0.5}]");
    QCOMPARE(bytes(observationLine(seen, {})), plain + "}");
    scene.setDoor(false);
    QCOMPARE(bytes(observationLine(seen, {true, true})),
             plain +
                 ",\"scan\":{\"time\":1.2,\"sensor\":{\"x\":0.1,\"y\":0.0,\"heading\":0.5},"
                 "\"angle_min\":-1.5,\"per_beam\":0.25,\"range\":10.0,\"distances\":[10.0,2.5]},"
                 "\"walls\":[[[2.0,3.0],[3.0,3.0],[3.0,4.0],[2.0,4.0]]]}");
  }

  /// Read by another parser.
  void observation_numbers_readBackEqual() {
    Scene scene;
    const double odd[] = {0.1 + 0.2, 1.0 / 3.0, std::nextafter(1.0, 2.0), 5e-324, 1.7e308, -0.0};
    for (const double number : odd) {
      scene.observation.pose.position.x() = number;
      const QJsonObject line =
          QJsonDocument::fromJson(bytes(observationLine(scene.observation, {}))).object();
      const double back = line[QLatin1String("pose")].toObject()[QLatin1String("x")].toDouble(7.0);
      QVERIFY(back == number);
    }
  }

  void names_oddBytes_stayOneLineOfJson() {
    Scene scene;
    const std::string line = greetingLine(setupOf("a\n\"\\\xFF"), scene.observation);
    QVERIFY(line.find('\n') == std::string::npos);
    const QJsonObject robot =
        QJsonDocument::fromJson(bytes(line)).object()[QLatin1String("robot")].toObject();
    QCOMPARE(robot[QLatin1String("name")].toString(), QString::fromUtf8("a\n\"\\\xEF\xBF\xBD"));
  }

  void end_reason_isWritten() {
    QCOMPARE(bytes(endLine("over")), QByteArray("{\"end\":true,\"reason\":\"over\"}"));
  }

  void standingOutlines_doors_areLeftOutWhenOpen() {
    Scene scene;
    QCOMPARE(enabledOutlines(*scene.observation.obstacles).size(), std::size_t{2});
    scene.setDoor(false);
    const auto standing = enabledOutlines(*scene.observation.obstacles);
    QCOMPARE(standing.size(), std::size_t{1});
    QVERIFY(standing[0]->points[0] == Vec2(2.0, 3.0));
  }

  void ready_answers_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("code");
    const auto row = [](const char* line, const char* name, const char* code) {
      QTest::newRow(line) << QByteArray(line) << QByteArray(name) << QByteArray(code);
    };
    row(R"({"ready":true,"name":"follow"})", "follow", "");
    row(R"(  {"later":[1],"ready":true}  )", "", "");
    row(R"({"ready":true,"name":7})", "", "");
    row(R"({"ready":false})", "", "external.not-ready");
    row(R"({"ready":1})", "", "external.not-ready");
    row(R"({"ready":"true"})", "", "external.not-ready");
    row(R"({})", "", "external.not-ready");
    row(R"({"ready":true,"error":"no GPU"})", "", "external.complaint");
    row(R"(ready)", "", "external.not-json");
    row(R"([true])", "", "external.not-json");
  }

  void ready_answers() {
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, code);
    const auto found = readReady(line.toStdString());
    QCOMPARE(codesOf(found.diagnostics()), code);
    QCOMPARE(static_cast<bool>(found), code.isEmpty());
    QVERIFY(!found || bytes(*found) == name);
  }

  void answer_good_isTaken_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QVector<double>>("twist");
    QTest::addColumn<int>("points");
    const auto row = [](const char* line, const QVector<double>& twist, int points = 0) {
      QTest::newRow(line) << QByteArray(line) << twist << points;
    };
    row(R"({"linear":0.5,"angular":-1})", {0.5, -1.0, 0.0});
    row(R"({"angular":1e-3,"linear":-0.0,"lateral":2})", {0.0, 0.001, 2.0});
    row(R"({"linear":0.30000000000000004,"angular":0})", {0.1 + 0.2, 0.0, 0.0});
    row(R"({"linear":1,"angular":0,"path":[]})", {1.0, 0.0, 0.0});
    row(R"({"linear":1,"angular":0,"path":[[0,0.5],[1,-2]],"cost":null})", {1.0, 0.0, 0.0}, 2);
  }

  void answer_good_isTaken() {
    QFETCH(QByteArray, line);
    QFETCH(QVector<double>, twist);
    QFETCH(int, points);
    const auto answer = readAnswer(line.toStdString());
    QVERIFY(answer);
    QVERIFY((answer->twist == BodyTwist{twist[0], twist[1], twist[2]}));
    QCOMPARE(static_cast<int>(answer->path.size()), points);
    QVERIFY(points == 0 || (answer->path == std::vector<Vec2>{{0.0, 0.5}, {1.0, -2.0}}));
  }

  void answer_bad_isToldWithWhatWasFound_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("code");
    QTest::addColumn<QByteArray>("part");  // of the message
    const auto row = [](const QByteArray& line, const char* code, const QByteArray& part) {
      QTest::newRow(line.left(60)) << line << QByteArray(code) << part;
    };
    row("", "external.not-json", "''");
    row("hello", "external.not-json", "'hello'");
    row("0.5 0.1", "external.not-json", "'0.5 0.1'");
    row("[0.5,0.1]", "external.not-json", "'[0.5,0.1]'");
    row(R"({"linear":1,"angular":0)", "external.not-json", "angular");
    row(R"({"linear":1,"angular":0} x)", "external.not-json", "} x");
    row(R"({"linear":NaN,"angular":0})", "external.not-json", "NaN");
    row(R"({"linear":Infinity,"angular":0})", "external.not-json", "Infinity");
    row(R"({"linear":1e999,"angular":0})", "external.not-json", "1e999");
    row("{\"linear\":\"\xFF\"}", "external.not-json", "linear");
    row(QByteArray(500, 'x'), "external.not-json", "'" + QByteArray(200, 'x') + "…'");
    row(QByteArray(100000, '['), "external.not-json", "[[[");
    row(R"({"angular":0})", "external.no-key", "no \"linear\": '{\"angular\":0}'");
    row(R"({"linear":0})", "external.no-key", "no \"angular\"");
    row(R"({"linear":"0.5","angular":0})", "external.no-number",
        "\"linear\" of the answer must be a finite number, not \"0.5\"");
    row(R"({"linear":0,"angular":null})", "external.no-number", "\"angular\"");
    row(R"({"linear":true,"angular":0})", "external.no-number", "not true");
    row(R"({"linear":[1],"angular":0})", "external.no-number", "not [1]");
    row(R"({"linear":1,"angular":0,"lateral":{}})", "external.no-number", "\"lateral\"");
    row(R"({"linear":1,"angular":0,"path":3})", "external.bad-path", "not 3");
    row(R"({"linear":1,"angular":0,"path":[[1]]})", "external.bad-path", "not [1]");
    row(R"({"linear":1,"angular":0,"path":[[1,2],[1,"a"]]})", "external.bad-path", "not [1,\"a\"]");
    row(R"({"linear":1,"angular":0,"path":[[1,2,3]]})", "external.bad-path", "not [1,2,3]");
    row(R"({"error":"no way","linear":1,"angular":0})", "external.complaint",
        "reports an error: no way");
    row(R"({"error":{"code":4}})", "external.complaint", "{\"code\":4}");
  }

  void answer_bad_isToldWithWhatWasFound() {
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, code);
    QFETCH(QByteArray, part);
    const auto answer = readAnswer(line.toStdString());
    QVERIFY(!answer);
    QCOMPARE(codesOf(answer.diagnostics()), code);
    const QByteArray message = bytes(answer.diagnostics().front().message);
    QVERIFY2(message.contains(part), message);
  }

  void answer_severalMistakes_areAllTold() {
    const auto answer = readAnswer(R"({"linear":"a","lateral":[],"path":1})");
    QCOMPARE(codesOf(answer.diagnostics()),
             QByteArray("external.no-number external.no-key external.no-number external.bad-path"));
  }

  void shownText_long_isCutBetweenCharacters() {
    QCOMPARE(printableText("a\tb\x01\x7F\xC3\xA4"), std::string("a?b??\xC3\xA4"));
    QCOMPARE(printableText("abcd", 4), std::string("abcd"));
    QCOMPARE(printableText("abcde", 4), std::string("abcd…"));
    QCOMPARE(printableText("abc\xC3\xA4", 4), std::string("abc…"));
    QCOMPARE(printableText("\xC3\xA4", 1), std::string("…"));
  }
};

QTEST_GUILESS_MAIN(PlannerProtocolTest)
#include "tst_PlannerProtocol.moc"
