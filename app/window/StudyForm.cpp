#include "app/window/StudyForm.h"

#include <algorithm>

#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QMimeData>
#include <QShortcut>

#include "app/run/DataPaths.h"
#include "app/run/ProgramRegistries.h"
#include "app/window/FileDialogs.h"
#include "editor/look/Fields.h"
#include "editor/look/FileDialog.h"
#include "editor/look/Form.h"
#include "editor/panels/RowDelegate.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlText.h"
#include "sim2d/world/Registries.h"

namespace app {

namespace {

constexpr int kMostScenarioRows = 6;  // seen at once
constexpr int kPlannerWidth = 118;
constexpr int kValueLines = 2;

QString quoted(const QString& text) {
  return QString::fromStdString(base::quotedText(text.toStdString()));
}

/// Nothing to compare by its name alone: it wants a program, a file or a hand.
bool needsMore(const QString& planner) {
  static const QStringList kAll = {QStringLiteral("external"), QStringLiteral("library"),
                                   QStringLiteral("replay"), QStringLiteral("teleop"),
                                   QStringLiteral("ros2")};
  return kAll.contains(planner);
}

/// "1, 2, 3 …" to the count alone, else as a list.
QString seedsText(const std::vector<long long>& seeds) {
  bool isCount = true;
  QStringList all;
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    isCount = isCount && seeds[k] == static_cast<long long>(k) + 1;
    all.append(QString::number(seeds[k]));
  }
  return isCount ? QString::number(seeds.size())
                 : QLatin1Char('[') + all.join(QStringLiteral(", ")) + QLatin1Char(']');
}

/// As high as its rows at its width: none of them is out of sight.
class TallList : public QListWidget {
 public:
  using QListWidget::QListWidget;

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QListWidget::resizeEvent(event);
    fit();
  }
  void rowsInserted(const QModelIndex& parent, int start, int end) override {
    QListWidget::rowsInserted(parent, start, end);
    fit();
  }

 private:
  void fit() {
    const int columns = std::max(1, viewport()->width() / kPlannerWidth);
    setFixedHeight((count() + columns - 1) / columns * editor::kListRowHeight);
  }
};

}  // namespace

StudyForm::StudyForm(editor::PanelContext& context)
    : context_(context),
      scenarios_(new QListWidget(this)),
      none_(new QLabel(tr("None yet: add them, or drop files here"), this)),
      planners_(new TallList(this)),
      seeds_(new QLineEdit(QStringLiteral("30"), this)),
      duration_(new QLineEdit(this)),
      record_(new editor::ChoiceField(this)),
      values_(new QPlainTextEdit(this)) {
  auto* rows = editor::arranged(new QVBoxLayout(this), {12, 6, 12, 6}, 6);
  rows->addWidget(makeScenarios());
  rows->addWidget(makePlanners());
  rows->addLayout(makeNumbers());
  rows->addWidget(editor::secondaryLabel(tr("Other values, one path a line"), this));
  styleValues();
  rows->addWidget(values_);
  rows->addStretch();
  setAcceptDrops(true);
  const auto tell = [this] {
    if (!showing_) {
      Q_EMIT changed();
    }
  };
  connect(planners_, &QListWidget::itemChanged, this, tell);
  connect(values_, &QPlainTextEdit::textChanged, this, tell);
  connect(seeds_, &QLineEdit::textChanged, this, tell);
  connect(duration_, &QLineEdit::textChanged, this, tell);
  connect(record_, qOverload<int>(&QComboBox::currentIndexChanged), this, tell);
}

QLayout* StudyForm::makeNumbers() {
  seeds_->setAccessibleName(tr("Seeds"));
  seeds_->setToolTip(tr("How many, or which: 30, or [3, 7, 11]"));
  duration_->setAccessibleName(tr("Duration"));
  duration_->setPlaceholderText(tr("of each scenario"));
  duration_->setToolTip(tr("Of each run at most [s]; empty: what the scenario says"));
  record_->addItems({tr("metrics alone"), tr("runs with an error"), tr("failures, to be played"),
                     tr("all runs")});
  record_->setCurrentIndex(static_cast<int>(Experiment::Record::Unsuccessful));
  record_->setAccessibleName(tr("Keep"));
  record_->setToolTip(
      tr("Files of which runs stay in the folder of the results. Failures are runs with an error "
         "and those whose robot did not succeed."));
  auto* both = editor::arranged(new QHBoxLayout, {}, 8);
  both->addWidget(seeds_, 2);
  both->addWidget(new QLabel(tr("Duration"), this));
  both->addWidget(duration_, 3);
  QFormLayout* form = formRows();
  form->addRow(tr("Seeds"), both);
  form->addRow(tr("Keep"), record_);
  return form;
}

void StudyForm::styleValues() {
  values_->setPlaceholderText(
      QStringLiteral("\"*.max_vel\": {normal: [1.2, 0.2, 0.6, 1.8]}\nrobot1.max_vel: [0.5, 1.0]"));
  values_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  values_->setLineWrapMode(QPlainTextEdit::NoWrap);
  values_->setTabChangesFocus(true);
  values_->setFixedHeight(kValueLines * values_->fontMetrics().lineSpacing() + 16);
  values_->setAccessibleName(tr("Other values"));
  values_->setToolTip(
      tr("A list: each of them. {normal: [mean, deviation, least, most]}, "
         "{uniform: [from, to]}, {choice: […]}: drawn for each seed, the same "
         "for all planners."));
}

QWidget* StudyForm::makeScenarios() {
  auto* part = new QWidget(this);
  auto* rows = editor::arranged(new QVBoxLayout(part), {}, 4);
  auto* head = editor::arranged(new QHBoxLayout, {}, 12);
  head->addWidget(editor::secondaryLabel(tr("Scenarios"), part), 1);
  addThis_ = editor::linkButton(tr("Add this one"), tr("The scenario that is open"), part,
                                [this] { addScenario(context_.document.path()); });
  head->addWidget(addThis_);
  head->addWidget(
      editor::linkButton(tr("Add…"), tr("Scenario files"), part, [this] { askScenarios(); }));
  rows->addLayout(head);
  editor::styleList(*scenarios_, tr("Scenarios"));
  scenarios_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  scenarios_->setToolTip(tr("Delete takes out what is selected"));
  rows->addWidget(scenarios_);
  none_->setFixedHeight(editor::kListRowHeight);
  rows->addWidget(none_);
  auto* remove =
      new QShortcut(QKeySequence::Delete, scenarios_, nullptr, nullptr, Qt::WidgetShortcut);
  connect(remove, &QShortcut::activated, this, [this] {
    qDeleteAll(scenarios_->selectedItems());
    fitScenarios();
    Q_EMIT changed();
  });
  fitScenarios();
  const auto follow = [this] {
    addThis_->setEnabled(!context_.document.path().isEmpty());
    addThis_->setToolTip(addThis_->isEnabled() ? tr("The scenario that is open")
                                               : tr("Save the scenario first"));
  };
  connect(&context_.document, &editor::ScenarioDocument::pathChanged, this, follow);
  follow();
  return part;
}

QWidget* StudyForm::makePlanners() {
  auto* part = new QWidget(this);
  auto* rows = editor::arranged(new QVBoxLayout(part), {}, 4);
  rows->addWidget(editor::secondaryLabel(tr("Planners, side by side"), part));
  editor::styleList(*planners_, tr("Planners"));
  const sim2d::Registries registries = programRegistries();
  for (const auto& planner : registries.planners.entries()) {
    const QString name = QString::fromStdString(planner.name);
    if (needsMore(name)) {
      continue;
    }
    addPlanner(name, QString::fromStdString(planner.help));
  }
  planners_->setFlow(QListView::LeftToRight);
  planners_->setWrapping(true);
  planners_->setGridSize({kPlannerWidth, editor::kListRowHeight});
  planners_->setResizeMode(QListView::Adjust);  // in as many columns as there is room for
  planners_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  rows->addWidget(planners_);
  return part;
}

void StudyForm::addPlanner(const QString& name, const QString& help) {
  auto* item = new QListWidgetItem(name, planners_);
  item->setToolTip(help);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
  item->setSizeHint({kPlannerWidth, editor::kListRowHeight});
  item->setCheckState(Qt::Unchecked);
}

void StudyForm::addItem(const QString& shown, const QString& path) {
  auto* item = new QListWidgetItem(shown, scenarios_);
  item->setData(Qt::UserRole, path);
  item->setToolTip(path);
  fitScenarios();
}

void StudyForm::fitScenarios() {
  const int rows = std::clamp(scenarios_->count(), 1, kMostScenarioRows);
  scenarios_->setFixedHeight(rows * editor::kListRowHeight);
  none_->setVisible(scenarios_->count() == 0);
  scenarios_->setVisible(scenarios_->count() > 0);
}

void StudyForm::addScenario(const QString& path) {
  if (!path.isEmpty() && !scenarios().contains(path)) {
    addItem(QFileInfo(path).completeBaseName(), path);
    if (!showing_) {
      Q_EMIT changed();
    }
  }
}

QStringList StudyForm::scenarios() const {
  QStringList paths;
  for (int row = 0; row < scenarios_->count(); ++row) {
    paths.append(scenarios_->item(row)->data(Qt::UserRole).toString());
  }
  return paths;
}

void StudyForm::askScenarios() {
  QFileDialog dialog(this, tr("Scenarios of the study"), context_.folder(),
                     tr("Scenarios (*.yaml *.yml)"));
  dialog.setFileMode(QFileDialog::ExistingFiles);
  editor::keepFiles(dialog, false);
  if (dialog.exec() == QDialog::Accepted) {
    for (const QString& path : dialog.selectedFiles()) {
      addScenario(path);
    }
  }
}

void StudyForm::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty() &&
      std::all_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); })) {
    event->acceptProposedAction();
  }
}

void StudyForm::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  for (const QUrl& url : event->mimeData()->urls()) {
    addScenario(url.toLocalFile());
  }
}

/// That of the file; else of the first robot of the scenario that is open.
QString StudyForm::plannerPath() const {
  if (!robotPath_.isEmpty()) {
    return robotPath_;
  }
  const auto& robots = context_.document.scenario().robots;
  const std::string name = robots.empty() ? "robot1" : robots.front().name;
  return QString::fromStdString(name) + QStringLiteral(".planner");
}

/// Those of the file in its order, then others.
QStringList StudyForm::chosenPlanners() const {
  QStringList chosen;
  for (int row = 0; row < planners_->count(); ++row) {
    if (planners_->item(row)->checkState() == Qt::Checked) {
      chosen.append(planners_->item(row)->text());
    }
  }
  const auto place = [this](const QString& name) {
    const int at = planned_.indexOf(name);
    return at < 0 ? planned_.size() : at;
  };
  std::stable_sort(chosen.begin(), chosen.end(),
                   [place](const QString& a, const QString& b) { return place(a) < place(b); });
  return chosen;
}

/// Also those of the file that are not offered, as "external": else they would be lost.
void StudyForm::showPlanners(const QStringList& chosen) {
  planned_ = chosen;
  for (const QString& name : chosen) {
    if (planners_->findItems(name, Qt::MatchExactly | Qt::MatchCaseSensitive).isEmpty()) {
      addPlanner(name, {});
    }
  }
  for (int row = 0; row < planners_->count(); ++row) {
    QListWidgetItem* item = planners_->item(row);
    item->setCheckState(chosen.contains(item->text()) ? Qt::Checked : Qt::Unchecked);
  }
}

QString StudyForm::textFor(const QString& folder) const {
  QStringList lines = {QStringLiteral("hunavsim_experiment: 1"), QStringLiteral("scenarios:")};
  for (const QString& path : scenarios()) {
    const bool isFile = QFileInfo(path).isAbsolute();
    const QString way = isFile ? QDir(folder).relativeFilePath(path) : path;
    lines.append(QStringLiteral("  - ") +
                 quoted(way.startsWith(QLatin1String("../..")) ? path : way));
  }
  lines.append(QStringLiteral("seeds: ") + seeds_->text().trimmed());
  if (!duration_->text().trimmed().isEmpty()) {
    lines.append(QStringLiteral("duration: ") + duration_->text().trimmed());
  }
  lines.append(others_);
  QStringList values;
  const QStringList planners = chosenPlanners();
  if (!planners.isEmpty()) {
    values.append(
        QStringLiteral("  %1: [%2]").arg(plannerPath(), planners.join(QStringLiteral(", "))));
  }
  for (const QString& line : values_->toPlainText().split(QLatin1Char('\n'))) {
    if (!line.trimmed().isEmpty()) {
      values.append(QStringLiteral("  ") + line.trimmed());
    }
  }
  if (!values.isEmpty()) {
    lines.append(QStringLiteral("values:"));
    lines.append(values);
  }
  lines.append(QStringLiteral("record: ") +
               QLatin1String(Experiment::kRecordNames[record_->currentIndex()]));
  return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void StudyForm::show(const Experiment& experiment) {
  showing_ = true;
  scenarios_->clear();
  fitScenarios();
  for (std::size_t k = 0; k < experiment.scenarios.size(); ++k) {
    const QString name = QString::fromStdString(experiment.scenarios[k]);
    const QString path = QString::fromStdString(experiment.scenarioPaths[k]);
    addItem(QFileInfo(path).completeBaseName(), QFileInfo(path).absoluteFilePath());
  }
  robotPath_.clear();
  QStringList planners;
  QStringList values;
  for (const ExperimentValue& value : experiment.values) {
    const QString path = QString::fromStdString(value.path);
    if (!value.isDrawn() && robotPath_.isEmpty() && path.endsWith(QLatin1String(".planner"))) {
      robotPath_ = path;
      for (const std::string& text : value.texts) {
        planners.append(QString::fromStdString(text));
      }
    } else {
      values.append(quoted(path) + QStringLiteral(": ") +
                    QString::fromStdString(experimentValueText(value)));
    }
  }
  showPlanners(planners);
  values_->setPlainText(values.join(QLatin1Char('\n')));
  seeds_->setText(seedsText(experiment.seeds));
  duration_->clear();
  others_.clear();
  for (const auto& [option, text] : experiment.options) {
    const QString words = QString::fromStdString(text);
    if (option == "--duration") {
      duration_->setText(words);
    } else {
      QString key = QString::fromStdString(option.substr(2));
      others_.append(key.replace(QLatin1Char('-'), QLatin1Char('_')) + QStringLiteral(": ") +
                     words);
    }
  }
  record_->setCurrentIndex(static_cast<int>(experiment.record));
  showing_ = false;
  Q_EMIT changed();
}

void StudyForm::setEditable(bool editable) {
  for (QWidget* child : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    child->setEnabled(editable);
  }
}

}  // namespace app
