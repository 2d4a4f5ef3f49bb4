#include "app/run/DataPaths.h"
#include "app/run/Nav2Robots.h"
#include "app/window/files/FileDialogs.h"
#include "app/window/study/StudyPanel.h"
#include "editor/look/CoreText.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/panels/RowDelegate.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/world/Registries.h"

namespace app {

namespace {

constexpr int kScenarioRows = 2;  // visible rows
constexpr int kPlannerWidth = 118;
constexpr int kValueLines = 2;
constexpr int kInitialSeeds = 30;

QString quoted(const QString& text) {
  return QString::fromStdString(base::quotedText(text.toStdString()));
}

/// Whether the planner needs a program, a file or manual control and cannot be selected by name.
bool needsConfiguration(const QString& planner) {
  static const QStringList kAll = {QStringLiteral("external"), QStringLiteral("library"),
                                   QStringLiteral("onnx"),     QStringLiteral("replay"),
                                   QStringLiteral("teleop"),   QStringLiteral("ros2")};
  return kAll.contains(planner);
}

/// The number of seeds if they are 1, 2, 3 …, otherwise a list.
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

/// A list that is high enough to show all rows.
class AutoHeightList : public QListWidget {
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
    : context_(context), planners_(new AutoHeightList(this)) {
  auto* rows = editor::configuredLayout(new QVBoxLayout(this), {12, 6, 12, 6}, 6);
  rows->addWidget(makeScenarios());
  rows->addWidget(makePlanners());
  rows->addLayout(makeNumbers());
  rows->addWidget(editor::secondaryLabel(tr("Other parameters, one per line"), this));
  styleValues();
  rows->addWidget(values_);
  rows->addStretch();
  setAcceptDrops(true);
  const auto tell = [this] {
    if (!isLoading_) {
      Q_EMIT changed();
    }
  };
  seeds_->setText(QString::number(kInitialSeeds));
  connect(planners_, &QListWidget::itemChanged, this, tell);
  connect(values_, &QPlainTextEdit::textChanged, this, tell);
  connect(seeds_, &QLineEdit::textChanged, this, tell);
  connect(duration_, &QLineEdit::textChanged, this, tell);
  connect(record_, qOverload<int>(&QComboBox::currentIndexChanged), this, tell);
}

QLayout* StudyForm::makeNumbers() {
  seeds_->setAccessibleName(tr("Seeds"));
  seeds_->setToolTip(tr("Number or list of seeds: 30 or [3, 7, 11]"));
  duration_->setAccessibleName(tr("Duration"));
  duration_->setPlaceholderText(tr("from scenario"));
  duration_->setToolTip(tr("Maximum duration of each run [s]; empty: as in the scenario"));
  record_->addItems(
      {tr("metrics only"), tr("runs with an error"), tr("failures only"), tr("all runs")});
  record_->setCurrentIndex(static_cast<int>(Experiment::Record::Unsuccessful));
  record_->setAccessibleName(tr("Keep recordings"));
  record_->setToolTip(
      tr("Runs whose files are kept in the results folder. Failures are runs with an error and "
         "runs whose robot did not succeed."));
  auto* both = editor::configuredLayout(new QHBoxLayout, {}, 8);
  both->addWidget(seeds_, 2);
  both->addWidget(new QLabel(tr("Duration"), this));
  both->addWidget(duration_, 3);
  QFormLayout* form = formRows();
  form->addRow(tr("Seeds"), both);
  form->addRow(tr("Keep recordings"), record_);
  return form;
}

void StudyForm::styleValues() {
  values_->setPlaceholderText(
      QStringLiteral("\"*.max_vel\": {normal: [1.2, 0.2, 0.6, 1.8]}\nrobot1.max_vel: [0.5, 1.0]"));
  values_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  values_->setLineWrapMode(QPlainTextEdit::NoWrap);
  values_->setTabChangesFocus(true);
  values_->setFixedHeight(kValueLines * values_->fontMetrics().lineSpacing() + 16);
  values_->setAccessibleName(tr("Other parameters"));
  values_->setToolTip(
      tr("A list tests each value. {normal: [mean, deviation, minimum, maximum]}, {uniform: [from, "
         "to]} and {choice: […]} are sampled for each seed, equally for all planners."));
}

QWidget* StudyForm::makeScenarios() {
  auto* part = new QWidget(this);
  auto* rows = editor::configuredLayout(new QVBoxLayout(part), {}, 4);
  auto* head = editor::configuredLayout(new QHBoxLayout, {}, 12);
  head->addWidget(editor::secondaryLabel(tr("Scenarios"), part), 1);
  addThis_ = editor::linkButton(tr("Add current"), tr("Add the open scenario"), part,
                                [this] { addScenario(context_.document.path()); });
  head->addWidget(addThis_);
  head->addWidget(
      editor::linkButton(tr("Add…"), tr("Add scenario files"), part, [this] { askScenarios(); }));
  rows->addLayout(head);
  editor::styleList(*scenarios_, tr("Scenarios"));
  scenarios_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  scenarios_->setToolTip(tr("Press Delete to remove the selection"));
  scenarios_->setTextElideMode(Qt::ElideMiddle);
  // The room for several rows is reserved: nothing below moves when a scenario is added.
  scenarioRoom_->setFixedHeight(kScenarioRows * editor::kListRowHeight);
  emptyLabel_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  emptyLabel_->setContentsMargins(0, 4, 0, 0);
  scenarioRoom_->addWidget(emptyLabel_);
  scenarioRoom_->addWidget(scenarios_);
  rows->addWidget(scenarioRoom_);
  scenarios_->installEventFilter(this);  // lists handle Delete themselves, see KeyRules
  showScenarios();
  const auto follow = [this] {
    addThis_->setEnabled(!context_.document.path().isEmpty());
    addThis_->setToolTip(addThis_->isEnabled() ? tr("Add the open scenario")
                                               : tr("Save the scenario first"));
  };
  connect(&context_.document, &editor::ScenarioDocument::pathChanged, this, follow);
  follow();
  return part;
}

/// Delete removes the selected scenarios.
bool StudyForm::eventFilter(QObject* watched, QEvent* event) {
  const bool isDelete = watched == scenarios_ && event->type() == QEvent::KeyPress &&
                        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Delete);
  if (isDelete) {
    qDeleteAll(scenarios_->selectedItems());
    showScenarios();
    isPreset_ = false;
    Q_EMIT changed();
  }
  return isDelete || QWidget::eventFilter(watched, event);
}

QWidget* StudyForm::makePlanners() {
  auto* part = new QWidget(this);
  auto* rows = editor::configuredLayout(new QVBoxLayout(part), {}, 4);
  rows->addWidget(editor::secondaryLabel(tr("Planners to compare"), part));
  editor::styleList(*planners_, tr("Planners"));
  const sim2d::Registries registries = builtinRegistries();
  for (const std::string& planner : listedPlanners(registries)) {
    const QString name = QString::fromStdString(planner);
    if (!needsConfiguration(name)) {
      addPlanner(name, editor::coreText(registries.planners.find(planner)->help));
    }
  }
  planners_->setFlow(QListView::LeftToRight);
  planners_->setWrapping(true);
  planners_->setGridSize({kPlannerWidth, editor::kListRowHeight});
  planners_->setResizeMode(QListView::Adjust);  // in as many columns as fit
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

void StudyForm::addItem(const QString& path) {
  auto* item = new QListWidgetItem(QFileInfo(path).completeBaseName(), scenarios_);
  item->setData(Qt::UserRole, path);
  item->setToolTip(path);
  showScenarios();
}

void StudyForm::showScenarios() {
  scenarioRoom_->setCurrentWidget(scenarios_->count() > 0 ? static_cast<QWidget*>(scenarios_)
                                                          : emptyLabel_);
}

void StudyForm::addScenario(const QString& path) {
  if (!path.isEmpty() && !scenarios().contains(path)) {
    addItem(path);
    isPreset_ = false;
    Q_EMIT changed();
  }
}

void StudyForm::presetOpenScenario() {
  const QString path = context_.document.path();
  emptyLabel_->setText(path.isEmpty() ? tr("Save the open scenario first, or add files")
                                      : tr("No scenarios: add or drop files here"));
  if (!isPreset_ || scenarios() == (path.isEmpty() ? QStringList() : QStringList(path))) {
    return;
  }
  scenarios_->clear();
  if (path.isEmpty()) {  // not saved yet
    showScenarios();
    Q_EMIT changed();
    return;
  }
  addItem(path);
  const QStringList chosen = chosenPlanners();
  const auto& robots = context_.document.scenario().robots;
  if (chosen.isEmpty() || chosen == presetPlanners_) {
    presetPlanners_ = robots.empty()
                          ? QStringList()
                          : QStringList(QString::fromStdString(
                                robots.front().planner.value_or(sim2d::ResolvedRobot().planner)));
    isLoading_ = true;
    showPlanners(presetPlanners_);
    isLoading_ = false;
  }
  Q_EMIT changed();
}

void StudyForm::replaceScenario(const QString& path, const QString& by) {
  for (int row = 0; row < scenarios_->count() && path != by; ++row) {
    if (scenarios_->item(row)->data(Qt::UserRole).toString() == path) {
      delete scenarios_->takeItem(row);
      addItem(by);
      Q_EMIT changed();
      return;
    }
  }
}

void StudyForm::reset() {
  Experiment initial;
  for (int seed = 1; seed <= kInitialSeeds; ++seed) {
    initial.seeds.push_back(seed);
  }
  initial.record = Experiment::Record::Unsuccessful;
  show(initial);
  presetPlanners_.clear();
  isPreset_ = true;
}

QStringList StudyForm::scenarios() const {
  QStringList paths;
  for (int row = 0; row < scenarios_->count(); ++row) {
    paths.append(scenarios_->item(row)->data(Qt::UserRole).toString());
  }
  return paths;
}

void StudyForm::askScenarios() {
  QFileDialog dialog(this, tr("Add scenarios"), context_.folder(), tr("Scenarios (*.yaml *.yml)"));
  dialog.setFileMode(QFileDialog::ExistingFiles);
  for (const QString& path : editor::chosenFiles(dialog, false)) {
    addScenario(path);
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
    const QString path = url.toLocalFile();
    if (report::studyOutputFile(path.toStdString())) {
      editor::later(*this, [this, path] { Q_EMIT resultsDropped(path); });
    } else {
      addScenario(path);
    }
  }
}

/// The planner path of the file, otherwise of the first robot of the open scenario.
QString StudyForm::plannerPath() const {
  if (!plannerPath_.isEmpty()) {
    return plannerPath_;
  }
  const auto& robots = context_.document.scenario().robots;
  const std::string name = robots.empty() ? "robot1" : robots.front().name;
  return QString::fromStdString(name) + QStringLiteral(".planner");
}

/// The selected planners: first those of the file in file order.
QStringList StudyForm::chosenPlanners() const {
  QStringList chosen;
  for (int row = 0; row < planners_->count(); ++row) {
    if (planners_->item(row)->checkState() == Qt::Checked) {
      chosen.append(planners_->item(row)->text());
    }
  }
  const auto place = [this](const QString& name) {
    const int at = plannerOrder_.indexOf(name);
    return at < 0 ? plannerOrder_.size() : at;
  };
  std::stable_sort(chosen.begin(), chosen.end(),
                   [place](const QString& a, const QString& b) { return place(a) < place(b); });
  return chosen;
}

/// Also adds planners of the file that are not offered, such as "external", so that they are kept.
void StudyForm::showPlanners(const QStringList& chosen) {
  plannerOrder_ = chosen;
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

QString StudyForm::yamlFor(const QString& folder) const {
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
  isLoading_ = true;
  isPreset_ = false;
  scenarios_->clear();
  showScenarios();
  for (const std::string& path : experiment.scenarioPaths) {
    addItem(QFileInfo(QString::fromStdString(path)).absoluteFilePath());
  }
  plannerPath_.clear();
  QStringList planners;
  QStringList values;
  for (const ExperimentValue& value : experiment.values) {
    const QString path = QString::fromStdString(value.path);
    if (!value.isDrawn() && plannerPath_.isEmpty() && path.endsWith(QLatin1String(".planner"))) {
      plannerPath_ = path;
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
  for (const RunOption& option : kRunOptions) {
    if ((option.use & RunOption::InExperiment) == 0 || !option.isGiven(experiment.common)) {
      continue;
    }
    const QString text = QString::fromStdString(option.texts(experiment.common).front());
    if (option.key() == "duration") {
      duration_->setText(text);
    } else {
      others_.append(QString::fromStdString(option.key()) + QStringLiteral(": ") + text);
    }
  }
  record_->setCurrentIndex(static_cast<int>(experiment.record));
  isLoading_ = false;
  Q_EMIT changed();
}

void StudyForm::setEditable(bool editable) {
  for (QWidget* child : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    child->setEnabled(editable);
  }
}

}  // namespace app
