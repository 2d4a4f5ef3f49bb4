#pragma once

#include <functional>
#include <utility>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSlider>
#include <QWheelEvent>

namespace editor {

/// A number with its unit in the field. What is typed is checked at once: a number outside of the
/// range has a red edge and is never taken over. A number of the file keeps all its digits: six
/// after the point are shown, if it has them. A value that the scenario leaves out is shown in the
/// secondary colour; a dash stands for several values.
class NumberField : public QDoubleSpinBox {
  Q_OBJECT
 public:
  struct Range {
    double minimum = 0.0, maximum = 1.0;  // may be infinite
    int decimals = 2;                     // at least shown
    double step = 0.1;
    bool above = false;  // the minimum itself is refused
  };
  NumberField(const Range& range, const QString& unit, QWidget* parent = nullptr);
  void setUnitOfOne(const QString& unit) { unitOfOne_ = unit; }  // "1 step", but "2 steps"

  /// Shows without `edited`. `isDefault`: the scenario has no value of its own.
  void show(double value, bool isDefault);
  void showMixed();
  bool isMixed() const { return mixed_; }
  int shownDecimals() const { return range_.decimals; }
  double lowest() const;  // that the arrows and a slider reach

  QValidator::State validate(QString& text, int& position) const override;
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  void stepBy(int steps) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 Q_SIGNALS:
  void edited(double value);
  void defaultWanted();

 protected:
  StepEnabled stepEnabled() const override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void take(double value);
  void setPale(bool pale);
  QString bare(const QString& text) const;
  QString rangeText() const;
  const Range range_;
  QString unit_, unitOfOne_;
  bool mixed_ = false;
  bool overDash_ = false;  // something is typed where several values are
  bool isTypedFine_ = false;
  bool default_ = false;
  bool showing_ = false;
};

/// A slider beside a NumberField; both show the same number.
class LinkedSlider : public QSlider {
  Q_OBJECT
 public:
  LinkedSlider(NumberField& field, double maximum, QWidget* parent = nullptr);

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }

 private:
  NumberField& field_;
  double minimum_, maximum_;
};

/// A combo box that the wheel does not change by accident while the panel scrolls.
class ChoiceField : public QComboBox {
  Q_OBJECT
 public:
  explicit ChoiceField(QWidget* parent = nullptr);

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

/// A text that is checked while it is typed.
class TextField : public QLineEdit {
  Q_OBJECT
 public:
  /// Says what is wrong with a text, or nothing.
  using Check = std::function<QString(const QString&)>;
  explicit TextField(QWidget* parent = nullptr);
  void setCheck(Check check) { check_ = std::move(check); }
  /// The tooltip while nothing is wrong.
  void setHint(const QString& hint);
  void show(const QString& text);

 Q_SIGNALS:
  void edited(const QString& text);  // after return or leaving; only what passes the check

 private:
  void judge();
  void commit();
  Check check_;
  QString hint_, shown_;
};

}  // namespace editor
