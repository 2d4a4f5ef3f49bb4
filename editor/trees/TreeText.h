#pragma once

#include <string>

#include <QtWidgets>

#include "editor/look/Theme.h"
#include "sim2d/base/Result.h"

namespace editor {

/// The XML of a tree as in its file, beside the graph. Typed text is applied as soon as it can be
/// parsed; errors are shown below with their line.
class TreeText : public QWidget {
  Q_OBJECT
 public:
  explicit TreeText(const Theme& theme);
  void setTheme(const Theme& theme);
  /// Sets the current text. Typed text that has not been applied is lost only if `text` differs
  /// from the previous one.
  void showText(const std::string& text);
  void showLine(int line);   // From 1; 0 = none.
  void commitPendingEdit();  // Applies the typed text immediately if it can be parsed.
  QPlainTextEdit& text() const { return *text_; }
  QString problem() const { return problem_->text(); }

 Q_SIGNALS:
  void edited(const std::string& xml);  // A parsable file.
  void lineChosen(int line);            // By mouse or arrow keys.

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void take();
  void markLine();
  Theme theme_;
  std::string taken_;  // The current text.
  int line_ = 0;
  bool showing_ = false;
  QTimer pause_;
  QPlainTextEdit* text_;
  QLabel* problem_;
  QToolButton* back_;
};

}  // namespace editor
