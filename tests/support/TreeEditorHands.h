#pragma once

#include <QMenu>
#include <QUndoStack>
#include <QtTest>

#include "editor/panels/behavior/TreeOutline.h"
#include "editor/trees/TreeEditor.h"

/// Mouse, keys and menus of a tree editor.
class TreeEditorHands {
 public:
  TreeEditorHands() = default;
  Q_DISABLE_COPY_MOVE(TreeEditorHands)

 protected:
  using EntityId = editor::EntityId;

  virtual ~TreeEditorHands() = default;
  virtual editor::ScenarioDocument& document() = 0;
  virtual editor::TreeEditor& studio() = 0;
  editor::TreeCanvas& canvas() { return studio().canvas(); }
  editor::TreeGraph& graph() { return canvas().graph(); }
  int undoSteps() { return document().undoStack().index(); }

  EntityId person(const char* name) {
    for (const sim2d::Human& human : document().scenario().humans) {
      if (human.name == name) {
        return human.key;
      }
    }
    return {};
  }
  int called(const char* title, int skip = 0) {
    for (std::size_t i = 0; i < graph().nodes().size(); ++i) {
      if (editor::nodeTitle(*graph().nodes()[i].node) == QString::fromUtf8(title) && skip-- == 0) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }
  QStringList rootChildren() {
    QStringList titles;
    for (const int child : graph().childrenOf(0)) {
      titles << editor::nodeTitle(*graph().node(child).node);
    }
    return titles;
  }
  void click(int node) {
    QVERIFY(graph().isShown(node));
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, canvas().centreOf(node));
  }
  void drag(const QPoint& from, const QPoint& to) {
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, from);
    for (int k = 1; k <= 4; ++k) {
      const QPoint at = from + (to - from) * k / 4;
      QMouseEvent move(QEvent::MouseMove, at, canvas().mapToGlobal(at), Qt::NoButton,
                       Qt::LeftButton, {});
      QCoreApplication::sendEvent(&canvas(), &move);
    }
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, to);
  }
  QAction* entry(QMenu& menu, const QString& words) {
    for (QAction* action : menu.actions()) {
      if (action->text().section(QLatin1Char('\t'), 0, 0) == words) {
        return action;
      }
      if (action->menu() != nullptr) {
        if (QAction* inner = entry(*action->menu(), words)) {
          return inner;
        }
      }
    }
    return nullptr;
  }
  void choosefromMenu(int node, const char* words) {
    QMenu menu;
    studio().fillMenu(menu, node);
    QAction* action = entry(menu, QString::fromUtf8(words));
    QVERIFY2(action != nullptr, words);
    QVERIFY2(action->isEnabled(), words);
    action->trigger();
  }
};
