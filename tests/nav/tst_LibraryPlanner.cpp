#include <cstring>
#include <dlfcn.h>
#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/external/LibraryPlanner.h"
#include "tests/nav/ExternalScene.h"
#include "tests/nav/PlannerFunctions.h"

using namespace external;

namespace {

const char* const kExample = EXAMPLE_PLANNERS "/library.so";
const char* const kFaulty = EXAMPLE_PLANNERS "/faulty_planner.so";

base::Result<std::shared_ptr<Planner>> faulty(const char* robot) {
  return makeLibraryPlanner(setupOf(robot), kFaulty);
}

/// The faulty library once more, for what it notes.
class FaultyNotes {
 public:
  FaultyNotes() : handle_(::dlopen(kFaulty, RTLD_NOW | RTLD_LOCAL)) {}
  ~FaultyNotes() {
    if (handle_ != nullptr) {
      ::dlclose(handle_);
    }
  }
  FaultyNotes(const FaultyNotes&) = delete;
  FaultyNotes& operator=(const FaultyNotes&) = delete;
  FaultyNotes(FaultyNotes&&) = delete;
  FaultyNotes& operator=(FaultyNotes&&) = delete;

  QByteArray lastSeen() const {
    return reinterpret_cast<const char* (*)()>(::dlsym(handle_, "faulty_last_seen"))();
  }
  int alive() const { return reinterpret_cast<int (*)()>(::dlsym(handle_, "faulty_alive"))(); }

 private:
  void* handle_;
};

#define NEED_LIBRARY(name)                                   \
  if (!QFile::exists(QString::fromLatin1(name))) {           \
    QSKIP("the libraries of the tests have not been built"); \
  }

}  // namespace

class LibraryPlannerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void make_withoutPermission_isRefused() {
    const auto made = makeLibraryPlanner(refusedSetup(), kExample);
    QCOMPARE(codeOf(made.diagnostics()), std::string("library.not-allowed"));
    QVERIFY(messageOf(made.diagnostics()).contains("--allow-code"));
  }

  void make_noLibrary_tellsWhy() {
    const auto none = makeLibraryPlanner(setupOf(), "");
    QCOMPARE(codeOf(none.diagnostics()), std::string("library.no-file"));
    for (const char* file : {"/no/such/library.so", SOURCE_DIR "/README.md"}) {
      const auto made = makeLibraryPlanner(setupOf(), file);
      QCOMPARE(codeOf(made.diagnostics()), std::string("library.not-loaded"));
      QVERIFY2(messageOf(made.diagnostics()).contains(file), messageOf(made.diagnostics()));
      QVERIFY(messageOf(made.diagnostics()).startsWith("robot 'amy': "));
    }
  }

  void make_missingFunctions_tellsEach() {
    const auto made = makeLibraryPlanner(setupOf(), "libm.so.6");
    QByteArray told;
    for (const base::Diagnostic& problem : made.diagnostics()) {
      QCOMPARE(std::string(problem.code), std::string("library.no-symbol"));
      told += QByteArray::fromStdString(problem.value("symbol")) + " ";
    }
    QCOMPARE(told,
             QByteArray("hunavsim_planner_abi hunavsim_planner_create hunavsim_planner_command "
                        "hunavsim_planner_error hunavsim_planner_destroy "));
  }

  void make_otherVersion_isRefused() {
    NEED_LIBRARY(kFaulty);
    qputenv("FAULTY_PLANNER_ABI", "77");
    const auto made = faulty("bob");
    qunsetenv("FAULTY_PLANNER_ABI");
    QCOMPARE(codeOf(made.diagnostics()), std::string("library.other-version"));
    QVERIFY(messageOf(made.diagnostics()).contains("version 77 of hunavsim_planner.h, not for 1"));
  }

  void make_refused_tellsTheReason() {
    NEED_LIBRARY(kFaulty);
    const auto made = faulty("refused");
    QCOMPARE(codeOf(made.diagnostics()), std::string("library.refused"));
    QVERIFY(messageOf(made.diagnostics()).endsWith("creates no planner: no?licence"));
    const auto silent = faulty("refused_silently");
    QCOMPARE(codeOf(silent.diagnostics()), std::string("library.refused"));
    QVERIFY(messageOf(silent.diagnostics()).endsWith("creates no planner"));
  }

  void make_fromRegistry_takesItsTexts() {
    NEED_LIBRARY(kExample);
    PlannerRegistry registry;
    addLibrary(registry);
    const auto* entry = registry.find("library");
    QVERIFY(entry != nullptr);
    QCOMPARE(entry->parameters.size(), std::size_t{1});
    PlannerSetup setup = setupOf();
    setup.texts = {{"file", kExample}};
    QVERIFY(entry->make(setup));
    setup.folder = "/nowhere";
    QVERIFY(entry->make(setup));  // the file begins at the root
    setup.texts = {{"file", "gone.so"}};
    const auto gone = entry->make(setup);
    QVERIFY2(messageOf(gone.diagnostics()).contains("/nowhere/gone.so"),
             messageOf(gone.diagnostics()));
    setup.code = ExternalCodePolicy::Skipped;
    QCOMPARE(codeOf(entry->make(setup).diagnostics()), std::string("library.not-there"));
    setup.code = ExternalCodePolicy::Refused;
    QCOMPARE(codeOf(entry->make(setup).diagnostics()), std::string("library.not-allowed"));
  }

  void create_robot_isHandedOver() {
    NEED_LIBRARY(kFaulty);
    const FaultyNotes notes;
    PlannerSetup setup = setupOf("bob");
    setup.body.kinematics = Kinematics::Ackermann;
    setup.body.footprint.corners = {{0.3, -0.4}, {0.3, 0.4}, {-0.1, 0.0}};
    setup.body.mass = 40.0;
    setup.body.limits = {0.8, 0.2, 0.9, 1.25, 2.5, 0.6};
    QVERIFY(makeLibraryPlanner(setup, kFaulty));
    QCOMPARE(notes.lastSeen(),
             QByteArray("bob 3 2 r0.5 m40 v0.8 -0.2 a0.9 w1.25 b2.5 t0.6 seed "
                        "18446744073709551615 corners (0.3 -0.4) (0.3 0.4) (-0.1 0)"));
    setup.body.footprint = {0.25, {}};
    setup.body.kinematics = Kinematics::Omnidirectional;
    QVERIFY(makeLibraryPlanner(setup, kFaulty));
    QVERIFY2(notes.lastSeen().startsWith("bob 3 1 r0.25 "), notes.lastSeen());
    QVERIFY(notes.lastSeen().endsWith(" corners"));
  }

  void command_observation_isHandedOver() {
    NEED_LIBRARY(kFaulty);
    const FaultyNotes notes;
    const auto made = faulty("bob");
    QVERIFY(made);
    Scene scene;
    Observation& seen = scene.observation;
    LaserScan scan;
    scan.sensor = {{0.1, 0.2}, 0.3};
    scan.time = 1.5;
    scan.angleMin = -2.0;
    scan.angleIncrement = 0.5;
    scan.range = 8.0;
    scan.distances = {8.0, 4.5, 3.0};
    seen.time = 2.0;
    seen.pose = {{-1.0, 0.5}, 0.25};
    seen.motion = {0.5, -0.75, 0.125};
    seen.bodies[0].heading = -1.5;
    seen.bodies.push_back({-2, BodyKind::Robot, Vec2(5.0, 6.0), Vec2(0.1, 0.2), 3.0, 0.4});
    const auto first = (*made)->command(seen);
    QVERIFY(first && (*first == BodyTwist{1.0, 0.0, 0.0}));
    const QByteArray rest(
        "t2 dt0.05 pose -1 0.5 0.25 motion 0.5 -0.75 0.125 goal 4 1 r0.2"
        " body 7 0 1.5 1 0 -0.5 -1.5 0.3 body -2 1 5 6 0.1 0.2 3 0.4");
    const QByteArray block(" (2 3) (3 3) (3 4) (2 4);");
    const QByteArray door(" (-1 3) (0 3) (0 3.1) (-1 3.1);");
    QCOMPARE(notes.lastSeen(), rest + " walls1" + block + door);
    seen.scan = &scan;
    const auto second = (*made)->command(seen);
    QVERIFY(second && (*second == BodyTwist{2.0, 0.0, 0.0}));
    const QByteArray turn(" scan 0.1 0.2 0.3 t1.5 -2 0.5 8 8 4.5 3");
    QCOMPARE(notes.lastSeen(), rest + turn + " walls0" + block + door);
    scene.setDoor(false);
    QVERIFY((*made)->command(seen));
    QCOMPARE(notes.lastSeen(), rest + turn + " walls1" + block);
    QVERIFY((*made)->path().empty());  // it has no such function
  }

  void command_error_endsTheRun() {
    NEED_LIBRARY(kFaulty);
    const auto made = faulty("fails");
    Scene scene;
    QVERIFY((*made)->command(scene.observation));
    const auto second = (*made)->command(scene.observation);
    QCOMPARE(codeOf(second.diagnostics()), std::string("library.failed"));
    QVERIFY2(messageOf(second.diagnostics()).endsWith("failed with code 42: stuck"),
             messageOf(second.diagnostics()));
    QVERIFY(messageOf(second.diagnostics()).startsWith("robot 'fails': "));
  }

  void command_noNumber_endsTheRun() {
    NEED_LIBRARY(kFaulty);
    const auto made = faulty("nan");
    Scene scene;
    const auto answer = (*made)->command(scene.observation);
    QCOMPARE(codeOf(answer.diagnostics()), std::string("library.no-number"));
    QVERIFY(messageOf(answer.diagnostics()).contains("angular of the command"));
  }

  void planner_end_destroysIt() {
    NEED_LIBRARY(kFaulty);
    const FaultyNotes notes;
    {
      const auto first = faulty("bob");
      const auto second = faulty("eve");
      QVERIFY(first && second);
      QCOMPARE(notes.alive(), 2);
      QVERIFY(!faulty("refused"));
      QCOMPARE(notes.alive(), 2);
    }
    QCOMPARE(notes.alive(), 0);
  }

  void example_drivingTwice_givesEqualBytes() {
    NEED_LIBRARY(kExample);
    checkDrivesTwice([] { return makeLibraryPlanner(setupOf(), kExample); });
    const auto made = makeLibraryPlanner(setupOf(), kExample);
    QVERIFY(made && drive(**made, 400).problems.empty());
    const std::vector<Vec2> path = (*made)->path();
    QCOMPARE(path.size(), std::size_t{2});
    QVERIFY(path[1] == Vec2(4.0, 1.0));
  }
};

QTEST_GUILESS_MAIN(LibraryPlannerTest)
#include "tst_LibraryPlanner.moc"
