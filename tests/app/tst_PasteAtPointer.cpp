#include <QtTest>

#include "Hands.h"
#include "editor/document/EditCommands.h"

using base::Vec2;

/// Copy and paste on the map by real mouse and key events.
class PasteAtPointerTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<app::MainWindow> window_;
  std::unique_ptr<Hands> hands_;

  editor::ScenarioDocument& document() { return window_->workspace().document(); }
  editor::MapView& view() { return window_->workspace().view(); }
  const std::vector<sim2d::Human>& people() { return document().scenario().humans; }
  void point(const Vec2& world) {
    QTest::mouseMove(window_->windowHandle(),
                     view().viewport()->mapTo(window_.get(), view().viewportFrom(world)));
    QCoreApplication::processEvents();
  }
  void leaveMap() {
    QTest::mouseMove(window_->windowHandle(), QPoint(20, 10));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(view().viewport(), &leave);
    QCoreApplication::processEvents();
  }
  void copy() { hands_->press(Qt::Key_C, Qt::ControlModifier); }
  void paste() { hands_->press(Qt::Key_V, Qt::ControlModifier); }
  double distance(std::size_t a, std::size_t b) {
    return (people()[a].initPose.position - people()[b].initPose.position).norm();
  }
  static bool isNear(const Vec2& a, const Vec2& b) { return (a - b).norm() < 0.05; }

 private Q_SLOTS:
  void init() {
    window_ = quiet::shownWindow();
    hands_ = std::make_unique<Hands>(*window_);
    window_->files().newOpenPlane();
    hands_->chooseTool(QStringLiteral("tool-person"));
    hands_->clickMap({-3.0, 1.0});
    hands_->clickMap({-1.0, 2.0});
    hands_->chooseTool(QStringLiteral("tool-select"));
    QCOMPARE(people().size(), std::size_t{2});
    document().setSelection({people()[0].key, people()[1].key});
    view().setFocus();
  }
  void cleanup() {
    hands_.reset();
    quiet::leave(window_);
  }

  void paste_mouseOnTheMap_putsTheCentreThere() {
    copy();
    point({4.0, -2.0});
    paste();
    QCOMPARE(people().size(), std::size_t{4});
    QVERIFY(
        isNear(0.5 * (people()[2].initPose.position + people()[3].initPose.position), {4.0, -2.0}));
    QVERIFY(isNear(people()[3].initPose.position - people()[2].initPose.position, {2.0, 1.0}));
    QCOMPARE(document().selection(),
             (std::vector<editor::EntityId>{people()[2].key, people()[3].key}));
  }

  void paste_mouseOnTheOriginal_isBesideIt() {
    document().setSelection({people()[0].key});
    copy();
    point({-3.0, 1.0});
    paste();
    paste();  // and beside the first copy
    QCOMPARE(people().size(), std::size_t{4});
    for (std::size_t a = 0; a < people().size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        QVERIFY2(distance(a, b) > 0.69, QByteArray::number(distance(a, b)).constData());
      }
    }
  }

  void paste_mouseElsewhere_isBesideTheOriginal() {
    copy();
    leaveMap();
    paste();
    QCOMPARE(people().size(), std::size_t{4});
    QVERIFY(isNear(people()[2].initPose.position - people()[0].initPose.position, {0.5, -0.5}));
    paste();
    QVERIFY(isNear(people()[4].initPose.position - people()[0].initPose.position, {1.0, -1.0}));
  }

  void paste_afterCut_restoresThePosition() {
    const Vec2 before = people()[0].initPose.position;
    hands_->press(Qt::Key_X, Qt::ControlModifier);
    QVERIFY(people().empty());
    leaveMap();
    paste();
    QVERIFY(isNear(people()[0].initPose.position, before));
  }

  void pasteHere_ofTheMenu_isWhereTheMenuWasOpened() {
    copy();
    const QPoint at = view().viewportFrom({3.0, 3.0});
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, view().viewport()->mapToGlobal(at));
    QCoreApplication::sendEvent(view().viewport(), &event);
    QMenu* menu = view().findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly).back();
    QAction* here = menu->actions().front();
    QCOMPARE(here->text(), QStringLiteral("Paste here"));
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(here).center());
    QCOMPARE(people().size(), std::size_t{4});
    QVERIFY(
        isNear(0.5 * (people()[2].initPose.position + people()[3].initPose.position), {3.0, 3.0}));
  }
};

QTEST_MAIN(PasteAtPointerTest)
#include "tst_PasteAtPointer.moc"
