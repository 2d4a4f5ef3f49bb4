// What keys do on a tree; how it lies there: TreeCanvas.cpp.
#include <algorithm>
#include <iterator>
#include <utility>

#include <QKeyEvent>

#include "editor/trees/TreeCanvas.h"

namespace editor {

/// Keys that are the canvas's own although commands of the window wait for them.
bool TreeCanvas::isCommand(const QKeyEvent& event) const {
  const QKeySequence::StandardKey standard[] = {QKeySequence::Copy, QKeySequence::Cut,
                                                QKeySequence::Paste};
  const bool isStandard = std::any_of(std::begin(standard), std::end(standard),
                                      [&event](auto key) { return event.matches(key); });
  const int plain[] = {Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_F2,
                       Qt::Key_F,      Qt::Key_Insert,    Qt::Key_Plus,
                       Qt::Key_Minus,  Qt::Key_Return,    Qt::Key_Enter};
  const Qt::KeyboardModifiers held = event.modifiers() & ~Qt::KeypadModifier;
  const bool isPlain =
      held == Qt::NoModifier && std::count(std::begin(plain), std::end(plain), event.key()) > 0;
  const bool isCtrl =
      held == Qt::ControlModifier && (event.key() == Qt::Key_D || event.key() == Qt::Key_A);
  const bool isArrow =
      event.key() >= Qt::Key_Left && event.key() <= Qt::Key_Down &&
      (held == Qt::NoModifier || held == Qt::AltModifier || held == Qt::ShiftModifier);
  return isStandard || isPlain || isCtrl || isArrow;
}

bool TreeCanvas::moveChosen(const QKeyEvent& event) {
  using Way = TreeGraph::Way;
  const std::pair<int, Way> ways[] = {{Qt::Key_Up, Way::Up},
                                      {Qt::Key_Down, Way::Down},
                                      {Qt::Key_Left, Way::Left},
                                      {Qt::Key_Right, Way::Right}};
  for (const auto& [key, way] : ways) {
    if (event.key() == key && (event.modifiers() & Qt::AltModifier) == 0) {
      const int next = graph_.beside(view_.chosen, way);
      if ((event.modifiers() & Qt::ShiftModifier) == 0) {
        chooseByUser(next);
      } else if (next >= 0) {
        std::vector<int> nodes = view_.selected;
        nodes.push_back(next);
        select(std::move(nodes), next);
        Q_EMIT chose(view_.chosen);
      }
      return true;
    }
  }
  return false;
}

void TreeCanvas::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && gesture_ != Gesture::None) {
    origin_ = gesture_ == Gesture::Panning ? originBefore_ : origin_;
    endGesture();
    return;
  }
  if (!isCommand(*event)) {
    if (event->key() == Qt::Key_Escape) {
      Q_EMIT escaped();
    }
    QWidget::keyPressEvent(event);
    return;
  }
  if (moveChosen(*event)) {
    return;
  }
  if (event->key() == Qt::Key_F) {
    fit();
  } else if (event->key() == Qt::Key_A) {
    select(graph_.shown(), view_.chosen);
    Q_EMIT chose(view_.chosen);
  } else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Minus) {
    const bool hasFold = view_.chosen >= 0 && !graph_.childrenOf(view_.chosen).empty();
    if (hasFold) {
      graph_.setFolded(view_.chosen, event->key() == Qt::Key_Minus);
      relayout();
    }
  } else {
    Q_EMIT keyCommand(event->key(), event->modifiers());
  }
}

}  // namespace editor
