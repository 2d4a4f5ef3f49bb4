#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bt/engine/Script.h"
#include "bt/engine/Value.h"

namespace bt {

/// Numbers closer than this are equal, as in the original scripts.
constexpr double kScriptTolerance = 1.1920928955078125e-07;  // epsilon of float

/// Runs a script on the slots of one agent. `stack` has at least Script::depth places.
class ScriptRunner {
 public:
  ScriptRunner(const Script& script, Slot* slots, Value* stack)
      : script_(script), slots_(slots), stack_(stack) {}

  /// False = it stopped with error().
  bool run();
  /// Value of the last statement, after run().
  const Value& result() const { return *stack_; }
  /// The result as a condition; nothing = it is no number.
  std::optional<bool> truth() const;
  const std::string& error() const { return error_; }

 private:
  using Code = ScriptInstruction::Code;

  bool execute(const ScriptInstruction& instruction);
  bool load(int slot);
  bool assign(const ScriptInstruction& instruction);
  bool binary(Code code);
  bool arithmetic(Code code, Value& left, const Value& right);
  bool bits(Code code, Value& left, const Value& right);
  bool unary(Code code);
  bool compare(const std::vector<Script::Comparison>& chain);
  bool jump(const ScriptInstruction& instruction);
  bool fail(std::string message) {
    error_ = std::move(message);
    return false;
  }
  Value& top(std::size_t below = 0) { return stack_[size_ - 1 - below]; }

  const Script& script_;
  Slot* slots_;
  Value* stack_;
  std::size_t size_ = 0;
  std::size_t next_ = 0;
  std::string error_;
};

}  // namespace bt
