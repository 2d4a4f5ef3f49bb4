#include "editor/document/ScenarioDocument.h"

#include "app/run/Bundle.h"
#include "editor/document/DocumentDiskState.h"
#include "editor/document/LatestTask.h"
#include "editor/document/PersonTree.h"
#include "sim2d/base/Find.h"

namespace editor {

namespace {

constexpr int kCheckDelayMs = 200;
constexpr int kMaxEdits = 20000;  // Undoable edits; each stores what it has changed.
constexpr std::chrono::milliseconds kCheckPatience(80);

/// The default position of an entity that is new or has been switched on or off: those that are
/// switched off follow the others, as in the file. People who are switched on are inserted before
/// those with higher numbers.
template <class List>
auto placeFor(const List& list, const typename List::value_type& value, bool isBack) {
  using Value = typename List::value_type;
  return std::find_if(list.begin(), list.end(), [&](const Value& other) {
    bool isBefore = !takesPart(other);
    if constexpr (std::is_same_v<Value, sim2d::Human>) {
      isBefore = isBefore || (isBack && other.id > value.id);
    }
    return takesPart(value) && isBefore;
  });
}

template <class List>
EntitySlot exchangeIn(List& list, EntityId id, EntitySlot slot) {
  using Value = typename List::value_type;
  EntitySlot old;
  auto* const value = slot.value ? &std::get<Value>(*slot.value) : nullptr;
  const int at = positionIn(list, id);
  if (at >= 0) {
    const auto place = list.begin() + at;
    const bool stays = value != nullptr &&
                       (slot.index < 0 ? takesPart(*place) == takesPart(*value) : slot.index == at);
    old = {Entity(std::move(*place)), at};
    if (stays) {
      *place = std::move(*value);
      return old;
    }
    list.erase(place);
  }
  if (value != nullptr) {
    const int size = static_cast<int>(list.size());
    const auto place = slot.index < 0 ? placeFor(list, *value, at >= 0)
                                      : list.cbegin() + std::min(slot.index, size);
    list.insert(place, std::move(*value));
  }
  return old;
}

/// Null if the entity does not exist.
template <class List>
const typename List::value_type* findIn(const List& list, EntityId id) {
  const int at = positionIn(list, id);
  return at < 0 ? nullptr : &list[static_cast<std::size_t>(at)];
}

}  // namespace

ScenarioDocument::ScenarioDocument(QObject* parent)
    : QObject(parent),
      surroundings_(std::make_shared<app::SurroundingsCache>()),
      liveCheck_(std::make_unique<LatestTask<base::Diagnostics>>([this](base::Diagnostics found) {
        checkIssues_ = std::move(found);
        Q_EMIT issuesChanged(issues());
      })),
      disk_(std::make_unique<DocumentDiskState>()) {
  checkTimer_.setSingleShot(true);
  checkTimer_.setInterval(kCheckDelayMs);
  connect(&checkTimer_, &QTimer::timeout, this, &ScenarioDocument::startCheck);
  connect(this, &ScenarioDocument::stepFinished, &checkTimer_, qOverload<>(&QTimer::start));
  connect(this, &ScenarioDocument::mapChanged, &checkTimer_, qOverload<>(&QTimer::start));
  undoStack_.setUndoLimit(kMaxEdits);
  connect(&undoStack_, &QUndoStack::cleanChanged, this,
          [this](bool) { Q_EMIT dirtyChanged(isDirty()); });
}

ScenarioDocument::~ScenarioDocument() {
  // Clearing the stack may still emit signals, which must not arrive.
  undoStack_.disconnect(this);
  stopMapTasks();
}

void ScenarioDocument::stopMapTasks() {
  mapStopFlag_->stop();
  mapStopFlag_ = std::make_shared<base::StopFlag>();
}

std::optional<Entity> ScenarioDocument::entity(EntityId id) const {
  if (id == kSettingsId) {
    return Entity(static_cast<const ScenarioSettings&>(scenario_));
  }
  return withList(scenario_, id.kind, [id](const auto& list) {
    const auto* found = findIn(list, id);
    return found == nullptr ? std::nullopt : std::optional<Entity>(*found);
  });
}

/// Keys of a run that was read from files are those of its reader.
std::optional<Entity> ScenarioDocument::entityIn(const sim2d::Scenario& scenario,
                                                 EntityId id) const {
  if (id == kSettingsId) {
    return Entity(static_cast<const ScenarioSettings&>(scenario));
  }
  const std::optional<Entity> own = entity(id);
  if (!own) {
    return std::nullopt;
  }
  const auto find = [&](const auto& list) -> std::optional<Entity> {
    using T = typename std::decay_t<decltype(list)>::value_type;
    const auto* const same = findIn(list, id);
    if constexpr (kIsNamed<T>) {
      const std::string& name = std::get<T>(*own).name;
      if (same == nullptr || same->name != name) {
        const T* const named = base::findBy(list, &T::name, name);
        return named != nullptr  ? std::optional<Entity>(*named)
               : same != nullptr ? std::optional<Entity>(*same)
                                 : std::nullopt;
      }
    }
    return same == nullptr ? std::nullopt : std::optional<Entity>(*same);
  };
  return withList(scenario, id.kind, find);
}

void ScenarioDocument::setRun(RunScenarios run) {
  if (run.start != run_.start || run.now != run_.now || run.customTrees != run_.customTrees) {
    run_ = std::move(run);
    Q_EMIT runChanged();
  }
}

std::vector<EntityId> ScenarioDocument::entities(EntityKind kind) const {
  return withList(scenario_, kind, [](const auto& list) {
    std::vector<EntityId> ids;
    ids.reserve(list.size());
    for (const auto& value : list) {
      ids.push_back(value.key);
    }
    return ids;
  });
}

const sim2d::Human* ScenarioDocument::human(EntityId id) const {
  return findIn(scenario_.humans, id);
}

const sim2d::GlobalGoal* ScenarioDocument::goal(EntityId id) const {
  return findIn(scenario_.goals, id);
}

int ScenarioDocument::indexOf(EntityId id) const {
  return withList(
      scenario_, id.kind, [id](const auto& list) { return positionIn(list, id); }, -1);
}

EntitySlot ScenarioDocument::exchange(EntityId id, EntitySlot slot) {
  const Step step(*this);
  const bool after = slot.value.has_value();
  EntitySlot old;
  if (id == kSettingsId) {
    Q_ASSERT(after);
    old.value = std::exchange(static_cast<ScenarioSettings&>(scenario_),
                              std::get<ScenarioSettings>(*std::move(slot.value)));
  } else {
    old = withList(scenario_, id.kind,
                   [&](auto& list) { return exchangeIn(list, id, std::move(slot)); });
  }
  if (const auto lost = std::find(selection_.begin(), selection_.end(), id);
      !after && lost != selection_.end()) {
    selection_.erase(lost);
    selectionShrank_ = true;
  }
  if (old.value || after) {
    Q_EMIT changed({!after      ? Change::What::Removed
                    : old.value ? Change::What::Edited
                                : Change::What::Added,
                    id});
  }
  return old;
}

std::optional<std::string> ScenarioDocument::exchangeTree(EntityId human,
                                                          std::optional<std::string> xml) {
  const Step step(*this);
  std::optional<std::string> old = tree(human);
  if (xml) {
    trees_[human] = *std::move(xml);
    if (const sim2d::Human* person = this->human(human)) {
      disk_->bases[human] = generatedTree(scenario_, *person);
    }
  } else {
    trees_.erase(human);
  }
  Q_EMIT changed({Change::What::Tree, human});
  return old;
}

void ScenarioDocument::setSelection(std::vector<EntityId> ids) {
  ids.erase(std::remove_if(ids.begin(), ids.end(), [this](EntityId id) { return !contains(id); }),
            ids.end());
  if (ids != selection_) {
    selection_ = std::move(ids);
    Q_EMIT selectionChanged();
  }
}

void ScenarioDocument::toggleSelected(EntityId id) {
  std::vector<EntityId> ids = selection_;
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end()) {
    ids.push_back(id);
  } else {
    ids.erase(found);
  }
  setSelection(std::move(ids));
}

void ScenarioDocument::finishStep() {
  if (--steps_ > 0) {
    return;
  }
  Q_EMIT stepFinished();
  if (std::exchange(selectionShrank_, false)) {
    Q_EMIT selectionChanged();
  }
}

void ScenarioDocument::replaced() {
  Q_EMIT changed({Change::What::Everything, {}});
  Q_EMIT stepFinished();
}

QString ScenarioDocument::displayName() const {
  return path_.isEmpty() ? tr("Untitled") : QFileInfo(path_).fileName();
}

base::Diagnostics ScenarioDocument::reportedMapProblems() const {
  // In a partly read file the map may be named in the unread part.
  const bool isScenario = !disk_->readOnly || (!disk_->isBeginning && !scenario_.humans.empty());
  return isScenario ? map_.problems : base::Diagnostics();
}

base::Diagnostics ScenarioDocument::issues() const {
  base::Diagnostics all = loadDiagnostics_;
  base::append(all, reportedMapProblems());
  base::append(all, checkIssues_);
  return all;
}

void ScenarioDocument::checkNow() {
  checkTimer_.stop();
  startCheck();
  liveCheck_->finish();
}

void ScenarioDocument::checkSoon() {
  checkTimer_.stop();
  startCheck();
  liveCheck_->finishWithin(kCheckPatience);
}

/// Runs the same check as a run, outside the GUI thread: tracing the walls of a large map is slow.
/// Problems reported while reading are not repeated.
void ScenarioDocument::startCheck() {
  liveCheck_->start([bundle = bundle()] {
    app::Verdict verdict = app::check(bundle);
    base::append(verdict.problems, verdict.worldRemarks);
    return app::newDiagnostics(bundle.remarks, verdict.problems);
  });
}

void ScenarioDocument::resetScenario(sim2d::Scenario scenario) {
  Q_EMIT aboutToBeReplaced();
  if (!selection_.empty()) {  // First: forms commit typed text with ids of this scenario.
    selection_.clear();
    Q_EMIT selectionChanged();
  }
  liveCheck_->forget();
  scenario_ = std::move(scenario);
  nextKey_ = std::max(nextKey_, scenario_.nextKey());
  trees_.clear();
  *disk_ = DocumentDiskState();
  loadDiagnostics_.clear();
  checkIssues_.clear();
  commentCount_ = 0;
  undoStack_.clear();
}

void ScenarioDocument::clear() {
  load(sim2d::Scenario());
  neverSaved_ = false;
  Q_EMIT dirtyChanged(false);
}

void ScenarioDocument::load(sim2d::Scenario scenario) {
  resetScenario(std::move(scenario));
  path_.clear();
  neverSaved_ = true;
  setMap(std::make_shared<sim2d::OccupancyGrid>());
  replaced();
  Q_EMIT pathChanged();
  Q_EMIT dirtyChanged(isDirty());
}

}  // namespace editor
