#include <QJsonArray>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

/// A person comes towards the robot in a hall of 12 x 4 m.
QByteArray meeting(const QByteArray& expectation, const QByteArray& robotGoal = "10.5") {
  return "hunav_loader:\n  ros__parameters:\n    yaml_base_name: meeting\n    simulator: Gazebo "
         "Classic\n    map: open\n    publish_people: true\n    global_goals:\n      1:\n        "
         "x: "
         "1.000\n        y: 2.100\n    agents:\n      - anna\n    anna:\n      id: 1\n      "
         "max_vel: "
         "1.2\n      radius: 0.3\n      goal_radius: 0.3\n      cyclic_goals: false\n      "
         "init_pose:\n        x: 11.000\n        y: 2.100\n        h: 3.142\n      goals:\n        "
         "- "
         "1\nhunavsim_desktop:\n  ros__parameters:\n    format: 1\n    card:\n      title: "
         "Meeting\n      metrics:\n        - minimum_distance_to_people\n      expect:\n        "
         "- " +
         expectation +
         "\n    map_file: none\n    stuck_after: 10.0\n    variation:\n      preset: light\n    "
         "robots:\n      - robot1\n    robot1:\n      start:\n        x: 1.0\n        y: 2.0\n     "
         " "
         "  h: 0.0\n      goal:\n        x: " +
         robotGoal +
         "\n        y: 2.0\n    obstacles:\n      - room\n    room:\n      kind: wall\n      xs:\n "
         " "
         "      - 0.0\n        - 12.0\n        - 12.0\n        - 0.0\n        - 0.0\n      ys:\n   "
         "  "
         "   - 0.0\n        - 0.0\n        - 4.0\n        - 4.0\n        - 0.0\n";
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
