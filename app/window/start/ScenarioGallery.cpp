#include "app/window/start/ScenarioGallery.h"

#include <algorithm>
#include <iterator>

#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr int kGalleryColumns = 2;
constexpr int kGalleryGap = 24;
constexpr int kRowGap = 12;
constexpr int kSearchWidth = 220;

/// The texts in the combo box, after the entry for all of them.
void setChoices(QComboBox& box, const QStringList& choices, const QString& all) {
  const QString chosen = box.currentText();
  const QSignalBlocker quiet(&box);
  box.clear();
  box.addItem(all);
  box.addItems(choices);
  box.setCurrentIndex(std::max(0, box.findText(chosen)));
  box.setVisible(choices.size() > 1);
}

int placeOf(const ShippedScenario& scenario) {
  return scenario.name == "corner_cafe_agents"                   ? 0
         : scenario.path.find("/planners/") != std::string::npos ? 1
         : !base::startsWith(scenario.name, "reaction_")         ? 2
                                                                 : 3;
}

}  // namespace

std::vector<ShippedScenario> galleryScenarios(std::vector<ShippedScenario> shipped) {
  shipped.erase(std::remove_if(shipped.begin(), shipped.end(),
                               [](const ShippedScenario& each) {
                                 return base::startsWith(each.name, "realism_");
                               }),
                shipped.end());
  std::stable_sort(
      shipped.begin(), shipped.end(),
      [](const ShippedScenario& a, const ShippedScenario& b) { return placeOf(a) < placeOf(b); });
  return shipped;
}

ScenarioGallery::ScenarioGallery(const std::vector<ShippedScenario>& scenarios,
                                 const QString& thumbnailFolder, const editor::Theme& theme,
                                 QWidget* parent)
    : QWidget(parent),
      theme_(theme),
      thumbnails_(new Thumbnails(thumbnailFolder, this)),
      search_(new editor::SearchField(tr("Find a scenario"), tr("Find a scenario"), this)),
      reading_([this](const std::vector<ScenarioInfo>& infos) { takeInfos(infos); }) {
  auto* rows = editor::configuredLayout(new QVBoxLayout(this), {}, 0);
  rows->addLayout(makeTop());
  rows->addSpacing(12);
  grid_->setContentsMargins({});
  grid_->setHorizontalSpacing(kGalleryGap);
  grid_->setVerticalSpacing(kRowGap);
  for (int column = 0; column < kGalleryColumns; ++column) {
    grid_->setColumnStretch(column, 1);
  }
  for (const ShippedScenario& scenario : scenarios) {
    const QString path = QString::fromStdString(scenario.path);
    auto* card = new ScenarioCard(path, infoOf(path, {}), theme_, area_);
    connect(card, &QAbstractButton::clicked, this, [this, path] { Q_EMIT fileRequested(path); });
    connect(card, &ScenarioCard::pictureNeeded, this, [this, card] {
      thumbnails_->request({card->path(), card->pictureSize(), devicePixelRatioF()});
    });
    cards_.push_back(card);
  }
  nothing_ = makeNothing();
  rows->addWidget(area_);
  rows->addWidget(nothing_);
  rows->addStretch(1);
  thumbnails_->setTheme(theme_);
  connect(thumbnails_, &Thumbnails::ready, this, &ScenarioGallery::takePicture);
  filter();
  search_->setTheme(theme_);
  readCards();
}

ScenarioGallery::~ScenarioGallery() {
  reading_.abandon();
}

void ScenarioGallery::readCards() {
  std::vector<QString> paths;
  for (const ScenarioCard* card : cards_) {
    paths.push_back(card->path());
  }
  reading_.start([paths] {
    std::vector<ScenarioInfo> infos;
    infos.reserve(paths.size());
    std::transform(paths.begin(), paths.end(), std::back_inserter(infos), infoOfFile);
    return infos;
  });
}

void ScenarioGallery::takeInfos(const std::vector<ScenarioInfo>& infos) {
  for (std::size_t i = 0; i < cards_.size(); ++i) {
    ScenarioInfo info = infos[i];
    info.people = cards_[i]->info().people;  // a picture may have come first
    info.robots = cards_[i]->info().robots;
    cards_[i]->setInfo(info);
  }
  areCardsRead_ = true;
  fillFilters();
  filter();
}

void ScenarioGallery::takePicture(const QString& path, const Thumbnail& thumbnail) {
  for (ScenarioCard* card : cards_) {
    if (card->path() == path) {
      ScenarioInfo info = card->info();
      info.people = thumbnail.people;
      info.robots = thumbnail.robots;
      card->setInfo(info);
      card->setPicture(QPixmap::fromImage(thumbnail.picture));
    }
  }
}

QLayout* ScenarioGallery::makeTop() {
  auto* top = editor::configuredLayout(
      new QHBoxLayout, {}, 8,
      {editor::headingLabel(tr("Scenarios"), theme_.font(12.0, QFont::DemiBold), this)});
  top->addStretch(1);
  family_->setAccessibleName(tr("Family"));
  family_->setToolTip(tr("Show the scenarios of one family"));
  difficulty_->setAccessibleName(tr("Difficulty"));
  difficulty_->setToolTip(tr("Show the scenarios of one difficulty"));
  search_->setFixedWidth(kSearchWidth);
  for (QWidget* widget : std::initializer_list<QWidget*>{family_, difficulty_, search_}) {
    top->addWidget(widget);
  }
  for (QComboBox* box : {family_, difficulty_}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    box->hide();  // until the cards are read
    connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, &ScenarioGallery::filter);
  }
  connect(search_, &QLineEdit::textChanged, this, &ScenarioGallery::filter);
  connect(search_, &QLineEdit::returnPressed, this, &ScenarioGallery::openFirst);
  return top;
}

/// Shown instead of the pictures when no scenario matches.
QWidget* ScenarioGallery::makeNothing() {
  auto* nothing = new QWidget(this);
  auto* rows = editor::configuredLayout(
      new QVBoxLayout(nothing), {}, 0,
      {editor::emptyState(tr("No scenario matches the search and the filters."), nothing)});
  rows->addWidget(
      editor::linkButton(tr("Show all scenarios"), tr("Clear the search and the filters"), nothing,
                         [this] {
                           search_->clear();
                           family_->setCurrentIndex(0);
                           difficulty_->setCurrentIndex(0);
                           search_->setFocus();
                         }),
      0, Qt::AlignHCenter);
  nothing->hide();
  return nothing;
}

void ScenarioGallery::showTheme() {
  search_->setTheme(theme_);
  thumbnails_->setTheme(theme_);
  for (ScenarioCard* card : cards_) {
    card->forgetPicture();
  }
}

void ScenarioGallery::fillFilters() {
  QStringList families;
  QStringList difficulties;
  for (const ScenarioCard* card : cards_) {
    const ScenarioInfo& info = card->info();
    if (!info.family.isEmpty() && !families.contains(info.family)) {
      families << info.family;
    }
    if (!info.difficulty.isEmpty() && !difficulties.contains(info.difficulty)) {
      difficulties << info.difficulty;
    }
  }
  setChoices(*family_, families, tr("All families"));
  difficulties.sort();
  setChoices(*difficulty_, difficulties, tr("Any difficulty"));
}

bool ScenarioGallery::isWanted(const ScenarioInfo& info) const {
  const bool isFamily = family_->currentIndex() <= 0 || family_->currentText() == info.family;
  const bool isDifficulty =
      difficulty_->currentIndex() <= 0 || difficulty_->currentText() == info.difficulty;
  return isFamily && isDifficulty && info.contains(search_->text());
}

void ScenarioGallery::filter() {
  const std::vector<ScenarioCard*> before = shownCards();
  std::vector<ScenarioCard*> wanted;
  std::copy_if(cards_.begin(), cards_.end(), std::back_inserter(wanted),
               [this](const ScenarioCard* card) { return isWanted(card->info()); });
  const QString searched = search_->text().trimmed();
  std::stable_partition(wanted.begin(), wanted.end(), [&searched](const ScenarioCard* card) {
    return card->info().title.contains(searched, Qt::CaseInsensitive);  // before other matches
  });
  nothing_->setVisible(wanted.empty() && !cards_.empty());
  if (wanted == before) {
    return;
  }
  for (ScenarioCard* card : before) {
    grid_->removeWidget(card);
    card->hide();
  }
  QWidget* previous = search_;
  for (int i = 0; i < static_cast<int>(wanted.size()); ++i) {
    ScenarioCard* card = wanted[static_cast<std::size_t>(i)];
    grid_->addWidget(card, i / kGalleryColumns, i % kGalleryColumns, Qt::AlignTop);
    card->setVisible(true);
    setTabOrder(previous, card);
    previous = card;
  }
}

void ScenarioGallery::openFirst() {
  const std::vector<ScenarioCard*> shown = shownCards();
  if (!shown.empty()) {
    Q_EMIT fileRequested(shown.front()->path());
  }
}

std::vector<ScenarioCard*> ScenarioGallery::shownCards() const {
  std::vector<ScenarioCard*> shown;
  shown.reserve(static_cast<std::size_t>(grid_->count()));
  for (int i = 0; i < grid_->count(); ++i) {
    shown.push_back(static_cast<ScenarioCard*>(grid_->itemAt(i)->widget()));
  }
  return shown;
}

}  // namespace app
