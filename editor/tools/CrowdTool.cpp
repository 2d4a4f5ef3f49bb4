#include "editor/tools/CrowdTool.h"

#include "editor/tools/ToolOptionFields.h"
#include "editor/tools/ToolRegistry.h"
#include "sim2d/base/Rng.h"

namespace editor {

namespace {

constexpr int kLateralAgent = -2;  // Agent number of the lateral offset draws.

/// Empty if all people found space.
QString skippedText(std::size_t placed, std::size_t wanted) {
  return placed == wanted ? QString()
         : placed == 0    ? QObject::tr("No space for people here")
                          : QObject::tr("Space for only %1 of %2")
                             .arg(QString::number(placed), peopleText(wanted));
}

}  // namespace

QString BrushTool::statusText() const {
  return ground_              ? tr("%1 · Esc cancels").arg(peopleText(people_.size()))
         : !result_.isEmpty() ? result_
                              : tr("Drag to place people along the path; they face its direction");
}

QWidget* BrushTool::makeOptions(QWidget* parent) {
  auto* row = new OptionsRow(parent);
  addNumber(*row, tr("Every"), {0.3, 20.0, 1, 0.5}, tr("m"), spacing_,
            [this](double value) { spacing_ = value; });
  addNumber(*row, tr("Width"), {0.0, 20.0, 1, 0.5}, tr("m"), width_,
            [this](double value) { width_ = value; });
  addRecipeFields(*row, recipe_, scene(), [this] { Q_EMIT statusTextChanged(); });
  return row;
}

sim2d::Human BrushTool::sampled(int drawn) const {
  const int index = nextPersonIndex(document()) + drawn;
  return sampledPerson(recipe_, behaviorsFrom(recipe_, index, 1).front(), index,
                       document().scenario());
}

void BrushTool::placeAt(const Vec2& at, double heading) {
  const int index = nextPersonIndex(document()) + drawn_;
  sim2d::Human human = sampled(drawn_);
  const base::AgentRng rng(static_cast<std::uint64_t>(recipe_.seed), kLateralAgent,
                           static_cast<std::uint64_t>(index));
  ++drawn_;
  const double aside = rng.uniform(-0.5 * width_, 0.5 * width_, base::DrawPurpose::Placement);
  const Vec2 place = Pose2{at, heading}.toWorld(Vec2(0.0, aside));
  human.initPose = {Vec2(roundedToCentimetres(place.x()), roundedToCentimetres(place.y())),
                    roundedToCentimetres(heading)};
  if (ground_->isFree(human.initPose.position, *human.radius)) {
    ground_->take(human.initPose.position, *human.radius);
    people_.push_back(std::move(human));
  }
}

void BrushTool::placeAlong(const Vec2& world) {
  for (Vec2 way = world - last_; way.norm() >= spacing_; way = world - last_) {
    const double heading = base::headingOf(way);
    if (drawn_ == 1 && people_.size() == 1) {
      people_.front().initPose.heading = roundedToCentimetres(heading);  // Unknown before.
    }
    last_ += spacing_ * way.normalized();
    placeAt(last_, heading);
  }
}

void BrushTool::press(const CanvasMouse& mouse) {
  cancel();
  ground_.emplace(document());
  last_ = mouse.world;
  placeAt(last_, sampled(0).initPose.heading);
  show();
}

void BrushTool::move(const CanvasMouse& mouse) {
  if (ground_) {
    placeAlong(mouse.world);
    show();
  }
}

void BrushTool::release(const CanvasMouse& mouse) {
  if (ground_) {
    placeAlong(mouse.world);
    const std::vector<sim2d::Human> people = std::move(people_);
    const QString result = skippedText(people.size(), static_cast<std::size_t>(drawn_));
    cancel();
    addCrowd(document(), {people, {}});
    result_ = result;
    Q_EMIT statusTextChanged();
  }
}

void BrushTool::cancel() {
  ground_.reset();
  people_.clear();
  result_.clear();
  drawn_ = 0;
  clearMarks();
}

FillTool::FillTool(ScenarioDocument& document, MapScene& scene, QObject* parent)
    : CornerDrawingTool(document, scene, parent) {
  connect(&document.undoStack(), &QUndoStack::indexChanged, this, [this] {
    if (!filling_) {
      last_.clear();
    }
  });
}

QString FillTool::idleText() const {
  const bool addsGoals = recipe_.walks && document().scenario().goals.empty();
  return !result_.isEmpty() ? result_
         : addsGoals
             ? tr("Drag or click the corners of an area to fill with %1 and %2 goals")
                   .arg(peopleText(count_))
                   .arg(kNewGoals)
             : tr("Drag or click the corners of an area to fill with %1").arg(peopleText(count_));
}

QWidget* FillTool::makeOptions(QWidget* parent) {
  auto* row = new OptionsRow(parent);
  addNumber(*row, tr("People"), {1.0, double(kLargestCrowd), 0, 5.0}, {}, double(count_),
            [this](double value) {
              count_ = static_cast<std::size_t>(value);
              applyOptions();
            });
  addRecipeFields(*row, recipe_, scene(), [this] { applyOptions(); });
  return row;
}

/// Shows or makes the polygon again with the current options.
void FillTool::applyOptions() {
  if (!last_.empty()) {
    filling_ = true;
    document().undoStack().undo();
    make(Corners(last_));
  } else {
    redraw();
  }
  Q_EMIT statusTextChanged();
}

void FillTool::deactivate() {
  last_.clear();
  result_.clear();
  CornerDrawingTool::deactivate();
}

void FillTool::preview(const Corners& corners) {
  showCrowd(scene(), fillCrowd(corners, count_, recipe_, document()));
  result_.clear();
}

void FillTool::make(const Corners& corners) {
  const Crowd crowd = fillCrowd(corners, count_, recipe_, document());
  result_ = skippedText(crowd.people.size(), count_);
  filling_ = true;
  addCrowd(document(), crowd);
  filling_ = false;
  last_ = crowd.people.empty() ? Corners() : corners;
  Q_EMIT statusTextChanged();
}

void addCrowdTool(ToolRegistry& to) {
  const QString crowd = QStringLiteral("crowd");
  to.add<FillTool>({30, QObject::tr("Fill"), QStringLiteral("tool-fill"), Qt::Key_L, crowd});
  to.add<BrushTool>({40, QObject::tr("Brush"), QStringLiteral("tool-brush"), Qt::Key_K, crowd});
}

}  // namespace editor
