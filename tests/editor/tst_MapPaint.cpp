#include <QtTest>

#include "editor/canvas/MapScene.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/look/Fields.h"
#include "editor/tools/ToolRegistry.h"

using namespace editor;

namespace {

/// An empty room of 6 x 4 m and the tool that paints on it.
struct Room {
  Room() {
    document.setMap(emptyRoom(6.0, 4.0));
    const ToolRegistry tools = standardTools();
    const auto found = std::find_if(
        tools.entries().begin(), tools.entries().end(),
        [](const auto& each) { return each.info.name == QStringLiteral("Paint map"); });
    tool.reset(found->make(document, scene, nullptr));
  }

  int valueAt(const Vec2& place) const {
    return document.map()->valueAt(document.map()->worldToCell(place));
  }

  ScenarioDocument document;
  MapScene scene{document, Theme::light()};
  std::unique_ptr<Tool> tool;
};

}  // namespace

class MapPaintTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void stroke_oneDrag_isOneCommand() {
    Room room;
    ScenarioDocument& document = room.document;
    Tool& tool = *room.tool;
    const auto before = document.map();
    QVERIFY(tool.statusText().contains(QStringLiteral("walls, 0.20 m wide")));
    drag(tool, {1.0, 2.0}, {5.0, 2.0});
    QCOMPARE(document.undoStack().count(), 1);
    const sim2d::OccupancyGrid& map = *document.map();
    for (int i = 95; i <= 505; ++i) {
      QVERIFY(map.isWall(map.worldToCell({0.01 * i, 2.0})));
    }
    QVERIFY(map.isWall(map.worldToCell({3.0, 2.07})));
    QVERIFY(!map.isWall(map.worldToCell({3.0, 2.16})));
    QVERIFY(!map.isWall(map.worldToCell({0.8, 2.0})));
    document.undoStack().undo();
    QVERIFY(*document.map() == *before);
    document.undoStack().redo();
    QVERIFY(document.map()->isWall(document.map()->worldToCell({3.0, 2.0})));
  }

  void stroke_escaped_leavesTheMap() {
    Room room;
    ScenarioDocument& document = room.document;
    Tool& tool = *room.tool;
    tool.press(mouse({1.0, 1.0}));
    tool.move(mouse({2.0, 1.0}));
    tool.cancel();
    tool.release(mouse({2.0, 1.0}));
    QCOMPARE(document.undoStack().count(), 0);
  }

  void stroke_mapIsAnotherMeanwhile_isDropped() {
    ScenarioDocument document;
    document.setMap(emptyRoom(6.0, 4.0));
    MapStroke stroke(document.map());
    stroke.paint({5.0, 1.0}, {5.0, 3.0}, 0.1, MapPaint::Occupied);
    pushMap(document, {emptyRoom(1.0, 1.0), {}, false, {}}, {}, QStringLiteral("Room"));
    pushStroke(document, stroke, QStringLiteral("Paint"));
    QCOMPARE(document.undoStack().count(), 1);
    QVERIFY(*document.map() == *emptyRoom(1.0, 1.0));
  }

  void paint_freeAndUnknown_byKeysAndShift() {
    Room room;
    ScenarioDocument& document = room.document;
    Tool& tool = *room.tool;
    QVERIFY(tool.keyPress(QKeyEvent(QEvent::KeyPress, Qt::Key_3, Qt::NoModifier)));
    drag(tool, {1.0, 1.0}, {2.0, 1.0});
    QCOMPARE(room.valueAt({1.5, 1.0}), -1);
    CanvasMouse press = mouse({1.0, 1.0});
    press.modifiers = Qt::ShiftModifier;
    tool.press(press);
    tool.release(mouse({2.0, 1.0}));
    QCOMPARE(room.valueAt({1.5, 1.0}), 0);
    tool.keyPress(QKeyEvent(QEvent::KeyPress, Qt::Key_2, Qt::NoModifier));
    drag(tool, {1.0, -0.02}, {2.0, -0.02});  // a hole in the wall
    QCOMPARE(room.valueAt({1.5, -0.02}), 0);
    const int count = document.undoStack().count();
    drag(tool, {1.0, 3.0}, {2.0, 3.0});  // free already
    QCOMPARE(document.undoStack().count(), count);
  }

  void options_chosen_changeTheBrush() {
    Room room;
    Tool& tool = *room.tool;
    const std::unique_ptr<QWidget> row(tool.makeOptions(nullptr));
    auto* paint = row->findChild<ChoiceField*>();
    auto* width = row->findChild<NumberField*>();
    QVERIFY(paint != nullptr && width != nullptr);
    QCOMPARE(paint->count(), 3);
    QCOMPARE(paint->currentIndex(), 0);
    QCOMPARE(width->value(), 0.2);
    Q_EMIT paint->activated(2);
    QVERIFY(tool.statusText().contains(QStringLiteral("unknown space, 0.20 m wide")));
    width->setValue(0.6);
    QVERIFY(tool.statusText().contains(QStringLiteral("unknown space, 0.60 m wide")));
    drag(tool, {1.0, 2.0}, {3.0, 2.0});
    QCOMPARE(room.valueAt({2.0, 2.26}), -1);
    QCOMPARE(room.valueAt({2.0, 2.4}), 0);
  }

  void options_keysPressed_showTheBrush() {
    Room room;
    Tool& tool = *room.tool;
    const std::unique_ptr<QWidget> row(tool.makeOptions(nullptr));
    tool.keyPress(QKeyEvent(QEvent::KeyPress, Qt::Key_2, Qt::NoModifier));
    tool.keyPress(QKeyEvent(QEvent::KeyPress, Qt::Key_BracketRight, Qt::NoModifier));
    QCOMPARE(row->findChild<ChoiceField*>()->currentIndex(), 1);
    QCOMPARE(row->findChild<NumberField*>()->value(), 0.3);
    QVERIFY(tool.statusText().contains(QStringLiteral("free space, 0.30 m wide")));
  }

  void press_withoutAMap_saysSo() {
    Room room;
    ScenarioDocument& document = room.document;
    Tool& tool = *room.tool;
    document.setMap(std::make_shared<sim2d::OccupancyGrid>());
    drag(tool, {1.0, 1.0}, {2.0, 1.0});
    QCOMPARE(document.undoStack().count(), 0);
    QVERIFY(tool.statusText().contains(QStringLiteral("No map")));
  }

  void paint_turnedMap_hitsTheCellsUnderTheBrush() {
    const sim2d::OccupancyGrid grid(100, 100, 0.1, {Vec2(1.0, 2.0), 0.7},
                                    std::vector<std::int8_t>(10000, 0));
    MapStroke stroke(std::make_shared<sim2d::OccupancyGrid>(grid));
    const Vec2 from = grid.cellToWorld({20, 30});
    const Vec2 to = grid.cellToWorld({60, 80});
    stroke.paint(from, to, 0.15, MapPaint::Occupied);
    std::vector<std::int8_t> cells = grid.cells();
    for (const MapStroke::CellChange& change : stroke.changes()) {
      cells[change.index] = change.value;
    }
    const sim2d::OccupancyGrid painted(100, 100, 0.1, grid.origin(), cells);
    for (int step = 0; step <= 50; ++step) {
      const Vec2 at = from + (step / 50.0) * (to - from);
      QVERIFY(painted.isWall(painted.worldToCell(at)));
    }
    QVERIFY(!painted.isWall({10, 30}));
    stroke.paint(Vec2(-1e9, -1e9), Vec2(1e9, 1e9), 0.1, MapPaint::Occupied);  // far outside
  }

 private:
  static CanvasMouse mouse(const Vec2& at) {
    CanvasMouse mouse;
    mouse.world = at;
    mouse.button = Qt::LeftButton;
    return mouse;
  }
  static void drag(Tool& tool, const Vec2& from, const Vec2& to) {
    tool.press(mouse(from));
    tool.move(mouse(0.5 * (from + to)));
    tool.release(mouse(to));
  }
};

QTEST_MAIN(MapPaintTest)
#include "tst_MapPaint.moc"
