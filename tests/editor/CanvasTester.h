#pragma once

#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QWindow>
#include <QtTest>

#include "SmallScenario.h"
#include "editor/canvas/MapView.h"
#include "editor/tools/ToolManager.h"

/// A canvas in a window with all tools, and real mouse and key events for it.
class CanvasTester {
 public:
  using EntityId = editor::EntityId;
  using Vec2 = editor::Vec2;

  /// A fresh document in the small room, select tool, everything in view.
  void start(sim2d::Scenario scenario) {
    QApplication::setFont(QFont(QStringLiteral("DejaVu Sans"), 9));
    document_.load(std::move(scenario));
    document_.setMap(small::room());
    scene_.setOptions({});
    tools_.setEditingEnabled(true);
    use("Select");
    view_.resize(800, 600);
    view_.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view_));
    view_.fitAll(false);
  }

  static EntityId person(int key) { return {base::EntityKind::Human, key}; }
  static bool isNear(const Vec2& a, const Vec2& b, double tolerance = 0.03) {
    return (a - b).norm() < tolerance;
  }

  QWindow* window() { return view_.window()->windowHandle(); }
  QPoint at(const Vec2& world) {
    return view_.viewport()->mapTo(view_.window(), view_.viewportFrom(world));
  }
  void press(const Vec2& world, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseMove(window(), at(world));
    QTest::mousePress(window(), Qt::LeftButton, modifiers, at(world));
  }
  void move(const Vec2& world) { QTest::mouseMove(window(), at(world)); }
  void release(const Vec2& world, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseRelease(window(), Qt::LeftButton, modifiers, at(world));
    QTest::qWait(0);
  }
  void click(const Vec2& world, Qt::KeyboardModifiers modifiers = {}) {
    press(world, modifiers);
    release(world, modifiers);
    // Two clicks at one place within the interval would be a double click.
    QTest::qWait(1);
  }
  void rightClick(const Vec2& world) {
    QTest::mouseMove(window(), at(world));
    QTest::mouseClick(window(), Qt::RightButton, {}, at(world));
  }
  void doubleClick(const Vec2& world) {
    QTest::mouseMove(window(), at(world));
    QTest::mouseDClick(window(), Qt::LeftButton, {}, at(world));
  }
  void drag(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers modifiers = {}) {
    press(from);
    move(0.5 * (from + to));
    move(to);
    release(to, modifiers);
  }
  void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(window(), which, modifiers);
  }
  std::vector<editor::ToolManager::Entry>::const_iterator entry(const char* name) {
    return std::find_if(tools_.entries().begin(), tools_.entries().end(), [name](const auto& each) {
      return each.info.name == QString::fromUtf8(name);
    });
  }
  editor::Tool* tool(const char* name) {
    const auto found = entry(name);
    return found == tools_.entries().end() ? nullptr : found->tool;
  }
  void use(const char* name) {
    const auto wanted = entry(name);
    QVERIFY2(wanted != tools_.entries().end(), name);
    wanted->action->trigger();
    QCOMPARE(tools_.current(), wanted->tool);
  }
  const sim2d::Scenario& scenario() const { return document_.scenario(); }
  int undoCount() { return document_.undoStack().count(); }
  void undo() { document_.undoStack().undo(); }
  void redo() { document_.undoStack().redo(); }
  /// Undoing that many commands gives `before`, redoing them what there was.
  void checkUndoAndRedo(const sim2d::Scenario& before, int commands = 1) {
    const sim2d::Scenario made = scenario();
    for (int i = 0; i < commands; ++i) {
      undo();
    }
    QVERIFY(scenario() == before);
    for (int i = 0; i < commands; ++i) {
      redo();
    }
    QVERIFY(scenario() == made);
  }
  void checkUnchanged(const sim2d::Scenario& before) {
    QVERIFY(scenario() == before);
    QCOMPARE(undoCount(), 0);
  }

  editor::ScenarioDocument document_;
  editor::MapScene scene_{document_, editor::Theme::light()};
  editor::MapView view_{scene_};
  editor::ToolManager tools_{document_, scene_};
};
