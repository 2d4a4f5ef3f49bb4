#include <algorithm>
#include <set>

#include <QtTest>

#include "HandMade.h"

using namespace metrics;
using namespace handmade;

class MoreMetricsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void registry_measures_areAtLeast64();
  void headingDisturbance_handCase();
  void formationSpace_handCase();
  void groupCrossings_throughAPair_isOne();
  void groupCrossings_throughATriangle_isOne();
  void reference_besideTheStraightWay();
  void reference_recordedRun_isUsed();
  void reference_longRun_isThinned();
  void topologicalComplexity_onceAround_isOneTurn();
  void events_replansAndArrivals_areCounted();
  void stoppedDistance_standing_isDistance();
  void timeToCollision_headOn_handCase();
  void passing_distanceAndApproach();
  void crowd_gridOfPeople_handCase();
  void crowd_lanes_ordered();
  void line_crossings_countedWithinTheEnds();
};

void MoreMetricsTest::registry_measures_areAtLeast64() {
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

void MoreMetricsTest::headingDisturbance_handCase() {
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

void MoreMetricsTest::formationSpace_handCase() {
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

void MoreMetricsTest::groupCrossings_throughAPair_isOne() {
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

void MoreMetricsTest::groupCrossings_throughATriangle_isOne() {
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

void MoreMetricsTest::reference_besideTheStraightWay() {
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

void MoreMetricsTest::reference_recordedRun_isUsed() {
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
void MoreMetricsTest::reference_longRun_isThinned() {
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

void MoreMetricsTest::topologicalComplexity_onceAround_isOneTurn() {
  std::vector<Sample> samples;
  for (int k = 0; k <= 12; ++k) {
    const double angle = 2.0 * base::kPi * k / 12.0;
    Sample sample = sampleAt(k, 2.0 * std::cos(angle), 2.0 * std::sin(angle));
    sample.people = {personAt(1, 0, 0), personAt(2, 50, 0)};
    samples.push_back(sample);
  }
  QVERIFY(isNear(valueOf(recordingOfSamples(samples), "topological_complexity"), 1.0));
}

void MoreMetricsTest::events_replansAndArrivals_areCounted() {
  SampledRun recording = recordingOfSamples({sampleAt(2, 0, 0), sampleAt(10, 1, 0)});
  const auto add = [&recording](double time, sim2d::EventKind kind, int id) {
    sim2d::Event event;
    event.kind = kind;
    event.id = id;
    recording.events.emplace_back(time, event);
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

void MoreMetricsTest::stoppedDistance_standing_isDistance() {
  SampledRun recording = recordingOfSamples(
      {sampleAt(0, 0, 0), sampleAt(1, 1, 0), sampleAt(2, 1.02, 0), sampleAt(3, 2, 0)});
  recording.goals = {{0, Vec2(5, 0), 0.2}};
  QVERIFY(isNear(valueOf(recording, "mean_dist_to_target_not_moving"), 3.98));
  recording.samples.erase(recording.samples.begin() + 2);
  QVERIFY(std::isnan(valueOf(recording, "mean_dist_to_target_not_moving")));
}

void MoreMetricsTest::timeToCollision_headOn_handCase() {
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

void MoreMetricsTest::passing_distanceAndApproach() {
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

void MoreMetricsTest::crowd_gridOfPeople_handCase() {
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

void MoreMetricsTest::crowd_lanes_ordered() {
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

void MoreMetricsTest::line_crossings_countedWithinTheEnds() {
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

QTEST_APPLESS_MAIN(MoreMetricsTest)
#include "tst_MoreMetrics.moc"
