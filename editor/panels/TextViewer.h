#pragma once

#include <QtWidgets>

#include "editor/look/Theme.h"

namespace editor {

/// Highlights a line of a text, from 1, like a selected list row; 0: none.
void markLine(QPlainTextEdit& text, int line, const Theme& theme);

/// Shows a text file at a line, read-only, with line numbers: for problems without an entity on the
/// map. A single window that is reused.
class TextViewer : public QDialog {
  Q_OBJECT
 public:
  explicit TextViewer(const Theme& theme, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  /// `line` from 1; 0 = the beginning. Returns an error message, or an empty text.
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
