#pragma once

#include <functional>
#include <utility>

#include <QtWidgets>

namespace editor {

/// A spin box with the unit inside the field. Typed text is validated immediately: a number outside
/// the range has a red edge and is never accepted. A comma is accepted as decimal point. A number
/// from a file keeps all its digits, of which up to six decimals are shown. If they do not fit, the
/// unit and decimals are left out rather than cut off, and the tooltip has the whole number. A
/// value that the scenario leaves out is shown in the secondary colour. A dash stands for several
/// values. A tip shows why a number was not accepted.
class NumberField : public QDoubleSpinBox {
  Q_OBJECT
 public:
  struct Range {
    double minimum = 0.0, maximum = 1.0;  // May be infinite.
    int decimals = 2;                     // The minimum number of decimals shown.
    double step = 0.1;
    bool above = false;  // The minimum itself is invalid.
  };
  NumberField(const Range& range, const QString& unit, QWidget* parent = nullptr);
  void setSingularUnit(const QString& unit) { singularUnit_ = unit; }  // "1 step", but "2 steps"

  /// Sets the value without emitting `edited`. `isDefault`: the scenario leaves the value out.
  void show(double value, bool isDefault);
  void showMixed();
  bool isMixed() const { return mixed_; }
  int shownDecimals() const { return range_.decimals; }
  double lowest() const;  // The lowest value that the arrows and a slider reach.

  QValidator::State validate(QString& text, int& position) const override;
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  void stepBy(int steps) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 Q_SIGNALS:
  void edited(double value);
  void resetRequested();

 protected:
  StepEnabled stepEnabled() const override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void fitSoon();
  void fitText();
  bool fits(const QString& text) const;
  QString textWith(double value, int mostDecimals) const;
  QString unitText() const;
  void take(double value);
  void finishTyping();
  QString refusalOf(const QString& typed) const;
  void setSecondaryColor(bool pale);
  QString bare(const QString& text) const;
  QString rangeText() const;
  const Range range_;
  QString unit_, singularUnit_;
  bool mixed_ = false;
  bool isTypingOverMixed_ = false;  // The user types while the field shows several values.
  bool isTypedValid_ = true;
  QString typed_;  // Typed since the last commit, if invalid.
  bool default_ = false;
  bool showing_ = false;
  int mostDecimals_;          // Number of decimals that fit.
  bool isShortened_ = false;  // The text has less than the whole number.
  QTimer fit_;                // Fits the text once after several changes.
};

/// A slider beside a NumberField; both show the same number. Of several values it has no handle.
class LinkedSlider : public QSlider {
  Q_OBJECT
 public:
  LinkedSlider(NumberField& field, double maximum, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }

 private:
  NumberField& field_;
  double minimum_, maximum_;
};

/// A combo box that ignores the mouse wheel, which scrolls the panel instead.
class ChoiceField : public QComboBox {
  Q_OBJECT
 public:
  explicit ChoiceField(QWidget* parent = nullptr);

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

/// A line edit that is validated during typing.
class TextField : public QLineEdit {
  Q_OBJECT
 public:
  /// Returns what is wrong with a text; empty if it is valid.
  using Check = std::function<QString(const QString&)>;
  explicit TextField(QWidget* parent = nullptr);
  void setCheck(Check check) { check_ = std::move(check); }
  /// Sets the tooltip for valid text.
  void setHint(const QString& hint) {
    hint_ = hint;
    setToolTip(hint);
  }
  void show(const QString& text);

 Q_SIGNALS:
  void edited(const QString& text);  // Emitted on Return and on focus loss, for valid text only.

 private:
  void judge();
  void commit();
  Check check_;
  QString hint_, shown_;
};

/// Shows below a field, or its place in a list, why its text was discarded.
void explainRefusal(QWidget& at, const QRect& place, const QString& wrong);

/// Commits the text being typed in a field of the window, as losing the focus does. The field keeps
/// the focus.
void commitPendingEdit(QWidget& window);
/// Commits the text being typed in a row of the list and closes the editor.
void commitPendingEdit(const QAbstractItemView& list);
/// Closes the editor without a commit before its row is replaced; otherwise Qt commits during the
/// replacement.
void cancelPendingEdit(const QAbstractItemView& list);

}  // namespace editor
