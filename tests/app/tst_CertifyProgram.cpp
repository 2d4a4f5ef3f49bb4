#include <QJsonArray>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

/// A person comes towards the robot in a hall of 12 x 4 m, in which a crate stands in the way.
constexpr const char* kMeeting = R"(hunav_loader:
  ros__parameters:
    yaml_base_name: meeting
    simulator: Gazebo Classic
    map: open
    publish_people: true
    global_goals:
      1: {x: 1.0, y: 2.1}
    agents: [anna]
    anna:
      id: 1
      max_vel: 1.2
      radius: 0.3
      goal_radius: 0.3
      cyclic_goals: false
      init_pose: {x: 11.0, y: 2.1, h: 3.142}
      goals: [1]
hunavsim_desktop:
  ros__parameters:
    format: 1
    card:
      title: Meeting
      metrics: [minimum_distance_to_people]
      expect: [EXPECTATION]
    map_file: none
    stuck_after: 10.0
    variation: {preset: light}
    robots: [robot1]
    robot1:
      start: {x: 1.0, y: 2.0, h: 0.0}
      goal: {x: GOAL, y: 2.0}
    obstacles: [room, crate]
    room:
      kind: wall
      xs: [0.0, 12.0, 12.0, 0.0, 0.0]
      ys: [0.0, 0.0, 4.0, 4.0, 0.0]
    crate: {kind: box, x: 5.0, y: 2.0, h: 0.0, length: 0.8, width: 0.8}
)";

QByteArray meeting(const QByteArray& expectation, const QByteArray& robotGoal = "10.5") {
  return QByteArray(kMeeting).replace("EXPECTATION", expectation).replace("GOAL", robotGoal);
}

QJsonObject certificateIn(const QTemporaryDir& folder) {
  QFile file(folder.filePath(QStringLiteral("meeting.certificate.json")));
  return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                        : QJsonObject();
}

QStringList problemsIn(const QTemporaryDir& folder) {
  QStringList problems;
  for (const auto& problem : certificateIn(folder)[text("problems")].toArray()) {
    problems << problem.toString();
  }
  return problems;
}

const QString kCertify = QStringLiteral(
    "check --certify meeting.yaml --seeds 4 --jobs 1 "
    "--planners pursuit,orca");

Finished certify(const QTemporaryDir& folder) {
  return runProgram(kCertify.split(QLatin1Char(' ')), folder.path());
}

}  // namespace

/// `check --certify` and `check --verify` from outside.
class CertifyProgramTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void certify_ofAMeeting_provesIt_andVerifyConfirms() {
    const QTemporaryDir folder;
    writeText(folder.filePath(text("meeting.yaml")), meeting("anna reaches goal 1 before 20 s"));
    const Finished certified = certify(folder);
    QVERIFY2(certified.exitCode == 0, qPrintable(certified.out + certified.err));
    const QJsonObject certificate = certificateIn(folder);
    QCOMPARE(certificate[text("certified")].toBool(), true);
    QCOMPARE(certificate[text("seeds")].toArray().size(), 4);
    const QJsonObject successes = certificate[text("successes")].toObject();
    QCOMPARE(successes.keys(), QStringList({text("orca"), text("pursuit"), text("straight")}));
    QVERIFY(successes[text("straight")].toInt() < 4);
    const QJsonObject metric = certificate[text("metrics")].toArray()[0].toObject();
    QCOMPARE(metric[text("key")].toString(), text("minimum_distance_to_people"));
    QCOMPARE(metric[text("planners")].toArray().size(), 2);
    const QJsonObject expectation = certificate[text("expectations")].toArray()[0].toObject();
    const double time = expectation[text("time")].toDouble();
    QVERIFY2(time > 9.0 / 1.5 && time < 20.0, qPrintable(QString::number(time)));

    const QStringList verify = list("check --verify meeting.yaml --jobs 2");
    const Finished same = runProgram(verify, folder.path());
    QVERIFY2(same.exitCode == 0, qPrintable(same.out + same.err));
    writeText(folder.filePath(text("meeting.yaml")),
              meeting("anna reaches goal 1 before 20 s", "9.0"));
    QCOMPARE(unexpected(runProgram(verify, folder.path()), 1, "inputs"), QString());
  }

  void verify_otherJson_isRefused() {
    const QTemporaryDir folder;
    writeText(folder.filePath(text("meeting.yaml")), meeting("anna reaches goal 1 before 20 s"));
    for (const char* const certificate :
         {"", "{", "[]", "7", R"({"hunavsim_certificate": "1", "seeds": [1], "successes": {}})",
          R"({"hunavsim_certificate": null, "seeds": [1], "successes": {"orca": 1}})",
          R"({"hunavsim_certificate": 1, "seeds": 5, "successes": {"orca": 1}})",
          R"({"hunavsim_certificate": 1, "seeds": ["a"], "successes": {"orca": 1}})",
          R"({"hunavsim_certificate": 1, "seeds": [1], "successes": [1]})",
          R"({"hunavsim_certificate": 1, "seeds": [1e999], "successes": {"orca": 1}})"}) {
      writeText(folder.filePath(text("meeting.certificate.json")), certificate);
      const Finished finished =
          runProgram(text("check --verify meeting.yaml").split(QLatin1Char(' ')), folder.path());
      QCOMPARE(unexpected(finished, 2,
                          "meeting.certificate.json: error: is not a certificate of a scenario"),
               QString());
    }
  }

  void certify_expectationThatFails_isAProblem() {
    const QTemporaryDir folder;
    writeText(folder.filePath(text("meeting.yaml")), meeting("anna reaches goal 1 before 3 s"));
    QCOMPARE(certify(folder).exitCode, 1);
    QCOMPARE(certificateIn(folder)[text("certified")].toBool(), false);
    QVERIFY2(problemsIn(folder).join(QLatin1Char('\n')).contains(text("before 3 s")),
             qPrintable(problemsIn(folder).join(QLatin1Char('\n'))));
  }

  void certify_goalInAWall_isAProblem() {
    const QTemporaryDir folder;
    writeText(folder.filePath(text("meeting.yaml")),
              meeting("anna reaches goal 1 before 20 s", "14.0"));
    QCOMPARE(certify(folder).exitCode, 1);
    QVERIFY(!problemsIn(folder).isEmpty());
  }

  void verify_withoutCertificate_isAnError() {
    const QTemporaryDir folder;
    writeText(folder.filePath(text("meeting.yaml")), meeting("anna reaches goal 1 before 20 s"));
    QCOMPARE(runProgram(list("check --verify meeting.yaml"), folder.path()).exitCode, 2);
  }
};

QTEST_GUILESS_MAIN(CertifyProgramTest)
#include "tst_CertifyProgram.moc"
