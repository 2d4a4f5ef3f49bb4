#include "editor/panels/IssuesPanel.h"

#include <algorithm>

#include <QAbstractTableModel>
#include <QFileInfo>
#include <QHeaderView>

#include "editor/look/Icons.h"
#include "editor/panels/Form.h"

namespace editor {

/// Columns: sentence with the icon of its severity, place.
class IssuesModel : public QAbstractTableModel {
 public:
  using QAbstractTableModel::QAbstractTableModel;

  void set(base::Diagnostics issues) {
    beginResetModel();
    issues_ = std::move(issues);
    std::stable_sort(issues_.begin(), issues_.end(), [](const auto& a, const auto& b) {
      return static_cast<int>(a.severity) > static_cast<int>(b.severity);
    });
    endResetModel();
  }
  void setTheme(const Theme& theme) {
    icons_ = {tintedIcon(QStringLiteral("info"), theme.color(Role::TextSecondary)),
              tintedIcon(QStringLiteral("warning"), theme.color(Role::WarningMark)),
              tintedIcon(QStringLiteral("error"), theme.color(Role::Error))};
    pale_ = theme.color(Role::TextSecondary);
  }
  const base::Diagnostics& issues() const { return issues_; }
  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(issues_.size());
  }
  int columnCount(const QModelIndex& = {}) const override { return 2; }
  QVariant data(const QModelIndex& index, int role) const override {
    if (!index.isValid()) {
      return {};
    }
    const base::Diagnostic& issue = issues_[static_cast<std::size_t>(index.row())];
    switch (role) {
      case Qt::DisplayRole:
        return index.column() == 0 ? sentence(issue) : place(issue);
      case Qt::ToolTipRole:
        return QString::fromStdString(issue.text());
      case Qt::DecorationRole:
        return index.column() == 0 ? icons_.at(static_cast<std::size_t>(issue.severity))
                                   : QVariant();
      case Qt::ForegroundRole:
        return index.column() == 1 ? pale_ : QVariant();
      case Qt::TextAlignmentRole:
        return static_cast<int>((index.column() == 1 ? Qt::AlignRight : Qt::AlignLeft) |
                                Qt::AlignVCenter);
      default:
        return {};
    }
  }

 private:
  static QString sentence(const base::Diagnostic& issue) {
    QString text = QString::fromStdString(issue.message);
    if (!text.isEmpty()) {
      text[0] = text[0].toUpper();
    }
    return text;
  }
  static QString place(const base::Diagnostic& issue) {
    QString text = QFileInfo(QString::fromStdString(issue.file)).fileName();
    if (issue.line > 0) {
      text += QStringLiteral(":%1").arg(issue.line);
    }
    return text;
  }

  base::Diagnostics issues_;
  std::array<QIcon, 3> icons_;
  QColor pale_;
};

IssuesPanel::IssuesPanel(ScenarioDocument& document, const Theme& theme, QWidget* parent)
    : QWidget(parent),
      document_(document),
      theme_(theme),
      model_(new IssuesModel(this)),
      stack_(new QStackedLayout(this)),
      table_(new QTableView(this)),
      calm_(emptyState(tr("Everything is in order."), this)) {
  table_->setModel(model_);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setShowGrid(false);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->horizontalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(24);
  table_->viewport()->setAutoFillBackground(false);
  table_->setAccessibleName(tr("Issues"));
  stack_->addWidget(calm_);
  stack_->addWidget(table_);
  const auto jump = [this](const QModelIndex& index) {
    const base::Diagnostic issue = model_->issues()[static_cast<std::size_t>(index.row())];
    if (issue.entity && document_.contains(issue.entity)) {
      document_.setSelection({issue.entity});
      Q_EMIT entityWanted(issue.entity);
    } else if (!issue.file.empty()) {
      Q_EMIT fileWanted(QString::fromStdString(issue.file), issue.line);
    }
  };
  connect(table_, &QTableView::clicked, this, jump);
  connect(table_, &QTableView::activated, this, jump);
  connect(&document_, &ScenarioDocument::issuesChanged, this, &IssuesPanel::rebuild);
  connect(&document_, &ScenarioDocument::pathChanged, this, &IssuesPanel::rebuild);
  setTheme(theme);
}

void IssuesPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  model_->setTheme(theme);
  rebuild();
}

void IssuesPanel::setActionIssues(const base::Diagnostics& issues) {
  action_ = issues;
  rebuild();
}

void IssuesPanel::rebuild() {
  base::Diagnostics all = action_;
  for (const base::Diagnostic& issue : document_.issues()) {
    const bool said = std::any_of(all.begin(), all.end(), [&](const base::Diagnostic& other) {
      return other.text() == issue.text();
    });
    if (!said) {
      all.push_back(issue);
    }
  }
  const sim2d::Scenario& scenario = document_.scenario();
  calm_->setText(scenario.humans.empty() ? tr("Nothing to complain about.")
                                         : tr("Everything is in order: %1 people, %2 goals.")
                                               .arg(scenario.humans.size())
                                               .arg(scenario.goals.size()));
  model_->set(std::move(all));
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

}  // namespace editor
