#include <QtTest>

#include "tests/trace/TrackImportTest.h"

using namespace foreign;

namespace {

/// Rows of a body that walks along x at 1 m/s.
std::string walk(int id, double y, double step, int count, double begin = 0.0) {
  std::string rows;
  for (int k = 0; k < count; ++k) {
    const double time = begin + step * k;
    rows += base::formatDouble(time) + ',' + std::to_string(id) + ',' + base::formatDouble(time) +
            ',' + base::formatDouble(y) + '\n';
  }
  return rows;
}

/// In how many instants somebody of this id is there.
std::size_t instantsOf(const Trace& trace, int id) {
  std::size_t count = 0;
  for (const sim2d::Frame& frame : trace.frames) {
    const std::vector<int>& ids = frame.humans.id;
    count += static_cast<std::size_t>(std::count(ids.begin(), ids.end(), id));
  }
  return count;
}

}  // namespace

/// How long somebody may be unseen and yet be there, where bodies are seen at different rates.
class TrackRatesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Seen twice at 0.1 s and then after a minute on the other side of the robot's way.
  void person_afterAMinute_wasAway() {
    const auto trace = traceOf(files_.add("minute.csv", "time,id,x,y\n" + walk(1, 5.0, 0.1, 601) +
                                                            "0,2,3,0\n0.1,2,3,0.01\n60,2,3,10\n"));
    QVERIFY(trace);
    QCOMPARE(trace->header.dt, 0.1);
    QCOMPARE(instantsOf(*trace, 1), std::size_t{601});
    QCOMPARE(instantsOf(*trace, 2), std::size_t{3});
    QVERIFY(!tells(trace.diagnostics(), "tracks.rates-differ-by-body"));
  }
  /// Two observations tell no rate: that of the other counts.
  void person_seenTwice_wasAway() {
    const auto trace = traceOf(
        files_.add("twice.csv", "time,id,x,y\n" + walk(1, 5.0, 0.1, 601) + "0,2,3,0\n60,2,3,10\n"));
    QVERIFY(trace);
    QCOMPARE(instantsOf(*trace, 2), std::size_t{2});
  }
  /// Nor do three, 2 s apart: 0.55 s are an absence beside somebody at 10 Hz, and 0.5 s are none.
  void person_seenThreeTimes_wasAwayAsLongAsOthersAre() {
    const auto instants = [this](double step) {
      const auto trace = traceOf(files_.add(
          "three.csv", "time,id,x,y\n" + walk(1, 5.0, 0.1, 101) + walk(2, 0.0, step, 3)));
      return trace ? instantsOf(*trace, 2) : 0;
    };
    QCOMPARE(instants(2.0), std::size_t{3});
    QCOMPARE(instants(0.6), std::size_t{3});
    QCOMPARE(instants(0.5), std::size_t{11});
  }
  /// Alone: the step is the shorter of two intervals, not the longer.
  void person_alone_wasAway() {
    const auto trace = traceOf(files_.add("alone.csv",
                                          "time,id,x,y\n0,2,3,0\n0.1,2,3,0.01\n"
                                          "60,2,3,10\n"));
    QVERIFY(trace);
    QCOMPARE(trace->header.dt, 0.1);
    QCOMPARE(instantsOf(*trace, 2), std::size_t{3});
  }
  /// Every 20 s beside others at 10 Hz: a rate of its own, but no way between. That is told.
  void person_seenSeldom_isThereAtTheseInstants() {
    const auto trace = traceOf(files_.add(
        "seldom.csv", "time,id,x,y\n" + walk(1, 5.0, 0.1, 1001) + walk(2, 0.0, 20.0, 6)));
    QVERIFY(trace);
    QCOMPARE(instantsOf(*trace, 2), std::size_t{6});
    QCOMPARE(trace.diagnostics().size(), std::size_t{1});
    QVERIFY(tells(trace.diagnostics(), "tracks.seen-seldom"));
    QVERIFY(trace.diagnostics()[0].message.find("20 s") != std::string::npos);
  }
  /// At 10 Hz beside a robot at 1000 Hz, one of them seen four times only: no gaps.
  void people_seenHundredTimesLessOften_areThere() {
    const auto trace =
        traceOf(files_.add("fast.csv", "time,id,x,y\n" + walk(1, 5.0, 0.001, 2001) +
                                           walk(2, 0.0, 0.1, 21) + walk(3, 2.0, 0.1, 4)));
    QVERIFY(trace && tells(trace.diagnostics(), "tracks.rates-differ-by-body"));
    QCOMPARE(trace->header.dt, 0.001);
    QCOMPARE(instantsOf(*trace, 2), std::size_t{2001});
    QCOMPARE(instantsOf(*trace, 3), std::size_t{301});
  }
  /// 1 Hz beside 50 Hz: 5.5 of its own intervals are 5.5 s, gaps of 5 s are none and of 6 s are.
  void gaps_goByTheOwnInterval() {
    const auto seen = [this](double again) {
      const auto trace =
          traceOf(files_.add("own.csv", "time,id,x,y\n" + walk(1, 5.0, 0.02, 801) +
                                            walk(2, 0.0, 1.0, 6) + walk(2, 0.0, 1.0, 6, again)));
      return trace ? instantsOf(*trace, 2) : 0;
    };
    QCOMPARE(seen(10.0), std::size_t{751});        // 0 to 15 s
    QCOMPARE(seen(11.0), std::size_t{251 + 251});  // 0 to 5 s and 11 s to 16 s
  }
  /// A finer grid makes nobody absent: those seen every 0.4 s stay there at steps of 1 ms.
  void step_thatIsFiner_keepsPeople() {
    TrackOptions options;
    options.step = 0.001;
    const auto trace =
        traceOf(files_.add("fine.csv", "time,id,x,y\n" + walk(1, 0.0, 0.4, 6)), {}, options);
    QVERIFY(trace);
    QCOMPARE(instantsOf(*trace, 1), std::size_t{2001});
  }
  void robot_seldomSeen_isTold() {
    TrackOptions options;
    options.robotId = 2;
    const auto trace = traceOf(files_.add("robot.csv", "time,id,x,y\n" + walk(1, 5.0, 0.1, 601) +
                                                           "0,2,3,0\n0.1,2,3,0.01\n60,2,3,10\n"),
                               {}, options);
    QVERIFY(trace && tells(trace.diagnostics(), "tracks.robot-gap"));
    QVERIFY(trace.diagnostics().front().message.find("59.9 s") != std::string::npos);
  }

 private:
  Written files_;
};

QTEST_APPLESS_MAIN(TrackRatesTest)
#include "tst_TrackRates.moc"
