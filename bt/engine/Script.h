#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt/engine/Value.h"
#include "sim2d/base/Result.h"

/// The script language of conditions and Script nodes, compiled to expressions. Literal numbers are
/// 64-bit integers or reals, computed numbers are reals. There is no short-circuit evaluation: both
/// sides of && and || are evaluated.
namespace bt {

enum class ScriptOperator : std::uint8_t {
  Create,  // := creates the entry; other assignments need an existing one
  Assign,
  Add,  // also for +=; likewise the next three
  Subtract,
  Multiply,
  Divide,
  Concat,
  And,
  Or,
  BitAnd,
  BitOr,
  BitXor,
  BitNot,
  Not,
  Negate,
  Equal,
  NotEqual,
  Less,
  Greater,
  LessEqual,
  GreaterEqual
};

struct ScriptExpression {
  enum class Kind : std::uint8_t {
    Constant,  // constant
    Load,      // value of `slot`
    Assign,    // assigns its operand to `slot`
    Unary,     // operator before its operand
    Combine,   // a + b - c: operators between operands, left-associative
    Compare,   // a < b < c: true if all comparisons hold
    Choose     // a ? b : c
  };
  Kind kind = Kind::Constant;
  Value constant = {};
  int slot = -1;
  std::vector<ScriptOperator> operators;
  std::vector<ScriptExpression> operands;
};

struct Script {
  std::string source;
  std::vector<ScriptExpression> statements;
  std::vector<int> written;  // assigned slots
  int unparsedColumn = 0;    // column after a statement without ';', where execution ends; 0: none
};

/// `slotOf` returns the slot of a blackboard key. An error contains the problem and its column.
base::Result<Script> compileScript(std::string_view source,
                                   const std::function<int(const std::string& key)>& slotOf);

/// Numbers closer than this are equal, as in BehaviorTree.CPP.
constexpr double kScriptTolerance = 1.1920928955078125e-07;  // epsilon of float

/// Evaluates a script on the slots of one agent.
class ScriptRunner {
 public:
  ScriptRunner(const Script& script, Slot* slots) : script_(script), slots_(slots) {}

  /// Returns false if it stopped with error().
  bool run();
  /// Value of the last statement, after run().
  const Value& result() const { return result_; }
  /// The result as a condition; empty for text and for integers other than 0 and 1.
  std::optional<bool> truth() const;
  const std::string& error() const { return error_; }

 private:
  bool evaluate(const ScriptExpression& expression, Value& result);
  bool chain(const ScriptExpression& expression, Value& result);
  bool load(const Slot& slot, Value& result);
  bool assign(Slot& slot, ScriptOperator sign, Value& value);
  bool combine(ScriptOperator sign, Value& left, const Value& right);
  bool join(Value& left, const Value& right);
  bool arithmetic(ScriptOperator sign, Value& left, const Value& right);
  bool bits(ScriptOperator sign, Value& left, const Value& right);
  bool unary(ScriptOperator sign, Value& value);
  bool compare(const ScriptExpression& expression, Value& result);
  bool choose(const ScriptExpression& expression, Value& result);
  bool fail(std::string message) {
    error_ = std::move(message);
    return false;
  }

  const Script& script_;
  Slot* slots_;
  Value result_;
  std::string error_;
};

}  // namespace bt
