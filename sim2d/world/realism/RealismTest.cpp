#include "sim2d/world/realism/RealismTest.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <set>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {
namespace {

constexpr int kMaxAttempts = 20000;     // for one random place
constexpr double kBeyondRing = 8.0;     // [m]; length of walls beyond the ends
constexpr double kHalfThickness = 0.1;  // [m], of walls

/// Behaviour in which each person walks to the target of its actor.
class TargetBehavior : public HumanBehavior {
 public:
  explicit TargetBehavior(const std::vector<TestScene::Actor>& actors) : actors_(actors) {}

  void enter(int /*human*/, const WorldView& /*view*/) override {}
  void decide(const WorldView& view, Intents& intents) override {
    for (int human = 0; human < view.humanCount(); ++human) {
      const TestScene::Actor& actor = actors_[static_cast<std::size_t>(human)];
      const Vec2 place = view.pose(human).position;
      Intent& intent = intents.of(human);
      intent.motion = Motion::Walk;
      intent.speed = actor.speed;
      intent.target = {0, actor.target(place), 0.1};
      if (actor.isDone && view.isPresent(human) && actor.isDone(place)) {
        intents.emit({EventKind::Arrived, view.constants(human).id, true, 0, false, {}});
      }
    }
  }

 private:
  const std::vector<TestScene::Actor>& actors_;
};

}  // namespace

TestScene::TestScene(RealismRun run, double dt) : run_(std::move(run)), dt_(dt) {
  scenario_.desktop.model = run_.model;
  scenario_.desktop.seed = run_.seed;
  scenario_.desktop.dt = dt_;
  scenario_.desktop.route = Route::Direct;
}

void TestScene::add(Actor actor) {
  Human human;
  human.id = static_cast<int>(actors_.size()) + 1;
  human.name = "walker" + std::to_string(human.id);
  human.initPose = {actor.start, actor.heading};
  human.maxVel = actor.speed;
  human.radius = actor.radius;
  human.groupId = actor.group;
  human.cyclicGoals = false;
  human.ours.atEnd = AtEnd::Leave;
  scenario_.humans.push_back(std::move(human));
  actors_.push_back(std::move(actor));
}

void TestScene::addWall(const std::vector<Vec2>& line) {
  Obstacle wall;
  wall.name = "wall" + std::to_string(scenario_.obstacles.size() + 1);
  wall.kind = ObstacleKind::Wall;
  wall.points = line;
  wall.thickness = 0.2;
  scenario_.obstacles.push_back(std::move(wall));
}

void TestScene::addRing(double width) {
  for (const double y : {-kHalfThickness, width + kHalfThickness}) {
    addWall({Vec2(-kBeyondRing, y), Vec2(kRingLength + kBeyondRing, y)});
  }
  scenario_.desktop.wrapX = {0.0, kRingLength};
}

std::unique_ptr<World> TestScene::build() const {
  WorldSetup setup;
  setup.scenario = std::make_shared<const Scenario>(scenario_);
  setup.behavior = std::make_unique<TargetBehavior>(actors_);
  base::Result<std::unique_ptr<World>> world = World::create(std::move(setup));
  if (world) {
    return *std::move(world);
  }
  std::string problem;
  for (const base::Diagnostic& diagnostic : world.diagnostics()) {
    problem = diagnostic.severity == base::Severity::Error ? diagnostic.text() : problem;
  }
  throw SceneFailed{base::error("run.not-played", {problem})};
}

void TestScene::play(double seconds, const Look& look) const {
  const std::unique_ptr<World> world = build();
  const auto steps = static_cast<std::int64_t>(std::llround(seconds / dt_));
  while (world->stepIndex() < steps) {
    if (run_.wantsStop && run_.wantsStop()) {
      throw SceneFailed{base::error("run.not-played", {"interrupted"})};
    }
    if (!world->step()) {
      throw SceneFailed{base::error("run.not-played", {world->failure()})};
    }
    if (!look(*world)) {
      return;
    }
  }
}

Scenario TestScene::scenario(const std::string& name, double duration) const {
  Scenario result = scenario_;
  result.yamlBaseName = name;
  result.desktop.mapFile = "none";
  result.desktop.duration = duration;
  result.desktop.route = result.desktop.wrapX.empty() ? Route::Planned : Route::Direct;
  for (std::size_t i = 0; i < actors_.size(); ++i) {
    const Vec2 place = actors_[i].goal.value_or(actors_[i].target(actors_[i].start));
    const auto known = std::find_if(result.goals.begin(), result.goals.end(),
                                    [&](const GlobalGoal& goal) { return goal.position == place; });
    const auto id = static_cast<int>(known - result.goals.begin()) + 1;
    if (known == result.goals.end()) {
      GlobalGoal goal;
      goal.id = id;
      goal.position = place;
      result.goals.push_back(goal);
    }
    result.humans[i].goals = {id};
    result.humans[i].goalRadius = actors_[i].goalRadius;
  }
  return result;
}

/// In the scenario file, neighbours share a goal far enough behind the end of the ring that their
/// paths are nearly straight.
TestScene::Actor ringWalker(const Vec2& start, double speed, bool goesLeft) {
  constexpr double kRow = 0.5;  // [m]
  const Vec2 goal(goesLeft ? -20.0 : 46.0, (std::floor(start.y() / kRow) + 0.5) * kRow);
  TestScene::Actor actor{start, speed, endlessTarget(Vec2(goesLeft ? -1.0 : 1.0, 0.0)), goal};
  actor.heading = goesLeft ? base::kPi : 0.0;
  return actor;
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): false positive with std::function

TestScene::Target endlessTarget(const Vec2& direction) {
  return [direction](const Vec2& place) { return Vec2(place + 1000.0 * direction); };
}

TestScene::Target constantTarget(const Vec2& place) {
  return [place](const Vec2& /*from*/) { return place; };
}

double freeSpeed(const RealismRun& run, int person, double mean, double deviation) {
  const base::AgentRng rng(static_cast<std::uint64_t>(run.seed), person);
  return std::clamp(rng.normal(mean, deviation, base::DrawPurpose::Test), 0.5, 2.2);
}

std::vector<Vec2> randomPlaces(const RealismRun& run, int count, const Box& box, double apart,
                               bool isClosed) {
  const Vec2 size = box.high - box.low;
  const PeriodicCorridor ring{box.low.x(), isClosed ? size.x() : 0.0};
  std::vector<Vec2> places;
  for (int person = 0; person < count; ++person) {
    const base::AgentRng rng(static_cast<std::uint64_t>(run.seed), person);
    for (std::uint32_t attempt = 0; attempt < kMaxAttempts; ++attempt) {
      const double u = rng.uniform01(base::DrawPurpose::Placement, 2 * attempt);
      const double v = rng.uniform01(base::DrawPurpose::Placement, 2 * attempt + 1);
      const Vec2 place = box.low + Vec2(u * size.x(), v * size.y());
      const bool isFree = std::none_of(places.begin(), places.end(), [&](const Vec2& other) {
        return (other + ring.shift(other, place) - place).norm() < apart;
      });
      if (isFree) {
        places.push_back(place);
        break;
      }
    }
  }
  return places;
}

namespace fs = std::filesystem;

void addAllRealismTests(
    std::vector<RealismTest>& to);  // generated by CMake from the …Tests.cpp here

double Quantity::summaryOf(const std::vector<double>& values) const {
  const bool isMissing =
      values.empty() || std::any_of(values.begin(), values.end(), [](double v) { return v != v; });
  if (isMissing) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  switch (summary) {
    case Summary::Smallest:
      return *std::min_element(values.begin(), values.end());
    case Summary::Largest:
      return *std::max_element(values.begin(), values.end());
    case Summary::Mean:
      break;
  }
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

base::Result<std::vector<double>> RealismTest::measure(const RealismRun& run) const {
  try {
    return play(run);
  } catch (const SceneFailed& problem) {
    return problem.why;
  }
}

const std::vector<RealismTest>& realismTests() {
  static const std::vector<RealismTest> kTests = [] {
    std::vector<RealismTest> tests;
    addAllRealismTests(tests);
    return tests;
  }();
  return kTests;
}

std::string sceneName(const RealismTest& test) {
  std::string name = "realism_" + test.name + "_agents";
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

Scenario sceneOf(const RealismTest& test) {
  return test.scene({"das", 1, {}}).scenario(sceneName(test), test.duration);
}

base::Diagnostics writeScenes(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  base::Diagnostics problems;
  std::set<fs::path> written;
  for (const RealismTest& test : realismTests()) {
    const fs::path path = fs::path(folder) / (sceneName(test) + ".yaml");
    base::append(problems, base::writeFileAtomically(path.string(), writeScenario(sceneOf(test))));
    written.insert(path);
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (written.count(entry.path()) == 0) {
      fs::remove(entry.path(), error);
    }
  }
  return problems;
}

}  // namespace sim2d
