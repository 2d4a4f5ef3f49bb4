#include "editor/panels/BlockDialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "editor/document/Groups.h"
#include "editor/document/PersonTree.h"
#include "editor/look/FigurePainter.h"
#include "editor/look/Form.h"

namespace editor {

namespace {

void addPeople(QListWidget& list, const ScenarioDocument& document, const Theme& theme) {
  const FigurePainter painter(theme);
  for (const sim2d::Human& human : document.scenario().humans) {
    auto* item = new QListWidgetItem(painter.markIcon(lookOfPerson(document, human)),
                                     QString::fromStdString(human.name), &list);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
    item->setCheckState(document.isSelected(human.key) ? Qt::Checked : Qt::Unchecked);
  }
}

}  // namespace

BlockDialog::BlockDialog(ScenarioDocument& document, const Theme& theme, QWidget* parent)
    : QDialog(parent),
      document_(document),
      ids_(document.entities(EntityKind::Human)),
      kinds_(new HintList(theme, tr("Blocks"), this)),
      people_(new HintList(theme, tr("People"), this)),
      about_(secondaryLabel({}, this)),
      form_(new ValueForm(this)) {
  setWindowTitle(tr("Add a block of behaviour"));
  resize(780, heightOnScreen(*this, 480));
  kinds_->setSelectionMode(QAbstractItemView::SingleSelection);
  people_->setSelectionMode(QAbstractItemView::SingleSelection);
  people_->setHint(tr("No people yet"));
  about_->setWordWrap(true);
  for (const bt::BlockKind& kind : bt::blockKinds()) {
    new QListWidgetItem(QString::fromStdString(kind.title), kinds_);
  }
  addPeople(*people_, document, theme);
  auto* middle = new QWidget(this);
  arranged(new QVBoxLayout(middle), {}, -1, {about_, form_})->addStretch(1);
  QScrollArea* area = scrollArea(middle, this);
  area->setMinimumWidth(330);
  auto* columns = arranged(new QHBoxLayout, {}, 16);
  columns->addLayout(titledColumn(tr("Block"), theme, kinds_), 3);
  columns->addLayout(titledColumn(tr("What it does"), theme, area), 5);
  columns->addLayout(titledColumn(tr("Who does it"), theme, people_), 3);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  add_ = buttons->button(QDialogButtonBox::Ok);
  add_->setText(tr("Add"));
  connect(buttons, &QDialogButtonBox::accepted, this, &BlockDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = arranged(new QVBoxLayout(this), {16, 16, 16, 16}, 16);
  layout->addLayout(columns, 1);
  layout->addWidget(buttons);
  connect(kinds_, &QListWidget::currentRowChanged, this, &BlockDialog::showKind);
  connect(form_, &ValueForm::edited, this, [this](const std::string& key, const QString& text) {
    setValue(block_, key, text);
    showBlock();
  });
  const auto judge = [this] { add_->setEnabled(!chosen().empty()); };
  connect(people_, &QListWidget::itemChanged, this, judge);
  kinds_->setCurrentRow(0);
  judge();
}

void BlockDialog::showKind() {
  const int row = kinds_->currentRow();
  if (row < 0) {
    return;
  }
  const bt::BlockKind& kind = bt::blockKinds()[static_cast<std::size_t>(row)];
  about_->setText(QString::fromStdString(kind.description) + QLatin1Char('.'));
  block_ = {kind.id, {}};
  showBlock();
}

std::vector<EntityId> BlockDialog::chosen() const {
  std::vector<EntityId> result;
  for (int row = 0; row < people_->count(); ++row) {
    if (people_->item(row)->checkState() == Qt::Checked) {
      result.push_back(ids_[static_cast<std::size_t>(row)]);
    }
  }
  return result;
}

void BlockDialog::accept() {
  pushAddBlock(document_, chosen(), block_);
  QDialog::accept();
}

}  // namespace editor
