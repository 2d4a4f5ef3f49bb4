#include "editor/panels/runs/RunOverlayReader.h"

#include <algorithm>
#include <utility>

#include "bt/human/ActiveBranch.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/RunOverlays.h"
#include "sim2d/trace/ContactMarks.h"

namespace editor {

namespace {

constexpr std::size_t kContactsAtOnce = 64;  // Events; the event loop runs in between.
constexpr qint64 kContactMs = 12;            // Duration of a batch.
constexpr qint64 kThoughtMs = 100;           // Interval between updates during a run.
constexpr std::size_t kMaxThinkers = 120;    // Above that only for selected people.

}  // namespace

RunOverlayReader::RunOverlayReader(MapScene& scene, QObject* parent)
    : QObject(parent), scene_(scene) {
  soon_.setSingleShot(true);
  connect(&soon_, &QTimer::timeout, this, [this] {
    if (recording_ != nullptr && frame_ != nullptr && scene_.options().contacts) {
      readContacts();
    }
  });
}

void RunOverlayReader::show(const std::shared_ptr<const sim2d::Recording>& recording,
                            sim2d::FramePtr frame, bool isRunning) {
  if (recording != recording_) {
    recording_ = recording;
    read_ = 0;
    thoughtStep_.reset();
    scene_.overlays().setContacts({});
    scene_.overlays().setThoughts({});
  }
  frame_ = std::move(frame);
  if (recording_ == nullptr || frame_ == nullptr) {
    return;
  }
  if (scene_.options().contacts) {
    readContacts();
  }
  if (scene_.options().thoughts) {
    updateThoughts(isRunning);
  }
}

/// Reads for a limited time; the rest is scheduled.
void RunOverlayReader::readContacts() {
  const std::size_t there = recording_->events().size();
  if (read_ >= there) {
    return;
  }
  QElapsedTimer clock;
  clock.start();
  RunOverlays& overlays = scene_.overlays();
  std::vector<sim2d::ContactMark> contacts = overlays.contacts();
  while (read_ < there && clock.elapsed() < kContactMs) {
    const std::size_t end = std::min(there, read_ + kContactsAtOnce);
    for (sim2d::ContactMark& mark : sim2d::contactMarks(*recording_, read_, end)) {
      contacts.push_back(mark);
    }
    read_ = end;
  }
  overlays.setContacts(std::move(contacts));
  scene_.update();
  if (read_ < there) {
    soon_.start();
  }
}

void RunOverlayReader::updateThoughts(bool isRunning) {
  const std::optional<int> spawnedAgent = scene_.spawnedAgent();
  const bool isEarly =
      isRunning && sinceThoughts_.isValid() && sinceThoughts_.elapsed() < kThoughtMs;
  const bool isCrowd = frame_->humans.size() > kMaxThinkers;
  const bool isSame = thoughtStep_ == frame_->step && thoughtAgent_ == spawnedAgent && !isCrowd;
  if (isEarly || isSame) {
    return;
  }
  sinceThoughts_.start();
  thoughtStep_ = frame_->step;
  thoughtAgent_ = spawnedAgent;
  std::map<int, QString> thoughts;
  const auto wordsOf = [](const auto& tree) {
    return QString::fromStdString(bt::activeBranchOf(tree).words());
  };
  if (isCrowd) {
    for (const ShownBody& body : scene_.frameLayer().shownBodies()) {
      if (body.isChosen && body.id >= 0 && thoughts.size() < kMaxThinkers) {
        thoughts[body.id] = wordsOf(recording_->treeAt(body.id, frame_->step));
      }
    }
  } else {
    for (const auto& [id, tree] : recording_->treesAt(frame_->step)) {
      thoughts[id] = wordsOf(tree);
    }
  }
  scene_.overlays().setThoughts(std::move(thoughts));
  scene_.update();
}

}  // namespace editor
