#include <QtTest>

#include "sim2d/trace/TrackImport.h"
#include "tests/trace/TrackImportTest.h"

using namespace foreign;

namespace {

/// A robot that drives 0.5 m/s to the right past a person who stands.
constexpr char kRun[] = R"({
 "grid": {"width": 3, "height": 2, "cell_size": 0.5, "x_orig": -1.0, "y_orig": -2.0,
          "angle_orig": 0.0, "data": [[1, 0, 0], [0, 0, -1]]},
 "walls": [[0.0, 3.0, 5.0, 3.0]],
 "sequence": [
  {"timestamp": 1700000000.0,
   "robot": {"x": 0.0, "y": 0.0, "angle": 0.1, "speed_x": 0.5, "speed_y": 0.0, "speed_a": 0.0,
             "shape": {"type": "circle", "width": 0.6, "length": 0.6}},
   "goal": {"type": "go-to", "human": null, "x": 4.0, "y": 0.0, "angle": 0.0,
            "pos_threshold": 0.25, "angle_threshold": 3.14},
   "people": [{"id": 3, "x": 2.0, "y": 1.0, "angle": -1.5}],
   "objects": [{"id": 1, "type": "table", "x": 2.0, "y": 2.0, "angle": 0.0,
                "shape": {"type": "rectangle", "width": 0.5, "length": 1.0}},
               {"id": 2, "type": "plant", "x": 4.0, "y": 2.0,
                "shape": {"type": "circle", "width": 0.4, "length": 0.4}}]},
  {"timestamp": 1700000000.2, "robot": {"x": 0.1, "y": 0.0, "angle": 0.1},
   "people": [{"id": 3, "x": 2.0, "y": 1.0, "angle": -1.5}], "objects": []},
  {"timestamp": 1700000000.4, "robot": {"x": 0.2, "y": 0.0, "angle": 0.1},
   "people": [], "objects": []}]
})";

sim2d::Trace run() {
  sim2d::Trace trace;
  trace.header.dt = 0.1;
  sim2d::TraceRobot robot;
  robot.name = "robot1";
  robot.radius = 0.25;
  robot.goals = {{0, {5.0, 0.0}, 0.3}};
  trace.header.robots = {robot};
  sim2d::TraceHuman person;
  person.id = 4;
  person.radius = 0.3;
  trace.header.humans = {person};
  trace.header.map = sim2d::OccupancyGrid(2, 2, 0.5, {{-1.0, -1.0}, 0.0}, {100, 0, -1, 0});
  sim2d::TraceObstacle box;
  box.name = "box";
  box.outlines = {sim2d::boxOutline({{3.0, 3.0}, 0.0}, 1.0, 1.0)};
  trace.header.obstacles = {box};
  for (int k = 0; k <= 100; ++k) {
    sim2d::Frame frame;
    frame.step = k;
    frame.time = 0.1 * k;
    frame.robots.add(-1, {{0.05 * k, 0.0}, 0.0}, {0.5, 0.0}, 0.0, sim2d::kNoGoal);
    frame.humans.add(4, {{2.0, 1.0 + 0.1 * k}, base::kPi / 2.0}, {0.0, 1.0}, 0.0, sim2d::kNoGoal);
    frame.humans.group.push_back(-1);
    frame.humans.state.push_back(0);
    trace.frames.push_back(frame);
  }
  return trace;
}

}  // namespace

/// Files of SocNav3 (SocNavData) and of TrajNet++, read and written.
class Socnav3Test : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sequence_isARecord() {
    const base::Result<Trace> trace = traceOf(files_.add("run.json", kRun));
    QVERIFY2(trace, textOf(trace.diagnostics()).c_str());
    QVERIFY2(trace.diagnostics().empty(), textOf(trace.diagnostics()).c_str());
    QVERIFY(std::fabs(trace->header.dt - 0.2) < 1e-6);
    QCOMPARE(trace->frames.size(), std::size_t{3});
    QVERIFY(isNear(trace->frames[1].robots.x[0], 0.1));
    QVERIFY(isNear(trace->frames[1].robots.heading[0], 0.1));
    QVERIFY(std::fabs(trace->frames[1].robots.vx[0] - 0.5) < 1e-6);
    QCOMPARE(trace->frames[0].humans.id, std::vector<int>{3});
    QVERIFY(isNear(trace->frames[0].humans.heading[0], -1.5));
    const sim2d::TraceRobot& robot = trace->header.robots.at(0);
    QVERIFY(isNear(robot.radius, 0.3));
    QCOMPARE(robot.goals.at(0).position, base::Vec2(4.0, 0.0));
    QVERIFY(isNear(robot.goals.at(0).radius, 0.25));
  }
  void surroundings_areWallsObjectsAndGrid() {
    const base::Result<TrackFile> file = read(files_.add("run.json", kRun));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QCOMPARE(file->map.width(), 3);
    QVERIFY(file->map.isWall({0, 0}) && !file->map.isWall({0, 1}) && file->map.isUnknown({2, 1}));
    QCOMPARE(file->map.origin().position, base::Vec2(-1.0, -2.0));
    QCOMPARE(file->obstacles.size(), std::size_t{3});
    QVERIFY(isNear(sim2d::signedArea(file->obstacles[1].outlines[0].points), 0.5));
    for (const base::Vec2& point : file->obstacles[0].outlines[0].points) {
      QVERIFY(std::fabs(point.y() - 3.0) < 0.01);
    }
    for (const base::Vec2& point : file->obstacles[1].outlines[0].points) {
      QVERIFY(isNear(std::fabs(point.x() - 2.0), 0.5));  // its length lies along its angle
    }
    for (const base::Vec2& point : file->obstacles[2].outlines[0].points) {
      QVERIFY(isNear((point - base::Vec2(4.0, 2.0)).norm(), 0.2));
    }
  }
  void largeIds_leaveOneForTheRobot() {
    const base::Result<TrackFile> file = read(files_.add("ids.json", R"({"sequence": [
        {"timestamp": 0, "robot": {"x": 0, "y": 0},
         "people": [{"id": 2147483646, "x": 1, "y": 1}, {"id": 5, "x": 2, "y": 1}]}]})"));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QCOMPARE(file->tracks.size(), std::size_t{3});
    QCOMPARE(file->tracks[0].id, 1);  // numbered, as words are
    QCOMPARE(file->tracks[1].id, 2);
    QVERIFY(file->tracks[2].isRobot);
    QCOMPARE(file->tracks[2].id, 3);
  }
  void otherSpellings_areRead() {
    const base::Result<TrackFile> file = read(files_.add(
        "list.json",
        R"([{"timestamp": 0, "robot": {"x": 0, "y": 0, "theta": 1}, "goal": [{"x": 1, "y": 2}],
            "humans": {"anna": {"x": 1, "y": 1}}, "walls": [{"x1": 0, "y1": 0, "x2": 1, "y2": 0}]},
           {"timestamp": 1, "robot": {"x": 1, "y": 0}, "humans": {"anna": {"x": 1, "y": 2}}}])"));
    QVERIFY2(file, textOf(file.diagnostics()).c_str());
    QVERIFY(tells(file.diagnostics(), "tracks.ids-numbered"));
    QCOMPARE(file->tracks[0].name, std::string("anna"));
    QVERIFY(file->tracks[1].isRobot);
    QCOMPARE(file->robotGoal->position, base::Vec2(1.0, 2.0));
    QCOMPARE(file->obstacles.size(), std::size_t{1});
  }
  void noTimes_askForTheRate() {
    const std::string path = files_.add(
        "rate.json", R"({"sequence": [{"robot": {"x": 0, "y": 0}}, {"robot": {"x": 1, "y": 0}}]})");
    QVERIFY(textOf(read(path).diagnostics()).find("--fps F") != std::string::npos);
    QVERIFY(isNear(
        read(path, with(&TrackImportOptions::framesPerSecond, 4.0))->tracks[0].points[1].time,
        0.25));
  }
  void badInput_hasItsLine() {
    const std::string told = textOf(
        read(files_.add(
                 "bad.json",
                 "{\"sequence\": [\n{\"timestamp\": 0,\n \"robot\": {\"x\": \"b\", \"y\": 0}},\n"
                 "{\"robot\": {\"x\": 0, \"y\": 0}},\n{\"timestamp\": 1, \"people\": [{\"x\": 0, "
                 "\"y\": 1}]}]}"))
            .diagnostics());
    QVERIFY2(told.find("bad.json:3: error: 'x' is missing or not a finite number in [0].robot") !=
                 std::string::npos,
             told.c_str());
    QVERIFY2(told.find("bad.json:4: error: 'timestamp' is missing") != std::string::npos,
             told.c_str());
    QVERIFY2(told.find("bad.json:5: error: 'id' is missing") != std::string::npos, told.c_str());
    const TrackImportOptions options = with(&TrackImportOptions::format, "socnav3");
    QVERIFY(tells(read(files_.add("none.json", "{\"a\": 1}"), options).diagnostics(),
                  "tracks.no-sequence"));
    QVERIFY(tells(read(files_.add("cut.json", "{\"sequence\": ["), options).diagnostics(),
                  "trace.not-json"));
    const base::Result<TrackFile> odd = read(
        files_.add("odd.json", R"({"walls": [1, [0, 0, 1]], "grid": {"width": 1e9, "height": 1e9},
        "sequence": [{"timestamp": 0, "robot": {"x": 0, "y": 0}}]})"));
    QVERIFY(odd);
    QCOMPARE(odd.diagnostics().size(), std::size_t{2});
    QVERIFY(tells(odd.diagnostics(), "tracks.left-out"));
  }

  void run_writtenAndRead_isTheSame() {
    const base::Result<std::string> text = sim2d::socnav3Text(run());
    QVERIFY(text && text.diagnostics().empty());
    const base::Result<Trace> back = traceOf(files_.add("back.json", *text));
    QVERIFY2(back, textOf(back.diagnostics()).c_str());
    const sim2d::Trace original = run();
    QCOMPARE(back->frames.size(), original.frames.size());
    for (std::size_t k = 0; k < original.frames.size(); ++k) {
      QVERIFY(isNear(back->frames[k].robots.x[0], original.frames[k].robots.x[0]));
      QVERIFY(isNear(back->frames[k].humans.y[0], original.frames[k].humans.y[0]));
      QVERIFY(isNear(back->frames[k].humans.heading[0], original.frames[k].humans.heading[0]));
    }
    QVERIFY(isNear(back->header.humans[0].radius, 0.3));
    QVERIFY(isNear(back->header.robots[0].radius, 0.25));
    QVERIFY(back->header.robots[0].goals == original.header.robots[0].goals);
    QVERIFY(back->header.map == original.header.map);
  }
  /// Byte for byte, as the pages of the format have it.
  void socnav3_instant_hasItsMembers() {
    sim2d::Trace trace = run();
    trace.frames.resize(1);
    trace.frames[0].robots.heading[0] = base::kPi / 2.0;
    trace.header.obstacles.clear();
    const base::Result<std::string> text = sim2d::socnav3Text(trace);
    QVERIFY(text);
    QCOMPARE(
        *text,
        std::string(R"({
 "grid": {"width":2,"height":2,"cell_size":0.5,"x_orig":-1.0,"y_orig":-1.0,"angle_orig":0.0,"data":[[1,0],[-1,0]]},
 "walls": [],
 "sequence": [
  {"timestamp":0.0,"robot":{"x":0.0,"y":0.0,"angle":1.5707963267948966,"speed_x":)") +
            (text->find("\"speed_x\":3.061616997868383e-17") != std::string::npos
                 ? "3.061616997868383e-17"
                 : "0.0") +
            R"(,"speed_y":-0.5,"speed_a":0.0,"shape":{"type":"circle","width":0.5,"length":0.5}},"goal":{"type":"go-to","human":null,"x":5.0,"y":0.0,"angle":0.0,"pos_threshold":0.3,"angle_threshold":3.141592653589793},"people":[{"id":4,"x":2.0,"y":1.0,"angle":1.5707963267948966,"shape":{"type":"circle","width":0.6,"length":0.6}}],"objects":[]}
 ]
}
)");
  }
  void socnav3_withoutRobot_isRefused() {
    sim2d::Trace trace = run();
    trace.header.robots.clear();
    QVERIFY(tells(sim2d::socnav3Text(trace).diagnostics(), "export.no-robot"));
    trace = run();
    trace.frames.clear();
    QVERIFY(tells(sim2d::socnav3Text(trace).diagnostics(), "export.no-states"));
    QVERIFY(tells(sim2d::trajnetText(trace).diagnostics(), "export.no-states"));
  }

  /// 10 s at 2.5 samples per second are 26: one scene of 21 for each body.
  void trajnet_hasScenesAndTracks() {
    const base::Result<std::string> text = sim2d::trajnetText(run());
    QVERIFY(text && tells(text.diagnostics(), "export.robot-as-person"));
    const std::vector<std::string> lines = base::split(*text, '\n');
    QCOMPARE(lines.size(), std::size_t{2 + 26 * 2 + 1});
    QCOMPARE(lines[0], std::string(R"({"scene":{"id":0,"p":4,"s":0,"e":20,"fps":2.5}})"));
    QCOMPARE(lines[1], std::string(R"({"scene":{"id":1,"p":5,"s":0,"e":20,"fps":2.5}})"));
    QCOMPARE(lines[2], std::string(R"({"track":{"f":0,"p":4,"x":2.0,"y":1.0}})"));
    const base::Result<TrackFile> back = read(files_.add("back.ndjson", *text));
    QVERIFY2(back, textOf(back.diagnostics()).c_str());
    QCOMPARE(back->tracks.size(), std::size_t{2});
    const sim2d::TrackPoint& robot = trackOf(*back, 5)->points.at(25);
    QVERIFY(isNear(robot.time, 10.0) && isNear(robot.position.x(), 5.0));
  }
  /// Between two states of 0.1 s: 1 / 4 s is in the middle of the third and the fourth.
  void samples_betweenStates_areInterpolated() {
    const base::Result<std::string> text = sim2d::trajnetText(run(), 4.0);
    const base::Result<TrackFile> back = read(files_.add("four.ndjson", *text));
    QVERIFY(back);
    QCOMPARE(trackOf(*back, 5)->points.size(), std::size_t{41});
    QVERIFY(isNear(trackOf(*back, 5)->points[1].position.x(), 0.125));
    QVERIFY(isNear(trackOf(*back, 4)->points[1].position.y(), 1.25));
  }
  void trajnet_ofAShortRun_hasNoScene() {
    sim2d::Trace trace = run();
    trace.frames.resize(50);
    QVERIFY(tells(sim2d::trajnetText(trace).diagnostics(), "export.no-scene"));
  }

 private:
  Written files_;
};

QTEST_APPLESS_MAIN(Socnav3Test)
#include "tst_Socnav3.moc"
