#include <QtTest>

#include "tests/trace/TrackImportTest.h"

using namespace foreign;

/// Tables with a header, and which body is the robot.
class ForeignCsvTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void csv_namedColumns_giveStatesOfEachInstant();
  void csv_unevenTimes_areInterpolated();
  void csv_toldMotion_isKept();
  void csv_personAway_isNotThere();
  void csv_oneSample_isARecord();
  void csv_robotColumn_givesARobot();
  void robot_ofAPerson_cutsTheRecord();
  void robot_betweenTheOthers_isMetByTheInstants();
  void parseColumns_wrongWords_areErrors();
  void csv_otherSeparators_areSeen_data();
  void csv_otherSeparators_areSeen();
  void csv_wrongColumnNames_haveHints();
};

void ForeignCsvTest::csv_namedColumns_giveStatesOfEachInstant() {
  Written files;
  const auto trace = traceOf(files.add("a.csv",
                                       "t,ped,px,py\n"
                                       "10.0,7,0,0\n10.0,3,5,5\n10.5,7,1,0\n10.5,3,5,5\n"
                                       "11.0,7,2,1\n11.0,3,5,5\n"),
                             withColumns("time=t,id=ped,x=px,y=py"));
  QVERIFY(trace);
  QCOMPARE(trace->header.dt, 0.5);
  QCOMPARE(trace->frames.size(), std::size_t{3});
  const sim2d::HumanColumns& middle = trace->frames[1].humans;
  QCOMPARE(trace->frames[1].time, 0.5);
  QVERIFY((middle.id == std::vector<int>{3, 7}));
  QCOMPARE(middle.x[1], 1.0);
  QVERIFY(isNear(middle.vx[1], 2.0));  // (2 - 0) / 1 s
  QVERIFY(isNear(middle.vy[1], 1.0));  // (1 - 0) / 1 s
  QVERIFY(isNear(middle.heading[1], std::atan2(1.0, 2.0)));
  QVERIFY(isNear(trace->frames[2].humans.vy[1], 2.0));  // (1 - 0) / 0.5 s
  QCOMPARE(middle.vx[0], 0.0);
  // Headings 0, atan2(1, 2), pi/4 over 1 s.
  QVERIFY(isNear(middle.omega[1], base::kPi / 4));
}

void ForeignCsvTest::csv_unevenTimes_areInterpolated() {
  Written files;
  TrackOptions options;
  options.step = 0.25;
  const auto trace =
      traceOf(files.add("a.csv", "time,id,x,y\n0,1,0,0\n0.4,1,4,0\n0.5,1,4,1\n"), {}, options);
  QVERIFY(trace);
  QCOMPARE(trace->frames.size(), std::size_t{3});
  QVERIFY(isNear(trace->frames[1].humans.x[0], 2.5));
  QCOMPARE(trace->frames[2].humans.x[0], 4.0);
  QCOMPARE(trace->frames[2].humans.y[0], 1.0);
}

void ForeignCsvTest::csv_toldMotion_isKept() {
  Written files;
  const auto trace =
      traceOf(files.add("a.csv",
                        "time,id,x,y,vx,vy,heading,omega,group,radius\n"
                        "0,1,0,0,0.3,0.4,1.5,0.25,4,0.2\n1,1,1,0,0.3,0.4,1.5,0.25,4,0.2\n"));
  QVERIFY(trace);
  const sim2d::HumanColumns& humans = trace->frames[0].humans;
  QCOMPARE(humans.vx[0], 0.3);
  QCOMPARE(humans.vy[0], 0.4);
  QCOMPARE(humans.heading[0], 1.5);
  QCOMPARE(humans.omega[0], 0.25);
  QCOMPARE(humans.group[0], 4);
  QCOMPARE(trace->header.humans[0].radius, 0.2);
}

void ForeignCsvTest::csv_personAway_isNotThere() {
  Written files;
  const auto trace = traceOf(
      files.add("a.csv", "time,id,x,y\n0,1,0,0\n1,1,1,0\n2,1,2,0\n8,1,8,0\n9,1,9,0\n10,1,10,0\n"));
  QVERIFY(trace);
  QCOMPARE(trace->frames.size(), std::size_t{11});
  QCOMPARE(trace->frames[2].humans.size(), std::size_t{1});
  QCOMPARE(trace->frames[5].humans.size(), std::size_t{0});
  QCOMPARE(trace->frames[8].humans.x[0], 8.0);
  QVERIFY(isNear(trace->frames[8].humans.vx[0], 1.0));  // not over the absence
}

void ForeignCsvTest::csv_oneSample_isARecord() {
  Written files;
  const auto trace = traceOf(files.add("a.csv", "time,id,x,y\n3.5,1,2,4\n"));
  QVERIFY(trace);
  QCOMPARE(trace->frames.size(), std::size_t{1});
  QCOMPARE(trace->frames[0].humans.x[0], 2.0);
  QCOMPARE(trace->frames[0].humans.vx[0], 0.0);
}

void ForeignCsvTest::csv_robotColumn_givesARobot() {
  Written files;
  const std::string path = files.add("a.csv",
                                     "time,id,kind,x,y\n0,-1,robot,0,0\n0,1,human,3,0\n"
                                     "1,-1,robot,1,0\n1,1,human,3,0\n");
  TrackOptions options;
  options.robotGoal = base::Vec2(4.0, 0.0);
  const auto trace = traceOf(path, {}, options);
  QVERIFY(trace);
  QCOMPARE(trace->header.robots.size(), std::size_t{1});
  QCOMPARE(trace->header.robots[0].goals[0].position.x(), 4.0);
  QCOMPARE(trace->frames[1].robots.x[0], 1.0);
  QCOMPARE(trace->header.humans.size(), std::size_t{1});
}

void ForeignCsvTest::robot_ofAPerson_cutsTheRecord() {
  Written files;
  TrackOptions options;
  options.robotId = 2;
  const auto trace = traceOf(files.add("a.csv",
                                       "time,id,x,y\n0,1,0,0\n1,1,1,0\n2,1,2,0\n3,1,3,0\n"
                                       "1,2,5,5\n2,2,5,6\n"),
                             {}, options);
  QVERIFY(trace);
  QCOMPARE(trace->frames.size(), std::size_t{2});
  QCOMPARE(trace->frames[0].time, 0.0);
  QCOMPARE(trace->frames[0].robots.y[0], 5.0);
  QCOMPARE(trace->frames[0].humans.x[0], 1.0);
  QCOMPARE(trace->header.humans.size(), std::size_t{1});
}

void ForeignCsvTest::robot_betweenTheOthers_isMetByTheInstants() {
  Written files;
  TrackOptions options;
  options.robotId = 2;
  const auto trace = traceOf(files.add("a.csv",
                                       "time,id,x,y\n0,1,0,0\n1,1,1,0\n2,1,2,0\n3,1,3,0\n"
                                       "4,1,4,0\n0.5,2,5,5\n1.5,2,5,7\n2.5,2,5,6\n"),
                             {}, options);
  QVERIFY(trace);
  QCOMPARE(trace->frames.size(), std::size_t{3});
  const double places[] = {5.0, 7.0, 6.0};
  for (std::size_t k = 0; k < 3; ++k) {
    QVERIFY(std::fabs(trace->frames[k].robots.y[0] - places[k]) < 1e-5);
    QVERIFY(std::fabs(trace->frames[k].humans.x[0] - static_cast<double>(k) - 0.5) < 1e-5);
  }
}

void ForeignCsvTest::parseColumns_wrongWords_areErrors() {
  QVERIFY(!sim2d::parseColumns("time"));
  QVERIFY(!sim2d::parseColumns("tme=t"));
  QVERIFY(!sim2d::parseColumns("x=a,x=b"));
  QVERIFY(sim2d::parseColumns("tme=t").diagnostics()[0].message.find("'time'") !=
          std::string::npos);
}

void ForeignCsvTest::csv_otherSeparators_areSeen_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::newRow("semicolons") << QByteArray("time;id;x;y\n0;1;0;0\n1;1;0.5;2\n");
  QTest::newRow("tabs") << QByteArray("time\tid\tx\ty\n0\t1\t0\t0\n1\t1\t0.5\t2\n");
  QTest::newRow("mark, lines of Windows")
      << QByteArray("\xEF\xBB\xBFtime,id,x,y\r\n0,1,0,0\r\n1,1,0.5,2\r\n");
}

void ForeignCsvTest::csv_otherSeparators_areSeen() {
  QFETCH(QByteArray, text);
  Written files;
  const auto trace = traceOf(files.add("a.csv", text.toStdString()));
  QVERIFY2(trace, trace ? "" : trace.diagnostics().front().text().c_str());
  QCOMPARE(trace->frames[1].humans.x[0], 0.5);
  QCOMPARE(trace->frames[1].humans.y[0], 2.0);
}

/// Each slip once.
void ForeignCsvTest::csv_wrongColumnNames_haveHints() {
  Written files;
  const auto trace =
      traceOf(files.add("a.csv", "t,ped,px,py\n0,1,0,0\n"), withColumns("time=t,id=pad,x=px,y=yy"));
  QVERIFY(!trace);
  const base::Diagnostics& problems = trace.diagnostics();
  QCOMPARE(problems.size(), std::size_t{2});
  QVERIFY(problems[0].message == "there is no column 'pad' (did you mean 'ped'?)");
  QVERIFY(problems[1].message.find("there is no column 'yy'") == 0);
}

QTEST_APPLESS_MAIN(ForeignCsvTest)
#include "tst_TrackImportCsv.moc"
