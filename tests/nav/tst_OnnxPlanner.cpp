#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/nav/onnx/PolicyNetwork.h"
#include "tests/nav/ExternalScene.h"
#include "tests/nav/OnnxFile.h"
#include "tests/nav/PlannerFunctions.h"

using namespace external;

namespace {

std::string stateMetadata(int repeat = 1) {
  return onnxfile::metadataOf(0, 0, 0, repeat);
}

base::Diagnostics problemsOf(const std::string& model) {
  return readPolicyMetadata(model, "policy.onnx").diagnostics();
}

std::string codesOf(const base::Diagnostics& problems) {
  std::vector<std::string> codes;
  for (const base::Diagnostic& problem : problems) {
    codes.emplace_back(problem.code);
  }
  return base::join(codes, " ");
}

}  // namespace

class OnnxPlannerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void metadata_good_isRead() {
    const auto read = parsePolicyMetadata(
        R"({"format": 1, "people": 3, "beams": 90, "grid_cells": 20, "grid_resolution": 0.25,
            "repeat": 4, "dt": 0.02, "actions": 3})",
        "policy.onnx");
    QVERIFY2(read, messageOf(read.diagnostics()));
    QCOMPARE(read->sizes.people, std::size_t{3});
    QCOMPARE(read->sizes.beams, std::size_t{90});
    QCOMPARE(read->sizes.gridCells, std::size_t{20});
    QCOMPARE(read->sizes.gridResolution, 0.25);
    QCOMPARE(read->repeat, 4);
    QCOMPARE(read->dt, 0.02);
    QCOMPARE(read->actions, 3);
  }

  void metadata_wrong_isAnError_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("codes");
    const auto row = [](const char* name, const char* from, const char* to, const char* codes) {
      QTest::newRow(name) << from << to << codes;
    };
    row("no JSON", "}", "", "onnx.not-json");
    row("another format", R"("format": 1)", R"("format": 2, "more": 1)", "onnx.wrong-format");
    row("format as text", R"("format": 1)", R"("format": "1")", "onnx.wrong-type");
    row("unknown key", R"("repeat")", R"("personal": "x", "repeat")", "onnx.unknown-key");
    row("misspelt key", R"("repeat")", R"("repeats")", "onnx.no-key onnx.unknown-key");
    row("no integer", R"("people": 0)", R"("people": 1.5)", "onnx.wrong-type");
    row("no number", R"("grid_resolution": 0.5)", R"("grid_resolution": null)", "onnx.wrong-type");
    row("negative", R"("beams": 0)", R"("beams": -1)", "onnx.out-of-range");
    row("two", R"("repeat": 1, "dt": 0.05, "actions": 2)",
        R"("repeat": 0, "dt": 0.05, "actions": 4)", "onnx.out-of-range onnx.out-of-range");
  }
  void metadata_wrong_isAnError() {
    QFETCH(const QString, from);
    QFETCH(const QString, to);
    QFETCH(const QString, codes);
    const QString good = QString::fromStdString(stateMetadata());
    QString text = good;
    text.replace(from, to);
    QVERIFY(text != good);
    const auto read = parsePolicyMetadata(text.toStdString(), "policy.onnx");
    QCOMPARE(QString::fromStdString(codesOf(read.diagnostics())), codes);
    QCOMPARE(read.diagnostics().front().file, std::string("policy.onnx"));
  }

  /// The library would exhaust the stack when it writes such a value.
  void metadata_deep_isAnError() {
    for (const std::size_t depth : {10U, 1000U, 1000000U}) {
      std::string text = stateMetadata();
      text.replace(text.find(": 0"), 3, ": " + std::string(depth, '[') + std::string(depth, ']'));
      QVERIFY(base::hasErrors(parsePolicyMetadata(text, "policy.onnx").diagnostics()));
    }
  }

  void model_withoutMetadata_isAnError() {
    const std::string graph = onnxfile::towardsGoal().graph();
    QCOMPARE(codesOf(problemsOf(onnxfile::model(graph, stateMetadata()))), std::string());
    QCOMPARE(codesOf(problemsOf(onnxfile::model(graph, {}, {}))), std::string("onnx.no-metadata"));
    for (const char* text : {"", "no ONNX file\n", "\x08\x07"}) {
      QCOMPARE(codesOf(problemsOf(text)), std::string("onnx.no-onnx"));
    }
  }

  void model_cut_isAnErrorAtEachLength() {
    const std::string model = onnxfile::model(onnxfile::towardsGoal().graph(), stateMetadata());
    for (std::size_t size = 0; size < model.size(); ++size) {
      QVERIFY2(base::hasErrors(problemsOf(model.substr(0, size))),
               qPrintable(QString::number(size)));
    }
  }

  void model_otherTensors_areErrors() {
    onnxfile::LinearPolicy policy = onnxfile::towardsGoal();
    const auto codes = [&](const std::string& metadata) {
      return codesOf(problemsOf(onnxfile::model(policy.graph(), metadata)));
    };
    QCOMPARE(codes(onnxfile::metadataOf(2, 0, 0, 1)), std::string("onnx.no-input"));
    QCOMPARE(codes(onnxfile::metadataOf(0, 0, 0, 1, 3)), std::string("onnx.wrong-shape"));
    policy.outputShape = {0, 2};  // any batch
    policy.inputs = {{"state", {0, 5}}};
    QCOMPARE(codes(stateMetadata()), std::string());
    policy.inputs = {{"state", {1, 6}}};
    QCOMPARE(codes(stateMetadata()), std::string("onnx.wrong-shape"));
    policy.inputs = {{"state", {1, 5}}, {"camera", {1, 9}}};
    QCOMPARE(codes(stateMetadata()), std::string("onnx.unknown-input"));
    policy.inputs = {{"state", {1, 5}}};
    std::string graph = policy.graph();
    const std::string input = onnxfile::bytes(11, onnxfile::declared(policy.inputs.front()));
    const std::size_t place = graph.find(input);
    QVERIFY(place != std::string::npos);
    const std::size_t type = graph.find("\x08\x01\x12", place);  // elem_type 1, then the shape
    graph[type + 1] = '\x0B';                                    // 11: DOUBLE
    const base::Diagnostics ofType = problemsOf(onnxfile::model(graph, stateMetadata()));
    QCOMPARE(codesOf(ofType), std::string("onnx.wrong-element-type"));
    QVERIFY2(messageOf(ofType).contains("'state'") && messageOf(ofType).contains("float64"),
             messageOf(ofType));
    policy.output = "value";
    QCOMPARE(codes(stateMetadata()), std::string("onnx.wrong-output"));
  }

  void make_badFiles_tellsWhy() {
    QCOMPARE(codesOf(make({}).diagnostics()), std::string("onnx.no-file"));
    const auto gone = makeFrom("gone.onnx");
    QVERIFY2(base::hasErrors(gone.diagnostics()) &&
                 messageOf(gone.diagnostics()).contains("/gone.onnx: "),
             messageOf(gone.diagnostics()));
    QCOMPARE(codesOf(make("version https://git-lfs.github.com/spec/v1\n").diagnostics()),
             std::string("file.lfs-pointer"));
    QCOMPARE(codesOf(make("text").diagnostics()), std::string("onnx.no-onnx"));
  }

  void make_otherRobot_isAnError() {
    NEED_OPENCV();
    onnxfile::LinearPolicy policy = onnxfile::towardsGoal();
    policy.inputs.push_back({"lidar", {1, 2}});
    policy.outputShape = {1, 3};
    policy.rows.assign(3, std::vector<float>(7, 0.0F));
    policy.offsets = {0.0F, 0.0F, 9.0F};
    const std::string model = onnxfile::model(policy.graph(), onnxfile::metadataOf(0, 2, 0, 1, 3));
    const auto plain = make(model);
    QCOMPARE(codesOf(plain.diagnostics()), std::string("onnx.no-lidar onnx.not-omnidirectional"));
    QVERIFY(messageOf(plain.diagnostics()).startsWith("robot 'amy': "));
    PlannerSetup setup = setupOf();
    setup.hasLidar = true;
    setup.body.kinematics = Kinematics::Omnidirectional;
    const auto made = make(model, setup);
    QVERIFY2(made, messageOf(made.diagnostics()));
    QVERIFY((*made)->readsScan());
    const Scene scene;
    const auto command = (*made)->command(scene.observation);
    QVERIFY(command && (*command == BodyTwist{0.0, 0.0, 0.8}));  // clipped
  }

  void command_linearPolicy_isTheProductByHand() {
    NEED_OPENCV();
    const auto made = make(onnxfile::model(onnxfile::towardsGoal().graph(), stateMetadata()));
    QVERIFY2(made, messageOf(made.diagnostics()));
    QVERIFY(!(*made)->readsScan());
    Scene scene;  // goal (4, 1), robot at the origin
    const auto first = (*made)->command(scene.observation);
    QVERIFY(first && (*first == BodyTwist{0.5625, 0.25, 0.0}));
    scene.observation.goal = {40.0, -16.0};
    const auto clipped = (*made)->command(scene.observation);
    QVERIFY(clipped && (*clipped == BodyTwist{0.8, -1.5, 0.0}));
    scene.observation.goal = {-40.0, 16.0};
    const auto back = (*made)->command(scene.observation);
    QVERIFY(back && (*back == BodyTwist{-1.0, 1.5, 0.0}));
  }

  void command_allInputs_arriveInTheirPlaces() {
    NEED_OPENCV();
    onnxfile::LinearPolicy policy;  // 5 + 2 * 5 + 4 + 2 * 2 values
    policy.inputs = {
        {"state", {1, 5}}, {"people", {1, 2, 5}}, {"lidar", {1, 4}}, {"grid", {1, 1, 2, 2}}};
    policy.rows.assign(2, std::vector<float>(23, 0.0F));
    policy.offsets = {0.0F, 0.0F};
    policy.rows[0][5 + 3] = -1.0F;     // vy of the nearest person: -0.5 m/s
    policy.rows[0][15 + 2] = 0.0625F;  // the beam ahead: 3 m
    policy.rows[1][4] = 1.0F;          // omega of the robot: 0.25 rad/s
    policy.rows[1][19 + 3] = 0.5F;     // ahead to the left: occupied by the block
    policy.rows[1][19 + 1] = 100.0F;   // behind to the left: free
    PlannerSetup setup = setupOf();
    setup.hasLidar = true;
    const auto made =
        make(onnxfile::model(policy.graph(), onnxfile::metadataOf(2, 4, 2, 1)), setup);
    QVERIFY2(made, messageOf(made.diagnostics()));
    Scene scene;
    scene.observation.pose = {{2.0, 3.0}, 0.0};
    scene.observation.motion.angular = 0.25;
    LaserScan scan;
    scan.angleMin = -base::kPi;
    scan.angleIncrement = base::kPi / 2.0;
    scan.distances = {1.0, 2.0, 3.0, 4.0};
    scene.observation.scan = &scan;
    const auto command = (*made)->command(scene.observation);
    QVERIFY2(command, messageOf(command.diagnostics()));
    QCOMPARE(command->linear, 0.6875);
    QCOMPARE(command->angular, 0.75);
  }

  void command_repeat_holdsTheCommand() {
    NEED_OPENCV();
    const auto made = make(onnxfile::model(onnxfile::towardsGoal().graph(), stateMetadata(3)));
    QVERIFY2(made, messageOf(made.diagnostics()));
    Scene scene;
    std::vector<double> speeds;
    for (int step = 0; step < 5; ++step) {
      const auto command = (*made)->command(scene.observation);
      QVERIFY(command);
      speeds.push_back(command->linear);
      scene.observation.goal.x() -= 0.5;
    }
    QCOMPARE(speeds, std::vector<double>({0.5625, 0.5625, 0.5625, 0.375, 0.375}));
  }

  void command_otherTimeStep_isHeldForTheSameTime() {
    NEED_OPENCV();
    for (const auto& [dt, steps] : {std::pair{0.01, 15}, {0.05, 3}, {0.1, 2}, {0.5, 1}}) {
      const auto made = make(onnxfile::model(onnxfile::towardsGoal().graph(), stateMetadata(3)));
      QVERIFY2(made, messageOf(made.diagnostics()));
      Scene scene;  // the policy decides every 3 * 0.05 s
      scene.observation.dt = dt;
      int held = 0;
      for (; held < 100; ++held) {
        const auto command = (*made)->command(scene.observation);
        QVERIFY(command);
        if (command->linear != 0.5625) {
          break;
        }
        scene.observation.goal.x() = 0.0;
      }
      QCOMPARE(held, steps);
    }
  }

  void network_brokenGraph_isAnErrorWithTheFile() {
    NEED_OPENCV();
    onnxfile::LinearPolicy policy = onnxfile::towardsGoal();
    std::string graph = policy.graph();
    graph.replace(graph.find("Gemm"), 4, "Gexx");
    const auto unknown = make(onnxfile::model(graph, stateMetadata()));
    QCOMPARE(codesOf(unknown.diagnostics()), std::string("onnx.not-loaded"));
    QVERIFY2(messageOf(unknown.diagnostics()).contains("/policy.onnx: OpenCV cannot read"),
             messageOf(unknown.diagnostics()));
    policy.offsets[1] = std::numeric_limits<float>::quiet_NaN();
    QCOMPARE(codesOf(make(onnxfile::model(policy.graph(), stateMetadata())).diagnostics()),
             std::string("onnx.not-finite"));
    policy = onnxfile::towardsGoal();
    policy.rows.push_back(policy.rows.front());  // three values, which the file does not declare
    policy.offsets.push_back(0.0F);
    QCOMPARE(codesOf(make(onnxfile::model(policy.graph(), stateMetadata())).diagnostics()),
             std::string("onnx.not-run"));
  }

  void drive_twice_givesEqualBytes() {
    NEED_OPENCV();
    onnxfile::LinearPolicy policy = onnxfile::towardsGoal();
    policy.rows = {{0.3F, 0.0F, 0.0F, 0.0F, 0.0F}, {0.0F, 1.7F, 0.0F, 0.0F, -0.1F}};
    policy.offsets = {0.3F, 0.0F};
    const std::string model = onnxfile::model(policy.graph(), stateMetadata());
    const auto first = make(model);
    const auto second = make(model);
    QVERIFY(first && second);
    const Drive one = external::drive(**first, 200);
    QVERIFY(one.problems.empty() && one.commands.size() > 100);
    QCOMPARE(external::drive(**second, 200).commands, one.commands);
  }

 private:
  base::Result<std::shared_ptr<Planner>> makeFrom(const char* file,
                                                  PlannerSetup setup = setupOf()) {
    PlannerRegistry registry;
    addOnnx(registry);
    setup.code = ExternalCodePolicy::Refused;  // a network is data
    setup.folder = folder_.path().toStdString();
    setup.texts = {{"file", file}};
    return registry.find("onnx")->make(setup);
  }

  /// Of a file with these bytes; empty: without a file.
  base::Result<std::shared_ptr<Planner>> make(const std::string& model,
                                              const PlannerSetup& setup = setupOf()) {
    QFile file(folder_.filePath(QStringLiteral("policy.onnx")));
    if (!file.open(QIODevice::WriteOnly) ||
        file.write(model.data(), static_cast<qint64>(model.size())) < 0) {
      return base::error("file.cannot-write", {"?"});
    }
    file.close();
    return makeFrom(model.empty() ? "" : "policy.onnx", setup);
  }

  QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(OnnxPlannerTest)
#include "tst_OnnxPlanner.moc"
