#include "editor/panels/IssuesPanel.h"

#include <algorithm>
#include <set>

#include <QAbstractTableModel>
#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHeaderView>
#include <QMenu>

#include "editor/document/Fixes.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

namespace {

constexpr int kSentenceMargin = 52;  // icon and what keeps it off the text and the edges [px]

}  // namespace

QString issueSentence(const base::Diagnostic& issue) {
  QString text = QString::fromStdString(issue.message);
  const EntityKind about = issue.entity.kind;
  const bool isNamed =
      about != EntityKind::None && about != EntityKind::Scenario && about != EntityKind::Goal;
  // "agents.anna.id: is missing", "max_vel …", "Goal" are left; "no tree file …" is a sentence.
  const QString first = text.section(QLatin1Char(' '), 0, 0);
  const bool isWord =
      std::all_of(first.begin(), first.end(), [](QChar each) { return each.isLower(); });
  if (!isNamed && !first.isEmpty() && isWord) {
    text[0] = text[0].toUpper();
  }
  return text;
}

/// Columns: sentence with the icon of its severity, place, what mends it. Where nothing does, the
/// place stands at the end, and the sentence has the room of both.
class IssuesModel : public QAbstractTableModel {
 public:
  enum Column { SentenceColumn, PlaceColumn, FixColumn, ColumnCount };
  explicit IssuesModel(QObject* parent) : QAbstractTableModel(parent) {}

  void set(base::Diagnostics issues, const ScenarioDocument& document) {
    beginResetModel();
    ownFile_ = QFileInfo(document.path()).fileName();
    issues_ = std::move(issues);
    std::stable_sort(issues_.begin(), issues_.end(), [](const auto& a, const auto& b) {
      return static_cast<int>(a.severity) > static_cast<int>(b.severity);
    });
    fixes_.clear();
    for (const base::Diagnostic& issue : issues_) {
      const std::optional<Fix> fix = fixFor(document, issue);
      fixes_.push_back(fix ? fix->words : QString());
    }
    endResetModel();
  }
  void setTheme(const Theme& theme) {
    icons_ = {tintedIcon(QStringLiteral("info"), theme.color(Role::TextSecondary)),
              tintedIcon(QStringLiteral("warning"), theme.color(Role::WarningMark)),
              tintedIcon(QStringLiteral("error"), theme.color(Role::Error))};
    pale_ = theme.color(Role::TextSecondary);
    link_ = theme.color(Role::AccentText);
  }
  const base::Diagnostics& issues() const { return issues_; }
  const base::Diagnostic& issue(int row) const { return issues_[static_cast<std::size_t>(row)]; }
  const QString& fixWords(int row) const { return fixes_[static_cast<std::size_t>(row)]; }
  bool hasFix(int row) const { return !fixWords(row).isEmpty(); }
  bool isLink(const QModelIndex& index) const {
    return index.column() == FixColumn && hasFix(index.row());
  }
  /// Columns that the sentence of a row covers.
  int sentenceSpan(int row) const {
    const bool hasPlace = !place(issue(row)).isEmpty();
    return 3 - (hasFix(row) ? 1 : 0) - (hasPlace ? 1 : 0);
  }
  int countOf(const QString& words) const {
    return static_cast<int>(std::count(fixes_.begin(), fixes_.end(), words));
  }
  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(issues_.size());
  }
  int columnCount(const QModelIndex& = {}) const override { return ColumnCount; }
  QVariant data(const QModelIndex& index, int role) const override {
    if (!index.isValid()) {
      return {};
    }
    const base::Diagnostic& issue = this->issue(index.row());
    switch (role) {
      case Qt::DisplayRole:
        return index.column() == SentenceColumn ? issueSentence(issue)
               : index.column() == PlaceColumn  ? (hasFix(index.row()) ? place(issue) : QString())
               : hasFix(index.row())            ? fixWords(index.row())
                                                : place(issue);
      case Qt::ToolTipRole:
        return isLink(index) ? fixWords(index.row()) : QString::fromStdString(issue.text());
      case Qt::DecorationRole:
        return index.column() == SentenceColumn
                   ? icons_.at(static_cast<std::size_t>(issue.severity))
                   : QVariant();
      case Qt::ForegroundRole:
        return index.column() == SentenceColumn ? QVariant() : isLink(index) ? link_ : pale_;
      case Qt::TextAlignmentRole:
        return static_cast<int>(
            (index.column() == SentenceColumn ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      default:
        return {};
    }
  }

 private:
  /// What is about a thing of the document needs no file name.
  QString place(const base::Diagnostic& issue) const {
    if (issue.entity && issue.line == 0) {
      return {};
    }
    QString text = QFileInfo(QString::fromStdString(issue.file)).fileName();
    if (issue.line > 0 && text == ownFile_) {
      return tr("line %1").arg(issue.line);  // the sentences need the room
    }
    if (issue.line > 0) {
      text += QStringLiteral(":%1").arg(issue.line);
    }
    return text;
  }

  QString ownFile_;
  base::Diagnostics issues_;
  std::vector<QString> fixes_;
  std::array<QIcon, 3> icons_;
  QColor pale_, link_;
};

IssuesPanel::IssuesPanel(ScenarioDocument& document, const Theme& theme, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new IssuesModel(this)),
      stack_(new QStackedLayout(this)),
      table_(new QTableView(this)),
      calm_(emptyState(tr("Everything is in order."), this)) {
  makeTable();
  stack_->addWidget(calm_);
  stack_->addWidget(table_);
  connect(table_, &QTableView::clicked, this, [this](const QModelIndex& index) {
    const base::Diagnostic issue = model_->issue(index.row());
    model_->isLink(index) ? mend(issue) : jump(issue);
  });
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    if (!model_->isLink(index)) {
      jump(base::Diagnostic(model_->issue(index.row())));
    }
  });
  connect(table_, &QTableView::entered, this, [this](const QModelIndex& index) {
    table_->viewport()->setCursor(model_->isLink(index) ? Qt::PointingHandCursor : Qt::ArrowCursor);
  });
  connect(table_, &QTableView::customContextMenuRequested, this, &IssuesPanel::offerMenu);
  connect(&document_, &ScenarioDocument::issuesChanged, this, &IssuesPanel::rebuild);
  connect(&document_, &ScenarioDocument::pathChanged, this, &IssuesPanel::rebuild);
  setTheme(theme);
}

void IssuesPanel::makeTable() {
  styleTable(*table_, *model_, tr("Issues"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  table_->setMouseTracking(true);
  QHeaderView* header = table_->horizontalHeader();
  header->hide();
  header->setSectionResizeMode(IssuesModel::SentenceColumn, QHeaderView::Stretch);
  header->setSectionResizeMode(IssuesModel::PlaceColumn, QHeaderView::ResizeToContents);
  header->setSectionResizeMode(IssuesModel::FixColumn, QHeaderView::ResizeToContents);
  table_->setWordWrap(true);
  table_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);  // rows differ in height
  connect(header, &QHeaderView::sectionResized, this, [this] { fit_.start(); });
  fit_.setSingleShot(true);
  fit_.setInterval(0);
  connect(&fit_, &QTimer::timeout, this,
          [this] { fitRowHeights(*table_, IssuesModel::SentenceColumn, kSentenceMargin); });
}

void IssuesPanel::jump(const base::Diagnostic& issue) {
  if (issue.entity && document_.contains(issue.entity)) {
    document_.setSelection({issue.entity});
    Q_EMIT entityWanted(issue.entity);
  } else if (!issue.file.empty()) {
    Q_EMIT fileWanted(QString::fromStdString(issue.file), issue.line);
  }
}

void IssuesPanel::mend(const base::Diagnostic& issue) {
  const std::optional<Fix> fix = fixFor(document_, issue);
  if (!fix) {
    return;
  }
  if (document_.contains(issue.entity)) {
    document_.setSelection({issue.entity});
  }
  if (fix->asksForGoals) {
    Q_EMIT goalsWanted();
    return;
  }
  fix->apply(document_);
  document_.checkSoon();
}

void IssuesPanel::offerMenu(const QPoint& at) {
  const QModelIndex index = table_->indexAt(at);
  if (!index.isValid()) {
    return;
  }
  const base::Diagnostic issue = model_->issue(index.row());
  const QString words = model_->fixWords(index.row());
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Show"), this, [this, issue] { jump(issue); });
  if (!words.isEmpty()) {
    menu->addAction(words, this, [this, issue] { mend(issue); });
  }
  const std::optional<Fix> fix = fixFor(document_, issue);
  if (fix && fix->apply && model_->countOf(words) > 1) {
    menu->addAction(tr("%1: all %2").arg(words).arg(model_->countOf(words)), this, [this, words] {
      applyToAll(document_, base::Diagnostics(model_->issues()), words);
      document_.checkSoon();
    });
  }
  menu->addSeparator();
  menu->addAction(tr("Copy the text"), this, [issue] {
    QGuiApplication::clipboard()->setText(QString::fromStdString(issue.text()));
  });
  menu->popup(table_->viewport()->mapToGlobal(at));
}

void IssuesPanel::setTheme(const Theme& theme) {
  model_->setTheme(theme);
  rebuild();
}

void IssuesPanel::setActionIssues(const base::Diagnostics& issues) {
  action_ = issues;
  rebuild();
}

void IssuesPanel::rebuild() {
  base::Diagnostics all = action_;
  base::Diagnostics live = document_.issues();
  base::append(live, adviceFor(document_.scenario()));
  std::set<std::string> said;
  for (const base::Diagnostic& issue : all) {
    said.insert(issue.text());
  }
  for (const base::Diagnostic& issue : live) {
    if (said.insert(issue.text()).second) {
      all.push_back(issue);
    }
  }
  const sim2d::Scenario& scenario = document_.scenario();
  calm_->setText(scenario.humans.empty()
                     ? tr("Nothing to complain about.")
                     : tr("Everything is in order: %1, %2.")
                           .arg(counted(scenario.humans.size(), tr("person"), tr("people")),
                                counted(scenario.goals.size(), tr("goal"), tr("goals"))));
  model_->set(std::move(all), document_);
  table_->clearSpans();
  for (int row = 0; row < model_->rowCount(); ++row) {
    if (const int span = model_->sentenceSpan(row); span > 1) {
      table_->setSpan(row, IssuesModel::SentenceColumn, 1, span);
    }
  }
  fit_.start();
  stack_->setCurrentIndex(model_->rowCount() > 0 ? 1 : 0);
  Q_EMIT countChanged(count());
}

int IssuesPanel::count() const {
  return static_cast<int>(std::count_if(
      model_->issues().begin(), model_->issues().end(),
      [](const base::Diagnostic& issue) { return issue.severity != base::Severity::Info; }));
}

bool IssuesPanel::hasErrors() const {
  return base::hasErrors(model_->issues());
}

void addIssuesPanel(PanelRegistry& to) {
  to.add({50, QObject::tr("Issues"), Qt::BottomDockWidgetArea}, [](PanelContext& context) {
    auto* panel = new IssuesPanel(context.document, context.theme());
    QObject::connect(&context, &PanelContext::themeChanged, panel, &IssuesPanel::setTheme);
    QObject::connect(panel, &IssuesPanel::countChanged, &context,
                     [&context, panel](int count) { Q_EMIT context.counted(panel, count); });
    QObject::connect(panel, &IssuesPanel::entityWanted, &context.view, &MapView::centerOnEntity);
    QObject::connect(panel, &IssuesPanel::fileWanted, &context, &PanelContext::fileWanted);
    QObject::connect(panel, &IssuesPanel::goalsWanted, &context, &PanelContext::goalsWanted);
    QObject::connect(&context, &PanelContext::problemsFound, panel, &IssuesPanel::setActionIssues);
    return panel;
  });
}

}  // namespace editor
