#pragma once

#include "app/run/DataPaths.h"
#include "app/window/start/StartCards.h"
#include "app/window/start/Thumbnails.h"
#include "editor/document/LatestTask.h"
#include "editor/look/Form.h"

namespace app {

/// The scenarios for the gallery in its order: the café, the scenes that compare planners, the
/// library, one scene per reaction; without the realism tests.
std::vector<ShippedScenario> galleryScenarios(std::vector<ShippedScenario> shipped);

/// The shipped scenarios as pictures, with search and filters. The cards of the files are read in
/// another thread; a picture is drawn when it becomes visible.
class ScenarioGallery : public QWidget {
  Q_OBJECT
 public:
  ScenarioGallery(const std::vector<ShippedScenario>& scenarios, const QString& thumbnailFolder,
                  const editor::Theme& theme, QWidget* parent);
  ~ScenarioGallery() override;
  Q_DISABLE_COPY_MOVE(ScenarioGallery)
  void showTheme();  // call after a theme change

  QLineEdit& search() const { return *search_; }
  QComboBox& family() const { return *family_; }
  QComboBox& difficulty() const { return *difficulty_; }
  std::vector<ScenarioCard*> shownCards() const;  // in their order
  void openFirst();                               // opens the first shown scenario
  const Thumbnails& thumbnails() const { return *thumbnails_; }
  bool areCardsRead() const { return areCardsRead_; }

 Q_SIGNALS:
  void fileRequested(const QString& path);

 private:
  QLayout* makeTop();
  QWidget* makeNothing();
  void readCards();
  void takeInfos(const std::vector<ScenarioInfo>& infos);
  void takePicture(const QString& path, const Thumbnail& thumbnail);
  void fillFilters();
  void filter();
  bool isWanted(const ScenarioInfo& info) const;

  const editor::Theme& theme_;  // of the workspace
  Thumbnails* thumbnails_;
  editor::SearchField* search_;
  QComboBox* family_ = new QComboBox(this);
  QComboBox* difficulty_ = new QComboBox(this);
  QWidget* area_ = new QWidget(this);
  QGridLayout* grid_ = new QGridLayout(area_);
  QWidget* nothing_ = nullptr;
  bool areCardsRead_ = false;
  std::vector<ScenarioCard*> cards_;
  editor::LatestTask<std::vector<ScenarioInfo>> reading_;  // in the order of the cards
};

}  // namespace app
