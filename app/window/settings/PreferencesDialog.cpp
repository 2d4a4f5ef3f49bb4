#include "app/window/settings/PreferencesDialog.h"

#include <algorithm>

#include "app/window/RunCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/look/PathFields.h"

namespace app {

namespace {

constexpr QSize kPreferencesSize(720, 600);
constexpr int kExplanationWidth = 420;
constexpr int kFormFieldWidth = 160;
enum ThemeChoice { System, Light, Dark };

QLabel* explanation(const QString& text, QWidget* parent) {
  QLabel* label = editor::secondaryLabel(text, parent);
  label->setWordWrap(true);
  label->setFixedWidth(kExplanationWidth);
  label->setMinimumHeight(label->heightForWidth(kExplanationWidth));  // forms reserve one line
  return label;
}

/// A page with a form at the top.
QFormLayout* pageForm(QWidget& page) {
  auto* rows = editor::configuredLayout(new QVBoxLayout(&page), {16, 16, 16, 16}, 0);
  QFormLayout* form = formRows();
  form->setVerticalSpacing(8);
  rows->addLayout(form);
  rows->addStretch(1);
  return form;
}

void name(QWidget& field, const QString& name, const QString& tip) {
  field.setAccessibleName(name);
  field.setToolTip(name + QLatin1Char('\n') + tip);
}

}  // namespace

PreferencesDialog::PreferencesDialog(Preferences& preferences, const WindowActions& actions,
                                     KeyMap& keys, Workspace& workspace, QString folder,
                                     QWidget* parent)
    : QDialog(parent),
      preferences_(preferences),
      actions_(actions),
      keys_(keys),
      workspace_(workspace),
      usualFolder_(std::move(folder)),
      shortcuts_(new ShortcutsPage(keys, this)) {
  setWindowTitle(tr("Preferences"));
  resize(kPreferencesSize.boundedTo(parent->size()));
  pages_->setDocumentMode(true);
  pages_->setAccessibleName(tr("Preferences"));
  pages_->addTab(makeGeneral(), tr("&General"));
  pages_->addTab(makeFiles(), tr("&Files"));
  auto* shortcuts = new QWidget(this);
  editor::configuredLayout(new QVBoxLayout(shortcuts), {12, 12, 12, 12}, 0, {shortcuts_});
  pages_->addTab(shortcuts, tr("Key&board"));
  auto* rows = editor::configuredLayout(new QVBoxLayout(this), {0, 0, 0, 0}, 0, {pages_});
  addButtons(*rows);
  connect(&workspace_, &Workspace::themeChanged, this, &PreferencesDialog::fill);
  fill();
}

QWidget* PreferencesDialog::makeGeneral() {
  auto* page = new QWidget(this);
  QFormLayout* form = pageForm(*page);
  theme_->addItems({tr("Follow system"), tr("Light"), tr("Dark")});
  name(*theme_, tr("Theme"), tr("Colours of the window"));
  form->addRow(tr("&Theme"), theme_);
  language_->addItem(tr("System language"), QString());
  for (const Language& each : languages()) {
    language_->addItem(each.name, each.code);
  }
  name(*language_, tr("Language"), tr("Language of the window"));
  form->addRow(tr("&Language"), language_);
  form->addRow(QString(), explanation(tr("Takes effect at the next start."), page));
  animation_->setToolTip(tr("Animations\nWithout animations, the map changes immediately"));
  form->addRow(QString(), animation_);
  history_->setRange(kLeastHistory, kMostHistory);
  history_->setSingleStep(kHistoryStep);
  history_->setSuffix(tr(" MB"));
  for (QWidget* field : {static_cast<QWidget*>(theme_), static_cast<QWidget*>(language_),
                         static_cast<QWidget*>(history_)}) {
    field->setFixedWidth(kFormFieldWidth);
  }
  name(*history_, tr("Memory for runs"),
       tr("Memory for the steps of a run that the timeline can show. 200 people need about 12 MB "
          "per "
          "minute."));
  form->addRow(tr("&Memory for runs"), history_);
  form->addRow(QString(), explanation(tr("Applies to runs started from now on."), page));
  form->addRow(tr("Numbers"),
               explanation(tr("Numbers have a decimal point (1.5) in every language, as in files. "
                              "Fields also accept a comma."),
                           page));
  connect(theme_, qOverload<int>(&QComboBox::activated), this, &PreferencesDialog::chooseTheme);
  connect(language_, qOverload<int>(&QComboBox::activated), this,
          [this] { preferences_.setLanguage(language_->currentData().toString()); });
  connect(animation_, &QCheckBox::toggled, &preferences_, &Preferences::setAnimated);
  connect(history_, &QSpinBox::editingFinished, this,
          [this] { preferences_.setHistoryMegabytes(history_->value()); });
  return page;
}

QWidget* PreferencesDialog::makeFiles() {
  auto* page = new QWidget(this);
  QFormLayout* form = pageForm(*page);
  auto* row = editor::configuredLayout(new QHBoxLayout, {}, 8, {folder_});
  auto* choose = new QPushButton(tr("&Choose…"), page);
  choose->setAutoDefault(false);
  choose->setToolTip(tr("Choose the default folder"));
  row->addWidget(choose);
  name(*folder_, tr("Default folder"),
       tr("Where file dialogs start for a scenario that is not saved yet"));
  folder_->setPlaceholderText(tr("Folder of the last used file"));
  editor::addClearButton(*folder_);
  editor::showEndOfPaths(*folder_);
  auto* label = new QLabel(tr("&Default folder"), page);
  label->setBuddy(folder_);
  form->addRow(label, row);
  form->addRow(QString(), autosave_);
  autosave_->setToolTip(
      tr("Copies of unsaved changes\nAfter a crash, the program offers to restore "
         "them"));
  seconds_->setRange(Preferences::kLeastSeconds, Preferences::kMostSeconds);
  seconds_->setSuffix(tr(" s"));
  seconds_->setFixedWidth(kFormFieldWidth);
  name(*seconds_, tr("Copy interval"), tr("The longest time between a change and its copy"));
  form->addRow(tr("C&opy interval"), seconds_);
  form->addRow(QString(),
               explanation(tr("The scenario file itself is written only when you save it."), page));
  connect(choose, &QPushButton::clicked, this, &PreferencesDialog::chooseFolder);
  connect(folder_, &QLineEdit::textChanged, this, [this](const QString& text) {
    const bool isFolder = text.isEmpty() || QFileInfo(text).isDir();
    folder_->setProperty(editor::kInvalidProperty, !isFolder);
    folder_->update();
    if (isFolder && !isFilling_) {
      preferences_.setFolder(text);
    }
  });
  const auto store = [this] {
    seconds_->setEnabled(autosave_->isChecked());
    if (!isFilling_) {
      preferences_.setAutosave(autosave_->isChecked(), seconds_->value());
    }
  };
  connect(autosave_, &QCheckBox::toggled, this, store);
  connect(seconds_, qOverload<int>(&QSpinBox::valueChanged), this, store);
  return page;
}

void PreferencesDialog::addButtons(QVBoxLayout& rows) {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  QPushButton* reset = buttons->addButton(tr("R&estore defaults"), QDialogButtonBox::ResetRole);
  reset->setAutoDefault(false);
  reset->setToolTip(tr("Restore the defaults of all pages"));
  buttons->button(QDialogButtonBox::Close)->setDefault(true);
  buttons->setContentsMargins(12, 8, 12, 12);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(reset, &QPushButton::clicked, this, &PreferencesDialog::resetAll);
  rows.addWidget(buttons);
}

void PreferencesDialog::fill() {
  const QScopedValueRollback<bool> filling(isFilling_, true);
  theme_->setCurrentIndex(actions_.systemTheme->isChecked() ? System
                          : workspace_.theme().isDark()     ? Dark
                                                            : Light);
  language_->setCurrentIndex(std::max(0, language_->findData(preferences_.language())));
  animation_->setChecked(preferences_.isAnimated());
  history_->setValue(preferences_.historyMegabytes());
  folder_->setText(preferences_.folder());
  autosave_->setChecked(preferences_.isAutosaved());
  seconds_->setValue(preferences_.autosaveSeconds());
  seconds_->setEnabled(preferences_.isAutosaved());
}

/// Uses the commands of the window, which store the theme.
void PreferencesDialog::chooseTheme(int theme) {
  actions_.systemTheme->setChecked(theme == System);
  if (theme != System && workspace_.theme().isDark() != (theme == Dark)) {
    actions_.switchTheme->trigger();
  }
}

void PreferencesDialog::chooseFolder() {
  QFileDialog dialog(this, tr("Default folder"),
                     preferences_.folder().isEmpty() ? usualFolder_ : preferences_.folder());
  dialog.setFileMode(QFileDialog::Directory);
  dialog.setOption(QFileDialog::ShowDirsOnly);
  const QStringList chosen = editor::chosenFiles(dialog, true);
  if (!chosen.isEmpty()) {
    folder_->setText(chosen.front());
  }
}

void PreferencesDialog::resetAll() {
  actions_.systemTheme->setChecked(true);
  preferences_.reset();
  keys_.resetAll();
  fill();
}

}  // namespace app
