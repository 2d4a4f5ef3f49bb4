#include <algorithm>
#include <array>

#include "app/window/files/FileDialogs.h"
#include "editor/document/EditCommands.h"
#include "editor/look/CoreText.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "editor/look/PathFields.h"
#include "sim2d/base/Text.h"

namespace app {

using editor::Role;

namespace {

constexpr int kTargetWidth = 168;
constexpr int kFileRow = 24;

QString stateText(ExportPlan::State state) {
  return state == ExportPlan::State::New        ? QObject::tr("new")
         : state == ExportPlan::State::Replaced ? QObject::tr("replaced")
                                                : QObject::tr("unchanged");
}

/// The command on one line and its arguments on a second, as a shell accepts it.
QString onTwoLines(const std::string& command) {
  constexpr int kCommandWords = 4;  // "ros2 launch package file", never quoted
  const QString words = QString::fromStdString(command);
  const QString head = words.section(QLatin1Char(' '), 0, kCommandWords - 1);
  const QString rest = words.section(QLatin1Char(' '), kCommandWords);
  return rest.isEmpty() ? words : head + QStringLiteral(" \\\n  ") + rest;
}

/// The message with an initial capital, unless it starts with a name.
QString sentence(const base::Diagnostic& problem, const sim2d::Scenario& scenario) {
  const QString text = QString::fromStdString(problem.message);
  return editor::UniqueNames(scenario).isTaken(problem.value("where")) ? text
                                                                       : editor::capitalized(text);
}

}  // namespace

ExportDialog::ExportDialog(Bundle source, const QString& folder, const editor::Theme& theme,
                           QWidget* parent)
    : QDialog(parent),
      source_(std::move(source)),
      theme_(theme),
      folder_(new QLineEdit(folder, this)) {
  setWindowTitle(tr("Export"));
  editor::showEndOfPaths(*folder_);
  build();
  fillTargets();
  connect(targets_, &QListWidget::currentRowChanged, this, &ExportDialog::replan);
  connect(folder_, &QLineEdit::textChanged, this, &ExportDialog::replan);
  connect(dialect_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ExportDialog::replan);
  connect(style_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ExportDialog::replan);
  targets_->setCurrentRow(0);
}

void ExportDialog::build() {
  resize(820, editor::limitedToScreen(*this, 620));
  auto* rows = editor::configuredLayout(new QVBoxLayout(this), {16, 16, 16, 12}, 8);
  auto* columns = editor::configuredLayout(new QHBoxLayout, {}, 16, {targets_});
  targets_->setFixedWidth(kTargetWidth);
  targets_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  targets_->setIconSize(QSize(16, 16));
  targets_->setAccessibleName(tr("Simulator"));
  auto* right = editor::configuredLayout(new QVBoxLayout, {}, 8);
  right->addLayout(makeForm());
  right->addSpacing(4);
  right->addWidget(summary_);
  files_->setHeaderHidden(true);
  files_->setRootIsDecorated(false);
  files_->setColumnCount(2);
  files_->setUniformRowHeights(true);
  files_->setSelectionMode(QAbstractItemView::NoSelection);
  files_->setAccessibleName(tr("Files to write"));
  files_->header()->setStretchLastSection(false);
  files_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  files_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  right->addWidget(files_, 3);
  right->addWidget(reportTitle_);
  report_->setWordWrap(true);
  report_->setSpacing(2);
  report_->setSelectionMode(QAbstractItemView::NoSelection);
  report_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  report_->setAccessibleName(tr("Remarks"));
  right->addWidget(report_, 2);
  start_ = makeStart();
  right->addWidget(start_);
  setTabOrder(report_, copy_);
  setTabOrder(copy_, command_);
  columns->addLayout(right, 1);
  rows->addLayout(columns, 1);
  rows->addSpacing(4);
  export_ = addButtons(this, *rows, tr("Export"));
}

QLayout* ExportDialog::makeForm() {
  QFormLayout* form = formRows();
  auto* place = editor::configuredLayout(new QHBoxLayout, {}, 8);
  folder_->setAccessibleName(tr("Folder"));
  place->addWidget(folder_, 1);
  auto* choose = new QPushButton(tr("C&hoose…"), this);
  choose->setAutoDefault(false);
  connect(choose, &QPushButton::clicked, this, [this] {
    QFileDialog dialog(this, tr("Export folder"), folder_->text());
    dialog.setFileMode(QFileDialog::Directory);
    dialog.setOption(QFileDialog::ShowDirsOnly);
    if (const QStringList chosen = editor::chosenFiles(dialog, true); !chosen.isEmpty()) {
      folder_->setText(chosen.front());
    }
  });
  place->addWidget(choose);
  setTabOrder(folder_, choose);
  setTabOrder(choose, dialect_);
  form->addRow(tr("Folder"), place);
  dialect_->addItems(
      {tr("For the simulator's package"), tr("HuNavSim 2.0"), tr("HuNavSim (2024)")});
  dialect_->setAccessibleName(tr("Format"));
  form->addRow(tr("Format"), dialect_);
  style_->addItems({tr("Corrected"), tr("As in HuNavSim 2.0")});
  style_->setAccessibleName(tr("Missing trees"));
  form->addRow(tr("Missing trees"), style_);
  return form;
}

/// Shows the complete command with a copy button.
QWidget* ExportDialog::makeStart() {
  auto* start = new QWidget(this);
  auto* rows = editor::configuredLayout(new QVBoxLayout(start), {}, 4);
  auto* heading = new QHBoxLayout;
  heading->addWidget(
      editor::headingLabel(tr("Launch command"), theme_.font(9.5, QFont::DemiBold), start));
  heading->addStretch(1);
  copy_ = new QPushButton(tr("Co&py"), start);
  copy_->setAutoDefault(false);
  connect(copy_, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(QString::fromStdString(plan_.startCommand));
    copy_->setText(tr("Copied"));
  });
  heading->addWidget(copy_);
  rows->addLayout(heading);
  command_->setReadOnly(true);
  command_->setTabChangesFocus(true);
  command_->setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  command_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  command_->setAccessibleName(tr("Launch command"));
  const int line = command_->fontMetrics().lineSpacing();
  const int margin = static_cast<int>(command_->document()->documentMargin());
  command_->setFixedHeight(4 * line + 2 * (margin + command_->frameWidth()));
  rows->addWidget(command_);
  return start;
}

void ExportDialog::fillTargets() {
  for (const sim2d::TargetInfo& target : sim2d::exportTargets()) {
    auto* item = new QListWidgetItem(editor::coreText(target.title), targets_);
    item->setData(Qt::UserRole, QString::fromStdString(target.name));
    item->setSizeHint(QSize(0, 28));
    item->setToolTip(target.package.empty()
                         ? tr("HuNavSim folder layout, for any simulator")
                         : tr("For %1").arg(QString::fromStdString(target.package)));
  }
}

void ExportDialog::replan() {
  ExportRequest request;
  request.target = targets_->currentItem()->data(Qt::UserRole).toString().toStdString();
  request.folder = folder_->text().trimmed().toStdString();
  request.style = style_->currentIndex() == 1 ? bt::TreeStyle::Hunav2 : bt::TreeStyle::Corrected;
  if (dialect_->currentIndex() > 0) {
    request.dialect = dialect_->currentIndex() == 1 ? sim2d::Dialect::C : sim2d::Dialect::B;
  }
  plan_ = planExport(source_, request);
  showFiles();
  showReport();
  command_->setPlainText(onTwoLines(plan_.startCommand));
  copy_->setText(tr("Co&py"));
  start_->setVisible(!plan_.startCommand.empty());
  export_->setEnabled(!request.folder.empty() && !base::hasErrors(plan_.report));
}

void ExportDialog::showFiles() {
  files_->clear();
  const QDir folder(folder_->text().trimmed());
  int replaced = 0;
  for (const ExportPlan::File& file : plan_.files) {
    const bool isReplaced = file.state == ExportPlan::State::Replaced;
    replaced += isReplaced ? 1 : 0;
    auto* item = new QTreeWidgetItem(files_);
    item->setText(0, folder.relativeFilePath(QString::fromStdString(file.content.path)));
    item->setIcon(
        0, editor::tintedIcon(isReplaced ? QStringLiteral("warning") : QStringLiteral("file"),
                              theme_.color(isReplaced ? Role::WarningMark : Role::TextSecondary)));
    item->setText(1, stateText(file.state));
    item->setForeground(1, theme_.color(isReplaced ? Role::Warning : Role::TextSecondary));
    item->setSizeHint(0, QSize(0, kFileRow));
    item->setToolTip(0, QString::fromStdString(file.content.path));
  }
  summary_->setText(replaced == 0
                        ? tr("Files: %1, none replaced").arg(plan_.files.size())
                        : tr("Files: %1, replaced: %2").arg(plan_.files.size()).arg(replaced));
}

void ExportDialog::showReport() {
  report_->clear();
  std::vector<GroupedDiagnostic> lines = groupedByAgents(plan_.report);
  std::stable_sort(
      lines.begin(), lines.end(), [](const GroupedDiagnostic& a, const GroupedDiagnostic& b) {
        return static_cast<int>(a.diagnostic.severity) > static_cast<int>(b.diagnostic.severity);
      });
  const std::array<QIcon, 3> icons = {
      editor::tintedIcon(QStringLiteral("info"), theme_.color(Role::TextSecondary)),
      editor::tintedIcon(QStringLiteral("warning"), theme_.color(Role::WarningMark)),
      editor::tintedIcon(QStringLiteral("error"), theme_.color(Role::Error))};
  for (const GroupedDiagnostic& line : lines) {
    auto* item = new QListWidgetItem(icons.at(static_cast<std::size_t>(line.diagnostic.severity)),
                                     sentence(line.diagnostic, *source_.scenario), report_);
    item->setToolTip(QString::fromStdString(base::join(line.people, ", ")));
  }
  reportTitle_->setText(lines.empty() ? tr("Nothing is lost") : tr("Information"));
  report_->setVisible(!lines.empty());
}

}  // namespace app
