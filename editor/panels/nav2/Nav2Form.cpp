#include "editor/panels/nav2/Nav2Form.h"

#include <algorithm>
#include <utility>

#include "editor/look/CoreText.h"
#include "editor/look/Fields.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

namespace {

constexpr int kNav2NameWidth = 250;    // [px]
constexpr int kNav2ValueWidth = 150;   // [px]
constexpr int kNav2NumberWidth = 120;  // [px]
constexpr int kNav2SearchWidth = 220;  // [px]
constexpr int kNav2HelpLines = 2;
constexpr int kAllTab = 0;

/// Edits values only: a combo box for booleans, else a validated text field.
class Nav2ValueDelegate : public RowDelegate {
 public:
  explicit Nav2ValueDelegate(Nav2Form& form) : RowDelegate(&form), form_(form) {}

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                        const QModelIndex& index) const override {
    const app::Nav2Parameter* const parameter = parameterAt(index);
    if (parameter == nullptr || index.column() != Nav2ValueColumn) {
      return nullptr;
    }
    if (parameter->type == "bool") {
      auto* choice = new QComboBox(parent);
      choice->addItems({QStringLiteral("true"), QStringLiteral("false")});
      return choice;
    }
    auto* field = new TextField(parent);
    field->setCheck(
        [this, key = *parameter](const QString& text) { return form_.problemOf(key, text); });
    return field;
  }

  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    const QString value = index.data().toString();
    if (auto* choice = qobject_cast<QComboBox*>(editor)) {
      choice->setCurrentText(value);
    } else if (auto* field = qobject_cast<TextField*>(editor)) {
      field->show(value);
      field->selectAll();
    }
  }

  void setModelData(QWidget* editor, QAbstractItemModel* /*model*/,
                    const QModelIndex& index) const override {
    const auto* choice = qobject_cast<QComboBox*>(editor);
    const auto* field = qobject_cast<QLineEdit*>(editor);
    const QString text = choice != nullptr ? choice->currentText() : field->text();
    if (const app::Nav2Parameter* const parameter = parameterAt(index)) {
      form_.applyEdit(app::Nav2Parameter(*parameter), text);
    }
  }

 protected:
  /// Values are shown with their unit, and edited without it.
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    RowDelegate::initStyleOption(option, index);
    const app::Nav2Parameter* const parameter = parameterAt(index);
    const bool isValue = index.column() == Nav2ValueColumn || index.column() == Nav2FileColumn;
    if (isValue && parameter != nullptr && !parameter->unit.empty() &&
        option->text != QStringLiteral("–")) {
      option->text += QLatin1Char(' ') + QString::fromStdString(parameter->unit);
    }
  }

 private:
  const app::Nav2Parameter* parameterAt(const QModelIndex& index) const {
    return form_.parameterOf(index.sibling(index.row(), 0).data(kNav2ParameterRole));
  }

  Nav2Form& form_;
};

QString words(const std::string& text) {
  return QString::fromStdString(text);
}

bool matchesSearch(const app::Nav2Parameter& parameter, const QString& searched) {
  return words(parameter.node + "." + parameter.name).contains(searched, Qt::CaseInsensitive) ||
         coreText(parameter.meaning).contains(searched, Qt::CaseInsensitive);
}

/// "3.5 rad/s"
QString withUnit(const std::string& value, const app::Nav2Parameter& parameter) {
  return parameter.unit.empty() ? words(value) : words(value + " " + parameter.unit);
}

/// The mark of values that apply at the next start, as in the properties.
QIcon dotIcon(const QColor& color) {
  constexpr int kSize = 48;  // [px], reduced by the view
  QPixmap pixmap(kSize, kSize);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawEllipse(QRectF(0.3 * kSize, 0.3 * kSize, 0.4 * kSize, 0.4 * kSize));
  return QIcon(pixmap);
}

}  // namespace

Nav2Form::Nav2Form(QWidget* parent) : QWidget(parent) {
  onlyChanged_ = linkButton(tr("Changed only"), tr("Show only values that differ from the file"),
                            this, [this] { filter(); });
  onlyChanged_->setCheckable(true);
  reset_ = linkButton(tr("Reset value"), tr("Reset to the value in the file (Delete)"), this,
                      [this] { resetRow(); });
  QSizePolicy policy = reset_->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  reset_->setSizePolicy(policy);
  tree_->installEventFilter(this);  // lists handle Delete themselves
  styleTree();
  tabs_->setAccessibleName(tr("Servers"));
  tabs_->setExpanding(false);
  tabs_->setDrawBase(false);
  tabs_->setElideMode(Qt::ElideNone);
  tabs_->setUsesScrollButtons(true);
  for (QToolButton* arrow : tabs_->findChildren<QToolButton*>()) {
    arrow->setAutoFillBackground(true);  // hides the tab below
  }
  search_->setFixedWidth(kNav2SearchWidth);
  nothing_ = new NoMatchesPlaceholder(*search_, *tree_, this);
  unchanged_ = makeUnchanged();
  help_ = secondaryLabel({}, this);
  help_->setObjectName(QStringLiteral("nav2_help"));
  help_->setWordWrap(true);
  help_->setTextFormat(Qt::PlainText);
  help_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  help_->setFixedHeight(kNav2HelpLines * help_->fontMetrics().lineSpacing() + 4);
  configuredLayout(head_, {12, 6, 12, 6}, 8, {search_, onlyChanged_})->addStretch(1);
  auto* layout = configuredLayout(new QVBoxLayout(this), {0, 0, 0, 0}, 0);
  layout->addLayout(head_);
  layout->addWidget(tabs_);
  layout->addWidget(tree_, 1);
  layout->addWidget(nothing_, 1);
  layout->addWidget(unchanged_, 1);
  auto* foot = configuredLayout(new QHBoxLayout, {12, 4, 12, 4}, 8);
  foot->addWidget(help_, 1);
  foot->addWidget(reset_);
  layout->addLayout(foot);
  connect(search_, &QLineEdit::textChanged, this, &Nav2Form::filter);
  connect(tabs_, &QTabBar::currentChanged, this, &Nav2Form::filter);
  connect(tree_, &QTreeWidget::currentItemChanged, this, &Nav2Form::showHelp);
}

QWidget* Nav2Form::makeUnchanged() {
  auto* part = new QWidget(this);
  part->setObjectName(QStringLiteral("nav2_unchanged"));
  auto* all = linkButton(tr("Show all"), tr("Show changed and unchanged values"), this,
                         [this] { onlyChanged_->click(); });
  unchangedText_->setTextFormat(Qt::PlainText);
  auto* layout = configuredLayout(new QVBoxLayout(part), {0, 0, 0, 0}, 0, {unchangedText_});
  layout->addWidget(all, 0, Qt::AlignHCenter);
  layout->addStretch(1);
  return part;
}

void Nav2Form::styleTree() {
  styleList(*tree_, tr("Nav2 parameters"));
  tree_->setColumnCount(Nav2Columns);
  tree_->setHeaderLabels(
      {tr("Parameter"), tr("Value"), tr("In the file"), tr("Nav2 default"), tr("Description")});
  tree_->setIndentation(14);
  tree_->setUniformRowHeights(true);
  tree_->setTextElideMode(Qt::ElideRight);
  tree_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  tree_->setItemDelegate(new Nav2ValueDelegate(*this));
  QHeaderView& header = *tree_->header();
  header.setStretchLastSection(true);
  header.resizeSection(Nav2NameColumn, kNav2NameWidth);
  header.resizeSection(Nav2ValueColumn, kNav2ValueWidth);
  header.resizeSection(Nav2FileColumn, kNav2NumberWidth);
  header.resizeSection(Nav2DefaultColumn, kNav2NumberWidth);
}

bool Nav2Form::eventFilter(QObject* watched, QEvent* event) {
  const bool isDelete = watched == tree_ && event->type() == QEvent::KeyPress &&
                        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Delete);
  if (isDelete) {
    resetRow();
  }
  return isDelete || QWidget::eventFilter(watched, event);
}

/// The list first: an open field of it stores its text when it is hidden.
Nav2Form::~Nav2Form() {
  delete tree_;
}

void Nav2Form::setTheme(const Theme& theme) {
  search_->setTheme(theme);
  accent_ = theme.color(Role::AccentText);
  secondary_ = theme.color(Role::TextSecondary);
  mark_ = theme.color(Role::WarningMark);
  showValues();
}

void Nav2Form::show(const std::optional<sim2d::Robot>& robot, const QString& scenarioPath,
                    const std::optional<sim2d::Robot>& inRun) {
  robot_ = robot;
  runValues_.reset();
  if (inRun) {
    runValues_.emplace();
    for (const app::Nav2Parameter& each :
         app::nav2ParameterListOf(*inRun, scenarioPath.toStdString()).parameters) {
      runValues_->emplace(each.path, each.value());
    }
  }
  scenarioPath_ = scenarioPath;
  app::Nav2ParameterList sheet;
  if (robot_) {
    sheet = app::nav2ParameterListOf(*robot_, scenarioPath_.toStdString());
  }
  const auto isSame = [](const app::Nav2Parameter& a, const app::Nav2Parameter& b) {
    return a.node == b.node && a.name == b.name;
  };
  const bool hasSameRows = std::equal(sheet.parameters.begin(), sheet.parameters.end(),
                                      sheet_.parameters.begin(), sheet_.parameters.end(), isSame);
  if (!hasSameRows) {
    cancelPendingEdit(*tree_);  // The text is for a row of the previous sheet.
  }
  sheet_ = std::move(sheet);
  if (!hasSameRows) {
    build();
  }
  showValues();
  filter();
}

int Nav2Form::changedCount() const {
  return static_cast<int>(
      std::count_if(sheet_.parameters.begin(), sheet_.parameters.end(),
                    [](const app::Nav2Parameter& each) { return each.given.has_value(); }));
}

const app::Nav2Parameter* Nav2Form::parameterOf(const QVariant& number) const {
  const std::size_t at = number.isValid() ? number.value<std::size_t>() : rows_.size();
  return at < rows_.size() && at < sheet_.parameters.size() ? &sheet_.parameters[at] : nullptr;
}

QTreeWidgetItem* Nav2Form::rowOf(const std::string& path) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (sheet_.parameters[i].path == path) {
      return rows_[i];
    }
  }
  return nullptr;
}

const app::Nav2Parameter* Nav2Form::current() const {
  const QTreeWidgetItem* const row = tree_->currentItem();
  return row != nullptr ? parameterOf(row->data(0, kNav2ParameterRole)) : nullptr;
}

QString Nav2Form::problemOf(const app::Nav2Parameter& parameter, const QString& text) const {
  return robot_ ? words(app::nav2ValueProblem(*robot_, scenarioPath_.toStdString(), parameter,
                                              text.trimmed().toStdString()))
                : QString();
}

void Nav2Form::applyEdit(const app::Nav2Parameter& parameter, const QString& text) {
  const std::string yaml = text.trimmed().toStdString();
  if (yaml == parameter.value() || !problemOf(parameter, text).isEmpty()) {
    return;
  }
  const bool isOfFile = yaml == parameter.fileValue.value_or(parameter.fallback);
  Q_EMIT edited(parameter, isOfFile ? std::nullopt : std::optional(yaml));
}

QTreeWidgetItem* Nav2Form::groupOf(const app::Nav2Parameter& parameter) {
  QTreeWidgetItem*& node = groups_[parameter.node];
  if (node == nullptr) {
    node = new QTreeWidgetItem(tree_, {words(parameter.node)});
    node->setFirstColumnSpanned(true);
  }
  const std::size_t dot = parameter.name.find('.');
  if (dot == std::string::npos) {
    return node;
  }
  const std::string plugin = parameter.name.substr(0, dot);
  QTreeWidgetItem*& group = groups_[parameter.node + "." + plugin];
  if (group == nullptr) {
    group = new QTreeWidgetItem(node, {words(plugin)});
    group->setFirstColumnSpanned(true);
  }
  return group;
}

void Nav2Form::build() {
  const QSignalBlocker quiet(tree_);
  tree_->clear();
  groups_.clear();
  rows_.clear();
  for (std::size_t i = 0; i < sheet_.parameters.size(); ++i) {
    const app::Nav2Parameter& parameter = sheet_.parameters[i];
    QTreeWidgetItem* const group = groupOf(parameter);
    const std::size_t dot = parameter.name.find('.');
    const std::string name =
        dot == std::string::npos ? parameter.name : parameter.name.substr(dot + 1);
    auto* row = new QTreeWidgetItem(group, {words(name)});
    row->setFlags(row->flags() | Qt::ItemIsEditable);
    row->setData(0, kNav2ParameterRole, QVariant::fromValue(i));
    rows_.push_back(row);
  }
  buildTabs();
}

/// The chosen server stays chosen if the new file has it.
void Nav2Form::buildTabs() {
  const QSignalBlocker quiet(tabs_);
  const QString before =
      tabs_->currentIndex() > kAllTab ? tabs_->tabText(tabs_->currentIndex()) : QString();
  while (tabs_->count() > 0) {
    tabs_->removeTab(0);
  }
  if (rows_.empty()) {
    return;
  }
  tabs_->addTab(tr("All"));
  for (int k = 0; k < tree_->topLevelItemCount(); ++k) {
    const QString node = tree_->topLevelItem(k)->text(Nav2NameColumn);
    const int tab = tabs_->addTab(node);
    if (node == before) {
      tabs_->setCurrentIndex(tab);
    }
  }
}

void Nav2Form::showValues() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    showRow(i);
  }
  showTabs();
  showHelp();
}

/// Whether the value differs from that of the shown run.
bool Nav2Form::isPending(const app::Nav2Parameter& parameter) const {
  if (!runValues_) {
    return false;
  }
  const auto inRun = runValues_->find(parameter.path);
  return inRun == runValues_->end() || inRun->second != parameter.value();
}

void Nav2Form::showRow(std::size_t index) {
  const app::Nav2Parameter& parameter = sheet_.parameters[index];
  QTreeWidgetItem& row = *rows_[index];
  QFont letters = font();
  letters.setWeight(parameter.given ? QFont::DemiBold : QFont::Normal);
  const QString meaning = capitalized(coreText(parameter.meaning));
  const bool pending = isPending(parameter);
  const QString later = pending ? QLatin1Char('\n') + tr("Applies at the next start") : QString();
  row.setIcon(Nav2ValueColumn, pending ? dotIcon(mark_) : QIcon());
  for (int column = 0; column < Nav2Columns; ++column) {
    row.setToolTip(column, words(parameter.path) + QLatin1Char('\n') + meaning + later);
    if (column > Nav2ValueColumn) {
      row.setForeground(column, secondary_);
    }
  }
  row.setFont(Nav2NameColumn, letters);
  row.setFont(Nav2ValueColumn, letters);
  row.setText(Nav2ValueColumn, words(parameter.value()));
  row.setText(Nav2FileColumn,
              parameter.fileValue ? words(*parameter.fileValue) : QStringLiteral("–"));
  row.setText(Nav2DefaultColumn, withUnit(parameter.fallback, parameter));
  row.setText(Nav2HelpColumn, meaning);
  row.setForeground(Nav2ValueColumn, parameter.given ? accent_
                                     : parameter.fileValue.has_value()
                                         ? palette().color(QPalette::Text)
                                         : secondary_);
}

/// Marks the servers that have changed values.
void Nav2Form::showTabs() {
  std::map<QString, int> changed;
  for (const app::Nav2Parameter& parameter : sheet_.parameters) {
    changed[words(parameter.node)] += parameter.given ? 1 : 0;
  }
  for (int tab = kAllTab + 1; tab < tabs_->count(); ++tab) {
    const int count = changed[tabs_->tabText(tab)];
    tabs_->setTabTextColor(tab, count > 0 ? accent_ : QColor());
    tabs_->setTabToolTip(tab, count > 0 ? tr("%1 changed").arg(count) : tr("As in the file"));
  }
}

bool Nav2Form::isShown(const app::Nav2Parameter& parameter) const {
  const int tab = tabs_->currentIndex();
  return (tab <= kAllTab || tabs_->tabText(tab) == words(parameter.node)) &&
         matchesSearch(parameter, search_->text().trimmed()) &&
         (!onlyChanged_->isChecked() || parameter.given.has_value());
}

void Nav2Form::filter() {
  const bool isFiltered = !search_->text().trimmed().isEmpty() || onlyChanged_->isChecked() ||
                          tabs_->currentIndex() > kAllTab;
  bool isAny = false;
  for (const auto& [name, group] : groups_) {
    group->setHidden(isFiltered);
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const bool isVisible = isShown(sheet_.parameters[i]);
    rows_[i]->setHidden(!isVisible);
    isAny = isAny || isVisible;
    for (QTreeWidgetItem* group = rows_[i]->parent(); group != nullptr && isVisible && isFiltered;
         group = group->parent()) {
      group->setHidden(false);
      group->setExpanded(true);
    }
  }
  const bool isUnchanged = !isAny && onlyChanged_->isChecked() && !rows_.empty();
  nothing_->setMatchFound(isAny || isUnchanged || search_->text().trimmed().isEmpty());
  tree_->setVisible(!isUnchanged && tree_->isVisibleTo(this));
  unchanged_->setVisible(isUnchanged);
  unchangedText_->setText(changedCount() == 0 ? tr("No changed values")
                                              : tr("No changed values match the filter"));
}

/// Shows description, default and file value of the current row.
void Nav2Form::showHelp() {
  const app::Nav2Parameter* const parameter = current();
  reset_->setVisible(parameter != nullptr && parameter->given.has_value());
  if (parameter == nullptr) {
    help_->setText(rows_.empty() ? words(sheet_.problems.empty() ? std::string()
                                                                 : sheet_.problems.front().message)
                   : runValues_  ? tr("Changes take effect at the next start. A dot marks values "
                                       "that differ from those of the run.")
                                 : tr("Double-click a value to change it. The scenario keeps the "
                                       "change; the file is only changed by saving it as a new "
                                       "file."));
    return;
  }
  QStringList lines;
  if (!parameter->meaning.empty()) {
    lines << capitalized(coreText(parameter->meaning));
  }
  lines << tr("Nav2 default %1").arg(withUnit(parameter->fallback, *parameter)) +
               (parameter->fileValue
                    ? tr(" · in the file %1").arg(withUnit(*parameter->fileValue, *parameter))
                    : tr(" · not in the file")) +
               (isPending(*parameter) ? tr(" · applies at the next start") : QString());
  help_->setText(lines.join(QLatin1Char('\n')));
}

void Nav2Form::resetRow() {
  const app::Nav2Parameter* const parameter = current();
  if (parameter != nullptr && parameter->given) {
    Q_EMIT edited(app::Nav2Parameter(*parameter), std::nullopt);
  }
}

}  // namespace editor
