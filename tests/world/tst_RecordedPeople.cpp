#include <algorithm>
#include <map>
#include <vector>

#include <QFileInfo>
#include <QtTest>

#include "sim2d/trace/TrackImport.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

constexpr int kSeen = 8, kWalked = 12;  // recorded steps
constexpr double kStep = 0.4;           // [s]
constexpr double kDt = 0.05;            // [s]
constexpr int kPerStep = 8;             // kStep / kDt
constexpr double kTooClose = 0.2;       // [m]

struct Person {
  std::vector<Vec2> places;  // of kSeen + kWalked steps
  Vec2 start() const { return places[kSeen - 1]; }
  Vec2 velocity() const { return (places[kSeen - 1] - places[kSeen - 2]) / kStep; }
  Vec2 end() const { return places.back(); }
  double speed() const { return (end() - start()).norm() / (kWalked * kStep); }
};
using Crowd = std::vector<Person>;

/// Those who are seen in every step of a window, for each window.
std::vector<Crowd> crowdsOf(const TrackFile& file) {
  std::map<long, Crowd> byStart;  // [ms]
  for (const Track& track : file.tracks) {
    const std::vector<TrackPoint>& points = track.points;
    for (std::size_t i = 0; i + kSeen + kWalked <= points.size(); ++i) {
      const double duration = points[i + kSeen + kWalked - 1].time - points[i].time;
      if (std::fabs(duration - (kSeen + kWalked - 1) * kStep) > 0.5 * kStep) {
        continue;
      }
      Person person;
      for (std::size_t k = i; k < i + kSeen + kWalked; ++k) {
        person.places.push_back(points[k].position);
      }
      byStart[std::lround(1000.0 * points[i].time)].push_back(std::move(person));
    }
  }
  std::vector<Crowd> crowds;
  crowds.reserve(byStart.size());
  for (auto& [start, crowd] : byStart) {
    crowds.push_back(std::move(crowd));
  }
  return crowds;
}

struct Score {
  double distance = 0.0;  // sum [m]
  int samples = 0;
  int close = 0;    // samples of people with somebody too close
  int walkers = 0;  // people in all crowds
  double mean() const { return distance / samples; }
};

/// Worlds begin at rest: the first step only brings everybody up to the own speed.
void walkOn(const std::string& model, const Crowd& crowd, Score& score) {
  Scenario scenario;
  scenario.desktop.model = model;
  scenario.desktop.dt = kDt;
  scenario.desktop.route = Route::Direct;
  for (std::size_t i = 0; i < crowd.size(); ++i) {
    const Person& person = crowd[i];
    const int id = static_cast<int>(i) + 1;
    addGoal(scenario, id, person.end().x(), person.end().y());
    const Vec2 v = person.velocity();
    Human& human =
        addPerson(scenario, id, person.start() - kDt * v, {id}, std::atan2(v.y(), v.x()));
    human.radius = 0.2;
    human.goalRadius = 0.1;
    human.maxVel = std::max(0.05, person.speed());
  }
  const auto world = make(scenario, [&](const WorldView& view, Intents& intents) {
    for (int human = 0; human < view.humanCount() && view.step() == 1; ++human) {
      const Vec2 v = crowd[static_cast<std::size_t>(human)].velocity();
      Intent& intent = intents.of(human);
      intent.motion = Motion::Walk;
      intent.speed = v.norm();
      intent.extraForce = 2000.0 * v;
    }
  });
  advance(*world, 1);
  for (std::size_t step = kSeen; step < kSeen + kWalked; ++step) {
    advance(*world, kPerStep);
    const Frame& frame = world->frame();
    for (std::size_t i = 0; i < crowd.size(); ++i) {
      score.distance += (positionOf(frame, i) - crowd[i].places[step]).norm();
      ++score.samples;
      bool isClose = false;
      for (std::size_t k = 0; k < crowd.size(); ++k) {
        isClose =
            isClose || (k != i && (positionOf(frame, i) - positionOf(frame, k)).norm() < kTooClose);
      }
      score.close += isClose ? 1 : 0;
    }
  }
  score.walkers += static_cast<int>(crowd.size());
}

Score scoreOf(const std::string& model, const std::vector<Crowd>& crowds) {
  Score score;
  for (const Crowd& crowd : crowds) {
    walkOn(model, crowd, score);
  }
  return score;
}

}  // namespace

/// Simulated people beside recorded ones: all who were seen for 20 steps of 0.4 s start as they
/// were after eight, know where they end and how fast they are on the way there, and walk the other
/// twelve. Measured is the mean distance to where the real ones were (ADE, with the goal known).
class RecordedPeopleTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void walk_asRecorded_staysNear() {
    const QString folder =
        qEnvironmentVariable("HUNAV_INTEROP_DIR", QStringLiteral(SOURCE_DIR "/../shared/interop")) +
        QStringLiteral("/trajectories/");
    struct Set {
      const char* name;
      int people;              // of all windows
      double ofDas, ofOthers;  // ADE of das and orca in independent programs [m]
    };
    double meanOfSfm = 0.0;
    double meanOfDas = 0.0;
    for (const Set& set : {Set{"eth", 2614, 0.202, 0.192}, Set{"hotel", 1197, 0.096, 0.081},
                           Set{"zara01", 2234, 0.165, 0.160}}) {
      const QString path = folder + QString::fromUtf8(set.name) + QStringLiteral("/obsmat.txt");
      if (!QFileInfo::exists(path)) {
        QSKIP("the recordings are not there");
      }
      const base::Result<TrackFile> file = importTracks(path.toStdString(), {});
      QVERIFY(file);
      const std::vector<Crowd> crowds = crowdsOf(*file);
      const Score sfm = scoreOf("sfm", crowds);
      const Score das = scoreOf("das", crowds);
      const Score orca = scoreOf("orca", crowds);
      qInfo("%s: ADE of sfm %.3f, das %.3f, orca %.3f m", set.name, sfm.mean(), das.mean(),
            orca.mean());
      QCOMPARE(das.walkers, set.people);
      QVERIFY(std::fabs(das.mean() - set.ofDas) < 0.01);
      QVERIFY(std::fabs(orca.mean() - set.ofOthers) < 0.01);
      for (const Score& score : {sfm, das, orca}) {
        QVERIFY(score.close <= 0.001 * score.samples);
      }
      meanOfSfm += sfm.mean() / 3.0;
      meanOfDas += das.mean() / 3.0;
    }
    QVERIFY(meanOfDas <= 0.17);
    QVERIFY(meanOfDas <= meanOfSfm - 0.02);
  }
};

QTEST_APPLESS_MAIN(RecordedPeopleTest)
#include "tst_RecordedPeople.moc"
