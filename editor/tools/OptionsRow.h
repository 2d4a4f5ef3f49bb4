#pragma once

#include <QHBoxLayout>
#include <QWidget>

namespace editor {

/// Fields of a tool in one row, each with a word before it.
class OptionsRow : public QWidget {
  Q_OBJECT
 public:
  explicit OptionsRow(QWidget* parent);
  void add(const QString& label, QWidget* field);
  void add(QWidget* field);

 private:
  QHBoxLayout* layout_;
};

}  // namespace editor
