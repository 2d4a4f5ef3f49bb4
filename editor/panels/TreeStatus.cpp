#include "editor/panels/TreeStatus.h"

namespace editor {

const std::vector<base::NodeStatus>& TreeStatus::at(int person, const FramePtr& frame) {
  const std::vector<FramePtr>& frames = runner_.history();
  const bool known = frame != nullptr && !frames.empty();
  const bool goesOn = known && person == person_ && first_ == frames.front() &&
                      (read_ == 0 || frames[read_ - 1]->step <= frame->step);
  if (!goesOn) {
    statuses_.clear();
    read_ = 0;
    person_ = person;
    first_ = known ? frames.front() : nullptr;
  }
  for (; known && read_ < frames.size() && frames[read_]->step <= frame->step; ++read_) {
    frames[read_]->treeChanges.forEach(
        [&](int id, const sim2d::TreeChanges::Paths& paths, int node, base::NodeStatus status) {
          if (id == person) {
            statuses_.resize(paths->size(), base::NodeStatus::Idle);
            statuses_[static_cast<std::size_t>(node)] = status;
          }
        });
  }
  return statuses_;
}

}  // namespace editor
