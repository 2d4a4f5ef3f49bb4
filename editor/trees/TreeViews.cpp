#include "editor/trees/TreeViews.h"

#include <algorithm>

#include "bt/tree/TreeXml.h"
#include "editor/look/Fields.h"
#include "editor/look/TableExport.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

namespace {

constexpr int kTypingPauseMs = 500;

}  // namespace

TreeText::TreeText(const Theme& theme) : theme_(theme) {
  QFont fixed(QStringLiteral("monospace"));
  fixed.setStyleHint(QFont::TypeWriter);
  fixed.setPointSizeF(theme.font().pointSizeF());
  text_->setFont(fixed);
  text_->setFrameShape(QFrame::NoFrame);
  text_->setLineWrapMode(QPlainTextEdit::NoWrap);
  text_->setUndoRedoEnabled(false);  // Undo is provided by the commands of the document.
  text_->setAccessibleName(tr("XML of the tree"));
  problem_->setTextFormat(Qt::PlainText);
  problem_->setWordWrap(true);
  back_ = linkButton(tr("Discard"),
                     tr("Discard the edit and show the current "
                        "tree"),
                     this, [this] {
                       const std::string counts = taken_;
                       taken_.clear();
                       showText(counts);
                     });
  auto* below = new QWidget(this);
  configuredLayout(new QHBoxLayout(below), {12, 2, 12, 2}, 8, {problem_, back_})
      ->setStretchFactor(problem_, 1);
  auto* layout = configuredLayout(new QVBoxLayout(this), {}, 0, {text_, below});
  layout->setStretchFactor(text_, 1);
  back_->hide();
  pause_.setSingleShot(true);
  pause_.setInterval(kTypingPauseMs);
  connect(&pause_, &QTimer::timeout, this, &TreeText::take);
  connect(text_, &QPlainTextEdit::textChanged, this, [this] {
    if (!showing_) {
      pause_.start();
    }
  });
  connect(text_, &QPlainTextEdit::cursorPositionChanged, this, [this] {
    if (!showing_ && !pause_.isActive()) {
      Q_EMIT lineChosen(text_->textCursor().blockNumber() + 1);
    }
  });
  text_->installEventFilter(this);
  setTheme(theme);
}

void TreeText::setTheme(const Theme& theme) {
  theme_ = theme;
  QPalette colors = palette();
  colors.setColor(QPalette::WindowText, theme.color(Role::Error));
  problem_->setPalette(colors);
  markLine();
}

void TreeText::showText(const std::string& text) {
  if (text == taken_) {
    return;
  }
  taken_ = text;
  pause_.stop();
  problem_->clear();
  back_->hide();
  const QString now = QString::fromStdString(text);
  if (now == text_->toPlainText()) {
    return;  // The text was typed here: the cursor stays.
  }
  showing_ = true;
  const int line = text_->textCursor().blockNumber();
  text_->setPlainText(now);
  const QTextBlock block = text_->document()->findBlockByNumber(line);
  text_->setTextCursor(QTextCursor(block.isValid() ? block : text_->document()->firstBlock()));
  showing_ = false;
}

void TreeText::commitPendingEdit() {
  if (pause_.isActive()) {
    pause_.stop();
    take();
  }
}

bool TreeText::eventFilter(QObject* watched, QEvent* event) {
  if (watched == text_ && event->type() == QEvent::FocusOut) {
    commitPendingEdit();
  }
  return QWidget::eventFilter(watched, event);
}

void TreeText::take() {
  const std::string typed = text_->toPlainText().toStdString();
  if (typed == taken_) {
    problem_->clear();
    back_->hide();
    return;
  }
  const base::Result<bt::TreeFile> file = bt::readTreeText(typed);
  if (!file) {
    const base::Diagnostic& first = file.diagnostics().front();
    problem_->setText(
        first.line > 0
            ? tr("Line %1: %2").arg(first.line).arg(QString::fromStdString(first.message))
            : QString::fromStdString(first.message));
    back_->show();
    return;
  }
  Q_EMIT edited(typed);
}

void TreeText::showLine(int line) {
  line_ = line;
  markLine();
  if (line > 0 && !text_->hasFocus()) {
    showing_ = true;
    const QTextBlock block = text_->document()->findBlockByNumber(line - 1);
    text_->setTextCursor(QTextCursor(block.isValid() ? block : text_->document()->firstBlock()));
    text_->centerCursor();
    showing_ = false;
  }
}

void TreeText::markLine() {
  editor::markLine(*text_, line_, theme_);
}

namespace {

enum EntryColumn { EntryKey, EntryValue, EntryColumns };

constexpr int kKeyWidth = 220;

}  // namespace

BlackboardView::BlackboardView(SimulationRunner& runner, const Theme& theme)
    : runner_(runner), theme_(theme), table_(new QTableWidget(0, EntryColumns, this)) {
  styleTable(*table_, tr("Blackboard"));
  makeTableSavable(*table_, tr("Blackboard"));
  table_->setHorizontalHeaderLabels({tr("Entry"), tr("Value")});
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->setColumnWidth(EntryKey, kKeyWidth);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                          QAbstractItemView::AnyKeyPressed);
  auto* layout = configuredLayout(new QVBoxLayout(this), {}, 0, {table_});
  layout->addWidget(words_, 1);
  soon_.setSingleShot(true);
  connect(&soon_, &QTimer::timeout, this, &BlackboardView::follow);
  connect(table_, &QTableWidget::cellChanged, this, &BlackboardView::take);
  connect(&runner_, &SimulationRunner::entriesChanged, this, &BlackboardView::follow);
  connect(&runner_, &SimulationRunner::frameShown, this, &BlackboardView::follow);
  connect(&runner_, &SimulationRunner::stateChanged, this, &BlackboardView::follow);
  connect(&runner_, &SimulationRunner::finished, this, &BlackboardView::follow);
  connect(&runner_, &SimulationRunner::inputsRefused, this,
          [this](const base::Diagnostics& problems) {
            typed_.clear();
            Q_EMIT messageChanged(QString::fromStdString(problems.front().message));
            follow();
          });
  setTheme(theme);
}

void BlackboardView::setTheme(const Theme& theme) {
  theme_ = theme;
  follow();
}

void BlackboardView::showPerson(std::optional<int> id) {
  if (id != person_) {
    commitPendingEdit(*table_);  // The text is for the previous person.
    person_ = id;
    typed_.clear();
  }
  if (id != runner_.watched()) {
    runner_.watchBlackboard(id);
  }
  follow();
}

QString BlackboardView::whyEmpty() const {
  if (runner_.state() == SimulationRunner::State::Editing) {
    return tr("The blackboard is available during a run: press Space.");
  }
  if (runner_.isRecorded()) {
    return runner_.canBranchFromShown()
               ? tr("Recorded runs contain no blackboard. \"Branch here…\" (in the menu Run) "
                    "replays the run with it.")
               : tr("Recorded runs contain no blackboard.");
  }
  if (runner_.isLookingBack() || runner_.isFinished()) {
    return tr(
        "Not recorded at this time: the blackboard is recorded from the step in which the person "
        "is selected.");
  }
  return tr("The tree has no entries.");
}

bool BlackboardView::isUserSet(const QString& key) const {
  return key == QLatin1String("id") || key == QLatin1String("dt");
}

void BlackboardView::showRow(int row, const std::string& key, const std::string& value) {
  const auto typed = typed_.find(key);
  const bool waits = typed != typed_.end();
  const QString texts[] = {QString::fromStdString(key),
                           QString::fromStdString(waits ? typed->second.first : value)};
  const bool isEditable = runner_.isLive() && !isUserSet(texts[EntryKey]);
  for (int column = 0; column < EntryColumns; ++column) {
    QTableWidgetItem* item = table_->item(row, column);
    if (item == nullptr) {
      item = new QTableWidgetItem;
      table_->setItem(row, column, item);
    }
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    flags.setFlag(Qt::ItemIsEditable, column == EntryValue && isEditable);
    item->setFlags(flags);
    item->setText(texts[column]);
    item->setForeground(theme_.color(column == EntryKey ? Role::TextSecondary
                                     : waits            ? Role::Accent
                                                        : Role::Text));
    item->setToolTip(waits        ? tr("Takes effect in the next step")
                     : isEditable ? tr("Double-click to change the value")
                                  : texts[column]);
  }
}

void BlackboardView::follow() {
  const app::BlackboardEntries* entries =
      person_ == runner_.watched() ? runner_.shownEntries() : nullptr;
  const bool isShown = person_ && entries != nullptr && !entries->empty();
  table_->setVisible(isShown);
  words_->setVisible(!isShown);
  words_->setText(isShown ? QString() : whyEmpty());
  if (table_->findChild<QLineEdit*>() != nullptr && isShown && runner_.isLive()) {
    return;  // The user is typing.
  }
  const std::int64_t step = runner_.shownFrame() == nullptr ? -1 : runner_.shownFrame()->step;
  for (auto each = typed_.begin(); each != typed_.end();) {
    each = each->second.second < step || !runner_.isLive() ? typed_.erase(each) : std::next(each);
  }
  showing_ = true;
  table_->setRowCount(isShown ? static_cast<int>(entries->size()) : 0);
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto& [key, value] = (*entries)[static_cast<std::size_t>(row)];
    showRow(row, key, value);
  }
  showing_ = false;
}

void BlackboardView::take(int row, int column) {
  if (showing_ || column != EntryValue || !person_ || !runner_.isLive()) {
    return;
  }
  const std::string key = table_->item(row, EntryKey)->text().toStdString();
  const std::string value = table_->item(row, EntryValue)->text().toStdString();
  sim2d::Input input;
  input.kind = sim2d::InputKind::Entry;
  input.id = *person_;
  input.name = key + "=" + value;
  const std::int64_t step = runner_.shownFrame() == nullptr ? 0 : runner_.shownFrame()->step;
  typed_[key] = {value, step};
  runner_.addInput(std::move(input));
  Q_EMIT messageChanged(tr("%1 becomes %2 in the next step, as an input of the run")
                            .arg(QString::fromStdString(key), QString::fromStdString(value)));
  soon_.start();
}

namespace {

constexpr double kMinScale = 24.0, kMaxScale = 60.0;  // [px/m]
constexpr double kInsetRadius = 6.0;
constexpr double kTitleHeight = 22.0;
constexpr double kTitleOpacity = 0.85;

}  // namespace

MapInset::MapInset(MapScene& scene, SimulationRunner& runner, QWidget* parent)
    : QWidget(parent), scene_(scene), runner_(runner) {
  resize(kSize);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAccessibleName(tr("The map around the person"));
  connect(&scene_, &QGraphicsScene::changed, this, qOverload<>(&QWidget::update));
  connect(&runner_, &SimulationRunner::frameShown, this, qOverload<>(&QWidget::update));
}

void MapInset::follow(EntityId person) {
  person_ = person;
  update();
}

std::optional<Vec2> MapInset::centre() const {
  const sim2d::Human* human = scene_.document().human(person_);
  if (human == nullptr) {
    return std::nullopt;
  }
  if (const FramePtr frame = runner_.shownFrame()) {
    const std::vector<int>& ids = frame->humans.id;
    const auto found = std::find(ids.begin(), ids.end(), human->id);
    if (found != ids.end()) {
      const auto row = static_cast<std::size_t>(found - ids.begin());
      return Vec2(frame->humans.x[row], frame->humans.y[row]);
    }
  }
  return human->initPose.position;
}

/// Above the map, so that it is not taken for an overview of the tree.
void MapInset::paintTitle(QPainter& painter) const {
  const Theme& theme = scene_.theme();
  const QRectF bar(0.0, 0.0, width(), kTitleHeight);
  painter.fillRect(bar, theme.color(Role::Panel, kTitleOpacity));
  painter.setFont(theme.font());
  painter.setPen(theme.color(Role::Text));
  const QRectF words = bar.adjusted(8.0, 0.0, -8.0, 0.0);
  painter.drawText(
      words, Qt::AlignLeft | Qt::AlignVCenter,
      painter.fontMetrics().elidedText(title(), Qt::ElideRight, qRound(words.width())));
}

QString MapInset::title() const {
  const sim2d::Human* human = scene_.document().human(person_);
  return human == nullptr ? QString()
                          : tr("Map around %1").arg(QString::fromStdString(human->name));
}

void MapInset::paintEvent(QPaintEvent* /*event*/) {
  const std::optional<Vec2> at = centre();
  if (!at) {
    return;
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  QPainterPath shape;
  shape.addRoundedRect(frame, kInsetRadius, kInsetRadius);
  painter.setClipPath(shape);
  painter.fillRect(rect(), scene_.groundColor());
  // The sizes of labels and lines correspond to the zoom of the main map.
  const double scale = std::clamp(scene_.pixelsPerMetre(), kMinScale, kMaxScale);
  painter.save();
  painter.translate(frame.center());
  painter.scale(scale, scale);
  painter.translate(-toScene(*at));
  const QSizeF seen = QSizeF(frame.size()) / scale;
  scene_.paintPart(painter, CanvasPart::All,
                   QRectF(toScene(*at) - QPointF(0.5 * seen.width(), 0.5 * seen.height()), seen));
  painter.restore();
  paintTitle(painter);
  painter.setClipping(false);
  painter.setPen(QPen(scene_.theme().color(Role::FieldEdge), 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(shape);
}

}  // namespace editor
