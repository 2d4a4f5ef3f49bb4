#include <QtTest>

#include "editor/panels/properties/PageWidgets.h"
#include "tests/support/Widgets.h"

using editor::RouteEditor;

namespace {

QMenu* openMenu(const RouteEditor& editor) {
  return widgets::shown<QMenu>(editor);
}

QAction* actionOf(const QMenu& menu, const QString& text) {
  for (QAction* action : menu.actions()) {
    if (action->text() == text) {
      return action;
    }
  }
  return nullptr;
}

}  // namespace

class RouteEditorTest : public QObject {
  Q_OBJECT

 private:
  editor::ScenarioDocument document_;
  RouteEditor editor_{document_};
  std::vector<std::vector<int>> edited_;

  QMenu* menuOfChip(int index) {
    const QList<QToolButton*> chips = editor_.findChildren<QToolButton*>();
    const int first =
        chips.size() - 1 - static_cast<int>(editor_.goals().size());  // "+ Add" is last
    QTest::mouseClick(chips.at(first + index), Qt::LeftButton);
    return openMenu(editor_);
  }

 private Q_SLOTS:
  void initTestCase() {
    connect(&editor_, &RouteEditor::edited, this,
            [this](const std::vector<int>& goals) { edited_.push_back(goals); });
  }
  void init() {
    editor_.show({});
    editor_.show({1, 2, 3});
    editor_.resize(400, 100);
    static_cast<QWidget&>(editor_).show();
    edited_.clear();
  }

  void menuOfAChip_movesItsGoal() {
    QMenu* const menu = menuOfChip(2);
    if (menu == nullptr) {
      QFAIL("no menu");
    }
    QAction* const earlier = actionOf(*menu, QStringLiteral("Earlier"));
    QVERIFY(earlier != nullptr);
    earlier->trigger();
    QVERIFY(edited_ == (std::vector<std::vector<int>>{{1, 3, 2}}));
  }

  /// While a menu is open the route may become another one: its numbers would be those of before.
  void menuOfAChip_closesWhenTheRouteChanges() {
    QMenu* const menu = menuOfChip(2);
    QVERIFY(menu != nullptr);
    editor_.show({1});
    QVERIFY(openMenu(editor_) == nullptr);
    QVERIFY(edited_.empty());
  }
};

QTEST_MAIN(RouteEditorTest)
#include "tst_RouteEditor.moc"
