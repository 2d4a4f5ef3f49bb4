#include <string>
#include <vector>

#include <QtTest>

#include "tests/bt/ScriptedNavigator.h"

namespace {

using namespace navigator;

const std::string kPlan = R"(<ComputePathToPose goal="{goal}" path="{path}"/>)";
const std::string kFollow = R"(<FollowPath path="{path}"/>)";

std::string pipeline(const std::string& children) {
  return "<PipelineSequence>" + children + "</PipelineSequence>";
}

}  // namespace

/// Nav2's nodes: what they do tick by tick, against what Nav2's documentation and code say.
class RobotNodesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void rateController_planSucceeds_isDueAPeriodAfterTheSuccess() {
    Played played(pipeline("<RateController hz=\"1.0\">" + kPlan + "</RateController>" + kFollow));
    played.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0}};
    // Asked in step 1, done in 2; 1 s = 20 steps later it is due again.
    QCOMPARE(played.stepsOf("plan", 70), (Steps{1, 22, 43, 64}));
  }

  void rateController_childFails_isTickedAgainAtOnce() {
    Played played("<KeepRunningUntilFailure><ForceSuccess><RateController hz=\"0.5\">" + kPlan +
                  "</RateController></ForceSuccess></KeepRunningUntilFailure>");
    played.host.script[RobotAction::ComputePath] = {{State::Failed, 208, 1}};
    // A decorator above resets it, so each time is a first time; within one life too a failure does
    // not restart the timer.
    QCOMPARE(played.stepsOf("plan", 6), (Steps{1, 3, 5}));
  }

  void distanceController_robotMoves_ticksEachMetre() {
    Played played(pipeline("<DistanceController distance=\"1.0\">" + kPlan +
                           "</DistanceController>" + kFollow));
    played.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0}};
    Steps steps;
    for (int i = 1; i <= 60; ++i) {
      played.host.place.position.x() = 0.0625 * i;  // exact in binary
      if (!played.stepsOf("plan", 1).empty()) {
        steps.push_back(i);
      }
    }
    // Succeeds in step 2 at 0.125 m; 1 m on is step 18, which succeeds in 19; then 35.
    QCOMPARE(steps, (Steps{1, 18, 35, 52}));
  }

  void speedController_speedChanges_changesThePeriod() {
    const std::string node = R"(<SpeedController min_rate="0.5" max_rate="2.0" min_speed="0.0"
                                               max_speed="0.5">)";
    Played slow(pipeline(node + kPlan + "</SpeedController>" + kFollow));
    slow.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0}};
    // The first period is that of the highest rate (0.5 s from step 1); then 2 s at rest.
    QCOMPARE(slow.stepsOf("plan", 100), (Steps{1, 11, 51, 91}));
    Played fast(pipeline(node + kPlan + "</SpeedController>" + kFollow));
    fast.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0}};
    fast.host.driven = 0.9;  // beyond the highest: 2 Hz
    QCOMPARE(fast.stepsOf("plan", 40), (Steps{1, 11, 21, 31}));
  }

  void goalUpdatedController_newGoal_ticksAgain() {
    Played played(
        pipeline("<GoalUpdatedController>" + kPlan + "</GoalUpdatedController>" + kFollow));
    played.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0}};
    QCOMPARE(played.stepsOf("plan", 10), (Steps{1}));
    played.setGoal(played.host.paths().add({{{3.0, 0.0}, 0.0}}));
    QCOMPARE(played.stepsOf("plan", 10), (Steps{11}));
  }

  void singleTrigger_secondTick_fails() {
    Played played("<Sequence><SingleTrigger>" + kPlan +
                  "</SingleTrigger><AlwaysSuccess/></Sequence>");
    QCOMPARE(played.tick(), kRunning);
    QCOMPARE(played.tick(), kSuccess);
    Played pipe(pipeline("<SingleTrigger>" + kPlan + "</SingleTrigger>" + kFollow));
    pipe.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0}};
    QCOMPARE(pipe.play(10), kFailure);  // ticked again while FollowPath runs
    QCOMPARE(pipe.host.text(), std::string("plan follow cancel"));
  }

  void pathLongerOnApproach_longerPathNearTheGoal_ticksTheChild() {
    const std::string nodes =
        "<RateController hz=\"20.0\">" + kPlan + "</RateController>" +
        R"(<PathLongerOnApproach path="{path}" prox_len="3.0" length_factor="2.0">
           <Spin/></PathLongerOnApproach>)" +
        kFollow;
    Played played(pipeline(nodes));
    played.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0}};
    played.host.nextLength = 10.0;
    played.stepsOf("plan", 4);
    played.host.nextLength = 2.0;  // nearer than 3 m, not longer
    played.stepsOf("plan", 4);
    played.host.nextLength = 3.9;  // longer, not twice
    played.stepsOf("plan", 3);
    QCOMPARE(played.host.text().find("spin"), std::string::npos);
    played.host.nextLength = 2.0;
    played.stepsOf("plan", 4);
    played.host.nextLength = 4.1;
    QCOMPARE(played.stepsOf("spin", 6).size(), std::size_t{1});
  }

  void pipelineSequence_earlierChildRuns_laterGoOn() {
    Played played(pipeline("<RateController hz=\"1.0\">" + kPlan + "</RateController>" + kFollow));
    played.host.script[RobotAction::ComputePath] = {{State::Succeeded, 0, 1},
                                                    {State::Succeeded, 0, 5}};
    played.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 23}};
    // Follow begins in step 2 and ends in 25, while the second plan (22 to 27) runs: the pipeline
    // succeeds only with the last child, whatever the first does.
    QCOMPARE(played.play(100), kSuccess);
    QCOMPARE(played.step, 25LL);
  }

  void pipelineSequence_earlierChildFails_haltsTheRest() {
    Played played(pipeline("<RateController hz=\"1.0\">" + kPlan + "</RateController>" + kFollow));
    played.host.script[RobotAction::ComputePath] = {{State::Succeeded, 0, 1},
                                                    {State::Failed, 208, 1}};
    played.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0}};
    QCOMPARE(played.play(100), kFailure);
    QCOMPARE(played.step, 23LL);
    QCOMPARE(played.host.text(), std::string("plan follow plan cancel"));
  }

  void recoveryNode_firstFails_triesAsOftenAsSaid() {
    const std::string nodes =
        "<RecoveryNode number_of_retries=\"2\">" + kPlan +
        R"(<ClearEntireCostmap service_name="global_costmap/x"/></RecoveryNode>)";
    Played played(nodes);
    played.host.script[RobotAction::ComputePath] = {{State::Failed, 208, 1}};
    QCOMPARE(played.play(100), kFailure);
    QCOMPARE(played.host.text(), std::string("plan clear-global plan clear-global plan"));
    QCOMPARE(played.step, 4LL);  // failure, recovery and the next try fall into one tick
    Played helped(nodes);
    helped.host.script[RobotAction::ComputePath] = {{State::Failed, 208, 1},
                                                    {State::Succeeded, 0, 1}};
    QCOMPARE(helped.play(100), kSuccess);
    QCOMPARE(helped.host.text(), std::string("plan clear-global plan"));
  }

  void recoveryNode_recoveryFails_fails() {
    Played played("<RecoveryNode number_of_retries=\"5\">" + kPlan + "<Spin/></RecoveryNode>");
    played.host.script[RobotAction::ComputePath] = {{State::Failed, 208, 1}};
    played.host.script[RobotAction::Spin] = {{State::Failed, 703, 1}};
    QCOMPARE(played.play(100), kFailure);
    QCOMPARE(played.host.text(), std::string("plan spin"));
  }

  void recoveryNode_halted_countsAnew() {
    // The goal changes while it recovers: the fallback takes its first child and halts the second.
    Played played("<RecoveryNode number_of_retries=\"1\">" + kPlan + "<Spin/></RecoveryNode>");
    played.host.script[RobotAction::ComputePath] = {{State::Failed, 208, 1}};
    played.host.script[RobotAction::Spin] = {{State::Succeeded, 0, 0}};
    played.play(5);
    QCOMPARE(played.host.text(), std::string("plan spin"));
    played.state->halt({played.step, 0.05, &played.host});
    played.host.log.clear();
    played.host.script[RobotAction::Spin] = {{State::Succeeded, 0, 1}};
    QCOMPARE(played.play(10), kFailure);
    QCOMPARE(played.host.text(), std::string("plan spin plan"));
  }

  void roundRobin_success_goesOnWithTheNext() {
    const std::string nodes = "<RoundRobin><Spin/><Wait/><BackUp/></RoundRobin>";
    Played played("<KeepRunningUntilFailure>" + nodes + "</KeepRunningUntilFailure>");
    played.play(14);
    QCOMPARE(played.host.text(), std::string("spin wait backup spin wait backup spin"));
    Played halted(nodes);
    halted.host.script[RobotAction::Wait] = {{State::Succeeded, 0, 0}};
    QCOMPARE(halted.play(10), kSuccess);  // spin
    QCOMPARE(halted.play(3), kRunning);   // wait
    halted.state->halt({halted.step, 0.05, &halted.host});
    halted.host.log.clear();
    halted.play(10);
    QCOMPARE(halted.host.text(), std::string("spin"));  // a halt begins anew
  }

  void roundRobin_ofMain_doesNotWrap() {
    const std::string nodes = "<RoundRobin><Spin/><Wait/></RoundRobin>";
    Played played(nodes, Distro::Main);
    QCOMPARE(played.play(10), kSuccess);
    QCOMPARE(played.play(10), kFailure);  // the last child has succeeded, and that is the end
    QCOMPARE(played.host.text(), std::string("spin wait"));
    QCOMPARE(played.play(10), kSuccess);
    QCOMPARE(played.host.text(), std::string("spin wait spin"));
    Played wrapping(R"(<RoundRobin wrap_around="true"><Spin/><Wait/></RoundRobin>)", Distro::Main);
    QCOMPARE(wrapping.play(10), kSuccess);
    QCOMPARE(wrapping.play(10), kSuccess);
    QCOMPARE(wrapping.play(10), kSuccess);
    QCOMPARE(wrapping.host.text(), std::string("spin wait spin"));
  }

  void roundRobin_allFail_fails() {
    Played played("<RoundRobin><Spin/><Wait/></RoundRobin>");
    played.host.script[RobotAction::Spin] = {{State::Failed, 703, 1}};
    played.host.script[RobotAction::Wait] = {{State::Failed, 0, 1}};
    QCOMPARE(played.play(10), kFailure);
    QCOMPARE(played.host.text(), std::string("spin wait"));
  }

  void nonblockingSequence_firstRuns_othersAreTicked() {
    Played played("<NonblockingSequence><Spin/><Wait/></NonblockingSequence>", Distro::Main);
    played.host.script[RobotAction::Spin] = {{State::Succeeded, 0, 3}};
    QCOMPARE(played.tick(), kRunning);
    QCOMPARE(played.host.text(), std::string("spin wait"));
    QCOMPARE(played.play(10), kSuccess);
    QCOMPARE(played.step, 4LL);
  }

  void goalUpdated_goalChanges_saysSoOnce() {
    Played played(
        "<ReactiveSequence><Inverter><GoalUpdated/></Inverter><Spin/>"
        "</ReactiveSequence>");
    QCOMPARE(played.tick(), kRunning);  // FAILURE, inverted
    Played direct(pipeline("<ForceSuccess><AlwaysSuccess/></ForceSuccess><GoalUpdated/>"));
    QCOMPARE(direct.tick(), kFailure);
    direct.setGoal(direct.host.paths().add({{{3.0, 0.0}, 0.0}}));
    QCOMPARE(direct.tick(), kFailure);  // the failure had reset it: it looks for the first time
    Played kept(
        "<Parallel success_count=\"2\" failure_count=\"2\"><Inverter><GoalUpdated/>"
        "</Inverter><Spin/></Parallel>");
    kept.host.script[RobotAction::Spin] = {{State::Succeeded, 0, 0}};
    QCOMPARE(kept.tick(), kRunning);
  }

  void globalUpdatedGoal_firstTime_saysYes() {
    Played played("<GlobalUpdatedGoal/>");
    QCOMPARE(played.tick(), kSuccess);
    QCOMPARE(played.tick(), kFailure);
    played.setGoal(played.host.paths().add({{{3.0, 0.0}, 0.0}}));
    QCOMPARE(played.tick(), kSuccess);
    QCOMPARE(played.tick(), kFailure);
  }

  void timeExpired_afterSeconds_saysSoOnce() {
    // Below a pipeline's success nothing is reset until the last child is done.
    Played played(
        pipeline("<ForceSuccess><TimeExpired seconds=\"0.5\"/></ForceSuccess>"
                 "<Spin/>"));
    played.host.script[RobotAction::Spin] = {{State::Succeeded, 0, 0}};
    QCOMPARE(played.play(30), kRunning);
    Played bare(
        "<RetryUntilSuccessful num_attempts=\"-1\"><Delay delay_msec=\"0\">"
        "<TimeExpired seconds=\"0.5\"/></Delay></RetryUntilSuccessful>");
    QCOMPARE(bare.play(40), kRunning);  // each try is a first one: never
  }

  void pathExpiringTimer_newPath_beginsAnew() {
    // It remembers whatever resets it: 1 s after it first looked, and after each time it said so.
    Played played(R"(<PathExpiringTimer seconds="1.0" path="{goal}"/>)");
    Steps steps;
    for (int i = 1; i <= 45; ++i) {
      if (i == 30) {
        played.setGoal(played.host.paths().add({{{3.0, 0.0}, 0.0}}));
      }
      if (played.tick() == kSuccess) {
        steps.push_back(i);
      }
    }
    QCOMPARE(steps, (Steps{21}));  // the next would have been 41, now it is 50
    for (int i = 46; i <= 49; ++i) {
      QCOMPARE(played.tick(), kFailure);
    }
    QCOMPARE(played.tick(), kSuccess);
  }

  void distanceTraveled_afterMetres_saysSoOnce() {
    Played played(R"(<PipelineSequence><Inverter><DistanceTraveled distance="1.0"/></Inverter>
                           <Spin/></PipelineSequence>)");
    QCOMPARE(played.tick(), kRunning);
    QCOMPARE(played.host.text(), std::string("spin"));
  }

  void followPath_newPath_isSentWithoutAStop() {
    Played played(pipeline("<RateController hz=\"1.0\">" + kPlan + "</RateController>" + kFollow));
    played.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0}};
    QCOMPARE(played.stepsOf("follow", 50), (Steps{2, 23, 44}));
    QCOMPARE(played.host.text().find("cancel"), std::string::npos);
  }

  void followPath_halted_isCancelled() {
    Played played("<Sequence>" + kPlan + kFollow + "</Sequence>");
    played.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0}};
    played.play(5);
    played.state->halt({played.step, 0.05, &played.host});
    QCOMPARE(played.host.text(), std::string("plan follow cancel"));
  }

  void computePath_fails_leavesAnEmptyPath() {
    Played played(R"(<Sequence><ComputePathToPose goal="{goal}" path="{path}"/><ForceSuccess>
      <ComputePathToPose goal="{goal}" path="{path}" error_code_id="{code}"/></ForceSuccess>
      <FollowPath path="{path}"/></Sequence>)");
    played.host.script[RobotAction::ComputePath] = {{State::Succeeded, 0, 1},
                                                    {State::Failed, 208, 1}};
    played.play(3);
    QCOMPARE(played.host.text(), std::string("plan plan follow"));
    QVERIFY(played.host.paths().get(played.host.last.path).empty());
    QCOMPARE(played.state->get(played.program->findSlot("code")).number(), 208.0);
  }

  void backUp_signs_doNotMatter() {
    Played played(R"(<BackUp backup_dist="-0.3" backup_speed="0.05"/>)");
    played.tick();
    QCOMPARE(played.host.last.amount, 0.3);
    QCOMPARE(played.host.last.speed, 0.05);
    QCOMPARE(played.host.last.timeAllowance, 10.0);
    QCOMPARE(played.host.recoveries, 1);
  }

  void wait_humble_waitsWholeSeconds() {
    Played humble(R"(<Wait wait_duration="5.7"/>)");
    humble.tick();
    QCOMPARE(humble.host.last.amount, 5.0);
    Played jazzy(R"(<Wait wait_duration="5.7"/>)", Distro::Jazzy);
    jazzy.tick();
    QCOMPARE(jazzy.host.last.amount, 5.7);
  }

  void behaviors_withoutCollisionChecks_areOfMain() {
    for (const char* const node : {"Spin", "BackUp", "DriveOnHeading"}) {
      const auto ignores = [&](Distro distro, const std::string& attributes) {
        Played played(std::string("<") + node + attributes + "/>", distro);
        played.tick();
        return played.host.log.size() == 1 && played.host.last.ignoresCollisions;
      };
      QVERIFY(ignores(Distro::Main, R"( disable_collision_checks="true")"));
      QVERIFY(!ignores(Distro::Main, R"( disable_collision_checks="false")"));
      QVERIFY(!ignores(Distro::Main, ""));
      QVERIFY(!ignores(Distro::Jazzy, R"( disable_collision_checks="true")"));
    }
  }

  void truncatePath_metre_endsBeforeItAndLooksAtTheEnd() {
    Played played(R"(<Sequence><TruncatePath distance="1.0" input_path="{goal}"
                                  output_path="{cut}"/><FollowPath path="{cut}"/></Sequence>)");
    Path path;
    for (int i = 0; i <= 10; ++i) {
      path.push_back({{0.5 * i, i == 10 ? 0.5 : 0.0}, 0.0});
    }
    played.setGoal(played.host.paths().add(path));
    played.tick();
    const Path& cut = played.host.paths().get(played.host.last.path);
    // (4.5, 0) is 0.71 m from the end (5, 0.5), (4, 0) is 1.12 m.
    QCOMPARE(cut.size(), std::size_t{9});
    QCOMPARE(cut.back().position.x(), 4.0);
    QVERIFY(std::fabs(cut.back().heading - std::atan2(0.5, 1.0)) < 1e-12);
  }

  void truncatePath_samePath_isTheSameResult() {
    Played played(pipeline(R"(<TruncatePath input_path="{goal}" output_path="{cut}"/>
                                    <FollowPath path="{cut}"/>)"));
    played.setGoal(
        played.host.paths().add({{{0.0, 0.0}, 0.0}, {{2.0, 0.0}, 0.0}, {{5.0, 0.0}, 0.0}}));
    played.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0}};
    QCOMPARE(played.stepsOf("follow", 10), (Steps{1}));
  }

  void removePassedGoals_near_keepsTheLast() {
    Played played(R"(<Sequence><RemovePassedGoals input_goals="{goals}" output_goals="{goals}"
      radius="0.7"/><ComputePathThroughPoses goals="{goals}" path="{path}"/></Sequence>)");
    played.setGoal(played.host.paths().add(
        {{{0.5, 0.0}, 0.0}, {{0.0, 0.7}, 0.0}, {{3.0, 0.0}, 0.0}, {{0.1, 0.0}, 0.0}}));
    played.tick();
    QCOMPARE(played.host.paths().get(played.host.last.path).size(), std::size_t{2});
    QCOMPARE(played.host.paths().get(played.host.last.path).front().position.x(), 3.0);
    played.host.place.position = {3.0, 0.0};
    Played last(R"(<Sequence><RemovePassedGoals input_goals="{goals}" output_goals="{goals}"/>
      <ComputePathThroughPoses goals="{goals}" path="{path}"/></Sequence>)");
    last.setGoal(last.host.paths().add({{{0.1, 0.0}, 0.0}}));
    last.tick();
    QCOMPARE(last.host.paths().get(last.host.last.path).size(), std::size_t{1});
  }

  void recoveryHelps_codes_asNav2Lists() {
    const auto answer = [](const char* node, int code) {
      Played played("<" + std::string(node) + " error_code=\"" + std::to_string(code) + "\"/>");
      return played.tick() == kSuccess;
    };
    const auto codes = [&](const char* node, int from, int to) {
      Steps yes;
      for (int code = from; code <= to; ++code) {
        if (answer(node, code)) {
          yes.push_back(code);
        }
      }
      return yes;
    };
    QCOMPARE(codes("WouldAControllerRecoveryHelp", 99, 109), (Steps{100, 104, 105, 106}));
    QCOMPARE(codes("WouldAPlannerRecoveryHelp", 199, 309), (Steps{200, 207, 208, 300, 307, 308}));
    QCOMPARE(codes("WouldASmootherRecoveryHelp", 499, 506), (Steps{500, 502, 503, 504}));
    QCOMPARE(codes("WouldARouteRecoveryHelp", 399, 409), (Steps{400, 404, 405}));
    QVERIFY(!answer("WouldAControllerRecoveryHelp", 0));
  }

  void isStuck_hardStop_saysSo() {
    Played played("<IsStuck/>");
    played.host.braking = -9.8;  // [m/s2]
    QCOMPARE(played.tick(), kFailure);
    played.host.braking = -10.4;
    QCOMPARE(played.tick(), kSuccess);
    played.host.braking = 10.4;
    QCOMPARE(played.tick(), kFailure);
  }
};

QTEST_GUILESS_MAIN(RobotNodesTest)
#include "tst_RobotNodes.moc"
