#include "editor/look/Fields.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/look/AppStyle.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/PathFields.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

constexpr int kSliderSteps = 1000;
constexpr int kExact = 20;       // The number of decimals that a value keeps.
constexpr int kMaxDecimals = 6;  // The maximum number of decimals shown.
constexpr double kLong = 1e15;   // Larger numbers are shown with an exponent.
constexpr int kWidest = 130;     // Maximum width [px].
constexpr int kTipOffset = 14;   // Qt places a tooltip below the pointer [px].
constexpr int kTipMargins = 12;  // Of a tooltip, both sides [px].
constexpr int kLeastTip = 180;   // Width of a tooltip near the right edge of the screen [px].

double roundedTo(double value, int decimals) {
  return QString::number(value, 'f', decimals).toDouble();
}

QString unitSuffix(const QString& unit) {
  return unit.isEmpty() || unit == QStringLiteral("°") ? unit : QStringLiteral(" ") + unit;
}

/// Broken at spaces into lines of at most that width [px].
QString brokenInto(int width, const QString& text, const QFontMetrics& metrics) {
  QStringList lines;
  for (const QString& word : text.split(QLatin1Char(' '))) {
    const QString longer = lines.isEmpty() ? word : lines.back() + QLatin1Char(' ') + word;
    if (lines.isEmpty() || metrics.horizontalAdvance(longer) > width) {
      lines << word;
    } else {
      lines.back() = longer;
    }
  }
  return lines.join(QLatin1Char('\n'));
}

void setInvalid(QWidget& widget, bool invalid) {
  if (widget.property(kInvalidProperty).toBool() != invalid) {
    widget.setProperty(kInvalidProperty, invalid);
    widget.update();
  }
}

}  // namespace

NumberField::NumberField(const Range& range, const QString& unit, QWidget* parent)
    : QDoubleSpinBox(parent), range_(range), unit_(unit), mostDecimals_(kMaxDecimals) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  setLocale(QLocale::c());
  setDecimals(range.decimals == 0 ? 0 : kExact);
  setRange(std::max(range.minimum, -kLargest), std::min(range.maximum, kLargest));
  setSingleStep(range.step);
  setSuffix(unitSuffix(unit));
  setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setKeyboardTracking(false);
  setAccelerated(true);
  setFocusPolicy(Qt::StrongFocus);
  setToolTip(rangeText());
  fit_.setSingleShot(true);
  fit_.setInterval(0);
  connect(&fit_, &QTimer::timeout, this, [this] { fitText(); });
  connect(this, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    if (!showing_) {
      take(value);
    }
    fitSoon();
  });
  connect(lineEdit(), &QLineEdit::textEdited, this, [this](const QString& text) {
    isTypingOverMixed_ = std::exchange(mixed_, false) || isTypingOverMixed_;
    QString typed = text;
    int position = 0;
    isTypedValid_ = validate(typed, position) == QValidator::Acceptable;
    typed_ = text;
  });
  connect(this, &QAbstractSpinBox::editingFinished, this, &NumberField::finishTyping);
}

void NumberField::finishTyping() {
  const bool isValid = std::exchange(isTypedValid_, true);
  if (std::exchange(isTypingOverMixed_, false)) {
    isValid ? take(value()) : showMixed();  // The typed number may equal one of the values.
  }
  if (!isValid) {
    const QString wrong = refusalOf(typed_);
    later(*this,
          [this, wrong] { explainRefusal(*this, rect(), wrong); });  // The focus moves first.
  }
}

/// "must be 0.10 to 1.00 m"
QString NumberField::refusalOf(const QString& typed) const {
  const std::optional<double> number = base::parseDouble(bare(typed).toStdString());
  const QString range = rangeText();
  const bool isNumber = number && std::isfinite(*number);
  return isNumber          ? tr("must be %1").arg(range)
         : range.isEmpty() ? tr("not a number")
                           : tr("not a number; must be %1").arg(range);
}

/// "0.00 to 5.00 m", "above 0.00 m"; empty if any number is allowed.
QString NumberField::rangeText() const {
  const bool hasLow = std::isfinite(range_.minimum);
  const QString low = QString::number(range_.minimum, 'f', range_.decimals);
  const QString high = QString::number(range_.maximum, 'f', range_.decimals);
  if (!std::isfinite(range_.maximum)) {
    return hasLow
               ? (range_.above ? tr("above %1%2") : tr("at least %1%2")).arg(low, unitSuffix(unit_))
               : QString();
  }
  return !hasLow        ? tr("at most %1%2").arg(high, unitSuffix(unit_))
         : range_.above ? tr("above %1, at most %2%3").arg(low, high, unitSuffix(unit_))
                        : tr("%1 to %2%3").arg(low, high, unitSuffix(unit_));
}

/// Arrows and sliders stop at 0 for counts, even where files may contain less.
double NumberField::lowest() const {
  const double low = range_.above ? range_.minimum + std::pow(10.0, -range_.decimals) : minimum();
  return range_.decimals == 0 && low < 0.0 && maximum() > 0.0 ? 0.0 : low;
}

QAbstractSpinBox::StepEnabled NumberField::stepEnabled() const {
  return (value() > lowest() ? StepDownEnabled : StepNone) |
         (value() < maximum() ? StepUpEnabled : StepNone);
}

/// Limits the width, which Qt derives from the range.
QSize NumberField::sizeHint() const {
  const QSize usual = QDoubleSpinBox::sizeHint();
  return {std::min(usual.width(), kWidest), usual.height()};
}

/// Accepts a value that the user entered.
void NumberField::take(double value) {
  isTypingOverMixed_ = false;
  if (std::exchange(mixed_, false)) {
    lineEdit()->setText(textFromValue(value) + suffix());
  }
  default_ = false;
  setSecondaryColor(false);
  Q_EMIT edited(value);
}

void NumberField::show(double value, bool isDefault) {
  showing_ = true;
  const bool wasMixed = std::exchange(mixed_, false);
  const bool wasDefault = std::exchange(default_, isDefault);
  if (wasMixed || this->value() != value || wasDefault != isDefault) {
    setValue(value);
    if (wasMixed || wasDefault != isDefault) {
      lineEdit()->setText(textFromValue(value) + suffix());
    }
  }
  if (!isShortened_ && suffix() != unitText()) {
    setSuffix(unitText());
  }
  fitSoon();
  setSecondaryColor(isDefault);
  showing_ = false;
}

/// The unit as it is shown after the number.
QString NumberField::unitText() const {
  const bool isOne = value() == 1.0 && !singularUnit_.isEmpty();
  return unitSuffix(isOne ? singularUnit_ : unit_);
}

bool NumberField::fits(const QString& text) const {
  constexpr int kMargins = 5;  // Of a QLineEdit, with the cursor [px].
  return lineEdit()->fontMetrics().horizontalAdvance(text) <= lineEdit()->width() - kMargins;
}

/// After the layout, which may still be that of another form.
void NumberField::fitSoon() {
  fit_.start();
}

/// Leaves out zeros at the end first, then the unit, then decimals. Text that is being typed stays
/// as it is.
void NumberField::fitText() {
  const bool isTyped = lineEdit()->hasFocus() && lineEdit()->isModified();
  if (!isVisible() || mixed_ || isTyped) {
    return;
  }
  const QString whole = textWith(value(), kMaxDecimals);
  int decimals = kMaxDecimals;
  while (decimals > 0 && !fits(textWith(value(), decimals) + unitText())) {
    --decimals;
  }
  const bool isWhole = textWith(value(), decimals).toDouble() == whole.toDouble();
  const QString unit =
      isWhole && fits(textWith(value(), decimals) + unitText()) ? unitText() : QString();
  decimals = isWhole && unit == unitText() ? decimals : kMaxDecimals;
  while (decimals > 0 && !fits(textWith(value(), decimals) + unit)) {
    --decimals;
  }
  const bool isChanged = decimals != mostDecimals_ || unit != suffix();
  mostDecimals_ = decimals;
  isShortened_ = unit != unitText() || textWith(value(), decimals) != whole;
  if (isChanged) {
    const QScopedValueRollback<bool> showing(showing_, true);
    if (unit != suffix()) {
      setSuffix(unit);
    }
    lineEdit()->setText(textFromValue(value()) + suffix());
  }
}

void NumberField::resizeEvent(QResizeEvent* event) {
  QDoubleSpinBox::resizeEvent(event);
  fitSoon();
}

void NumberField::showEvent(QShowEvent* event) {
  QDoubleSpinBox::showEvent(event);
  fitSoon();
}

bool NumberField::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && isShortened_ && !mixed_) {
    const QString whole = textWith(value(), kMaxDecimals) + unitText();
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                       toolTip().isEmpty() ? whole : whole + QLatin1Char('\n') + toolTip(), this);
    return true;
  }
  if (event->type() == QEvent::PaletteChange) {
    setSecondaryColor(default_ || mixed_);
  }
  return QDoubleSpinBox::event(event);
}

void NumberField::showMixed() {
  showing_ = true;
  mixed_ = true;
  lineEdit()->setText(textFromValue(value()) + suffix());
  setSecondaryColor(true);
  showing_ = false;
}

QString NumberField::bare(const QString& text) const {
  QString word = text;
  for (const QString& unit : {unit_, singularUnit_}) {
    if (!unit.isEmpty() && word.trimmed().endsWith(unit)) {
      word = word.trimmed();
      word.chop(unit.size());
      break;
    }
  }
  const bool isDecimalComma = word.count(QLatin1Char(',')) == 1 && !word.contains(QLatin1Char('.'));
  if (isDecimalComma) {
    word.replace(QLatin1Char(','), QLatin1Char('.'));
  }
  return word.trimmed();
}

QValidator::State NumberField::validate(QString& text, int&) const {
  if (mixed_ && bare(text) == QStringLiteral("–")) {
    return QValidator::Acceptable;
  }
  const std::optional<double> number = base::parseDouble(bare(text).toStdString());
  const bool finite = number && std::isfinite(*number);
  const bool valid = finite && *number >= minimum() && *number <= maximum() &&
                     (!range_.above || *number > range_.minimum);
  setInvalid(const_cast<NumberField&>(*this), !valid);
  return valid ? QValidator::Acceptable : QValidator::Intermediate;
}

QString NumberField::textFromValue(double value) const {
  return mixed_ ? QStringLiteral("–") : textWith(value, mostDecimals_);
}

QString NumberField::textWith(double value, int mostDecimals) const {
  if (range_.decimals > 0 && std::abs(value) >= kLong) {
    return QString::fromStdString(base::formatDouble(value));
  }
  int decimals = std::min(range_.decimals, mostDecimals);
  const double shown = roundedTo(value, kMaxDecimals);
  while (!default_ && decimals > 0 && decimals < mostDecimals &&
         roundedTo(value, decimals) != shown) {
    ++decimals;
  }
  const bool isZero = roundedTo(value, decimals) == 0.0;
  return QString::number(isZero ? 0.0 : value, 'f', decimals);  // Not "-0.0".
}

double NumberField::valueFromText(const QString& text) const {
  const QString word = bare(text);
  if (word == textFromValue(value())) {
    return value();  // Keeps the digits that are not shown.
  }
  const std::optional<double> number = base::parseDouble(word.toStdString());
  return number && std::isfinite(*number) ? *number : value();
}

void NumberField::stepBy(int steps) {
  mixed_ = false;
  isTypedValid_ = true;
  QString text = lineEdit()->text();
  int position = 0;
  const double from =
      validate(text, position) == QValidator::Acceptable ? valueFromText(text) : value();
  const double to = roundedTo(from + steps * singleStep(), kMaxDecimals);
  setValue(std::clamp(to, std::min(from, lowest()), maximum()));
  selectAll();
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  QDoubleSpinBox::focusOutEvent(event);
  lineEdit()->setText(textFromValue(value()) + suffix());  // Discards invalid text.
  setInvalid(*this, false);
  fitSoon();
}

void NumberField::setSecondaryColor(bool pale) {
  QPalette colors;
  if (pale) {
    const QColor color = palette().color(QPalette::PlaceholderText);
    colors.setColor(QPalette::Active, QPalette::Text, color);
    colors.setColor(QPalette::Inactive, QPalette::Text, color);
  }
  lineEdit()->setPalette(colors);
}

void NumberField::contextMenuEvent(QContextMenuEvent* event) {
  QMenu* menu = lineEdit()->createStandardContextMenu();
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addSeparator();
  QAction* reset = menu->addAction(tr("Use the default"));
  reset->setEnabled(!default_);
  connect(reset, &QAction::triggered, this, &NumberField::resetRequested);
  menu->popup(event->globalPos());
}

void NumberField::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) {
    QDoubleSpinBox::wheelEvent(event);
  } else {
    event->ignore();  // The panel scrolls.
  }
}

LinkedSlider::LinkedSlider(NumberField& field, double maximum, QWidget* parent)
    : QSlider(Qt::Horizontal, parent),
      field_(field),
      minimum_(std::max(field.lowest(), 0.0)),
      maximum_(maximum) {
  setRange(0, kSliderSteps);
  setFocusPolicy(Qt::NoFocus);
  const auto follow = [this](double value) {
    const QSignalBlocker quiet(this);
    const double part = (value - minimum_) / (maximum_ - minimum_);
    setValue(static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * kSliderSteps)));
  };
  connect(&field_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, follow);
  connect(this, &QSlider::valueChanged, this, [this](int position) {
    field_.setValue(roundedTo(minimum_ + (maximum_ - minimum_) * position / kSliderSteps,
                              std::min(field_.shownDecimals(), 2)));
  });
  follow(field_.value());
  if (const auto* text = field_.findChild<QLineEdit*>()) {  // Several values have the text "–".
    connect(text, &QLineEdit::textChanged, this, qOverload<>(&QSlider::update));
  }
}

void LinkedSlider::paintEvent(QPaintEvent* event) {
  if (!field_.isMixed()) {
    QSlider::paintEvent(event);
    return;
  }
  QStyleOptionSlider groove;
  initStyleOption(&groove);
  groove.subControls = QStyle::SC_SliderGroove;
  groove.sliderPosition = groove.sliderValue = groove.minimum;
  QPainter painter(this);
  style()->drawComplexControl(QStyle::CC_Slider, &groove, &painter, this);
}

ChoiceField::ChoiceField(QWidget* parent) : QComboBox(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(4);
  setPlaceholderText(QStringLiteral("–"));  // Shown for several values.
}

TextField::TextField(QWidget* parent) : QLineEdit(parent) {
  connect(this, &QLineEdit::textEdited, this, &TextField::judge);
  connect(this, &QLineEdit::editingFinished, this, &TextField::commit);
  showEndOfPaths(*this);
}

void TextField::show(const QString& text) {
  shown_ = text;
  if (this->text() != text) {
    setText(text);
    setCursorPosition(hasFocus() ? cursorPosition() : 0);  // Shows the beginning of a long text.
  }
  setInvalid(*this, false);
  setToolTip(hint_);
}

void TextField::judge() {
  const QString wrong = check_ && text() != shown_ ? check_(text()) : QString();
  setInvalid(*this, !wrong.isEmpty());
  setToolTip(wrong.isEmpty() ? hint_ : wrong);
}

void TextField::commit() {
  if (text() == shown_) {
    return;
  }
  judge();
  if (property(kInvalidProperty).toBool()) {
    const QString wrong = toolTip();
    show(shown_);
    QWidget* const viewport = parentWidget();
    const bool isInList = viewport != nullptr &&
                          qobject_cast<QAbstractItemView*>(viewport->parentWidget()) != nullptr;
    QWidget& at = isInList ? *viewport : *this;  // A list closes its editor.
    later(at, [&at, place = isInList ? geometry() : rect(), wrong] {
      explainRefusal(at, place, wrong);  // The focus moves first.
    });
    return;
  }
  shown_ = text();
  Q_EMIT edited(shown_);
}

/// At the right edge of the screen the text has several lines: Qt would move it over the labels.
void explainRefusal(QWidget& at, const QRect& place, const QString& wrong) {
  if (!at.isVisible()) {
    return;
  }
  const QString text = TextField::tr("Not used: %1").arg(wrong);
  const QFontMetrics metrics(QToolTip::font());
  const int left = at.mapToGlobal(place.topLeft()).x();
  const int end = at.screen()->availableGeometry().right() - kTipMargins;
  const int width = std::max(kLeastTip, end - left - kTipMargins);
  const QString lines = brokenInto(width, text, metrics);
  const int needed = metrics.boundingRect(QRect(0, 0, width, 1000), 0, lines).width();
  const QPoint below(std::min(left, end - kTipMargins - needed),
                     at.mapToGlobal(place.bottomLeft()).y() + 1 - kTipOffset);
  QToolTip::showText(below, lines, &at);
}

namespace {

/// The open item editor, or null. A list edits one row at a time.
QWidget* openEditor(const QAbstractItemView& list) {
  for (QWidget* each :
       list.viewport()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    const bool isField =
        qobject_cast<QLineEdit*>(each) != nullptr || qobject_cast<QComboBox*>(each) != nullptr;
    if (isField && !each->isHidden()) {  // Hidden editors are about to be deleted.
      return each;
    }
  }
  return nullptr;
}

}  // namespace

void commitPendingEdit(QWidget& window) {
  const QPointer<QWidget> field = window.focusWidget();
  const bool isField = qobject_cast<QLineEdit*>(field) != nullptr ||
                       qobject_cast<QAbstractSpinBox*>(field) != nullptr ||
                       qobject_cast<QPlainTextEdit*>(field) != nullptr;
  if (!isField || !field->hasFocus()) {
    return;  // The menu or dialog that took the focus has already committed the text.
  }
  field->clearFocus();
  if (field && field->isVisible()) {  // An editor in a list has already been closed.
    field->setFocus();
  }
}

void commitPendingEdit(const QAbstractItemView& list) {
  if (QWidget* const field = openEditor(list)) {
    Q_EMIT list.itemDelegate()->commitData(field);
    Q_EMIT list.itemDelegate()->closeEditor(field);
  }
}

void cancelPendingEdit(const QAbstractItemView& list) {
  if (QWidget* const field = openEditor(list)) {
    Q_EMIT list.itemDelegate()->closeEditor(field, QAbstractItemDelegate::RevertModelCache);
  }
}

}  // namespace editor
