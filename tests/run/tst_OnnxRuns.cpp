#include <cmath>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <QTemporaryDir>
#include <QtTest>

#include "app/python/CrowdEnvironment.h"
#include "app/run/Bundle.h"
#include "app/run/PlannerFiles.h"
#include "tests/nav/OnnxFile.h"

namespace {

constexpr int kBeams = 36;
constexpr std::uint64_t kSeed = 7;
const base::Vec2 kGoal(8.0, 1.0);

sim2d::Human walker(int id, const base::Vec2& start, int goal) {
  sim2d::Human human;
  human.key = {base::EntityKind::Human, id};
  human.id = id;
  human.name = "person" + std::to_string(id);
  human.initPose = {start, 0.0};
  human.goals = {goal};
  return human;
}

/// A robot that sees as the environment does, and two people who cross its way.
sim2d::Scenario crossing(int beams) {
  sim2d::Scenario scenario;
  for (int id = 1; id <= 2; ++id) {
    sim2d::GlobalGoal goal;
    goal.key = {base::EntityKind::Goal, id};
    goal.id = id;
    goal.position = {2.0 * id, id == 1 ? 6.0 : -6.0};
    scenario.goals.push_back(goal);
  }
  scenario.humans = {walker(1, {2.0, -3.0}, 1), walker(2, {5.0, 4.0}, 2)};
  sim2d::Robot robot;
  robot.key = {base::EntityKind::Robot, 1};
  robot.name = "amy";
  robot.goal.point = kGoal;
  robot.lidar.beams = beams;
  robot.lidar.range = 10.0;
  robot.lidar.rate = 20.0;  // one scan per step
  robot.lidar.noise = robot.lidar.x = robot.lidar.y = robot.lidar.h = 0.0;
  robot.detector.kind = sim2d::DetectorKind::GroundTruth;
  robot.planner = "onnx";
  robot.plannerParameters = {{"file", "policy.onnx"}};
  scenario.robots = {robot};
  return scenario;
}

/// Weights that make it turn with what the people and the lidar say.
onnxfile::LinearPolicy curvingPolicy(int beams) {
  onnxfile::LinearPolicy policy;
  policy.inputs.push_back({"people", {1, 3, 5}});
  std::size_t size = 20;
  if (beams > 0) {
    policy.inputs.push_back({"lidar", {1, static_cast<std::uint64_t>(beams)}});
    size += static_cast<std::size_t>(beams);
  }
  policy.rows.assign(2, std::vector<float>(size, 0.0F));
  policy.offsets = {0.1F, 0.25F};
  policy.rows[0][0] = 0.06F;
  policy.rows[0][2] = -0.1F;
  policy.rows[1][1] = 0.4F;
  policy.rows[1][4] = 0.2F;
  for (std::size_t i = 5; i < size; ++i) {
    policy.rows[1][i] = 0.01F * static_cast<float>(i % 7) - 0.03F;
  }
  return policy;
}

/// The actions of the policy, added up here.
std::vector<float> actionOf(const onnxfile::LinearPolicy& policy,
                            const python::Observations& seen) {
  std::vector<float> values = seen.state;
  values.insert(values.end(), seen.people.begin(), seen.people.end());
  values.insert(values.end(), seen.lidar.begin(), seen.lidar.end());
  std::vector<float> action;
  for (std::size_t k = 0; k < policy.rows.size(); ++k) {
    auto sum = static_cast<double>(policy.offsets[k]);
    for (std::size_t i = 0; i < values.size(); ++i) {
      sum += static_cast<double>(policy.rows[k][i]) * static_cast<double>(values[i]);
    }
    action.push_back(static_cast<float>(sum));
  }
  return action;
}

std::string textOf(const base::Diagnostics& problems) {
  std::string text;
  for (const base::Diagnostic& problem : problems) {
    text += std::string(problem.code) + ": " + problem.text() + "\n";
  }
  return text;
}

}  // namespace

/// The planner `onnx` in whole runs.
class OnnxRunsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void run_policy_drivesAsInTheEnvironment_data() {
    QTest::addColumn<int>("beams");
    QTest::addColumn<int>("repeat");
    QTest::newRow("each step, with a lidar") << kBeams << 1;
    QTest::newRow("each third step") << 0 << 3;
  }
  void run_policy_drivesAsInTheEnvironment() {
    QFETCH(const int, beams);
    QFETCH(const int, repeat);
    NEED_OPENCV();
    const onnxfile::LinearPolicy policy = curvingPolicy(beams);
    writePolicy(policy, onnxfile::metadataOf(3, static_cast<std::size_t>(beams), 0, repeat));
    python::EnvironmentOptions options;
    options.people = 3;
    options.beams = beams;
    options.repeat = repeat;
    python::CrowdEnvironment environment(bundleOf(crossing(beams)), options);
    QVERIFY2(!base::hasErrors(environment.problems()), textOf(environment.problems()).c_str());
    environment.reset(kSeed);
    sim2d::Scenario scenario = crossing(beams);
    scenario.desktop.seed = static_cast<long long>(kSeed * 1'000'003 + 1);  // of the first episode
    const app::Verdict verdict = app::check(bundleOf(scenario));
    QVERIFY2(verdict.world != nullptr, textOf(verdict.problems).c_str());
    bool hasTurned = false;
    for (int decision = 0; decision < 90 / repeat; ++decision) {
      const base::Pose2 pose = verdict.world->view().robotPose(0);
      const base::Vec2 goal = pose.toLocal(kGoal);
      const std::vector<float>& state = environment.observations().state;
      QVERIFY2(std::fabs(state[0] - goal.x()) < 1e-5 && std::fabs(state[1] - goal.y()) < 1e-5,
               qPrintable(QStringLiteral("decision %1: (%2, %3), not (%4, %5)")
                              .arg(decision)
                              .arg(goal.x())
                              .arg(goal.y())
                              .arg(static_cast<double>(state[0]))
                              .arg(static_cast<double>(state[1]))));
      hasTurned = hasTurned || std::fabs(pose.heading) > 0.1;
      environment.step(actionOf(policy, environment.observations()).data(), 2);
      for (int i = 0; i < repeat; ++i) {
        QVERIFY(verdict.world->step());
      }
    }
    QVERIFY(hasTurned);
    QVERIFY(verdict.world->view().robotPose(0).position.x() > 1.0);
  }

  void check_policyThatDoesNotFit_isAProblem() {
    NEED_OPENCV();
    writePolicy(curvingPolicy(kBeams), onnxfile::metadataOf(3, kBeams, 0, 1));
    const app::Verdict verdict = app::check(bundleOf(crossing(0)));
    QVERIFY(verdict.world == nullptr);
    QVERIFY2(textOf(verdict.problems).find("onnx.no-lidar") != std::string::npos,
             textOf(verdict.problems).c_str());
    QVERIFY(verdict.problems.back().entity == (base::EntityId{base::EntityKind::Robot, 1}));
  }

  void inputs_policy_isAFileThatIsRead() {
    const sim2d::Scenario scenario = crossing(0);
    QCOMPARE(app::filesThatPlannersRead(scenario, "/some/where/scenario.yaml"),
             std::vector<std::string>{"/some/where/policy.onnx"});
    QVERIFY(app::externalCodeOf(scenario).empty());  // it is not code
  }

 private:
  std::string pathOf(const char* name) const {
    return folder_.filePath(QString::fromUtf8(name)).toStdString();
  }

  void writePolicy(const onnxfile::LinearPolicy& policy, const std::string& metadata) const {
    std::ofstream(pathOf("policy.onnx"), std::ios::binary)
        << onnxfile::model(policy.graph(), metadata);
  }

  app::Bundle bundleOf(const sim2d::Scenario& scenario) const {
    app::Bundle bundle;
    bundle.path = pathOf("scenario.yaml");
    bundle.scenario = std::make_shared<const sim2d::Scenario>(scenario);
    bundle.map = std::make_shared<const sim2d::OccupancyGrid>();
    return bundle;
  }

  QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(OnnxRunsTest)
#include "tst_OnnxRuns.moc"
