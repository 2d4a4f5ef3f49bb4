#include "app/window/MainWindow.h"
#include "app/window/StartPage.h"
#include "editor/look/AppStyle.h"
#include "editor/tools/ToolManager.h"
#include "tests/app/QuietWindow.h"

using app::MainWindow;
using app::WindowSetup;

/// What can be seen to be cut, crooked or jumping at the smallest size.
class WindowLookTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<MainWindow> window_;
  editor::MapView& view() { return window_->workspace().view(); }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() { window_ = quiet::shownWindow(); }
  void cleanup() { window_.reset(); }

  void start_demosStandInTheColumnsOfTheActions() {
    WindowSetup setup = quiet::setup();
    setup.demos = {{"One", quiet::demoPath().toStdString()},
                   {"Two", quiet::demoPath().toStdString()}};
    MainWindow window(setup);
    window.resize(1280, 800);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    const auto lefts = [&window](auto cards) {
      std::vector<int> xs;
      for (const QWidget* card : cards) {
        xs.push_back(card->mapTo(&window, QPoint()).x());
      }
      std::sort(xs.begin(), xs.end());
      return xs;
    };
    const std::vector<int> actions = lefts(window.findChildren<app::ActionCard*>());
    const std::vector<int> demos = lefts(window.findChildren<app::ScenarioCard*>());
    QCOMPARE(actions.size(), std::size_t(6));  // two rows
    QCOMPARE(demos.size(), std::size_t(2));
    QVERIFY(std::abs(actions[2] - demos[0]) <= 1);
    QVERIFY(std::abs(actions[3] - demos[0]) <= 1);
    QVERIFY(std::abs(actions[4] - demos[1]) <= 1);
  }

  /// The actions that do not fit into the tool bar are shown below it on a click.
  void toolBar_narrow_showsTheRestOnAClick() {
    QVERIFY(window_->open(quiet::demoPath()));
    window_->resize(960, 700);
    auto* bar = window_->findChild<QToolBar*>(QStringLiteral("tools"));
    auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
    QVERIFY(more != nullptr);
    QTRY_VERIFY(more->isVisible());
    QCOMPARE(bar->height(), 44);
    QTest::mouseMove(more);
    QTest::mouseClick(more, Qt::LeftButton);
    QTRY_VERIFY2(bar->height() >= 2 * 32, qPrintable(QString::number(bar->height())));
  }

  void emptyBoxes_inBothThemes_canBeSeen() {
    for (const editor::Theme& theme : {editor::Theme::light(), editor::Theme::dark()}) {
      editor::applyTheme(theme);
      QCheckBox check;
      QRadioButton radio;
      for (QWidget* box : {static_cast<QWidget*>(&check), static_cast<QWidget*>(&radio)}) {
        box->resize(24, 24);
        const QImage picture = box->grab().toImage();
        double best = 1.0;
        for (int i = 0; i < picture.width() * picture.height(); ++i) {
          best = std::max(best, editor::contrastRatio(
                                    picture.pixelColor(i % picture.width(), i / picture.width()),
                                    theme.color(editor::Role::Field)));
        }
        QVERIFY2(best >= 3.0, qPrintable(QString::number(best)));
      }
    }
    editor::applyTheme(editor::Theme::light());
  }

  void menuEntry_hovered_isExplainedWithoutHidingTheState() {
    QVERIFY(window_->open(quiet::demoPath()));
    QLabel* hint = nullptr;
    for (QLabel* label : window_->statusBar()->findChildren<QLabel*>()) {
      hint = label->text().startsWith(QStringLiteral("Click to select")) ? label : hint;
    }
    QVERIFY(hint != nullptr);
    const QString before = hint->text();
    QStatusTipEvent tip(QStringLiteral("The whole map in the window"));
    QCoreApplication::sendEvent(window_.get(), &tip);
    QCOMPARE(hint->text(), QStringLiteral("The whole map in the window"));
    QVERIFY(hint->isVisible());
    QVERIFY(window_->statusBar()->currentMessage().isEmpty());
    QStatusTipEvent none{QString()};
    QCoreApplication::sendEvent(window_.get(), &none);
    QCOMPARE(hint->text(), before);
  }

  void toolOptions_inASmallWindow_areNotCut() {
    QVERIFY(window_->open(quiet::demoPath()));
    auto* bar = view().findChild<editor::ToolOptionsBar*>();
    QVERIFY(bar != nullptr);
    int rows = 0;
    for (QAction* tool : window_->workspace().tools().actions().actions()) {
      tool->trigger();
      QCoreApplication::processEvents();
      if (bar->isHidden()) {
        continue;
      }
      ++rows;
      QVERIFY2(bar->geometry().right() < view().width(), qPrintable(tool->text()));
      for (const QComboBox* box : bar->findChildren<QComboBox*>()) {
        const int text = box->fontMetrics().horizontalAdvance(box->currentText());
        QVERIFY2(box->isHidden() || text <= box->width() - 30, qPrintable(box->currentText()));
      }
    }
    QCOMPARE(rows, 4);  // area, brush, fill, map
  }

  /// Of every kind of thing, with usual and larger fonts.
  void numbers_ofAllProperties_areNotCut() {
    window_->resize(1280, 800);
    QVERIFY(window_->open(quiet::demoPath()));
    editor::ScenarioDocument& document = window_->workspace().document();
    const QFont usual = QApplication::font();
    int fields = 0;
    for (const double larger : {1.0, 1.3, 1.6}) {
      QFont font = usual;
      font.setPointSizeF(larger * usual.pointSizeF());
      QApplication::setFont(font);
      std::vector<std::vector<editor::EntityId>> selections = {{}};
      for (const base::EntityKind kind :
           {base::EntityKind::Human, base::EntityKind::Robot, base::EntityKind::Goal,
            base::EntityKind::Obstacle, base::EntityKind::Area}) {
        if (!document.entities(kind).empty()) {
          selections.push_back({document.entities(kind).front()});
        }
      }
      for (const std::vector<editor::EntityId>& selection : selections) {
        document.setSelection(selection);
        QCoreApplication::processEvents();
        for (const QAbstractSpinBox* box : window_->findChildren<QAbstractSpinBox*>()) {
          const auto* line = box->findChild<QLineEdit*>();
          if (!box->isVisible() || line == nullptr || line->visibleRegion().isEmpty()) {
            continue;
          }
          ++fields;
          const int needed = line->fontMetrics().horizontalAdvance(line->text());
          QVERIFY2(needed <= line->width() - 4,
                   qPrintable(QStringLiteral("%1: '%2' needs %3 of %4 px at %5 points")
                                  .arg(box->accessibleName(), line->text())
                                  .arg(needed)
                                  .arg(line->width() - 4)
                                  .arg(font.pointSizeF())));
        }
      }
    }
    QApplication::setFont(usual);
    QVERIFY(fields > 30);
  }

  void dock_leftAloneInItsPlace_hasAHeading() {
    QVERIFY(window_->open(quiet::demoPath()));
    app::Docks& docks = window_->docks();
    const auto heading = [&docks](const char* name) {
      return docks.dock(QString::fromUtf8(name))->titleBarWidget()->sizeHint().height();
    };
    QCOMPARE(heading("properties"), 0);  // its tab says the name
    QVERIFY(heading("scenario") > 0);
    docks.dock(QStringLiteral("behaviour"))->hide();
    QVERIFY(heading("properties") > 0);
    QTRY_VERIFY(docks.dock(QStringLiteral("properties"))->titleBarWidget()->height() > 20);
    docks.dock(QStringLiteral("behaviour"))->show();
    QCOMPARE(heading("properties"), 0);
  }
};

QTEST_MAIN(WindowLookTest)
#include "tst_WindowLook.moc"
