#include "editor/panels/IssuesPanel.h"

#include <set>

#include "app/run/Bundle.h"
#include "editor/document/Fixes.h"
#include "editor/document/PersonTree.h"
#include "editor/look/Icons.h"
#include "editor/look/TableExport.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/RowDelegate.h"
#include "editor/panels/properties/PropertyPage.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Fields.h"

namespace editor {

namespace {

constexpr int kSentenceMargin = 52;  // Width of the icon and the margins [px].

/// Columns: message with severity icon, location, fix. Without a fix the location is in the last
/// column and the message spans the other two.
enum IssueColumn { SentenceColumn, PlaceColumn, FixColumn, IssueColumns };

/// Problems of an entity need no file name.
QString placeOf(const base::Diagnostic& issue, const QString& ownFile) {
  if (issue.entity && issue.line == 0) {
    return {};
  }
  const QString file = QFileInfo(QString::fromStdString(issue.file)).fileName();
  if (issue.line > 0 && file == ownFile) {
    return QObject::tr("line %1").arg(issue.line);  // Short, to leave space for the messages.
  }
  return issue.line > 0 ? file + QStringLiteral(":%1").arg(issue.line) : file;
}

/// The label of a key in the forms; empty: none of these tables has it.
template <class... Owners>
QString labelOfKey(const std::string& key) {
  QString label;
  const auto look = [&label](const auto* field) {
    label = field != nullptr && label.isEmpty() ? labelOf(field->spec) : label;
  };
  (look(sim2d::fieldOf<Owners>(key)), ...);
  return label;
}

/// "max_vel 99 is …" as "Top speed (max_vel) 99 is …", because forms do not show keys.
base::Diagnostic withLabel(const base::Diagnostic& issue) {
  const std::string key = issue.value("key");
  const EntityKind kind = issue.entity.kind;
  const QString label = kind == EntityKind::Human
                            ? labelOfKey<sim2d::Human, sim2d::Behavior, sim2d::PersonExtension>(key)
                        : kind == EntityKind::Robot ? labelOfKey<sim2d::Robot>(key)
                        : kind == EntityKind::Area  ? labelOfKey<sim2d::Area>(key)
                                                    : QString();
  return label.isEmpty() ? issue
                         : base::withValue("key", label.toStdString() + " (" + key + ")", issue);
}

/// Removes duplicates: problems with the same message about the same entity, wherever they were
/// found.
base::Diagnostics withoutRepeatedIssues(const base::Diagnostics& all) {
  std::set<std::pair<EntityId, std::string>> said;
  base::Diagnostics once;
  for (const base::Diagnostic& issue : app::withoutDuplicates(all, all)) {
    const std::string place =
        issue.file + ':' + std::to_string(issue.line) + ':' + std::to_string(issue.column) + ':';
    if (said.insert({issue.entity, place + issue.message}).second) {
      once.push_back(issue);
    }
  }
  return once;
}

}  // namespace

QString issueSentence(const base::Diagnostic& issue) {
  const QString text = base::startsWith(issue.code, "tree.")
                           ? treeProblemText(issue)
                           : QString::fromStdString(withLabel(issue).message);
  const EntityKind about = issue.entity.kind;
  const bool isNamed =
      about != EntityKind::None && about != EntityKind::Scenario && about != EntityKind::Goal;
  // "agents.anna.id: is missing", "max_vel …", "Goal" are unchanged; "no tree file …" is
  // capitalized.
  const QString first = text.section(QLatin1Char(' '), 0, 0);
  const bool isWord =
      std::all_of(first.begin(), first.end(), [](QChar each) { return each.isLower(); });
  return !isNamed && !first.isEmpty() && isWord ? capitalized(text) : text;
}

IssuesPanel::IssuesPanel(ScenarioDocument& document, const Theme& theme)
    : document_(document), theme_(theme), table_(new QTableWidget(0, IssueColumns, this)) {
  makeTable();
  stack_->addWidget(noIssuesLabel_);
  stack_->addWidget(table_);
  connect(table_, &QTableView::clicked, this, [this](const QModelIndex& index) {
    if (issueAt(index.row()) == nullptr) {
      setHintsOpen(!areHintsOpen_);
      return;
    }
    const base::Diagnostic issue = *issueAt(index.row());
    isLink(index) ? applyFix(issue) : goToIssue(issue);
  });
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    if (const base::Diagnostic* issue = issueAt(index.row()); issue != nullptr && !isLink(index)) {
      goToIssue(base::Diagnostic(*issue));
    }
  });
  connect(table_, &QTableView::entered, this, [this](const QModelIndex& index) {
    table_->viewport()->setCursor(isLink(index) ? Qt::PointingHandCursor : Qt::ArrowCursor);
  });
  connect(table_, &QTableView::customContextMenuRequested, this, &IssuesPanel::offerMenu);
  connect(&document_, &ScenarioDocument::issuesChanged, this, &IssuesPanel::rebuild);
  connect(&document_, &ScenarioDocument::pathChanged, this, &IssuesPanel::rebuild);
  connect(&document_, &ScenarioDocument::stepFinished, this, [this] {
    if (!isRecorded_ && !action_.empty()) {  // An edit may have fixed them.
      setActionIssues({});
    }
  });
  setTheme(theme);
}

void IssuesPanel::makeTable() {
  styleTable(*table_, tr("Issues"));
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  table_->setMouseTracking(true);
  QHeaderView* header = table_->horizontalHeader();
  header->hide();
  header->setSectionResizeMode(SentenceColumn, QHeaderView::Stretch);
  header->setSectionResizeMode(PlaceColumn, QHeaderView::ResizeToContents);
  header->setSectionResizeMode(FixColumn, QHeaderView::ResizeToContents);
  table_->setWordWrap(true);
  table_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);  // Row heights differ.
  connect(header, &QHeaderView::sectionResized, this, [this] { fit_.start(); });
  fit_.setSingleShot(true);
  fit_.setInterval(0);
  connect(&fit_, &QTimer::timeout, this,
          [this] { fitRowHeights(*table_, SentenceColumn, kSentenceMargin); });
}

/// Most severe problems first, then the row with the number of hints, then the hints.
const base::Diagnostic* IssuesPanel::issueAt(int row) const {
  if (row == count()) {
    return nullptr;
  }
  return &issues_[static_cast<std::size_t>(row > count() ? row - 1 : row)];
}

QString IssuesPanel::fixAt(int row) const {
  const base::Diagnostic* issue = issueAt(row);
  return issue == nullptr ? QString() : fixes_[static_cast<std::size_t>(issue - issues_.data())];
}

bool IssuesPanel::isLink(const QModelIndex& index) const {
  return index.column() == FixColumn && !fixAt(index.row()).isEmpty();
}

void IssuesPanel::setHintsOpen(bool open) {
  areHintsOpen_ = open;
  rebuild();
  table_->setCurrentIndex(table_->model()->index(count(), SentenceColumn));
}

void IssuesPanel::fillFold(int row) {
  const QString icon =
      areHintsOpen_ ? QStringLiteral("chevron-down") : QStringLiteral("chevron-right");
  auto* fold = new QTableWidgetItem(
      tintedIcon(icon, theme_.color(Role::TextSecondary)),
      counted(issues_.size() - static_cast<std::size_t>(count()), tr("hint"), tr("hints")));
  fold->setToolTip(tr("Information: click to show or hide"));
  fold->setForeground(theme_.color(Role::TextSecondary));
  table_->setItem(row, SentenceColumn, fold);
  table_->setSpan(row, SentenceColumn, 1, IssueColumns);
}

void IssuesPanel::goToIssue(const base::Diagnostic& issue) {
  if (issue.entity && document_.contains(issue.entity)) {
    document_.setSelection({issue.entity});
    Q_EMIT entityRequested(issue.entity);
    if (base::startsWith(issue.code, "tree.")) {
      Q_EMIT treeIssueRequested(issue);
    }
  } else if (!issue.file.empty()) {
    Q_EMIT fileRequested(QString::fromStdString(issue.file), issue.line);
  }
}

void IssuesPanel::applyFix(const base::Diagnostic& issue) {
  const std::optional<Fix> fix = fixFor(document_, issue);
  if (!fix) {
    return;
  }
  if (document_.contains(issue.entity)) {
    document_.setSelection({issue.entity});
  }
  if (!fix->apply) {
    Q_EMIT goalsRequested();
    return;
  }
  fix->apply(document_);
  document_.checkSoon();
}

void IssuesPanel::offerMenu(const QPoint& at) {
  const QModelIndex index = table_->indexAt(at);
  if (!index.isValid() || issueAt(index.row()) == nullptr) {
    return;
  }
  const base::Diagnostic issue = *issueAt(index.row());
  const QString label = fixAt(index.row());
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Show"), this, [this, issue] { goToIssue(issue); });
  if (!label.isEmpty()) {
    menu->addAction(label, this, [this, issue] { applyFix(issue); });
  }
  const std::optional<Fix> fix = fixFor(document_, issue);
  const auto alike = std::count(fixes_.begin(), fixes_.end(), label);
  if (fix && fix->apply && alike > 1) {
    menu->addAction(tr("%1: all %2").arg(label).arg(alike), this, [this, label] {
      applyToAll(document_, base::Diagnostics(issues_), label);
      document_.checkSoon();
    });
  }
  menu->addSeparator();
  menu->addAction(tr("Copy text"), this, [issue] {
    QGuiApplication::clipboard()->setText(QString::fromStdString(issue.text()));
  });
  addTableActions(*menu, *table_, tr("Issues"));
  menu->popup(table_->viewport()->mapToGlobal(at));
}

void IssuesPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  icons_ = {tintedIcon(QStringLiteral("info"), theme.color(Role::TextSecondary)),
            tintedIcon(QStringLiteral("warning"), theme.color(Role::WarningMark)),
            tintedIcon(QStringLiteral("error"), theme.color(Role::Error))};
  rebuild();
}

void IssuesPanel::setActionIssues(const base::Diagnostics& issues) {
  action_ = issues;
  rebuild();
}

void IssuesPanel::setRecorded(bool recorded) {
  if (std::exchange(isRecorded_, recorded) != recorded) {
    rebuild();
  }
}

/// The issues of the document and of the last action, the most severe first.
base::Diagnostics IssuesPanel::currentIssues() {
  base::Diagnostics all = isRecorded_ ? base::Diagnostics() : document_.issues();
  if (document_.path().isEmpty()) {  // A new scenario begins without people: that is no problem.
    all.erase(std::remove_if(all.begin(), all.end(),
                             [](const auto& each) { return each.code == "scenario.nobody"; }),
              all.end());
  }
  if (!isRecorded_) {
    base::append(all, adviceFor(document_.scenario()));
  }
  base::Diagnostics known = action_;
  base::append(known, all);
  action_ = app::withoutDuplicates(action_, known);  // A fixed problem must not reappear.
  all.insert(all.begin(), action_.begin(), action_.end());
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return static_cast<int>(a.severity) > static_cast<int>(b.severity);
  });
  return withoutRepeatedIssues(all);
}

QString IssuesPanel::noIssuesText() const {
  if (isRecorded_) {
    return tr("No issues. A recorded run is shown.");
  }
  const sim2d::Scenario& scenario = document_.scenario();
  if (scenario.humans.empty()) {
    return tr("No issues. Press P and click on the map to place a person.");
  }
  QStringList counts{counted(scenario.humans.size(), tr("person"), tr("people")),
                     counted(scenario.goals.size(), tr("goal"), tr("goals"))};
  if (!scenario.robots.empty()) {
    counts << counted(scenario.robots.size(), tr("robot"), tr("robots"));
  }
  return tr("No issues: %1.").arg(counts.join(QStringLiteral(", ")));
}

void IssuesPanel::rebuild() {
  issues_ = currentIssues();
  noIssuesLabel_->setText(noIssuesText());
  fixes_.clear();
  table_->clearSpans();
  table_->setRowCount(0);  // Clears the selection.
  const int serious = count(), total = static_cast<int>(issues_.size());
  const bool areHints = total > serious;
  table_->setRowCount(areHintsOpen_ && areHints ? total + 1 : serious + (areHints ? 1 : 0));
  for (const base::Diagnostic& issue : issues_) {
    const std::optional<Fix> fix = fixFor(document_, issue);
    fixes_.push_back(fix ? fix->label : QString());
    const int place = static_cast<int>(fixes_.size()) - 1;
    if (place < serious || areHintsOpen_) {
      fillRow(place < serious ? place : place + 1, issue, fixes_.back());
    }
  }
  if (areHints) {
    fillFold(serious);
  }
  fit_.start();
  stack_->setCurrentIndex(issues_.empty() ? 0 : 1);
  Q_EMIT countChanged(count());
}

void IssuesPanel::fillRow(int row, const base::Diagnostic& issue, const QString& fix) {
  const QString text = QString::fromStdString(issue.text());
  const QString place = placeOf(issue, QFileInfo(document_.path()).fileName());
  auto* sentence = new QTableWidgetItem(icons_.at(static_cast<std::size_t>(issue.severity)),
                                        issueSentence(issue));
  sentence->setToolTip(text);
  table_->setItem(row, SentenceColumn, sentence);
  const auto addRight = [&](int column, const QString& label, bool link) {
    auto* item = new QTableWidgetItem(label);
    item->setToolTip(link ? label : text);
    item->setForeground(theme_.color(link ? Role::AccentText : Role::TextSecondary));
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table_->setItem(row, column, item);
  };
  addRight(PlaceColumn, fix.isEmpty() ? QString() : place, false);
  addRight(FixColumn, fix.isEmpty() ? place : fix, !fix.isEmpty());
  const int span = 3 - (fix.isEmpty() ? 0 : 1) - (place.isEmpty() ? 0 : 1);
  if (span > 1) {
    table_->setSpan(row, SentenceColumn, 1, span);
  }
}

int IssuesPanel::count() const {
  return static_cast<int>(std::count_if(
      issues_.begin(), issues_.end(),
      [](const base::Diagnostic& issue) { return issue.severity != base::Severity::Info; }));
}

bool IssuesPanel::hasErrors() const {
  return base::hasErrors(issues_);
}

void addIssuesPanel(PanelRegistry& to) {
  to.add(closedBottomPanel(50, QObject::tr("Issues"), true), [](PanelContext& context) {
    auto* panel = new IssuesPanel(context.document, context.theme());
    QObject::connect(&context, &PanelContext::themeChanged, panel, &IssuesPanel::setTheme);
    QObject::connect(panel, &IssuesPanel::countChanged, &context, [&context, panel](int count) {
      const auto worst = panel->hasErrors() ? base::Severity::Error : base::Severity::Warning;
      Q_EMIT context.counted(panel, count, worst);
    });
    QObject::connect(panel, &IssuesPanel::entityRequested, &context.view, &MapView::centerOnEntity);
    QObject::connect(panel, &IssuesPanel::treeIssueRequested, &context,
                     &PanelContext::treeIssueRequested);
    QObject::connect(panel, &IssuesPanel::fileRequested, &context, &PanelContext::fileRequested);
    QObject::connect(panel, &IssuesPanel::goalsRequested, &context, &PanelContext::goalsRequested);
    QObject::connect(&context, &PanelContext::problemsFound, panel, &IssuesPanel::setActionIssues);
    return panel;
  });
}

namespace {

constexpr int kLongest = 4 * 1024 * 1024;  // [bytes]

/// A text widget with line numbers in a margin at the left.
class NumberedText : public QPlainTextEdit {
 public:
  explicit NumberedText(QWidget* parent) : QPlainTextEdit(parent), margin_(new Margin(*this)) {
    connect(this, &QPlainTextEdit::updateRequest, margin_, qOverload<>(&QWidget::update));
    connect(this, &QPlainTextEdit::blockCountChanged, this, [this] { makeRoom(); });
    makeRoom();
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QPlainTextEdit::resizeEvent(event);
    const QRect inside = contentsRect();
    margin_->setGeometry(inside.left(), inside.top(), room(), inside.height());
  }

 private:
  class Margin : public QWidget {
   public:
    explicit Margin(NumberedText& text) : QWidget(&text), text_(text) {}

   protected:
    void paintEvent(QPaintEvent*) override {
      QPainter painter(this);
      painter.setPen(palette().color(QPalette::PlaceholderText));
      painter.setFont(text_.font());
      QTextBlock block = text_.firstVisibleBlock();
      qreal top = text_.blockBoundingGeometry(block).translated(text_.contentOffset()).top();
      while (block.isValid() && top <= rect().bottom()) {
        const qreal height = text_.blockBoundingRect(block).height();
        painter.drawText(QRectF(0, top, width() - 8, height), Qt::AlignRight | Qt::AlignVCenter,
                         QString::number(block.blockNumber() + 1));
        block = block.next();
        top += height;
      }
    }

   private:
    NumberedText& text_;
  };

  int room() const {
    const int digits = std::max(3, static_cast<int>(QString::number(blockCount()).size()));
    return digits * fontMetrics().horizontalAdvance(QLatin1Char('9')) + 20;
  }
  void makeRoom() { setViewportMargins(room(), 0, 0, 0); }
  Margin* margin_;
};

}  // namespace

TextViewer::TextViewer(const Theme& theme, QWidget* parent)
    : QDialog(parent), theme_(theme), text_(new NumberedText(this)) {
  resize(720, limitedToScreen(*this, 520));
  text_->setReadOnly(true);
  text_->setLineWrapMode(QPlainTextEdit::NoWrap);
  QFont fixed(QStringLiteral("monospace"));
  fixed.setStyleHint(QFont::TypeWriter);
  fixed.setPointSizeF(theme.font().pointSizeF());
  text_->setFont(fixed);
  text_->setAccessibleName(tr("Text of the file"));
  place_->setTextFormat(Qt::PlainText);
  place_->setForegroundRole(QPalette::PlaceholderText);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  QPushButton* outside = buttons->addButton(tr("Open with…"), QDialogButtonBox::ActionRole);
  outside->setAutoDefault(false);
  buttons->button(QDialogButtonBox::Close)->setDefault(true);
  outside->setToolTip(tr("Open the file with the default application"));
  connect(outside, &QPushButton::clicked, this, &TextViewer::openOutside);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout =
      configuredLayout(new QVBoxLayout(this), {16, 16, 16, 16}, 8, {place_, text_, buttons});
  layout->setStretchFactor(text_, 1);
}

void TextViewer::setTheme(const Theme& theme) {
  theme_ = theme;
  markLine();
}

QString TextViewer::showFile(const QString& path, int line) {
  const base::Result<std::string> read = base::readTextFile(path.toStdString());
  if (!read) {
    return QString::fromStdString(read.diagnostics().front().text());
  }
  if (read->size() > static_cast<std::size_t>(kLongest)) {
    return tr("%1 is too long to display").arg(path);
  }
  path_ = path;
  line_ = line;
  text_->setPlainText(QString::fromStdString(*read));
  setWindowTitle(QFileInfo(path).fileName());
  place_->setText(line > 0 ? tr("%1, line %2").arg(path).arg(line) : path);
  show();
  raise();
  markLine();
  return {};
}

void TextViewer::openOutside() {
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(path_))) {
    place_->setText(tr("No application is available to open %1").arg(path_));
  }
}

void markLine(QPlainTextEdit& text, int line, const Theme& theme) {
  const QTextBlock block = text.document()->findBlockByNumber(std::max(line - 1, 0));
  QList<QTextEdit::ExtraSelection> marks;
  if (line > 0 && block.isValid()) {
    QTextEdit::ExtraSelection mark;
    mark.format.setBackground(theme.color(Role::RowSelected));
    mark.format.setProperty(QTextFormat::FullWidthSelection, true);
    mark.cursor = QTextCursor(block);
    marks.push_back(mark);
  }
  text.setExtraSelections(marks);
}

void TextViewer::markLine() {
  editor::markLine(*text_, line_, theme_);
  const QTextBlock block = text_->document()->findBlockByNumber(std::max(line_ - 1, 0));
  text_->setTextCursor(QTextCursor(block.isValid() ? block : text_->document()->firstBlock()));
  text_->centerCursor();
}

}  // namespace editor
