#include <QDesktopServices>

#include "app/window/Docks.h"
#include "app/window/files/FileCommands.h"
#include "app/window/study/StudyPanel.h"
#include "app/window/study/StudyTable.h"
#include "editor/look/AppStyle.h"
#include "tests/app/QuietWindow.h"
#include "tests/app/StudyFiles.h"

using app::StudyPanel;
using app::StudyRow;
using namespace outside;

namespace {

constexpr int kLong = 120000;  // [ms]

/// Receives the files that are opened with the desktop's program.
class OpenedFiles : public QObject {
  Q_OBJECT
 public:
  OpenedFiles() { QDesktopServices::setUrlHandler(text("file"), this, "take"); }
  ~OpenedFiles() override { QDesktopServices::unsetUrlHandler(text("file")); }
  Q_DISABLE_COPY_MOVE(OpenedFiles)
  QStringList files() const { return files_; }

 public Q_SLOTS:
  void take(const QUrl& url) { files_.append(url.toLocalFile()); }

 private:
  QStringList files_;
};

StudyRow rowIn(int run, const QString& scenario) {
  StudyRow row;
  row.run = run;
  row.scenario = scenario;
  row.metrics = {{text("path_length"), 10.0 + run}};
  return row;
}

}  // namespace

/// The study panel by mouse: how many clicks a study takes, and that nothing moves meanwhile.
class StudyClicksTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  int clicks_ = 0;

  StudyPanel& panel() { return window_->docks().panel<StudyPanel>(); }

  /// Where everything that can be seen in the panel is, without the cells of its tables.
  std::map<const QWidget*, QRect> places() {
    std::map<const QWidget*, QRect> found;
    for (const QWidget* each : panel().findChildren<QWidget*>()) {
      const bool isInTable =
          qobject_cast<const QHeaderView*>(each) != nullptr ||
          qobject_cast<const QHeaderView*>(each->parentWidget()) != nullptr ||
          qobject_cast<const QScrollBar*>(each) != nullptr ||
          each->inherits("QAbstractScrollArea") ||
          qobject_cast<const QAbstractItemView*>(each->parentWidget()) != nullptr;
      if (each->isVisible() && !isInTable) {
        found[each] = QRect(each->mapTo(&panel(), QPoint()), each->size());
      }
    }
    return found;
  }
  /// The first part that is somewhere else now; empty: none.
  static QString movedPart(const std::map<const QWidget*, QRect>& before,
                           const std::map<const QWidget*, QRect>& now) {
    for (const auto& [part, place] : before) {
      const auto there = now.find(part);
      if (there != now.end() && there->second != place) {
        return text(part->metaObject()->className()) + QLatin1Char(' ') + part->accessibleName() +
               part->objectName();
      }
    }
    return {};
  }

  /// A click that moves nothing in the panel.
  void click(QWidget& target, const QPoint& at) {
    const auto before = places();
    QTest::mouseClick(&target, Qt::LeftButton, {}, at);
    QTest::qWait(400);  // the form is checked after 300 ms
    QCOMPARE(movedPart(before, places()), QString());
    ++clicks_;
  }
  void click(QWidget& target) { click(target, target.rect().center()); }

  void clickPlanner(const char* name) {
    auto& list = quiet::part<QListWidget>(panel(), "Planners");
    QListWidgetItem* item = list.findItems(text(name), Qt::MatchExactly).front();
    const QRect place = list.visualItemRect(item);
    const Qt::CheckState before = item->checkState();
    click(*list.viewport(), QPoint(place.left() + 12, place.center().y()));
    QVERIFY2(item->checkState() != before, name);
  }
  QToolButton& toggle() {
    const QAction* action = window_->docks().toggleOf(*window_->docks().dock(text("study")));
    return *widgets::findIf<QToolButton>(
        *window_, [&](const QToolButton* each) { return each->defaultAction() == action; });
  }
  QString yard() const {
    QString file = at("yard.yaml");
    writeText(file, QByteArray(kYardText) + "    duration: 5.0\n");
    return file;
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    clicks_ = 0;
    begin();
    panel().process().setProgram(text(HUNAVSIM_PROGRAM));
  }
  void cleanup() { end(); }

  /// Two planners, ten seeds, from the open scenario: the panel, a planner, the seeds, Start,
  /// Report. The planner of the scenario is chosen already.
  void study_ofTwoPlanners_takesFiveClicks() {
    QVERIFY(window_->open(yard()));
    const OpenedFiles opened;
    QTest::mouseClick(&toggle(), Qt::LeftButton);
    ++clicks_;
    QTRY_VERIFY(panel().isVisible());
    QTRY_COMPARE(panel().message(), text("1 scenario × 30 seeds = 30 runs"));
    clickPlanner("dwa");
    auto& seeds = quiet::part<QLineEdit>(panel(), "Seeds");
    click(seeds);
    seeds.selectAll();
    QTest::keyClicks(&seeds, text("10"));
    QTRY_COMPARE(panel().message(), text("1 scenario × 2 planners × 10 seeds = 20 runs"));
    click(*widgets::withText<QPushButton>(panel(), text("Start")));
    const auto before = places();
    QTRY_COMPARE_WITH_TIMEOUT(panel().message(), text("20 of 20 runs"), kLong);
    QTRY_VERIFY(!panel().isRunning());
    QCOMPARE(movedPart(before, places()), QString());
    QCOMPARE(panel().file(), at("yard_study.yaml"));  // beside the scenario, without a question
    QCOMPARE(panel().results().comparison().rowCount(), 2);
    quiet::shoot(*window_, "study_clicks");
    click(*widgets::withText<QPushButton>(panel(), text("Report")));
    QTRY_COMPARE_WITH_TIMEOUT(opened.files().size(), 1, kLong);
    QVERIFY(bytesOf(opened.files().front()).contains("class=\"verdict\""));
    QCOMPARE(panel().message(), text("Report written to ") + at("yard_study_results/report.html"));
    QVERIFY2(clicks_ <= 5, qPrintable(QString::number(clicks_)));
  }

  /// Scenarios, planners and problems come and go: the form stays.
  void form_whateverIsClicked_staysWhereItIs() {
    QVERIFY(window_->open(yard()));
    QTest::mouseClick(&toggle(), Qt::LeftButton);
    QTRY_VERIFY(panel().isVisible());
    QTest::qWait(500);
    const auto before = places();
    auto& scenarios = quiet::part<QListWidget>(panel(), "Scenarios");
    QCOMPARE(scenarios.count(), 1);
    click(*widgets::withText<QAbstractButton>(panel().form(), text("Add current")));
    QCOMPARE(scenarios.count(), 1);  // it is there already
    for (const char* name : {"a.yaml", "b.yaml", "c.yaml", "d.yaml"}) {
      writeText(at(name), QByteArray(kYardText));
      panel().form().addScenario(at(name));
      QCOMPARE(movedPart(before, places()), QString());
    }
    for (const char* planner : {"dwa", "pursuit", "dwa", "pursuit"}) {
      clickPlanner(planner);
    }
    auto& seeds = quiet::part<QLineEdit>(panel(), "Seeds");
    click(seeds);
    seeds.selectAll();
    QTest::keyClicks(&seeds, text("many"));
    QTest::qWait(400);
    QCOMPARE(movedPart(before, places()), QString());  // a problem takes no room
    click(*scenarios.viewport(), scenarios.visualItemRect(scenarios.item(1)).center());
    scenarios.setFocus();
    scenarios.selectAll();
    QTest::keyClick(&scenarios, Qt::Key_Delete);
    QCOMPARE(scenarios.count(), 0);
    QCOMPARE(movedPart(before, places()), QString());
    quiet::shoot(*window_, "study_form_empty");
  }

  /// The open scenario is followed until another one is chosen.
  void preset_followsTheOpenScenario() {
    QVERIFY(window_->open(yard()));
    QTest::mouseClick(&toggle(), Qt::LeftButton);
    QTRY_COMPARE(panel().form().scenarios(), QStringList(yard()));
    writeText(at("other.yaml"), QByteArray(kYardText));
    QVERIFY(window_->open(at("other.yaml")));
    QTRY_COMPARE(panel().form().scenarios(), QStringList(at("other.yaml")));
    writeText(at("third.yaml"), QByteArray(kYardText));
    panel().form().addScenario(at("third.yaml"));
    QVERIFY(window_->open(yard()));
    QCOMPARE(panel().form().scenarios(), QStringList({at("other.yaml"), at("third.yaml")}));
  }

  /// A new scenario has no file yet: the one of before is not studied in its place.
  void preset_ofANewScenario_isEmptyUntilItIsSaved() {
    QVERIFY(window_->open(yard()));
    QTest::mouseClick(&toggle(), Qt::LeftButton);
    QTRY_COMPARE(panel().form().scenarios(), QStringList(yard()));
    window_->files().newOpenPlane();
    QTRY_COMPARE(panel().form().scenarios(), QStringList());
    QVERIFY(widgets::withText<QLabel>(panel(), text("Save the open scenario first, or add files")));
    QVERIFY(window_->files().saveTo(at("mine.yaml")));
    QTRY_COMPARE(panel().form().scenarios(), QStringList(at("mine.yaml")));
  }

  /// However low the panels are that were opened before.
  void panel_openedAfterAReset_showsItsResults() {
    QVERIFY(window_->open(yard()));
    window_->docks().toggleOf(*window_->docks().dock(text("study")))->trigger();
    window_->actions().resetLayout->trigger();
    window_->docks().toggleOf(*window_->docks().dock(text("metrics")))->trigger();
    QTRY_VERIFY(window_->docks().dock(text("metrics"))->isVisible());
    QTest::mouseClick(&toggle(), Qt::LeftButton);
    QTRY_VERIFY(panel().isVisible());
    QTRY_VERIFY2(panel().height() >= 350, qPrintable(QString::number(panel().height())));
  }

  /// Without a study of that name to write over.
  void start_withAnEarlierStudy_takesAnotherName() {
    QVERIFY(window_->open(yard()));
    writeText(at("yard_study.yaml"), "mine");
    QTest::mouseClick(&toggle(), Qt::LeftButton);
    QTRY_VERIFY(panel().isVisible());
    auto& seeds = quiet::part<QLineEdit>(panel(), "Seeds");
    seeds.setText(text("1"));
    QTRY_VERIFY(panel().message().contains(text("= 1 run")));
    click(*widgets::withText<QPushButton>(panel(), text("Start")));
    QTRY_VERIFY_WITH_TIMEOUT(!panel().isRunning(), kLong);
    QCOMPARE(panel().file(), at("yard_study_2.yaml"));
    QCOMPARE(bytesOf(at("yard_study.yaml")), QByteArray("mine"));
  }

  void runs_namesAreWithoutTheSharedFolder() {
    app::StudyRunsModel runs;
    runs.begin({});
    const auto nameOf = [&runs](int row) { return runs.index(row, 1).data().toString(); };
    runs.add(rowIn(0, text("/home/one/maps/planners/cafe/cafe_agents.yaml")));
    QCOMPARE(nameOf(0), text("cafe_agents"));
    runs.add(rowIn(1, text("/home/one/maps/planners/hall/hall.yml")));
    QCOMPARE(nameOf(0), text("cafe/cafe_agents"));
    QCOMPARE(nameOf(1), text("hall/hall"));
    QCOMPARE(runs.index(1, 1).data(Qt::ToolTipRole).toString(),
             text("/home/one/maps/planners/hall/hall.yml"));
    runs.add(rowIn(2, text("/home/one/plain.yaml")));
    QCOMPARE(nameOf(0), text("maps/planners/cafe/cafe_agents"));
    QCOMPARE(nameOf(2), text("plain"));
  }

  /// Where bar and dot are drawn follows from the numbers; what the brackets mean is written.
  void comparison_intervalsAreDrawnOnOneScale() {
    app::StudyResults results(nullptr);
    results.begin({}, {});
    std::vector<StudyRow> rows;
    for (int k = 0; k < 3; ++k) {
      rows.push_back(rowIn(k, text("a.yaml")));        // 10, 11, 12
      rows.push_back(rowIn(100 + k, text("b.yaml")));  // 110, 111, 112
    }
    results.add(rows);
    results.compare();
    const QTableWidget& table = results.comparison();
    const int last = table.columnCount() - 1;  // path length
    const QVariantList first = table.item(0, last)->data(app::kIntervalRole).toList();
    const QVariantList second = table.item(1, last)->data(app::kIntervalRole).toList();
    QCOMPARE(first.size(), 5);
    QCOMPARE(first[1].toDouble(), 11.0);
    QCOMPARE(second[1].toDouble(), 111.0);
    QCOMPARE(first[3].toDouble(), first[0].toDouble());   // the scale begins with its lower end
    QCOMPARE(first[4].toDouble(), second[2].toDouble());  // and ends with the other's upper end
    QCOMPARE(first[3], second[3]);
    const auto* meaning = results.findChild<QLabel*>(text("study_brackets"));
    QVERIFY(meaning != nullptr && meaning->text().contains(text("95 % confidence interval")));
    results.resize(1500, 300);  // with all columns
    results.show();
    QVERIFY(QTest::qWaitForWindowExposed(&results));
    QVERIFY(meaning->isVisible());
    const QRect cell = table.visualItemRect(table.item(0, last));
    const QImage picture = table.viewport()->grab(cell).toImage();
    const QColor accent = table.palette().color(QPalette::Link);
    int left = 0;
    int right = 0;  // pixels of the bar of the smaller value in either half of the cell
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        const bool isBar = picture.pixelColor(x, y) == accent;
        left += isBar && 2 * x < picture.width() ? 1 : 0;
        right += isBar && 2 * x >= picture.width() ? 1 : 0;
      }
    }
    QVERIFY2(left > 8 && right == 0, qPrintable(text("%1 %2").arg(left).arg(right)));
  }
};

QTEST_MAIN(StudyClicksTest)
#include "tst_StudyClicks.moc"
