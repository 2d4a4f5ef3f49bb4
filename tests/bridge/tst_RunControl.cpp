#include <chrono>
#include <limits>
#include <string>

#include <QtTest>

#include "app/bridge/live/RunControl.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/geometry_msgs.h"
#include "tests/bridge/ClientFrames.h"

using client::bytesOf;
using live::ParameterValue;

namespace {

struct Scene {
  Scene() { session.setSpeed(1.0); }
  app::Session session{sim2d::StopRule{}};
  live::RunControl control{session, {"cafe", 7, 0.05}, {{"/cmd_vel", -1}}};
  std::vector<live::Service> services = control.services();
  std::vector<live::Parameter> parameters = control.parameters();
  std::vector<live::ClientTopic> clientTopics = control.clientTopics();

  QByteArray call(std::size_t service, const char* encoding, const std::string& payload) const {
    const live::ServiceAnswer answer = services.at(service).call(encoding, payload);
    const QByteArray bytes = QByteArray::fromStdString(answer.payload);
    return answer.isFine ? bytes : "failed: " + bytes;
  }
  const live::Parameter& parameter(const char* name) const {
    for (const live::Parameter& each : parameters) {
      if (each.name == name) {
        return each;
      }
    }
    qFatal("no parameter %s", name);
  }
};

}  // namespace

class RunControlTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void schemas_areThoseOfRos() {
    const Scene scene;
    QCOMPARE(scene.services.at(0).request.name, std::string("std_srvs/srv/SetBool_Request"));
    QCOMPARE(scene.services.at(0).request.text, std::string("bool data\n"));
    QCOMPARE(scene.services.at(0).response.text, std::string("bool success\nstring message\n"));
    QCOMPARE(scene.services.at(1).type, std::string("std_srvs/srv/Trigger"));
    QCOMPARE(scene.clientTopics.at(0).schemaName, std::string("geometry_msgs/msg/Twist"));
  }

  /// CDR by hand: the head, a bool; then padding to the length of "paused" with its NUL, 7.
  void pause_cdr_isDoneAndAnswered() {
    const Scene scene;
    QCOMPARE(scene.call(0, "cdr", bytesOf("00 01 00 00 01")),
             QByteArray::fromHex("00 01 00 00 01 00 00 00 07 00 00 00 70 61 75 73 65 64 00"));
    QVERIFY(scene.parameter("/hunavsim.paused").get() == ParameterValue(true));
    scene.call(0, "cdr", bytesOf("00 01 00 00 00"));
    QVERIFY(scene.parameter("/hunavsim.paused").get() == ParameterValue(false));
  }

  /// By the window, too.
  void parameters_ofWhatOthersOrdered_areTrue() {
    Scene scene;
    scene.session.setPaused(true);
    scene.session.setSpeed(4.0);
    QVERIFY(scene.parameter("/hunavsim.paused").get() == ParameterValue(true));
    QVERIFY(scene.parameter("/hunavsim.real_time_factor").get() == ParameterValue(4.0));
    QVERIFY(scene.call(1, "json", "").startsWith(R"({"success":true,)"));
    const app::SessionUpdate news = scene.session.takeUpdate();
    QVERIFY(news.isPaused == std::optional(true) && news.speed == std::optional(4.0));
  }

  void pause_json_isDoneAndAnswered() {
    const Scene scene;
    QCOMPARE(scene.call(0, "json", R"({"data":true})"),
             QByteArray(R"({"success":true,"message":"paused"})"));
    QVERIFY(scene.parameter("/hunavsim.paused").get() == ParameterValue(true));
  }

  void pause_otherBytes_fail_data() {
    QTest::addColumn<QByteArray>("encoding");
    QTest::addColumn<QByteArray>("payload");
    QTest::newRow("no bytes") << QByteArray("cdr") << QByteArray();
    QTest::newRow("no bool") << QByteArray("cdr") << QByteArray::fromHex("00010000");
    QTest::newRow("bool 2") << QByteArray("cdr") << QByteArray::fromHex("0001000002");
    QTest::newRow("no json") << QByteArray("json") << QByteArray("{");
    QTest::newRow("a number") << QByteArray("json") << QByteArray("{\"data\":1}");
    QTest::newRow("a list") << QByteArray("json") << QByteArray("[true]");
    QTest::newRow("deep") << QByteArray("json") << QByteArray(60000, '[');
    QTest::newRow("long") << QByteArray("json")
                          << "{\"data\":true,\"x\":\"" + QByteArray(70000, 'x') + "\"}";
  }

  void pause_otherBytes_fail() {
    QFETCH(const QByteArray, encoding);
    QFETCH(const QByteArray, payload);
    const Scene scene;
    QCOMPARE(scene.call(0, encoding.constData(), payload.toStdString()),
             QByteArray("failed: the request is not a std_srvs/srv/SetBool"));
    QVERIFY(scene.parameter("/hunavsim.paused").get() == ParameterValue(false));
  }

  void step_onlyWhilePaused() {
    const Scene scene;
    QVERIFY(scene.call(1, "json", "").startsWith(R"({"success":false,)"));
    scene.call(0, "json", R"({"data":true})");
    QCOMPARE(scene.call(1, "json", "{}"), QByteArray(R"({"success":true,"message":"one step"})"));
  }

  void parameters_tellAndTake() {
    const Scene scene;
    QVERIFY(scene.parameter("/hunavsim.scenario").get() == ParameterValue(std::string("cafe")));
    QVERIFY(scene.parameter("/hunavsim.seed").get() == ParameterValue(std::int64_t{7}));
    QVERIFY(!scene.parameter("/hunavsim.seed").set);
    QVERIFY(scene.parameter("/hunavsim.time_step").get() == ParameterValue(0.05));
    const live::Parameter& factor = scene.parameter("/hunavsim.real_time_factor");
    QVERIFY(factor.get() == ParameterValue(1.0));
    QCOMPARE(factor.set(ParameterValue(2.5)), std::string());
    QVERIFY(factor.get() == ParameterValue(2.5));
    QCOMPARE(factor.set(ParameterValue(std::int64_t{4})), std::string());
    QVERIFY(factor.get() == ParameterValue(4.0));
    QCOMPARE(scene.parameter("/hunavsim.paused").set(ParameterValue(1.0)),
             std::string("must be true or false"));
    QCOMPARE(scene.parameter("/hunavsim.paused").set(ParameterValue(true)), std::string());
    QVERIFY(scene.parameter("/hunavsim.paused").get() == ParameterValue(true));
  }

  void realTimeFactor_wrongValues_areRefused_data() {
    QTest::addColumn<double>("factor");
    for (const double factor :
         {0.0, -1.0, 0.0999, 100.1, 1e300, std::numeric_limits<double>::infinity(),
          std::numeric_limits<double>::quiet_NaN()}) {
      QTest::newRow(QByteArray::number(factor)) << factor;
    }
  }

  void realTimeFactor_wrongValues_areRefused() {
    QFETCH(const double, factor);
    const Scene scene;
    const live::Parameter& parameter = scene.parameter("/hunavsim.real_time_factor");
    QCOMPARE(parameter.set(ParameterValue(factor)),
             std::string("must be a number from 0.1 to 100"));
    QVERIFY(!parameter.set(ParameterValue()).empty());
    QVERIFY(!parameter.set(ParameterValue(std::string("2"))).empty());
    QVERIFY(parameter.get() == ParameterValue(1.0));
  }

  void drive_finiteTwists_areTaken_data() {
    QTest::addColumn<QByteArray>("encoding");
    QTest::addColumn<QByteArray>("payload");
    QTest::addColumn<bool>("isTaken");
    bridge::geometry_msgs::Twist twist;
    const auto cdr = [&twist] { return QByteArray::fromStdString(bridge::encode(twist)); };
    QTest::newRow("cdr") << QByteArray("cdr") << cdr() << true;
    QTest::newRow("cut") << QByteArray("cdr") << cdr().left(30) << false;
    twist.linear.x = std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("NaN") << QByteArray("cdr") << cdr() << false;
    twist.linear.x = std::numeric_limits<double>::infinity();
    QTest::newRow("inf") << QByteArray("cdr") << cdr() << false;
    QTest::newRow("json") << QByteArray("json")
                          << QByteArray(R"({"linear":{"x":0.5,"y":0,"z":0},"angular":{"z":-1}})")
                          << true;
    QTest::newRow("null") << QByteArray("json") << QByteArray(R"({"linear":{"x":null}})") << false;
    QTest::newRow("no vector") << QByteArray("json") << QByteArray(R"({"linear":1})") << false;
  }

  void drive_finiteTwists_areTaken() {
    QFETCH(const QByteArray, encoding);
    QFETCH(const QByteArray, payload);
    QFETCH(const bool, isTaken);
    const Scene scene;
    QCOMPARE(scene.clientTopics.at(0).take(encoding.toStdString(), payload.toStdString()),
             std::string(isTaken ? "" : "not a geometry_msgs/msg/Twist with finite numbers"));
  }

  /// The world takes no input above 1000: whoever drives is told instead of being left alone.
  void drive_aboveAThousand_isToldNotLost() {
    const Scene scene;
    const auto answer = [&](const char* payload) {
      return scene.clientTopics.at(0).take("json", payload);
    };
    QCOMPARE(answer(R"({"linear":{"x":1000,"y":-1000},"angular":{"z":1000}})"), std::string());
    for (const char* payload :
         {R"({"linear":{"x":1000.5}})", R"({"linear":{"y":-1e308}})", R"({"angular":{"z":1e6}})"}) {
      QCOMPARE(answer(payload), std::string("velocities must be at most 1000"));
    }
  }
};

QTEST_APPLESS_MAIN(RunControlTest)
#include "tst_RunControl.moc"
