#include <algorithm>
#include <set>

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
  void everyMetricOfOurs_hasACase() {
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
      for (const QString& name : QDir(folder).entryList(
               {QStringLiteral("*.cpp"), QStringLiteral("*.json")}, QDir::Files)) {
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

  void finalSituation_isThatOfTheLastSample() {
    // At the end the robot looks along y: person 2 is 3 m to its left, person 1 has passed.
    std::vector<Sample> samples = {sampleAt(0, 0, 0), sampleAt(1, 1, 2)};
    samples[0].people = {personAt(1, 0.6, 0)};
    samples[1].robot.heading = base::kPi / 2.0;
    samples[1].people = {personAt(1, 1, -8), personAt(2, -2, 2, 0.3, -0.4), personAt(3, 4, 6)};
    const SampledRun recording = recordingOfSamples(samples);
    QVERIFY(isNear(valueOf(recording, "final_bearing_to_person"), base::kPi / 2.0));
    QVERIFY(isNear(valueOf(recording, "final_distance_to_person"), 3.0 - 0.5));
    QVERIFY(isNear(valueOf(recording, "final_person_speed"), 0.5));
    QCOMPARE(valueOf(recording, "final_people_near"), 1.0);  // the third is 5 m - 0.5 m away
    samples[1].people.clear();
    const SampledRun alone = recordingOfSamples(samples);
    QVERIFY(std::isnan(valueOf(alone, "final_bearing_to_person")));
    QCOMPARE(valueOf(alone, "final_people_near"), 0.0);
  }

  void facing_narrowAndWideCones() {
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

  void facing_personAtTheSamePlace_isFaced() {
    std::vector<Sample> samples = {sampleAt(0, 0, 0), sampleAt(1, 0, 0)};
    for (Sample& sample : samples) {
      sample.robot.heading = 2.0;
      sample.people = {personAt(1, 0, 0), personAt(2, 0, 3)};
    }
    QCOMPARE(valueOf(recordingOfSamples(samples), "time_facing_people"), 1.0);
  }

  void gaussianSpace_extremesAndTimeAbove() {
    // Who stands: variances 0.5 ahead, 0.25 behind, 1/3 aside.
    std::vector<Sample> samples = {sampleAt(0, 1, 0), sampleAt(1, -0.5, 0), sampleAt(3, 0, 1)};
    for (Sample& sample : samples) {
      sample.people = {personAt(1, 0, 0)};
    }
    const SampledRun recording = recordingOfSamples(samples);
    const double mean = 100.0 * (std::exp(-1.0) + 2.0 * std::exp(-0.5)) / 3.0;
    QVERIFY(isNear(valueOf(recording, "personal_space_intrusion_gaussian"), mean));
    QVERIFY(isNear(valueOf(recording, "personal_space_intrusion_gaussian_min"),
                   100.0 * std::exp(-1.5)));
    QVERIFY(isNear(valueOf(recording, "personal_space_intrusion_gaussian_max"),
                   100.0 * std::exp(-0.5)));
    QVERIFY(isNear(valueOf(recording, "personal_space_intrusion_gaussian_above"), 200.0 / 3.0));
  }

  void discomfort_meanOfCloseGaps() {
    std::vector<Sample> samples = {sampleAt(0, 0, 0), sampleAt(1, 0, 0), sampleAt(2, 0, 0)};
    samples[0].people = {personAt(1, 0.6, 0)};
    samples[1].people = {personAt(1, 0, 0.65), personAt(2, 9, 0)};
    samples[2].people = {personAt(1, 1.5, 0)};
    const SampledRun recording = recordingOfSamples(samples);
    QVERIFY(isNear(valueOf(recording, "discomfort_distance_avg"), 0.125));
    QVERIFY(isNear(valueOf(recording, "discomfort_frequency"), 200.0 / 3.0));
  }

  void zoneEntries_byWhoClosesIn() {
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

  /// Person 171 of the ETH recording as the robot, at frames 8391 and 8397: it stands, then walks
  /// at
  /// (-0.524, -0.430) m/s; person 184, at frame 8397 for the first time, is 1.449 m away and comes
  /// no nearer than 0.007 m/s along the line of centres. Velocities of two times would blame the
  /// person.
  void zoneEntries_ofWhoWasNotThere_areOfOneTime() {
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
    recording.events = {{0.2, eventOf(EventKind::Enter, 184)}};
    QCOMPARE(valueOf(recording, "personal_zone_entries_by_robot"), 1.0);
    // For a person who was present, the earlier velocities count for both, as contact may have
    // stopped them.
    recording.events.clear();
    recording.samples[0].people = {
        personAt(184, 3.0 * between.x(), 3.0 * between.y(), -between.x(), -between.y())};
    QCOMPARE(valueOf(recording, "personal_zone_entries_by_robot"), 0.0);
    QCOMPARE(valueOf(recording, "personal_zone_entries_by_person"), 1.0);
  }

  void obstacles_contactsAndTimeTooClose() {
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

  void finalDistance_perMetreDriven() {
    SampledRun recording =
        recordingOfSamples({sampleAt(0, 0, 0), sampleAt(1, 3, 0), sampleAt(2, 3, 4)});
    recording.goals = {{0, Vec2(3, 6), 0.2}};
    QVERIFY(isNear(valueOf(recording, "targ_dist_norm"), 2.0 / 7.0));
  }

  void crowd_densestLook() {
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

  void responsibility_ofBothSides() {
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

  void registry_measures_areAtLeast64() {
    // Least, mean and largest of one measure count once.
    std::set<std::string> measures;
    for (const MetricEntry& entry : standardRegistry().entries()) {
      std::string key = entry.info.key;
      for (const char* word : {"_min", "_max", "_avg", "_mean", "avg_", "max_", "min_", "_above",
                               "minimum_", "maximum_", "_by_robot", "_by_person", "_60"}) {
        const std::size_t at = key.find(word);
        key = at == std::string::npos ? key : key.erase(at, std::string(word).size());
      }
      if (entry.info.partOf.empty()) {
        measures.insert(key);
      }
    }
    QVERIFY2(measures.size() >= 64, std::to_string(measures.size()).c_str());
  }

  void headingDisturbance_handCase() {
    // The robot comes from ahead, 2 m away, aims 0.14 m beside the person at half the speed.
    SampledRun recording = recordingOfSamples({sampleAt(0, 2, 0.14), sampleAt(1, 2, 0.14)});
    for (Sample& sample : recording.samples) {
      sample.robot.heading = base::kPi;
      sample.robot.speed = 0.275;
      sample.people = {personAt(1, 0, 0)};
    }
    const double separation = std::sqrt(4.0 + 0.14 * 0.14);
    const double bearing = std::atan2(0.14, 2.0);
    const double quarter = 190.0 / 180.0 * base::kPi / 4.0;
    const double expected = 100.0 * std::exp(-0.5) *
                            std::exp(-bearing * bearing / (2.0 * quarter * quarter)) * 0.5 *
                            (0.25 + 0.28) / separation;
    QVERIFY(isNear(valueOf(recording, "heading_direction_disturbance"), expected));
    QVERIFY(isNear(valueOf(recording, "heading_direction_disturbance_max"), expected));
    recording.samples[0].robot.heading = 0.0;  // away from the person
    QCOMPARE(valueOf(recording, "heading_direction_disturbance"), 0.0);
  }

  void formationSpace_handCase() {
    // Two at (-1, 0) and (1, 0), radius 0.25: spans 2.5 and 0.5, deviations 0.625 and 0.125.
    SampledRun recording = recordingOfSamples({sampleAt(0, 0.625, 0), sampleAt(2, 0, 0.125)});
    for (Sample& sample : recording.samples) {
      sample.people = {personAt(1, -1, 0), personAt(2, 1, 0)};
      sample.people[0].group = sample.people[1].group = 3;
    }
    QVERIFY(isNear(valueOf(recording, "formation_space_intrusion"), 100.0 * std::exp(-0.5)));
    QVERIFY(isNear(valueOf(recording, "formation_space_intrusion_max"), 100.0 * std::exp(-0.5)));
    recording.samples[0].people[1].group = recording.samples[1].people[1].group = -1;
    QCOMPARE(valueOf(recording, "formation_space_intrusion"), 0.0);
  }

  void groupCrossings_throughAPair_isOne() {
    for (const double offset : {0.0, 5.0}) {
      std::vector<Sample> samples;
      for (int k = 0; k < 5; ++k) {
        Sample sample = sampleAt(k, offset, -2.2 + k);
        sample.people = {personAt(1, -1, 0.3 * k - 0.6), personAt(2, 1, 0.3 * k - 0.6)};
        sample.people[0].group = sample.people[1].group = 3;
        samples.push_back(sample);
      }
      QCOMPARE(valueOf(recordingOfSamples(samples), "group_crossings"), offset > 1.0 ? 0.0 : 1.0);
    }
  }

  void groupCrossings_throughATriangle_isOne() {
    std::vector<Sample> samples;
    for (int k = 0; k < 30; ++k) {
      Sample sample = sampleAt(0.1 * k, -3.03 + 0.2 * k, 0.1);
      sample.people = {personAt(1, -1, -1), personAt(2, 1, -1), personAt(3, 0, 1)};
      for (Pedestrian& person : sample.people) {
        person.group = 3;
      }
      samples.push_back(sample);
    }
    QCOMPARE(valueOf(recordingOfSamples(samples), "group_crossings"), 1.0);
  }

  void reference_besideTheStraightWay() {
    // To (2, 0) at 1 m/s; the robot is 0.3 beside the way, the last second late.
    SampledRun recording = recordingOfSamples(
        {sampleAt(0, 0, 0), sampleAt(1, 1, 0.3), sampleAt(2, 1, 0.3), sampleAt(3, 2, 0)});
    recording.goals = {{0, Vec2(2, 0), 0.2}};
    const double late = std::sqrt(1.0 + 0.09);
    QVERIFY(isNear(valueOf(recording, "ade"), (0.0 + 0.3 + late + 0.0) / 4.0));
    QVERIFY(isNear(valueOf(recording, "fde"), 0.0));
    QVERIFY(isNear(valueOf(recording, "path_deviation"), 0.6 / 4.0));
    // Reference 0, 2/3, 4/3, 2: pairs (0,0) (1,2/3) (1,4/3) (2,2).
    const double aside = std::sqrt(1.0 / 9.0 + 0.09);
    QVERIFY(isNear(valueOf(recording, "dtw"), 2.0 * aside / 4.0));
    recording.goals.clear();
    for (const char* key : {"ade", "fde", "dtw", "path_deviation"}) {
      QVERIFY2(std::isnan(valueOf(recording, key)), key);
    }
  }

  void reference_recordedRun_isUsed() {
    // The reference goes up 1 m in 2 s and then 1 m to the right in 1 s; the robot cuts the corner.
    SampledRun recording = recordingOfSamples(
        {sampleAt(5, 0, 0), sampleAt(6, 0.4, 0.5), sampleAt(7, 1, 1), sampleAt(9, 1.5, 1)});
    recording.reference = {{0.0, Vec2(0, 0)}, {2.0, Vec2(0, 1)}, {3.0, Vec2(1, 1)}};
    QVERIFY(isNear(valueOf(recording, "ade"), (0.0 + 0.4 + 1.0 + 0.5) / 4.0));
    QVERIFY(isNear(valueOf(recording, "fde"), 0.5));
    QVERIFY(isNear(valueOf(recording, "path_deviation"), (0.0 + 0.4 + 0.0 + 0.5) / 4.0));
    // Pairs: the starts, the second with (0, 1), the third and the last with (1, 1).
    const double second = std::sqrt(0.16 + 0.25);
    QVERIFY(isNear(valueOf(recording, "dtw"), (second + 0.5) / 4.0));
  }

  /// Above 800 samples every 4th is taken here, and both ends: of both ways.
  void reference_longRun_isThinned() {
    std::vector<Sample> samples;
    for (int step = 0; step <= 1602; ++step) {
      samples.push_back(sampleAt(step, 0.01 * step, 1));
    }
    const auto warpedUpTo = [&samples](std::size_t count) {
      SampledRun recording =
          recordingOfSamples({samples.begin(), samples.begin() + static_cast<long>(count)});
      for (std::size_t k = 0; k < count; ++k) {  // one metre beside
        recording.reference.emplace_back(static_cast<double>(k),
                                         Vec2(0.01 * static_cast<double>(k), 0));
      }
      return valueOf(recording, "dtw");
    };
    QVERIFY(isNear(warpedUpTo(800), 1.0));
    QVERIFY(isNear(warpedUpTo(1601), 1.0));
    QVERIFY(isNear(warpedUpTo(1603), 1.0));
  }

  void topologicalComplexity_onceAround_isOneTurn() {
    std::vector<Sample> samples;
    for (int k = 0; k <= 12; ++k) {
      const double angle = 2.0 * base::kPi * k / 12.0;
      Sample sample = sampleAt(k, 2.0 * std::cos(angle), 2.0 * std::sin(angle));
      sample.people = {personAt(1, 0, 0), personAt(2, 50, 0)};
      samples.push_back(sample);
    }
    QVERIFY(isNear(valueOf(recordingOfSamples(samples), "topological_complexity"), 1.0));
  }

  void events_replansAndArrivals_areCounted() {
    SampledRun recording = recordingOfSamples({sampleAt(2, 0, 0), sampleAt(10, 1, 0)});
    const auto add = [&recording](double time, sim2d::EventKind kind, int id) {
      recording.events.emplace_back(time, eventOf(kind, id));
    };
    QVERIFY(std::isnan(valueOf(recording, "aggregated_time")));
    add(1, sim2d::EventKind::Replan, -1);  // before the record
    add(3, sim2d::EventKind::Replan, -1);
    add(4, sim2d::EventKind::Replan, -2);
    add(5, sim2d::EventKind::Arrived, 7);
    add(6, sim2d::EventKind::Arrived, -1);
    add(8, sim2d::EventKind::Arrived, 7);  // again
    QCOMPARE(valueOf(recording, "replanning_count"), 1.0);
    QCOMPARE(valueOf(recording, "aggregated_time"), 3.0 + 4.0);
  }

  void stoppedDistance_standing_isDistance() {
    SampledRun recording = recordingOfSamples(
        {sampleAt(0, 0, 0), sampleAt(1, 1, 0), sampleAt(2, 1.02, 0), sampleAt(3, 2, 0)});
    recording.goals = {{0, Vec2(5, 0), 0.2}};
    QVERIFY(isNear(valueOf(recording, "mean_dist_to_target_not_moving"), 3.98));
    recording.samples.erase(recording.samples.begin() + 2);
    QVERIFY(std::isnan(valueOf(recording, "mean_dist_to_target_not_moving")));
  }

  void timeToCollision_headOn_handCase() {
    // 1 m/s each towards the other, gap 6, 3.5 and 1 m: 3, 1.75 and 0.5 s.
    SampledRun recording = recordingOfSamples(
        {sampleAt(0, 0, 0, 1), sampleAt(1.25, 1.25, 0, 1), sampleAt(2.5, 2.5, 0, 1)});
    for (Sample& sample : recording.samples) {
      sample.people = {personAt(1, 6.5 - sample.time, 0, -1)};
    }
    QVERIFY(isNear(valueOf(recording, "avg_time_to_collision"), (3.0 + 1.75 + 0.5) / 3.0));
    QVERIFY(isNear(valueOf(recording, "time_exposed_to_collision"), 1.25));
    QVERIFY(isNear(valueOf(recording, "time_integrated_to_collision"), 0.25 * 1.25));
  }

  void passing_distanceAndApproach() {
    SampledRun recording = recordingOfSamples({sampleAt(0, 0, 0, 0.5), sampleAt(1, 1, 0, 0.5)});
    recording.samples[0].people = {personAt(1, 1.5, 0, -0.25), personAt(2, 0, 30)};
    recording.samples[1].people = {personAt(1, 1.0, 2.5), personAt(2, 0, 3.5)};
    recording.samples[1].robot.omega = -2.0;
    // Person 1: gaps 1 and 2; person 2: 29.5 and sqrt(1 + 3.5^2) - 0.5.
    const double second = std::sqrt(1.0 + 3.5 * 3.5) - 0.5;
    QVERIFY(isNear(valueOf(recording, "avg_passing_distance"), (1.0 + second) / 2.0));
    QVERIFY(isNear(valueOf(recording, "max_approach_speed"), 0.75));
    QVERIFY(isNear(valueOf(recording, "max_lateral_acceleration"), 1.0));
  }

  void crowd_gridOfPeople_handCase() {
    // 21 x 21 people, 1 m apart: cells of 1 m2 inside; the middle one has 12 others within 2 m.
    SampledRun recording;
    Sample sample;
    for (int k = 0; k < 441; ++k) {
      const int row = k / 21;
      sample.people.push_back(personAt(k, k % 21, row, 0.5));
    }
    recording.samples = {sample};
    double classic = 0.0;
    for (const Pedestrian& person : sample.people) {
      for (const Pedestrian& other : sample.people) {
        const double reach = (person.position - other.position).squaredNorm();
        classic += reach <= 4.0 ? 1.0 : 0.0;
      }
    }
    QVERIFY(isNear(valueOf(recording, "crowd_density"), classic / 441.0 / (4.0 * base::kPi)));
    QCOMPARE(valueOf(recording, "crowd_polarisation"), 1.0);
    QCOMPARE(valueOf(recording, "crowd_lane_order"), 1.0);
    const double density = valueOf(recording, "crowd_voronoi_density");
    QVERIFY(isNear(valueOf(recording, "crowd_specific_flow"), 0.5 * density));
    // Inner cells 1 m2 each; those at the border are larger.
    QVERIFY(density > 361.0 / 441.0 && density < 1.0);
    recording.samples[0].people = {personAt(1, 0, 0)};  // alone: the whole circle
    QVERIFY(isNear(valueOf(recording, "crowd_voronoi_density"), 1.0 / (4.0 * base::kPi)));
    recording.samples[0].people.push_back(personAt(2, 0.5, 0));  // each a bit over half of it
    const double half = 2.0 * base::kPi;
    const double strip = 2.0 * 2.0 * 0.25;  // 0.25 m wide, nearly 4 m long
    QVERIFY(std::fabs(1.0 / valueOf(recording, "crowd_voronoi_density") - half - strip) < 0.02);
  }

  void crowd_lanes_ordered() {
    SampledRun recording;
    Sample sample;
    for (int k = 0; k < 10; ++k) {
      sample.people.push_back(personAt(k, k, k < 5 ? 0.0 : 3.0, k < 5 ? 1.0 : -1.0));
    }
    recording.samples = {sample};
    QCOMPARE(valueOf(recording, "crowd_lane_order"), 1.0);
    QVERIFY(isNear(valueOf(recording, "crowd_polarisation"), 0.0));
    for (Pedestrian& person : recording.samples[0].people) {
      person.position.y() = 0.0;
    }
    QCOMPARE(valueOf(recording, "crowd_lane_order"), 0.0);
  }

  /// Four people who walk away from each other at right angles: the sums of the main axis are 0, or
  /// of the size of rounding errors.
  void crowd_withoutMainAxis_hasNoLaneOrder() {
    for (const double turn : {0.0, 0.3}) {
      Sample sample;
      for (int k = 0; k < 4; ++k) {
        const double direction = turn + 0.5 * base::kPi * k;
        Pedestrian person = personAt(k, std::cos(direction), std::sin(direction), 1.0);
        person.velocity = {std::cos(direction), std::sin(direction)};
        sample.people.push_back(person);
      }
      SampledRun recording;
      recording.samples = {sample};
      QVERIFY(std::isnan(valueOf(recording, "crowd_lane_order")));
      recording.samples[0].people.pop_back();  // now most walk along one axis
      QVERIFY(!std::isnan(valueOf(recording, "crowd_lane_order")));
    }
  }

  void line_crossings_countedWithinTheEnds() {
    SampledRun recording;
    for (int k = 0; k < 5; ++k) {
      Sample sample;
      sample.time = k;
      sample.people = {personAt(1, -1.5 + k, 0.5), personAt(2, 1.5 - k, 0.2),
                       personAt(3, -1.5 + k, 4.0)};
      recording.samples.push_back(sample);
    }
    QVERIFY(std::isnan(valueOf(recording, "line_crossings")));
    MetricParameters parameters;
    parameters.flowLineY1 = -1.0;
    parameters.flowLineY2 = 1.0;
    QCOMPARE(valueOf(recording, "line_crossings", parameters), 2.0);
    QVERIFY(isNear(valueOf(recording, "line_flow", parameters), 2.0 / 4.0 / 2.0));
  }
};

QTEST_APPLESS_MAIN(HandCasesTest)
#include "tst_HandCases.moc"
