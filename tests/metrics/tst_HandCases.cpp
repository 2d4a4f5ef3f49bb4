#include <QDir>
#include <QtTest>

#include "HandMade.h"
#include "sim2d/base/Text.h"

using namespace metrics;
using namespace handmade;

/// Cases whose values were worked out by hand.
class HandCasesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void everyMetricOfOurs_hasACase();
  void facing_narrowAndWideCones();
  void gaussianSpace_extremesAndTimeAbove();
  void discomfort_meanOfCloseGaps();
  void zoneEntries_byWhoClosesIn();
  void zoneEntries_ofWhoWasNotThere_areOfOneTime();
  void obstacles_contactsAndTimeTooClose();
  void finalDistance_perMetreDriven();
  void crowd_densestLook();
  void responsibility_ofBothSides();
};

void HandCasesTest::everyMetricOfOurs_hasACase() {
  // In a test of this folder, in its own vectors, or in the published ones.
  QString texts;
  const QString published = qEnvironmentVariable("HUNAV_METRIC_VECTORS");
  QStringList folders{QStringLiteral(SOURCE_DIR "/tests/metrics"),
                      QStringLiteral(TEST_DATA_DIR "/metrics")};
  if (published.isEmpty()) {
    QSKIP("the published vectors are not here (HUNAV_METRIC_VECTORS)");
  }
  folders << published;
  for (const QString& folder : folders) {
    for (const QString& name :
         QDir(folder).entryList({QStringLiteral("*.cpp"), QStringLiteral("*.json")}, QDir::Files)) {
      const auto text = base::readTextFile(QDir(folder).filePath(name).toStdString());
      QVERIFY(text);
      texts += QString::fromStdString(*text);
    }
  }
  for (const MetricEntry& entry : standardRegistry().entries()) {
    const QString quoted = QStringLiteral("\"%1\"").arg(QString::fromStdString(entry.info.key));
    const bool isPlain = entry.info.hunav == 0 && entry.info.partOf.empty();
    QVERIFY2(!isPlain || texts.contains(quoted), qPrintable(quoted));
  }
}

void HandCasesTest::facing_narrowAndWideCones() {
  // 2.9 degrees off for 1 s, 45 and 30 degrees off for 2 s, then turned away.
  const double small = std::atan(0.05);
  std::vector<Sample> samples = {sampleAt(0, 0, 0), sampleAt(1, 0, 0), sampleAt(3, 0, 0),
                                 sampleAt(4, 0, 0)};
  samples[0].people = {personAt(1, 2, 0.1)};
  samples[0].people[0].heading = -base::kPi + 2.0 * small;
  samples[1].people = {personAt(1, 2, 2)};
  samples[1].people[0].heading = (-135.0 + 30.0) / 180.0 * base::kPi;
  samples[2].people = {personAt(1, -2, 0)};
  samples[2].people[0].heading = base::kPi;
  const SampledRun recording = recordingOfSamples(samples);
  QCOMPARE(valueOf(recording, "time_facing_people"), 1.0);
  QCOMPARE(valueOf(recording, "time_facing_people_60"), 3.0);
  QCOMPARE(valueOf(recording, "time_seen_by_people"), 1.0);
  QCOMPARE(valueOf(recording, "time_seen_by_people_60"), 3.0);
}

void HandCasesTest::gaussianSpace_extremesAndTimeAbove() {
  // Who stands: variances 0.5 ahead, 0.25 behind, 1/3 aside.
  std::vector<Sample> samples = {sampleAt(0, 1, 0), sampleAt(1, -0.5, 0), sampleAt(3, 0, 1)};
  for (Sample& sample : samples) {
    sample.people = {personAt(1, 0, 0)};
  }
  const SampledRun recording = recordingOfSamples(samples);
  const double mean = 100.0 * (std::exp(-1.0) + 2.0 * std::exp(-0.5)) / 3.0;
  QVERIFY(isNear(valueOf(recording, "personal_space_intrusion_gaussian"), mean));
  QVERIFY(
      isNear(valueOf(recording, "personal_space_intrusion_gaussian_min"), 100.0 * std::exp(-1.5)));
  QVERIFY(
      isNear(valueOf(recording, "personal_space_intrusion_gaussian_max"), 100.0 * std::exp(-0.5)));
  QVERIFY(isNear(valueOf(recording, "personal_space_intrusion_gaussian_above"), 200.0 / 3.0));
}

void HandCasesTest::discomfort_meanOfCloseGaps() {
  std::vector<Sample> samples = {sampleAt(0, 0, 0), sampleAt(1, 0, 0), sampleAt(2, 0, 0)};
  samples[0].people = {personAt(1, 0.6, 0)};
  samples[1].people = {personAt(1, 0, 0.65), personAt(2, 9, 0)};
  samples[2].people = {personAt(1, 1.5, 0)};
  const SampledRun recording = recordingOfSamples(samples);
  QVERIFY(isNear(valueOf(recording, "discomfort_distance_avg"), 0.125));
  QVERIFY(isNear(valueOf(recording, "discomfort_frequency"), 200.0 / 3.0));
}

void HandCasesTest::zoneEntries_byWhoClosesIn() {
  // Person 1 stands ahead of the driving robot, person 2 runs in from the side at the end.
  std::vector<Sample> samples;
  const double gaps[] = {2.5, 1.0, 0.4, 2.0};
  for (int k = 0; k < 4; ++k) {
    Sample sample = sampleAt(k, 0, 0, 1.0);
    sample.people = {personAt(1, gaps[k] + 0.5, 0), personAt(2, 0, k < 3 ? 5.5 : 0.8, 0, -3.0)};
    samples.push_back(sample);
  }
  const SampledRun recording = recordingOfSamples(samples);
  for (const char* zone : {"intimate", "personal"}) {
    const std::string key = std::string(zone) + "_zone_entries";
    QCOMPARE(valueOf(recording, key.c_str()), 2.0);
    QCOMPARE(valueOf(recording, (key + "_by_robot").c_str()), 1.0);
    QCOMPARE(valueOf(recording, (key + "_by_person").c_str()), 1.0);
  }
  const char* tested[] = {"intimate_zone_entries_by_robot", "intimate_zone_entries_by_person",
                          "personal_zone_entries_by_robot", "personal_zone_entries_by_person"};
  for (const char* key : tested) {
    QVERIFY2(standardRegistry().find(key) != nullptr, key);
  }
}

/// Person 171 of the ETH recording as the robot, at frames 8391 and 8397: it stands, then walks at
/// (-0.524, -0.430) m/s; person 184, at frame 8397 for the first time, is 1.449 m away and comes no
/// nearer than 0.007 m/s along the line of centres. Velocities of two times would blame the person.
void HandCasesTest::zoneEntries_ofWhoWasNotThere_areOfOneTime() {
  std::vector<Sample> samples = {sampleAt(0.0, 0.0, 0.0), sampleAt(0.4, 0.0, 0.0)};
  Robot& robot = samples[1].robot;
  robot.velocity = Vec2(-0.52382326, -0.42954246);
  robot.speed = robot.velocity.norm();
  // Along the line of centres 0.307 m/s of the robot, 0.0066 m/s of the person.
  const double along = std::atan2(-0.42954246, -0.52382326) + std::acos(0.3070557 / robot.speed);
  const Vec2 between(std::cos(along), std::sin(along));
  const Vec2 person = -0.0065890 * between + 2.1 * Vec2(-between.y(), between.x());
  samples[1].people = {
      personAt(184, 1.449 * between.x(), 1.449 * between.y(), person.x(), person.y())};
  SampledRun recording = recordingOfSamples(samples);
  QCOMPARE(valueOf(recording, "personal_zone_entries_by_robot"), 1.0);
  QCOMPARE(valueOf(recording, "personal_zone_entries_by_person"), 0.0);
  // A person who enters again at another place was not present before either.
  recording.samples[0].people = {personAt(184, 9.0, 9.0, 5.0, 5.0)};
  sim2d::Event enter;
  enter.kind = sim2d::EventKind::Enter;
  enter.id = 184;
  recording.events = {{0.2, enter}};
  QCOMPARE(valueOf(recording, "personal_zone_entries_by_robot"), 1.0);
  // For a person who was present, the earlier velocities count for both, as contact may have
  // stopped them.
  recording.events.clear();
  recording.samples[0].people = {
      personAt(184, 3.0 * between.x(), 3.0 * between.y(), -between.x(), -between.y())};
  QCOMPARE(valueOf(recording, "personal_zone_entries_by_robot"), 0.0);
  QCOMPARE(valueOf(recording, "personal_zone_entries_by_person"), 1.0);
}

void HandCasesTest::obstacles_contactsAndTimeTooClose() {
  // Clearances 0.75, 0.25, 0, none in reach, -0.05.
  std::vector<Sample> samples = {sampleAt(0, 0, 0), sampleAt(1, 0, 0), sampleAt(2, 0, 0),
                                 sampleAt(3, 0, 0), sampleAt(5, 0, 0)};
  samples[0].robot.obstacleDistance = 1.0;
  samples[1].robot.obstacleDistance = 0.5;
  samples[2].robot.obstacleDistance = 0.25;
  samples[4].robot.obstacleDistance = 0.2;
  SampledRun recording = recordingOfSamples(samples);
  recording.hasObstacles = true;
  QCOMPARE(valueOf(recording, "obstacle_safety"), 40.0);
  QCOMPARE(valueOf(recording, "obstacle_collisions"), 2.0);
  QVERIFY(isNear(valueOf(recording, "clearing_distance_min"), -0.05));
  QVERIFY(isNear(valueOf(recording, "clearing_distance_avg"), 0.95 / 4.0));
}

void HandCasesTest::finalDistance_perMetreDriven() {
  SampledRun recording =
      recordingOfSamples({sampleAt(0, 0, 0), sampleAt(1, 3, 0), sampleAt(2, 3, 4)});
  recording.goals = {{0, Vec2(3, 6), 0.2}};
  QVERIFY(isNear(valueOf(recording, "targ_dist_norm"), 2.0 / 7.0));
}

void HandCasesTest::crowd_densestLook() {
  // Alone: a circle of 2 m; then two in one place share it.
  SampledRun recording;
  Sample alone;
  alone.people = {personAt(1, 0, 0)};
  Sample pair;
  pair.time = 1.0;
  pair.people = {personAt(1, 0, 0), personAt(2, 1e-6, 0)};
  recording.samples = {alone, pair};
  const double circle = 4.0 * base::kPi;
  QVERIFY(std::fabs(valueOf(recording, "crowd_voronoi_density_max") - 2.0 / circle) < 1e-5);
  QVERIFY(std::fabs(valueOf(recording, "crowd_voronoi_density") - 1.5 / circle) < 1e-5);
  const MetricEntry* density = standardRegistry().find("crowd_voronoi_density");
  const auto series = metrics::valueOf(*density, recording, MetricParameters{}).series;
  QVERIFY(series && series->values.size() == 2 && isNear(series->values[0], 1.0 / circle));
}

void HandCasesTest::responsibility_ofBothSides() {
  // Head-on, 4 m apart: the robot turns by 0.1 rad, then the person steps aside.
  std::vector<Sample> samples = {sampleAt(0, 0, 0, 1.0), sampleAt(0.5, 0, 0, 1.0),
                                 sampleAt(1, 0, 0, 1.0)};
  for (Sample& sample : samples) {
    sample.people = {personAt(1, 4, 0)};
  }
  samples[1].robot.velocity = Vec2(std::cos(0.1), std::sin(0.1));
  samples[2].robot.velocity = samples[1].robot.velocity;
  samples[2].people[0].velocity = Vec2(0.0, -0.05);
  const double byRobot = 4.0 * std::sin(0.1);
  const double aside = std::sin(0.1) + 0.05;
  const double ahead = std::cos(0.1);
  const double byPerson = 4.0 * aside / std::sqrt(ahead * ahead + aside * aside) - byRobot;
  const SampledRun recording = recordingOfSamples(samples);
  QVERIFY(isNear(valueOf(recording, "responsibility"), 100.0 * byRobot / (byRobot + byPerson)));
  QVERIFY(isNear(valueOf(recording, "engagement"), byRobot / 1.0));
  samples[0].people[0].position = samples[1].people[0].position = Vec2(-4, 0);
  QVERIFY(std::isnan(valueOf(recordingOfSamples(samples), "responsibility")));
}

QTEST_APPLESS_MAIN(HandCasesTest)
#include "tst_HandCases.moc"
