#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <QtTest>

#include "app/report/Comparison.h"
#include "app/report/Figure.h"
#include "app/report/Markup.h"
#include "app/report/Plots.h"
#include "app/report/RunPictures.h"
#include "app/report/Tables.h"

using namespace report;

namespace {

/// Two planners, one scenario, seeds 1 to 3; the second planner lacks seed 3.
Study smallStudy() {
  Study study;
  study.options = {"a", "b"};
  study.cases = {"hall"};
  const struct {
    std::size_t option;
    long long seed;
    double value;
  } rows[] = {{0, 1, 1.0}, {0, 2, 4.0}, {0, 3, 7.0}, {1, 1, 2.0}, {1, 2, 3.0}};
  study.results.keys = {"time"};
  study.results.metrics.emplace_back();
  study.results.isBoolean = {false};
  study.metrics = {{"time", "Time", "s", false, -1}};
  for (const auto& row : rows) {
    Results::Run run;
    run.seed = row.seed;
    study.results.runs.push_back(run);
    study.results.metrics[0].push_back(row.value);
    study.optionOf.push_back(row.option);
    study.caseOf.push_back(0);
  }
  return study;
}

/// Times of two planners, a pair for each seed.
Study pairedStudy(const std::vector<std::array<double, 2>>& pairs) {
  Study study = smallStudy();
  study.results.runs.clear();
  study.results.metrics[0].clear();
  study.optionOf.clear();
  study.caseOf.assign(2 * pairs.size(), 0);
  for (std::size_t seed = 0; seed < pairs.size(); ++seed) {
    for (std::size_t option = 0; option < 2; ++option) {
      Results::Run run;
      run.seed = static_cast<long long>(seed) + 1;
      study.results.runs.push_back(run);
      study.results.metrics[0].push_back(pairs[seed][option]);
      study.optionOf.push_back(option);
    }
  }
  return study;
}

/// Times of two planners in two scenarios: in `pen` shorter for the second one by 0.1 s to 0.6 s,
/// in `plaza` by chance and by up to a minute.
Study twoScenarios() {
  std::vector<std::array<double, 2>> pairs;
  for (int seed = 1; seed <= 6; ++seed) {
    pairs.push_back({5.0 + 0.1 * seed, 5.0});
  }
  for (const double difference : {-60.0, 50.0, -40.0, 30.0, -20.0, 10.0}) {
    pairs.push_back({200.0 + difference, 200.0});
  }
  Study study = pairedStudy(pairs);
  study.cases = {"pen", "plaza"};
  std::fill(study.caseOf.begin() + 12, study.caseOf.end(), 1);
  return study;
}

}  // namespace

/// Parts of reports: texts, scales, pairs.
class ReportPiecesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Planners may be in maps for the whole robot, after another varied path.
  void compared_byDefault_areThePlanners_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("second");
    QTest::addColumn<QString>("compared");
    QTest::addColumn<QString>("title");
    QTest::newRow("maps") << "robot1"
                          << "{planner: orca}"
                          << "robot1"
                          << "Planners compared";
    QTest::newRow("key") << "robot1.planner"
                         << "orca"
                         << "robot1.planner"
                         << "Planners compared";
    QTest::newRow("no planner") << "robot1"
                                << "{max_vel: 0.5}"
                                << "p01.max_vel"
                                << "Max vel compared";
  }
  void compared_byDefault_areThePlanners() {
    QFETCH(const QString, path);
    QFETCH(const QString, second);
    QFETCH(const QString, compared);
    QFETCH(const QString, title);
    const std::string first = second == QLatin1String("orca")             ? "dwa"
                              : second.contains(QLatin1String("planner")) ? "{planner: dwa}"
                                                                          : "{max_vel: 0.4}";
    Study study = smallStudy();
    study.results.runs.pop_back();
    study.results.metrics[0].pop_back();
    study.results.paths = {"p01.max_vel", path.toStdString()};
    for (std::size_t run = 0; run < 4; ++run) {
      study.results.runs[run].scenario = "hall.yaml";
      study.results.runs[run].values = {run % 2 == 0 ? "1.0" : "1.2",
                                        run < 2 ? first : second.toStdString()};
    }
    QVERIFY(selectCompared({}, study).empty());
    QCOMPARE(QString::fromStdString(study.compared), compared);
    QCOMPARE(QString::fromStdString(study.title), title);
  }

  void escaped_whatXmlRefuses_isReplaced() {
    QCOMPARE(escaped("a<b>&\"'"), std::string("a&lt;b&gt;&amp;&quot;&#39;"));
    QCOMPARE(escaped("\xC3\xA4\xE2\x88\x92"), std::string("\xC3\xA4\xE2\x88\x92"));
    QCOMPARE(escaped("a\x01z\xFF\xC3"), std::string("a\xEF\xBF\xBDz\xEF\xBF\xBD\xEF\xBF\xBD"));
    QCOMPARE(scriptSafe("\"</script>&\""), std::string("\"\\u003c/script\\u003e\\u0026\""));
  }

  void filled_values_areNotSearched() {
    const std::vector<std::pair<std::string_view, std::string>> values = {{"x", "{{y}}"},
                                                                          {"y", "2"}};
    QCOMPARE(filled("{{x}} {{y}} {{z}}", values), std::string("{{y}} 2 {{z}}"));
  }

  void numberText_rounding_isToTheNearest() {
    QCOMPARE(numberText(1.005, 1), std::string("1.0"));
    QCOMPARE(numberText(-0.04, 1), std::string("0.0"));
    QCOMPARE(numberText(-1.25, 2), std::string("−1.25"));
    QCOMPARE(numberText(1234.5, 0), std::string("1235"));
    QCOMPARE(numberText(0.0625, 3), std::string("0.063"));
    QCOMPARE(numberText(std::numeric_limits<double>::quiet_NaN(), 2), std::string("–"));
    QCOMPARE(plainNumber(-1.5, 1), std::string("-1.5"));
    QCOMPARE(pValueText(0.0004), std::string("< 0.001"));
    QCOMPARE(pValueText(0.0456), std::string("0.046"));
    QCOMPARE(pValueText(1.0), std::string("1"));
  }

  void latexText_commands_areEscaped() {
    QCOMPARE(latexText("50 % of a_b & {c} \\x ~ ^ <"),
             std::string("50 \\% of a\\_b \\& \\{c\\} \\textbackslash{}x \\textasciitilde{} "
                         "\\textasciicircum{} $<$"));
    QCOMPARE(latexText("−1.5 m²"), std::string("$-$1.5 m$^2$"));
    QCOMPARE(latexText("χ² ∞"), std::string("$\\chi$$^2$ $\\infty$"));  // Friedman's table
  }

  /// How many runs a mean is of stands beside it, and a bracket at the beginning of a row is no
  /// option of the line break before it.
  void tableLatex_cells_areWhole() {
    Table table;
    table.columns = {{"Option", {}, false}, {"Time", "s"}};
    table.rows = {{{"[0.0, 30.0]"}, {"20", "[18, 22]"}}};
    table.rows[0][1].note = "n = 5";
    const std::string latex = tableLatex(table);
    QVERIFY2(latex.find("    {}[0.0, 30.0] & 20 {\\footnotesize [18, 22]} {\\footnotesize n = 5} "
                        "\\\\\n") != std::string::npos,
             latex.c_str());
  }

  void levelText_level_isWhole() {
    QCOMPARE(levelText(0.95), std::string("95 %"));
    QCOMPARE(levelText(0.975), std::string("97.5 %"));
    QCOMPARE(levelText(0.999), std::string("99.9 %"));
  }

  void shellText_words_areQuotedWhereNeeded() {
    QCOMPARE(shellText({"hunavsim", "a b", "it's", "x=1", ""}),
             std::string("hunavsim 'a b' 'it'\\''s' x=1 ''"));
  }

  void ticks_areRoundNumbersWithin() {
    QCOMPARE(ticks(0.0, 1.0, 5),
             std::vector<double>({0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0}));
    QCOMPARE(ticks(-3.0, 12.0, 3), std::vector<double>({0.0, 5.0, 10.0}));
    QCOMPARE(ticks(980.0, 1010.0, 3), std::vector<double>({980.0, 990.0, 1000.0, 1010.0}));
    QCOMPARE(axisTicks({17.0, 24.0, 0.0, 136.0}), std::vector<double>({18.0, 22.0}));
    QCOMPARE(axisTicks({1.0, 9.1, 0.0, 136.0}), std::vector<double>({2.0, 6.0}));
    QCOMPARE(axisTicks({0.0, 1.0, 0.0, 136.0}), std::vector<double>({0.0, 0.5, 1.0}));
    const std::vector<double> wide = axisTicks({0.0, 12.0, 0.0, 1500.0});
    QCOMPARE(wide.size(), std::size_t{25});
    QCOMPARE(wide.back(), 12.0);
    const Scale equal = paddedScale(5.0, 5.0, 0.0, 10.0);
    QVERIFY(equal.low < 5.0 && equal.high > 5.0);
    QCOMPARE(paddedScale(1.0, 0.0, 0.0, 10.0).high, 1.0);  // nothing to show
    const Scale zeros = scaleOfValues({0.0, 0.0}, 0.0, 136.0);
    QCOMPARE(axisTicks(zeros), std::vector<double>({0.0, 1.0}));  // no contacts below none
  }

  void tickStep_isOneTwoOrFive() {
    QCOMPARE(tickStep(1.0, 4), 0.5);
    QCOMPARE(tickStep(10.0, 4), 5.0);
    QCOMPARE(tickStep(7.9, 4), 2.0);
    QCOMPARE(tickStep(60.0, 6), 10.0);
    QCOMPARE(tickStep(0.035, 4), 0.01);
  }

  void logarithmicScale_ticks_arePowersOfTen() {
    const Scale scale{0.02, 2000.0, 0.0, 500.0, true};
    const std::vector<double> at = axisTicks(scale);
    QCOMPARE(at.size(), std::size_t(5));
    QVERIFY(tickTexts(scale, at) == (std::vector<std::string>{"0.1", "1", "10", "100", "1000"}));
    QVERIFY(std::abs(scale.at(2.0) - 200.0) < 1e-9);  // two of five decades
  }

  /// A value that is undefined leaves a gap: two lines.
  void timePlot_undefinedValues_areGaps() {
    TimeCurve curve{"Speed", "m/s", {}, {}};
    for (int k = 0; k < 11; ++k) {
      curve.times.push_back(0.1 * k);
      curve.values.push_back(k == 5 ? std::nan("") : 0.1 * k);
    }
    const auto linesOf = [](const TimeCurve& drawn) {
      return QByteArray::fromStdString(timePlot({drawn}, 321.0).standalone())
          .count("stroke=\"#0072B2\"");
    };
    QCOMPARE(linesOf(curve), 2);
    curve.values[5] = 0.5;
    QCOMPARE(linesOf(curve), 1);
  }

  /// The axis of 0.3 to 1.9 begins at 0; the numbers of extreme values do not end the program.
  void timePlot_axis_hasWholeSteps() {
    const TimeCurve curve{"Speed", "m/s", {0.0, 1.0}, {0.3, 1.9}};
    const std::string svg = timePlot({curve}, 642.0, "caption", 0.5).standalone();
    for (const char* text :
         {">0.0<", ">0.5<", ">2.0<", ">Speed [m/s]<", ">time [s]<", ">caption<"}) {
      QVERIFY2(svg.find(text) != std::string::npos, text);
    }
    for (const double value : {0.0, -1.0, 1e308, -1e308}) {
      QVERIFY(timePlot({{"x", "", {0.0, 1.0}, {value, -value}}}, 321.0).markup().size() > 500);
    }
    QVERIFY(timePlot({{"x", "", {}, {}}}, 321.0).markup().size() > 500);
  }

  void shortened_utf8_cutsNoCharacter() {
    QCOMPARE(shortened("planner", 7), std::string("planner"));
    QCOMPARE(shortened("planners", 7), std::string("planne…"));
    QCOMPARE(shortened("ääää", 3), std::string("ää…"));
  }

  void wrapped_longNames_keepAllLetters() {
    using Lines = std::vector<std::string>;
    QCOMPARE(wrapped("planner", 7), Lines({"planner"}));
    QCOMPARE(wrapped("timed_elastic_band", 13), Lines({"timed_", "elastic_band"}));
    QCOMPARE(wrapped("abcdefghij", 4), Lines({"abcd", "efgh", "ij"}));
    QCOMPARE(wrapped("äöüäöü", 4), Lines({"äöüä", "öü"}));
    QCOMPARE(wrapped("", 4), Lines({""}));
  }

  /// Also in panels side by side, and in heads of narrow columns.
  void figures_longNames_areNotCut() {
    Study study = twoScenarios();
    study.options = {"model_predictive_path_integral", "timed_elastic_band_local"};
    study.metrics.push_back(study.metrics[0]);
    study.results.metrics.push_back(study.results.metrics[0]);
    const auto blocks = blocksOf(study);
    const Comparisons both = {compare(study, 0, blocks), compare(study, 1, blocks)};
    for (const std::optional<Figure>& figure :
         {intervalsFigure(study, both, false), distributionFigure(study, both),
          paretoFigure(study, both[0], both[1])}) {
      for (const std::string& option : study.options) {
        QVERIFY2(figure->markup().find(">" + option + "<") != std::string::npos,
                 figure->name().c_str());
      }
    }
    const std::string pairs = differencesFigure(study, both)->markup();
    QVERIFY(pairs.find(study.options[0] + " − " + study.options[1]) != std::string::npos);
    const std::string table = difficultyFigure(study, 0)->markup();
    QVERIFY(table.find(">integral<") != std::string::npos);  // of the last line of its head
    QVERIFY(table.find("…") == std::string::npos);
  }

  void standalone_roles_becomeColours() {
    Figure figure("f", 10.0, 10.0);
    figure.text(1.0, 2.0, "a<b", "ink");
    figure.mark(3.0, 4.0, 8);  // the eighth option has the second's mark and colour again
    const std::string svg = figure.standalone();
    QVERIFY(svg.find("class=") == std::string::npos);
    QVERIFY(svg.find("a&lt;b") != std::string::npos);
    QVERIFY(svg.find("#C65600") != std::string::npos);
    QVERIFY(figure.markup().find("class=\"f1\"") != std::string::npos);
  }

  void compare_missingRun_isLeftOutOfThePairs() {
    const Study study = smallStudy();
    const auto blocks = blocksOf(study);
    QCOMPARE(blocks.size(), std::size_t{3});
    const MetricComparison found = compare(study, 0, blocks);
    QCOMPARE(found.pairs.size(), std::size_t{1});
    QCOMPARE(found.pairs[0].differences, Numbers({-1.0, 1.0}));
    QCOMPARE(found.pairs[0].p, 1.0);
    QCOMPARE(found.estimates[0].mean, 4.0);
    QCOMPARE(found.estimates[1].mean, 2.5);
    QVERIFY(found.best == std::size_t{1});  // less time is better
    QVERIFY(found.relativeToBest[0] == RelativeToBest::NotDifferent);
    QVERIFY(!found.friedman);
  }

  void constantCells_seedsThatChangeNothing_areNamed() {
    using Names = std::vector<std::string>;
    Study study = smallStudy();
    QCOMPARE(constantCells(study), Names());
    study.results.metrics[0] = {1.0, 1.0, 1.0, 2.0, 3.0};  // of the first option all are equal
    QCOMPARE(constantCells(study), Names({"a, hall"}));
    study.results.metrics[0] = {1.0, 1.0009, 1.0, 2.0, 3.0};  // the limit is 0.1 %
    QCOMPARE(constantCells(study), Names({"a, hall"}));
    study.results.metrics[0][1] = 1.0011;
    QCOMPARE(constantCells(study), Names());
    study.results.metrics[0] = {1.0, 1.0, std::numeric_limits<double>::quiet_NaN(), 2.0, 3.0};
    QCOMPARE(constantCells(study), Names());
    study.results.metrics.push_back({4.0, 4.0, 5.0, 4.0, 4.0});  // every column must be constant
    study.results.metrics[0][2] = 1.0;
    QCOMPARE(constantCells(study), Names());
    study.results.metrics.pop_back();
    QCOMPARE(constantCells(study), Names({"a, hall"}));
    for (Results::Run& run : study.results.runs) {
      run.seed = 1;  // repeated points of a design
    }
    QCOMPARE(constantCells(study), Names());
  }

  /// 0.3 - 0.2 and 0.2 - 0.1 are not the same double, and the same difference.
  void compare_differencesByRounding_areTies() {
    Study study = smallStudy();
    study.results.metrics[0] = {0.3, 0.2, 7.0, 0.2, 0.1};
    const MetricComparison found = compare(study, 0, blocksOf(study));
    QVERIFY(0.3 - 0.2 != 0.2 - 0.1);
    QCOMPARE(found.pairs[0].differences, Numbers({0.1, 0.1}));
  }

  /// Who breaks down at once drives the shortest way and comes near nobody.
  void compare_failedRun_countsForNothingButSuccess() {
    Study study = smallStudy();
    study.results.runs[0].ok = false;
    const MetricComparison found = compare(study, 0, blocksOf(study));
    QCOMPARE(found.estimates[0].values, Numbers({4.0, 7.0}));
    QCOMPARE(found.pairs[0].differences, Numbers({1.0}));
    study.metrics = {{"success", "Success", "-", true, 1}};
    study.results.metrics[0] = {1.0, 1.0, 0.0, 1.0, 1.0};
    QCOMPARE(valueOf(study, 0, 0), 0.0);
    QCOMPARE(compare(study, 0, blocksOf(study)).estimates[0].successes, 1);
  }

  void compare_equalMeans_allLead() {
    Study study = smallStudy();
    study.results.metrics[0] = {1.0, 4.0, 2.5, 2.0, 3.0};
    QVERIFY(!compare(study, 0, blocksOf(study)).best);  // all are equal
    study.options.emplace_back("c");
    study.optionOf[2] = 2;
    study.results.metrics[0][2] = 7.0;
    const MetricComparison found = compare(study, 0, blocksOf(study));
    QVERIFY(found.isBestOrTied(0) && found.isBestOrTied(1) && !found.isBestOrTied(2));
  }

  /// The way of the first option is shorter because it ends early.
  void compare_optionThatNeverSucceeds_isNotBest() {
    Study study = smallStudy();
    study.results.keys.emplace_back("success");
    study.metrics.push_back({"success", "Success", "-", true, 1});
    study.results.metrics[0] = {1.0, 1.0, 1.5, 2.0, 3.0};
    const auto bestWith = [&](const std::vector<double>& success) {
      study.results.metrics.resize(1);
      study.results.metrics.push_back(success);
      return compare(study, 0, blocksOf(study)).best;
    };
    QVERIFY(bestWith({1.0, 0.0, 0.0, 1.0, 0.0}) == std::size_t{0});
    QVERIFY(bestWith({0.0, 0.0, 0.0, 1.0, 0.0}) == std::size_t{1});
    QVERIFY(!bestWith({0.0, 0.0, 0.0, 0.0, 0.0}));
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();  // a crowd without a robot
    QVERIFY(bestWith({kNone, kNone, kNone, kNone, kNone}) == std::size_t{0});
    QVERIFY(bestWith({kNone, 0.0, kNone, 1.0, kNone}) == std::size_t{1});
  }

  /// What its runs measure is of pieces: it is not ranked, but in success itself.
  void compare_optionThatNeverSucceeds_isNotBeaten() {
    Study study =
        pairedStudy({{1.0, 3.0}, {1.1, 3.1}, {1.2, 3.2}, {1.3, 3.3}, {1.4, 3.4}, {1.5, 3.5}});
    study.results.keys.emplace_back("success");
    study.results.metrics.emplace_back();
    study.metrics.push_back({"success", "Success", "-", true, 1});
    for (std::size_t run = 0; run < study.runCount(); ++run) {
      study.results.metrics[1].push_back(run % 2 == 0 ? 1.0 : 0.0);
    }
    const MetricComparison time = compare(study, 0, blocksOf(study));
    QVERIFY(time.best == std::size_t{0});
    QVERIFY(time.pairs[0].adjusted < kSignificance);
    QVERIFY(time.relativeToBest[1] == RelativeToBest::NeverSucceeds);
    const MetricComparison success = compare(study, 1, blocksOf(study));
    QVERIFY(success.best == std::size_t{0});
    QVERIFY(success.relativeToBest[1] == RelativeToBest::Worse);
  }

  /// The first arrives only where the way is short, and is slower there.
  void compare_bestByItsMeanAlone_isNotBetter() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const Study study = pairedStudy({{6.0, 5.0},
                                     {7.0, 5.9},
                                     {8.0, 6.8},
                                     {9.0, 7.7},
                                     {10.0, 8.6},
                                     {11.0, 9.5},
                                     {kNone, 90.0},
                                     {kNone, 95.0}});
    const MetricComparison found = compare(study, 0, blocksOf(study));
    QVERIFY(found.best == std::size_t{0});
    QVERIFY(found.relativeToBest[1] == RelativeToBest::Better);
  }

  /// Nothing to compare is no equality, and takes no part in the adjustment of the others.
  void compare_noCommonBlock_hasNoP() {
    Study study =
        pairedStudy({{1.0, 2.0}, {1.1, 2.2}, {1.2, 2.4}, {1.3, 2.6}, {1.4, 2.8}, {1.5, 3.0}});
    study.options.emplace_back("c");
    Results::Run run;
    run.seed = 99;
    study.results.runs.push_back(run);
    study.results.metrics[0].push_back(9.0);
    study.optionOf.push_back(2);
    study.caseOf.push_back(0);
    const MetricComparison found = compare(study, 0, blocksOf(study));
    QVERIFY(std::isnan(found.pairOf(0, 2)->p) && std::isnan(found.pairOf(0, 2)->adjusted));
    QCOMPARE(found.pairOf(0, 1)->adjusted, found.pairOf(0, 1)->p);
    QCOMPARE(found.pairOf(0, 1)->p, 0.03125);  // 2 / 2^6
  }

  /// By hand: of 150 pairs 3 differ, (1.95996 √0.02 + 0.84162 √0.0196)² / 0.02² = 390.08; of 10
  /// pairs 8 differ, all one way, 1.95996² / (3 / 4) = 5.1 → 6, over 8 / 10.
  void compare_pairsThatTie_tellNothing() {
    std::vector<std::array<double, 2>> rare(150, {0.0, 0.0});
    rare[3] = rare[50] = rare[99] = {1.0, 0.0};
    const Study few = pairedStudy(rare);
    QCOMPARE(compare(few, 0, blocksOf(few)).pairs[0].requiredPairs, 391.0);
    std::vector<std::array<double, 2>> some(10, {1.0, 1.0});
    for (std::size_t k = 0; k < 8; ++k) {
      some[k][0] = 2.0 + 0.1 * static_cast<double>(k);
    }
    const Study most = pairedStudy(some);
    QCOMPARE(compare(most, 0, blocksOf(most)).pairs[0].requiredPairs, 8.0);
  }

  /// All three seeds differ in success: no difference that is known to no width.
  void compare_rates_haveTheIntervalOfPairs() {
    Study study = smallStudy();
    study.metrics = {{"success", "Success", "-", true, 1}};
    study.results.metrics[0] = {1.0, 1.0, 1.0, 0.0, 0.0};
    const MetricComparison found = compare(study, 0, blocksOf(study));
    QCOMPARE(found.pairs[0].shift, 1.0);
    QVERIFY(found.pairs[0].shiftInterval.low < 0.5);
    QCOMPARE(found.pairs[0].requiredPairs, 6.0);
  }

  /// A column of zeros is only named, unless it was asked for; success is always shown.
  void resultsTable_columnOfZeros_isOnlyNamed() {
    Study study = smallStudy();
    study.results.metrics[0] = {0.0, 0.0, 0.0, 0.0, 0.0};
    const auto table = [&study] {
      return resultsTable(study, {compare(study, 0, blocksOf(study))}, {});
    };
    QCOMPARE(table().columns.size(), std::size_t{2});
    QCOMPARE(table().rows[0].size(), std::size_t{2});
    QVERIFY(table().caption.find("0 or undefined in all runs: Time.") != std::string::npos);
    QVERIFY(!mediansTable(study, {compare(study, 0, blocksOf(study))}));
    study.hasChosenMetrics = true;
    QCOMPARE(table().columns.size(), std::size_t{3});
    study.hasChosenMetrics = false;
    study.results.metrics[0][4] = 1.0;
    QCOMPARE(table().columns.size(), std::size_t{3});
    study.metrics = {{"success", "Success", "-", true, 1}};
    study.results.metrics[0][4] = 0.0;
    QCOMPARE(table().columns.size(), std::size_t{3});
  }

  /// 20 ± 8 alone would have one digit after the point, 1.015 ± 0.005 has three.
  void resultsTable_column_hasTheSameDigits() {
    Study study = smallStudy();
    study.results.metrics[0] = {10.0, 20.0, 30.0, 1.01, 1.02};
    const Table table = resultsTable(study, {compare(study, 0, blocksOf(study))}, {});
    QCOMPARE(table.rows[0][2].text, std::string("20.000"));
    QCOMPARE(table.rows[1][2].text, std::string("1.015"));
    study.results.metrics[0] = {10e6, 20e6, 30e6, 1.01, 1.02};
    QCOMPARE(resultsTable(study, {compare(study, 0, blocksOf(study))}, {}).rows[0][2].text,
             std::string("20000000"));
  }

  void tableHtml_number_isBeforeTheCaption() {
    Table table;
    table.caption = "Means.";
    QVERIFY(tableHtml(table, {}, 2).find("<caption><b>Table 2.</b> Means.</caption>") !=
            std::string::npos);
    QVERIFY(tableHtml(table).find("<caption>Means.</caption>") != std::string::npos);
  }

  /// Three counts of 0 show nothing about the width of an interval; 0 of 3 runs do: Wilson's end is
  /// z² / (n + z²) = 3.8415 / 6.8415.
  void compare_equalValues_haveNoInterval() {
    Study study = smallStudy();
    study.results.metrics[0] = {0.0, 0.0, 0.0, 2.0, 3.0};
    MetricComparison found = compare(study, 0, blocksOf(study));
    QVERIFY(found.estimates[0].isConstant && !found.estimates[1].isConstant);
    QVERIFY(!found.estimates[0].interval.isDefined());
    QVERIFY(!found.estimates[0].medianInterval.isDefined());
    QVERIFY(found.estimates[1].interval.isDefined());
    const Table results = resultsTable(study, {found}, {});
    QCOMPARE(results.rows[0][2].below, std::string("constant"));
    QVERIFY(results.caption.find("Constant: all runs have this value") != std::string::npos);
    study.results.metrics[0] = {4.0, 5.0, 7.0, 2.0, 3.0};  // both pairs differ by 2
    found = compare(study, 0, blocksOf(study));
    QCOMPARE(pairsTable(study, {found}, true).rows[0][4].below, std::string("constant"));
    study.metrics[0].isRate = true;
    study.results.metrics[0] = {0.0, 0.0, 0.0, 1.0, 1.0};
    const statistics::Interval rate = compare(study, 0, blocksOf(study)).estimates[0].interval;
    QCOMPARE(rate.low, 0.0);
    QVERIFY(std::abs(rate.high - 0.5615) < 1e-4);
  }

  /// In one scenario all six agree: p = 2/2^6 of the signed-rank test. In the other the ranks are
  /// 6 - 5 + 4 - 3 + 2 - 1. Together, each weighted with 1/7: of the 2^12 changes of signs, counted
  /// by a program of a few lines, 442 give a sum of 21 + 9 or more.
  void compare_scenarios_areTestedEachAndTogether() {
    const Study study = twoScenarios();
    const PairResult pair = compare(study, 0, blocksOf(study)).pairs[0];
    QCOMPARE(pair.cases.size(), std::size_t{2});
    QCOMPARE(pair.cases[0].differences.size(), std::size_t{6});
    QVERIFY(std::abs(pair.cases[0].p - 2.0 / 64.0) < 1e-12);
    QVERIFY(std::abs(pair.cases[0].shift - 0.35) < 1e-9);
    QVERIFY(pair.cases[1].p > 0.6);
    QCOMPARE(pair.cases[0].adjusted, 4.0 / 64.0);  // the smaller one of two tests
    QVERIFY2(std::abs(pair.p - 2.0 * 442.0 / 4096.0) < 1e-12,
             qPrintable(QString::number(pair.p * 2048.0)));
    QCOMPARE(pair.delta, 0.5);  // 1 in one, 0 in the other
    const Table rows = *casePairsTable(study, {compare(study, 0, blocksOf(study))}, true);
    QCOMPARE(rows.rows.size(), std::size_t{2});
    QCOMPARE(rows.rows[1][2].text, std::string("plaza"));
    QCOMPARE(rows.rows[0][4].text, std::string("6 / 0 / 0"));
    const Table all = pairsTable(study, {compare(study, 0, blocksOf(study))}, true);
    QCOMPARE(all.rows[0].back().text, std::string("1 / 0 / 1"));
    QVERIFY(!casePairsTable(smallStudy(), {}, true));
  }

  void compare_clearDifference_isMarked() {
    std::vector<std::array<double, 2>> pairs;
    for (int seed = 1; seed <= 8; ++seed) {
      pairs.push_back({1.1 * seed, 1.0 * seed});
    }
    const Study study = pairedStudy(pairs);
    const MetricComparison found = compare(study, 0, blocksOf(study));
    QVERIFY(found.best == std::size_t{1});
    QVERIFY(std::abs(found.pairs[0].p - 2.0 / 256.0) < 1e-12);  // eight of one sign: 2 / 2^8
    QVERIFY(found.relativeToBest[0] == RelativeToBest::Worse);
    QVERIFY(found.relativeToBest[1] == RelativeToBest::NotDifferent);
  }
};

QTEST_APPLESS_MAIN(ReportPiecesTest)
#include "tst_ReportPieces.moc"
