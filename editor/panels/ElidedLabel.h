#pragma once

#include <QLabel>

namespace editor {

/// One line that asks for no width of its own: what does not fit loses its middle, and the tool tip
/// has the whole. `text` stays whole.
class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(QWidget* parent = nullptr);
  void setWords(const QString& words);
  QString shownWords() const;  // as they fit now

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace editor
