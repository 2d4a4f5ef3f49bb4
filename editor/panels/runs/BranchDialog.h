#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/run/RunSpec.h"
#include "editor/canvas/MapView.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// The robots and people of a run at the branch time.
struct BranchState {
  struct RobotState {
    std::string name, planner;
    double maxVel = 1.0;  // [m/s]
  };
  struct PersonState {
    std::string name;
    base::Pose2 pose;
  };
  double time = 0.0;  // [s]
  long long seed = 1;
  std::vector<RobotState> robots;
  std::vector<PersonState> people;  // present ones, without those spawned during the run
};
/// Of the shown state. `run`: must show one.
BranchState branchStateOf(const SimulationRunner& run);

/// "anna 2.5 1 0", as for the option `--move`.
std::string moveText(const std::string& person, const base::Pose2& pose);

/// Asks for the changes of a new branch: planners and speeds of robots, positions of people, a new
/// random seed, and other values as PATH = VALUE. All may be unchanged. The dialog stays open while
/// the changes are invalid.
class BranchDialog : public QDialog {
  Q_OBJECT
 public:
  /// Returns the errors of the changes; none: they are valid.
  using Check = std::function<base::Diagnostics(const app::RunSpec&)>;
  BranchDialog(BranchState state, const QString& name, const Theme& theme, Check check,
               QWidget* parent = nullptr);

  /// Enters these changes: `moves` and `set` of the kinds that the dialog shows.
  void propose(const app::RunSpec& changes);
  app::RunSpec changes() const;
  QString name() const { return name_->text().trimmed(); }
  void accept() override;

 private:
  struct RobotRow {
    std::string name;
    double maxVel = 1.0;  // Current value [m/s].
    QComboBox* planner = nullptr;
    NumberField* speed = nullptr;
  };
  struct MoveRow {
    std::string person;
    QWidget* row = nullptr;
    NumberField *x = nullptr, *y = nullptr, *heading = nullptr;  // [m], [°]
  };
  void addRobots(FormSection& section);
  void addPeople(FormSection& section);
  void addSeed(FormSection& section);
  void addMove(const std::string& person, const base::Pose2& pose);
  void removeMove(const QWidget* row);
  void fillPeople();
  void showChanges();
  void showNote(const QString& text, Role role);

  const BranchState state_;
  Check check_;
  Theme theme_;
  QLineEdit* name_;
  std::vector<RobotRow> robots_;
  QComboBox* people_ = nullptr;  // Adds a row for a person.
  QVBoxLayout* moveRows_ = nullptr;
  std::vector<MoveRow> moves_;
  QCheckBox* drawsNewSeed_ = new QCheckBox(tr("New random seed"), this);
  QSpinBox* seed_ = new QSpinBox(this);
  QPlainTextEdit* values_ = new QPlainTextEdit(this);
  QLabel* note_ = new QLabel(this);  // The changes, or what is wrong with them.
};

/// The command that branches a run: from the menu, the timeline, the map, plots and panels. It
/// pauses the run, asks for the changes, and shows the new branch.
class BranchCommand : public QObject {
  Q_OBJECT
 public:
  /// `action`: its trigger branches without proposed changes.
  BranchCommand(SimulationRunner& runner, MapView& view, QAction& action,
                QObject* parent = nullptr);

  QAction& action() const { return action_; }
  /// Opens the dialog at the shown state with these changes.
  void branchHere(const app::RunSpec& proposal = {});
  /// Offers a branch at the shown state in which this person stands elsewhere.
  void offerMove(int person, const base::Pose2& pose);
  /// Shows the state at this time [s] and adds the command to the menu.
  void offerIn(double time, QMenu* menu);

 private:
  void follow();
  QMenu& emptyMenu();

  SimulationRunner& runner_;
  MapView& view_;
  MapScene& scene_;  // Outlives the view.
  QAction& action_;
  QPointer<QMenu> menu_;
  QString why_;  // Reason for which the command is disabled.
};

}  // namespace editor
