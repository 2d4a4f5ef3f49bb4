#include <QtTest>

#include "MetricCases.h"
#include "SampledRun.h"
#include "metrics/Expression.h"

using namespace metrics;

namespace {

/// Robot at 0, 1, 3 m at 0, 1, 3 s; a person at (1, 2), at the last sample another at (3, 1).
SampledRun threeSamples() {
  SampledRun recording;
  recording.hasRobot = true;
  recording.goals = {{0, Vec2(5.0, 0.0), 0.2}};
  for (const double t : {0.0, 1.0, 3.0}) {
    Sample sample;
    sample.time = 10.0 + t;
    sample.robot.position = Vec2(t, 0.0);
    sample.robot.velocity = Vec2(1.0 + t, 0.0);
    sample.robot.speed = 1.0 + t;
    sample.robot.radius = 0.25;
    Pedestrian person;
    person.id = 4;
    person.position = Vec2(1.0, 2.0);
    person.radius = 0.25;
    person.speed = 0.5;
    sample.people = {person};
    recording.samples.push_back(sample);
  }
  Pedestrian second;
  second.id = 5;
  second.position = Vec2(3.0, 1.0);
  second.radius = 0.25;
  second.speed = 1.5;
  recording.samples[2].people.push_back(second);
  for (Sample& sample : recording.samples) {
    computePairs(sample, nullptr, MetricParameters{});
  }
  return recording;
}

MetricValue evaluated(const Expression& formula, const SampledRun& recording,
                      const MetricParameters& parameters = {}) {
  const std::vector<Sample>& samples = recording.samples;
  return formula.evaluate(samples, {recording, parameters, samples.back(), nullptr, nullptr,
                                    samples.size() - 1, samples.front().time});
}

std::string problemOf(const char* text) {
  const base::Result<Expression> expression = Expression::parse(text);
  return expression ? "" : expression.diagnostics().front().text();
}

}  // namespace

class ExpressionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void evaluate_formula_givesNumber_data() {
    QTest::addColumn<QByteArray>("formula");
    QTest::addColumn<double>("expected");
    const auto row = [](const char* formula, double expected) {
      QTest::newRow(formula) << QByteArray(formula) << expected;
    };
    row("1 + 2 * 3 - 4 / 8", 6.5);
    row("-2 ^ 2", -4.0);
    row("2 ^ 3 ^ 2", 512.0);
    row("(1 + 2) * 3", 9.0);
    row("1.5e1 + .5", 15.5);
    row("not 0 and 1 < 2 or 0", 1.0);
    row("duration", 3.0);
    row("samples", 3.0);
    row("max(speed)", 4.0);
    row("min(x)", 0.0);
    row("mean(speed)", 7.0 / 3.0);
    row("sum(people)", 4.0);
    row("integral(speed)", 1.0 * 1 + 2.0 * 2);
    row("integral(speed > 1.5)", 2.0);
    row("count(speed >= 2)", 2.0);
    row("first(time) + last(time)", 3.0);
    row("last(goal_distance)", 2.0);
    row("sum(speed > mean(speed))", 1.0);
    row("max(people_max(p.speed))", 1.5);
    row("last(people_mean(p.speed))", 1.0);
    row("last(people_sum(p.id))", 9.0);
    row("sum(people_count(p.speed > 1))", 1.0);
    row("sum(any(p.x > 2))", 1.0);
    row("sum(all(p.x < 2))", 2.0);
    row("min(people_min(p.gap))", 0.5);
    row("min(gap)", 0.5);
    row("intimate_distance", 0.45);
    row("hypot(3, 4) + abs(-1) + lesser(1, 2) + greater(1, 2)", 9.0);
    row("if(1 > 2, 5, 6)", 6.0);
    row("mean(defined(clearance))", 0.0);
    row("wrap(3 * pi) - pi", 0.0);
  }

  void evaluate_formula_givesNumber() {
    QFETCH(QByteArray, formula);
    QFETCH(double, expected);
    const base::Result<Expression> expression = Expression::parse(formula.toStdString());
    QVERIFY2(expression, expression ? "" : expression.diagnostics()[0].text().c_str());
    const MetricValue value = evaluated(*expression, threeSamples());
    QVERIFY(value.value);
    QVERIFY2(std::fabs(*value.value - expected) < 1e-12, std::to_string(*value.value).c_str());
  }

  void evaluate_undefined_hasNoValue() {
    for (const char* text : {"0 / 0", "1 / 0", "mean(clearance)", "sqrt(-1)"}) {
      const MetricValue value = evaluated(*Expression::parse(text), threeSamples());
      QVERIFY2(!value.value && !value.why.empty(), text);
    }
    // Samples without a value are passed over.
    SampledRun recording = threeSamples();
    recording.samples[0].robot.obstacleDistance = 1.25;
    QCOMPARE(*evaluated(*Expression::parse("mean(clearance)"), recording).value, 1.0);
  }

  void parse_mistake_isToldWithItsColumn_data() {
    QTest::addColumn<QByteArray>("formula");
    QTest::addColumn<QByteArray>("problem");
    const auto row = [](const char* formula, const char* problem) {
      QTest::newRow(formula) << QByteArray(formula) << QByteArray(problem);
    };
    row("", "1:1: error: the formula ends too early");
    row("max(speed", "1:10: error: ')' is missing");
    row("max(sped)", "1:5: error: unknown name 'sped' (did you mean 'speed'?)");
    row("maxx(speed)", "1:1: error: unknown function 'maxx' (did you mean 'max'?)");
    row("speed", "differs from sample to sample");
    row("max(p.speed)", "differs from person to person");
    row("1 + * 2", "1:5: error: a number or a name");
    row("1 2", "1:3: error: unexpected text");
    row("hypot(1)", "1:1: error: hypot takes 2 values, not 1");
    row("max(1, 2)", "max takes one value");
    row("1..5", "'1..5' is not a number");
  }

  void parse_mistake_isToldWithItsColumn() {
    QFETCH(QByteArray, formula);
    QFETCH(QByteArray, problem);
    const std::string told = problemOf(formula.constData());
    QVERIFY2(told.find(problem.toStdString()) != std::string::npos, told.c_str());
  }

  void parse_deepNesting_isRefused() {
    QVERIFY(!Expression::parse(std::string(3000, '(')));
    QVERIFY(!Expression::parse(std::string(3000, '-')));
    QVERIFY(!Expression::parse(std::string(100000, '1')));
  }

  void metricsFile_formulas_areMetrics() {
    const auto file = parseMetricsFile(
        "hunav_evaluator_node:\n  ros__parameters:\n    metrics: {path_length: true}\n"
        "hunavsim_metrics:\n  ros__parameters:\n    fast_time:\n"
        "      expression: \"integral(speed > 1.5)\"\n      unit: s\n      better: lower\n",
        "m.yaml");
    QVERIFY2(file, file ? "" : file.diagnostics()[0].text().c_str());
    const Evaluation evaluation =
        *evaluate(threeSamples(), file->selection, MetricParameters{}, standardRegistry());
    const MetricResult* result = evaluation.find("fast_time");
    QVERIFY(result != nullptr);
    QCOMPARE(*result->value.value, 2.0);
    QVERIFY(result->info.unit == "s" && result->info.better == Better::Lower);
    SampledRun alone = threeSamples();
    alone.hasRobot = false;
    const Evaluation people = *evaluate(alone, file->selection, MetricParameters{});
    QVERIFY(!people.find("fast_time")->value.value);
    // Formulas alone: all the others are on as well.
    const auto own = parseMetricsFile(
        "hunavsim_metrics:\n  ros__parameters:\n    n: {expression: samples}\n", "m.yaml");
    QVERIFY(own && !own->selection.keys && own->selection.own.size() == 1);
  }

  void metricsFile_mistakes_haveLineAndColumn() {
    const auto problems = [](const std::string& entry) {
      const auto file =
          parseMetricsFile("hunavsim_metrics:\n  ros__parameters:\n" + entry + "\n", "m.yaml");
      return file ? std::string() : file.diagnostics()[0].text();
    };
    const auto begins = [](const std::string& text, const char* start) {
      return text.compare(0, std::string(start).size(), start) == 0;
    };
    QVERIFY2(begins(problems("    a: {expression: max(sped)}"), "m.yaml:3:25: error: unknown name"),
             problems("    a: {expression: max(sped)}").c_str());
    QVERIFY2(begins(problems("    a: {expression: \"max(sped)\"}"), "m.yaml:3:26: error: unknown"),
             problems("    a: {expression: \"max(sped)\"}").c_str());
    QVERIFY(
        begins(problems("    path_length: {expression: samples}"), "m.yaml:3:5: error: a metric"));
    QVERIFY(begins(problems("    A b: {expression: samples}"), "m.yaml:3:5: error: a key"));
    QVERIFY(begins(problems("    a: {unit: s}"), "m.yaml:3:5: error: 'a' needs an expression"));
    QVERIFY(begins(problems("    a: {expression: samples, better: best}"), "m.yaml:3:38: error:"));
  }

  void metricsFile_written_readsBackEqual() {
    const auto file = parseMetricsFile(
        "hunavsim_metrics:\n  ros__parameters:\n    a: {expression: \"max(x) - min(x)\", name: "
        "it's}\n",
        "m.yaml");
    QVERIFY(file);
    const std::string text = writeMetricsFile(*file);
    const auto again = parseMetricsFile(text, "again.yaml");
    QVERIFY2(again, again ? "" : again.diagnostics()[0].text().c_str());
    QVERIFY(again->selection.own[0].info.formula == "max(x) - min(x)");
    QVERIFY(again->selection.own[0].info.name == "it's");
    QVERIFY(writeMetricsFile(*again) == text);
  }

  void stream_formula_equalsTheWholeRecord_data() {
    QTest::addColumn<QString>("text");
    for (const char* text :
         {"integral(gap < 0.5) / duration", "max(people_min(p.gap)) + samples", "mean(speed * dt)",
          "sum(people_sum(p.speed * dt))", "first(time) + last(time) * count(x > 1)",
          "integral(people_min(p.distance))", "min(goal_distance) - max(speed) / mean(speed)"}) {
      QTest::newRow(text) << QString::fromUtf8(text);
    }
  }

  void stream_formula_equalsTheWholeRecord() {
    QFETCH(QString, text);
    const Expression formula = *Expression::parse(text.toStdString());
    QVERIFY(!formula.needsRecord());
    SampledRun recording = sampledRunOf(cases::trace(60, 5));
    const MetricParameters parameters;
    MetricEntry entry;
    entry.computation = formula.computation();
    for (Sample& sample : recording.samples) {
      computePairs(sample, nullptr, parameters);
    }
    const MetricValue whole = evaluated(formula, recording, parameters);
    const MetricValue streamed = valueOf(entry, recording, parameters);
    QVERIFY(whole.value && streamed.value);
    QCOMPARE(*streamed.value, *whole.value);
  }

  void needsRecord_whereASumIsOfTheEnd() {
    for (const char* text : {"sum(speed > mean(speed))", "sum(speed / duration)",
                             "max(people_max(p.speed * samples))", "sum(not duration)"}) {
      QVERIFY2(Expression::parse(text)->needsRecord(), text);
    }
  }

  void liveMetrics_formulas_equalEvaluation() {
    Selection selection = *selectionOfKeys({"path_length"});
    selection.own = {*entryOf({"close", "integral(gap < 1)", "", "s", Better::Lower})};
    const sim2d::Trace trace = cases::trace(40, 5);
    FrameEvaluation live(trace.header, selection, MetricParameters{});
    for (const sim2d::Frame& frame : trace.frames) {
      live.append(frame);
    }
    const Evaluation evaluation = *evaluate(trace, selection, MetricParameters{});
    QCOMPARE(evaluation.results.size(), std::size_t{2});
    const std::string difference = cases::difference(live.values(), evaluation.results, 0.0);
    QVERIFY2(difference.empty(), difference.c_str());
  }
};

QTEST_APPLESS_MAIN(ExpressionTest)
#include "tst_Expression.moc"
