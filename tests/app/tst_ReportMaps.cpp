#include <QRegularExpression>
#include <QtTest>

#include "app/report/Plots.h"
#include "app/report/RunPictures.h"
#include "tests/app/RunFiles.h"

using namespace report;
using outside::text;

namespace {

const char* const kHall = "hall.yaml";

/// One run per option and case, options first, each kept and with a way unless it is left out.
struct MapStudy {
  Study study;
  RunPictures pictures;

  MapStudy(std::size_t options, std::size_t cases, const std::set<std::size_t>& without = {}) {
    for (std::size_t k = 0; k < options; ++k) {
      study.options.push_back("option" + std::to_string(k));
    }
    for (std::size_t k = 0; k < cases; ++k) {
      study.cases.push_back("case" + std::to_string(k));
    }
    FloorPlan ground;
    ground.high = {10.0, 5.0};
    pictures.floorPlans[kHall] = ground;
    for (std::size_t run = 0; run < options * cases; ++run) {
      addRun(run % options, run / options, without.count(run) == 0);
    }
  }

  void addRun(std::size_t option, std::size_t ofCase, bool isKept) {
    Results::Run run;
    run.number = static_cast<long long>(study.runCount());
    run.scenario = kHall;
    study.results.runs.push_back(run);
    study.optionOf.push_back(option);
    study.caseOf.push_back(ofCase);
    if (isKept) {
      RunPicture picture;
      picture.run = study.runCount() - 1;
      picture.path = {{1.0, 1.0}, {2.0, 1.0}};
      pictures.runs.push_back(picture);
      ++pictures.kept;
    }
  }
};

/// Where these words stand, in the order of the drawing.
std::vector<base::Vec2> placesOf(const Figure& figure, const std::string& words) {
  const QRegularExpression wanted(text(R"raw(<text x="([-\d.]+)" y="([-\d.]+)"[^>]*>)raw") +
                                  QRegularExpression::escape(QString::fromStdString(words)) +
                                  text("</text>"));
  std::vector<base::Vec2> places;
  auto each = wanted.globalMatch(QString::fromStdString(figure.markup()));
  while (each.hasNext()) {
    const auto match = each.next();
    places.emplace_back(match.captured(1).toDouble(), match.captured(2).toDouble());
  }
  return places;
}

/// How strongly the squares of contacts are drawn, in the order of the drawing; 1: nothing is said.
std::vector<double> strengthsOf(const Figure& figure) {
  const QRegularExpression wanted(text(R"raw(<rect [^>]*class="hot"/>)raw"));
  const QRegularExpression opacity(text(R"raw(opacity="([\d.]+)")raw"));
  std::vector<double> strengths;
  auto each = wanted.globalMatch(QString::fromStdString(figure.markup()));
  while (each.hasNext()) {
    const auto match = opacity.match(each.next().captured());
    strengths.push_back(match.hasMatch() ? match.captured(1).toDouble() : 1.0);
  }
  return strengths;
}

bool areApart(const Box& a, const Box& b) {
  return a.high.x() <= b.low.x() || b.high.x() <= a.low.x() || a.high.y() <= b.low.y() ||
         b.high.y() <= a.low.y();
}

bool has(const std::string& all, const char* part) {
  return all.find(part) != std::string::npos;
}

}  // namespace

/// Maps, contacts and names of points in reports.
class ReportMapsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Nothing was kept of the first option in the first case, and of the whole second case.
  void waysFigure_cellWithoutRun_staysBlank() {
    const MapStudy all(2, 3, {0, 2, 3});
    const std::optional<Figure> figure = pathsFigure(all.study, all.pictures);
    QVERIFY(figure);
    QCOMPARE(placesOf(*figure, "case0").size(), std::size_t{1});
    QCOMPARE(placesOf(*figure, "case1").size(), std::size_t{0});
    QCOMPARE(placesOf(*figure, "case2").size(), std::size_t{1});
    const auto first = placesOf(*figure, "option0");
    const auto second = placesOf(*figure, "option1");
    QCOMPARE(first.size(), std::size_t{2});
    QCOMPARE(second.size(), std::size_t{2});
    QVERIFY(first[0].x() == 0.0 && first[1].x() == 0.0);
    QVERIFY(second[0].x() > 360.0 && second[0].x() == second[1].x());
    QVERIFY(first[0].y() == second[0].y() && first[1].y() == second[1].y());
    const auto blank = placesOf(*figure, "no run drawn");
    QVERIFY(blank.size() == 1 && blank[0].x() == 0.0 && blank[0].y() < first[1].y());
  }

  void waysFigure_noRobot_isLeftOut() {
    MapStudy all(1, 2);
    all.pictures.runs[0].path.clear();
    const std::optional<Figure> figure = pathsFigure(all.study, all.pictures);
    QVERIFY(figure && placesOf(*figure, "case0").empty());
    QCOMPARE(placesOf(*figure, "case1").size(), std::size_t{1});
    all.pictures.runs[1].path.clear();
    QVERIFY(!pathsFigure(all.study, all.pictures));
  }

  /// One that never left its place has no way and is seen.
  void waysFigure_robotThatStands_isADot() {
    MapStudy all(1, 1);
    all.pictures.runs[0].path.resize(1);
    const std::optional<Figure> figure = pathsFigure(all.study, all.pictures);
    QVERIFY(figure && has(figure->markup(), "<circle"));
  }

  void waysFigure_manyPanels_saysWhatIsMissing() {
    const MapStudy table(4, 7);
    const std::optional<Figure> rows = pathsFigure(table.study, table.pictures);
    QVERIFY2(rows && has(rows->caption, "(the first 6 of 7 cases)"), rows->caption.c_str());
    const MapStudy list(5, 6);
    const std::optional<Figure> cells = pathsFigure(list.study, list.pictures);
    QVERIFY2(cells && has(cells->caption, "(the first 24 of 30 panels)"), cells->caption.c_str());
  }

  void contactsFigure_oneScale_forAllMaps() {
    MapStudy all(1, 1);
    all.study.results.runs[0].scenario = "a.yaml";
    all.addRun(0, 0, true);
    all.pictures.floorPlans["a.yaml"] = all.pictures.floorPlans[kHall];
    all.pictures.runs[0].contacts.resize(1);
    all.pictures.runs[1].contacts.resize(15);
    const std::optional<Figure> figure = contactsFigure(all.study, all.pictures);
    QVERIFY(figure);
    // One square each, then those of the key: 1, 8, 15.
    const std::vector<double> strengths = strengthsOf(*figure);
    QCOMPARE(strengths.size(), std::size_t{5});
    QVERIFY(strengths[0] < 0.5 * strengths[1]);
    QCOMPARE(strengths[2], strengths[0]);
    QVERIFY(strengths[2] < strengths[3] && strengths[3] < strengths[4]);
    QCOMPARE(strengths[4], strengths[1]);
    for (const char* number : {"1", "8", "15"}) {
      QCOMPARE(placesOf(*figure, number).size(), std::size_t{1});
    }
    QVERIFY2(has(figure->caption, "contact_distance"), figure->caption.c_str());
  }

  void contactsFigure_manyScenarios_saysWhatIsMissing() {
    MapStudy all(1, 26);
    for (RunPicture& picture : all.pictures.runs) {
      const std::string name = "s" + std::to_string(100 + picture.run);
      all.study.results.runs[picture.run].scenario = name;
      all.pictures.floorPlans[name] = all.pictures.floorPlans[kHall];
      picture.contacts.resize(1);
    }
    const std::optional<Figure> figure = contactsFigure(all.study, all.pictures);
    QVERIFY2(figure && has(figure->caption, "(the first 24 of 26 scenarios with contacts)"),
             figure->caption.c_str());
  }

  /// Two dense heaps of points, and lines through them.
  void placeLabels_crowd_isOnNothingElse() {
    std::vector<Label> labels;
    std::vector<Segment> lines;
    for (int k = 0; k < 12; ++k) {
      const base::Vec2 point(k % 2 == 0 ? 150.0 + 6.0 * k : 560.0 - 2.0 * k, 150.0 + k * k % 17);
      labels.push_back({"planner_number_" + std::to_string(k), point});
      lines.push_back({point - base::Vec2(40.0, 0.0), point + base::Vec2(40.0, 0.0)});
      lines.push_back({point - base::Vec2(0.0, 30.0), point + base::Vec2(0.0, 30.0)});
    }
    const Box bounds{{66.0, 22.0}, {720.0, 306.0}};
    const std::vector<PlacedLabel> places = placeLabels(labels, lines, bounds);
    QCOMPARE(places.size(), labels.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Box& box = places[k].box;
      QVERIFY(box.low.x() >= bounds.low.x() && box.high.x() <= bounds.high.x());
      QVERIFY(box.low.y() >= bounds.low.y() && box.high.y() <= bounds.high.y());
      for (std::size_t other = 0; other < places.size(); ++other) {
        const base::Vec2 mark(5.0, 5.0);
        QVERIFY(areApart(box, {labels[other].point - mark, labels[other].point + mark}));
        QVERIFY(other == k || areApart(box, places[other].box));
      }
      const base::Vec2 nearest = labels[k].point.cwiseMax(box.low).cwiseMin(box.high);
      QVERIFY(places[k].hasLeader || (nearest - labels[k].point).norm() < 15.0);
    }
  }

  void placeLabels_dashedLine_isNotCrossed() {
    const std::vector<Label> labels = {{"mppi", {200.0, 200.0}}};
    const std::vector<Segment> lines = {{{200.0, 200.0}, {300.0, 140.0}}};
    const Box bounds{{0.0, 0.0}, {400.0, 400.0}};
    const PlacedLabel place = placeLabels(labels, lines, bounds)[0];
    QVERIFY(!place.hasLeader);
    QVERIFY(place.box.low.y() > 200.0 || place.box.high.x() < 200.0);
  }

  void playerJson_customTree_hasItsOwnColour() {
    sim2d::Trace trace;
    sim2d::TraceHuman human;
    human.id = 1;
    human.behavior = 3;
    trace.header.humans = {human};
    trace.frames.resize(1);
    trace.frames[0].humans.add(1, base::Pose2(), base::Vec2::Zero(), 0.0, sim2d::kNoGoal);
    QVERIFY(has(playerJson(trace, {}, {"Run 1"}, 0.2), "\"look\":3"));
    trace.header.humans[0].customTree = true;
    QVERIFY(has(playerJson(trace, {}, {"Run 1"}, 0.2), "\"look\":7"));
  }

  void playerJson_speedOfAContact_isToldWithItsUnit() {
    sim2d::Trace trace;
    const auto add = [&trace](sim2d::EventKind kind, const char* words) {
      sim2d::Event event;
      event.kind = kind;
      event.id = -1;
      event.text = words;
      trace.events.emplace_back(1, event);
    };
    add(sim2d::EventKind::Contact, "0.36931624699836924 robot ahead");
    add(sim2d::EventKind::Contact, "1.5");
    add(sim2d::EventKind::Contact, "0 table 2");
    add(sim2d::EventKind::Contact, "");
    add(sim2d::EventKind::Stop, "1.5 of something");
    const std::string json = playerJson(trace, {}, {"Run 1", "dwa, hall, seed 3", "timeout"}, 0.2);
    for (const char* wanted :
         {"\"closing speed 0.37 m/s, robot ahead\"", "\"closing speed 1.50 m/s\"",
          "\"closing speed 0.00 m/s, table 2\"", "null,\"\"]", "\"1.5 of something\"", "\"Run 1\"",
          "\"dwa, hall, seed 3\"", "\"timeout\""}) {
      QVERIFY2(has(json, wanted), json.c_str());
    }
  }
};

QTEST_APPLESS_MAIN(ReportMapsTest)
#include "tst_ReportMaps.moc"
