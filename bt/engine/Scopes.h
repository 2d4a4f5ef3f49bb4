#pragma once

#include <map>
#include <string>
#include <vector>

#include "bt/engine/Program.h"

/// The blackboards of a tree and its SubTrees while it is compiled: which slot a key means.
namespace bt {

class Scopes {
 public:
  Scopes();  // the root blackboard is scope 0

  /// A blackboard for a SubTree called from `parent`; `path` is shown in lists.
  int add(int parent, bool autoRemap, const std::string& path);
  /// `key` of `scope` is `parentKey` of its parent.
  void remap(int scope, const std::string& key, const std::string& parentKey);
  /// `key` of `scope` starts with this constant.
  void setConstant(int scope, const std::string& key, const std::string& text);

  /// Makes the slot when the key is new.
  int slotOf(int scope, const std::string& key);
  int find(int scope, const std::string& key) const;  // -1 = no slot

  /// What is known about a slot beside its first value.
  struct Use {
    bool literal = false;  // a constant of a SubTree: takes the type of its first reader
    bool written = false;
    bool read = false;
    std::string firstTyped;  // who fixed the type, for messages
    std::string firstRead;   // "{key}" of the first reader
    std::string file;
    int line = 0;
  };
  Slot& slot(int index) { return slots_[static_cast<std::size_t>(index)]; }
  Use& use(int index) { return uses_[static_cast<std::size_t>(index)]; }
  const std::vector<Slot>& slots() const { return slots_; }
  const std::vector<Use>& uses() const { return uses_; }
  const std::vector<Program::Entry>& entries() const { return entries_; }

 private:
  struct Scope {
    int parent = -1;
    bool autoRemap = false;
    std::string path;
    std::map<std::string, int> slots;
    std::map<std::string, std::string> remaps;
  };
  int addSlot(int scope, const std::string& key);

  std::vector<Scope> scopes_;
  std::vector<Slot> slots_;
  std::vector<Use> uses_;
  std::vector<Program::Entry> entries_;
};

}  // namespace bt
