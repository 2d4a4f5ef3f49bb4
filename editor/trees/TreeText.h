#pragma once

#include <string>

#include <QLabel>
#include <QPlainTextEdit>
#include <QTimer>
#include <QToolButton>

#include "editor/look/Theme.h"
#include "sim2d/base/Result.h"

namespace editor {

/// The XML of a tree, as it will be in its file, beside the graph: what is typed is taken as soon
/// as it can be read, and what is wrong is said below with its line.
class TreeText : public QWidget {
  Q_OBJECT
 public:
  explicit TreeText(const Theme& theme);
  void setTheme(const Theme& theme);
  /// The text that counts now; what is typed and not taken yet is lost only if that is another one
  /// than before.
  void showText(const std::string& text);
  void showLine(int line);  // from 1; 0 = none
  void finishTyping();      // applies the typed text now, if it can be parsed
  QPlainTextEdit& text() const { return *text_; }
  QString problem() const { return problem_->text(); }

 Q_SIGNALS:
  void edited(const std::string& xml);  // a file that can be read
  void lineChosen(int line);            // by the mouse or the arrows

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void take();
  void markLine();
  Theme theme_;
  std::string taken_;  // counts now
  int line_ = 0;
  bool showing_ = false;
  QTimer pause_;
  QPlainTextEdit* text_;
  QLabel* problem_;
  QToolButton* back_;
};

}  // namespace editor
