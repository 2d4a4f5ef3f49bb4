#pragma once

#include <QDialog>
#include <QLabel>
#include <QPlainTextEdit>

#include "editor/look/Theme.h"

namespace editor {

/// Marks a line of a text, from 1, as rows of lists are; 0: none.
void markLine(QPlainTextEdit& text, int line, const Theme& theme);

/// Shows a text file at a line, read-only, with numbers at its lines: for problems that no thing on
/// the map stands for. One window, used again and again.
class TextViewer : public QDialog {
  Q_OBJECT
 public:
  explicit TextViewer(const Theme& theme, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  /// `line` from 1; 0 = the beginning. What went wrong, or nothing.
  QString showFile(const QString& path, int line);
  QPlainTextEdit& text() const { return *text_; }
  QString path() const { return path_; }
  int line() const { return line_; }

 private:
  void openOutside();
  void markLine();
  Theme theme_;
  QString path_;
  int line_ = 0;
  QLabel* place_;
  QPlainTextEdit* text_;
};

}  // namespace editor
