#include <algorithm>
#include <map>

#include <QtTest>

#include "MetricCases.h"
#include "metrics/Expression.h"
#include "metrics/IncrementalEvaluation.h"
#include "tests/AllocationCount.h"

using namespace metrics;

Q_DECLARE_METATYPE(metrics::Selection)

namespace {

constexpr double kStep = 0.05;  // [s]
constexpr int kPeople = 5;

/// Goes round and round, so that places and neighbours are those of the first round.
sim2d::Frame frameAt(int step) {
  sim2d::Frame frame = cases::frameAt(step % 200, kPeople, kStep);
  frame.step = step;
  frame.time = step * kStep;
  return frame;
}

sim2d::Event eventOf(sim2d::EventKind kind, int id) {
  sim2d::Event event;
  event.kind = kind;
  event.hasId = true;
  event.id = id;
  event.text = "a text that needs memory of its own, and so on";
  return event;
}

Selection totals() {
  Selection selection;
  selection.series = false;
  selection.behaviors = false;
  return selection;
}

struct Held {
  long few = 0, many = 0;  // [B] after some samples and ten times as many
};

Held heldBy(const Selection& selection, Profile profile) {
  constexpr int kFew = 1000;
  Held held;
  MetricParameters parameters = cases::parametersOf(profile);
  parameters.timeLimit = 1.0;  // the sums at it are kept aside from then on
  FrameEvaluation evaluation(cases::header(kPeople, kStep), selection, parameters);
  for (int step = 0; step <= 10 * kFew; ++step) {
    const sim2d::Frame frame = frameAt(step);
    evaluation.note(frame.time, eventOf(sim2d::EventKind::Replan, -1));
    evaluation.note(frame.time, eventOf(sim2d::EventKind::Arrived, 1 + step % kPeople));
    evaluation.append(frame);
    (step <= kFew ? held.few : held.many) = bytesHeld;
  }
  return held;
}

}  // namespace

/// What an evaluation holds while a run goes on.
class StreamMemoryTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void totals_tenTimesTheSamples_holdNoMore_data() {
    QTest::addColumn<Selection>("selection");
    QTest::addColumn<bool>("original");
    QTest::newRow("corrected") << totals() << false;
    QTest::newRow("hunav2") << totals() << true;
    Selection perType = totals();
    perType.behaviors = true;
    perType.behaviorSeries = false;
    QTest::newRow("per behaviour type") << perType << false;
    Selection part = totals();
    part.window.until = "time 20";
    part.window.frequency = 4.0;
    QTest::newRow("part of the run") << part << false;
    Selection never = totals();
    never.window.from = "event stuck";
    QTest::newRow("a part that never begins") << never << false;
    Selection formula = totals();
    formula.own = {*entryOf({"close", "integral(gap < 1) / duration", "", "", Better::Lower})};
    QTest::newRow("with a formula") << formula << false;
  }

  void totals_tenTimesTheSamples_holdNoMore() {
    QFETCH(Selection, selection);
    QFETCH(bool, original);
    const Held held = heldBy(selection, original ? Profile::Hunav2 : Profile::Corrected);
    constexpr long kNoise = 2048;  // [B] buffers of the newest samples; a number each is 72 000
    QVERIFY2(held.many - held.few < kNoise, std::to_string(held.many - held.few).c_str());
  }

  /// One number per sample and column, at most twice while the vectors grow.
  void series_growByTheirValuesAlone() {
    Selection selection;
    selection.behaviors = false;
    const auto results = evaluate(cases::trace(10, kPeople), selection, {});
    const auto columns =
        std::count_if(results->results.begin(), results->results.end(),
                      [](const MetricResult& result) { return result.value.series.has_value(); });
    const Held held = heldBy(selection, Profile::Corrected);
    constexpr long kSamples = 9000;
    const long column = kSamples * static_cast<long>(sizeof(double));
    QVERIFY(held.many - held.few > column * columns / 2);
    QVERIFY2(held.many - held.few < 2 * column * (columns + 20),
             std::to_string(held.many - held.few).c_str());
  }

  /// And by where their blocks lie.
  void series_onDisk_growByTheTimesAlone() {
    Selection selection;
    selection.behaviors = false;
    selection.seriesOnDisk = true;
    const Held held = heldBy(selection, Profile::Corrected);
    constexpr long kTimes = 2L * 9000 * static_cast<long>(sizeof(double));
    QVERIFY2(held.many - held.few < kTimes + 100000, std::to_string(held.many - held.few).c_str());
  }

  void series_onDisk_areThoseInMemory() {
    const sim2d::Trace trace = cases::trace(1500, kPeople);
    for (const Profile profile : {Profile::Corrected, Profile::Hunav2}) {
      const auto inMemory = evaluate(trace, Selection{}, cases::parametersOf(profile));
      Selection selection;
      selection.seriesOnDisk = true;
      FrameEvaluation evaluation(trace.header, selection, cases::parametersOf(profile));
      for (const sim2d::Frame& frame : trace.frames) {
        evaluation.append(frame);
      }
      std::map<std::string, std::vector<double>> taken;
      const auto onDisk =
          evaluation.finish([&taken](const std::string& /*robot*/, const MetricInfo& info,
                                     const Series& series) { taken[info.key] = series.values; });
      QVERIFY(inMemory && onDisk);
      std::size_t columns = 0;
      for (const MetricResult& result : inMemory->results) {
        if (result.value.series) {
          ++columns;
          const std::vector<double>& values = taken[result.info.key];
          QCOMPARE(values.size(), result.value.series->values.size());
          QVERIFY2(std::equal(values.begin(), values.end(), result.value.series->values.begin(),
                              [](double a, double b) { return a == b || (a != a && b != b); }),
                   result.info.key.c_str());
        }
      }
      QCOMPARE(taken.size(), columns);
      QVERIFY(!onDisk->find("path_length")->value.series);
    }
  }

  void wholeRecord_isKeptForWhoWantsIt() {
    Selection selection = totals();
    selection.keys.emplace();
    selection.own = {*entryOf({"fast", "sum(speed > mean(speed))", "", "", Better::Lower})};
    const Held held = heldBy(selection, Profile::Corrected);
    QVERIFY(held.many - held.few > 9000 * static_cast<long>(sizeof(Sample)));
  }

  void totals_equalThoseOfAllResults_data() {
    QTest::addColumn<bool>("original");
    QTest::newRow("corrected") << false;
    QTest::newRow("hunav2") << true;
  }

  void totals_equalThoseOfAllResults() {
    QFETCH(bool, original);
    const MetricParameters parameters =
        cases::parametersOf(original ? Profile::Hunav2 : Profile::Corrected);
    const sim2d::Trace trace = cases::trace(300, 6);
    const auto all = evaluate(trace, Selection{}, parameters);
    const auto few = evaluate(trace, totals(), parameters);
    QVERIFY(all && few);
    const std::string problem = cases::difference(all->results, few->results, 0.0);
    QVERIFY2(problem.empty(), problem.c_str());
    QVERIFY(few->behaviors.empty() && few->times.empty());
    for (const MetricResult& result : few->results) {
      QVERIFY2(!result.value.series, result.info.key.c_str());
    }
  }
};

QTEST_APPLESS_MAIN(StreamMemoryTest)
#include "tst_StreamMemory.moc"
