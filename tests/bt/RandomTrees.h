#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/bt/PageTree.h"

/// Random trees from a seed, for the comparison of two engines.
namespace page {

/// Known: controls, decorators and leaves. Wide: with scripts, conditions, entries and SubTrees.
/// Ports: with typed inputs and outputs as well.
enum class Grammar { Known, Wide, Ports };

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed) {}
  int below(int count) {  // splitmix64
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return static_cast<int>((z ^ (z >> 31U)) % static_cast<std::uint64_t>(count));
  }
  bool chance(int percent) { return below(100) < percent; }
  std::string of(const std::vector<std::string>& all) {
    return all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
  }

 private:
  std::uint64_t state_;
};

/// A random file and the results of its leaves.
struct Drawn {
  Trees trees;
  std::map<std::string, std::string> answers;  // "RSF" of each leaf, the last one repeats
};

class TreeDrawer {
 public:
  TreeDrawer(Grammar grammar, std::uint64_t seed)
      : grammar_(grammar), draw_(seed * 3 + static_cast<std::uint64_t>(grammar)) {}

  Drawn draw() {
    if (grammar_ != Grammar::Known) {
      subTrees_ = draw_.below(3);
    }
    for (int k = subTrees_; k >= 1; --k) {
      names_ = {{"pi", "l1"}, {"pd"}, {"ps"}};
      drawn_.trees["T" + std::to_string(k)] = withStart("l1 := 0", node(2, false));
      known_.push_back("T" + std::to_string(k));
    }
    names_ = {{"i1", "i2"}, {"d1", "d2"}, {"s1", "s2"}};
    Spec root = node(4, false);
    drawn_.trees["Main"] =
        grammar_ == Grammar::Known
            ? root
            : withStart("i1 := 1; i2 := 2; d1 := 0.5; d2 := 1.5; s1 := 'a'; s2 := 'b'", root);
    return std::move(drawn_);
  }

 private:
  struct Names {
    std::vector<std::string> whole, real, text;
  };
  using Attributes = std::vector<std::pair<std::string, std::string>>;

  static Spec withStart(const std::string& code, const Spec& rest) {
    const Spec start{"RunOnce", {}, {{"Script", {{"code", code}}, {}}}};
    return {"Sequence", {}, {start, rest}};
  }

  std::string number(int low, int high) { return std::to_string(low + draw_.below(high - low)); }
  std::string wholeTerm(int depth) {
    switch (draw_.below(depth > 0 ? 6 : 3)) {
      case 0:
        return draw_.of(names_.whole);
      case 1:
        return number(0, 5);
      case 2:
        return draw_.of({"-3", "0x10", "true", "~1"});
      case 3:
        return "(" + wholeTerm(depth - 1) + draw_.of({" + ", " - ", " * ", " & ", " | "}) +
               wholeTerm(depth - 1) + ")";
      case 4:
        return "(" + truthTerm(depth - 1) + " ? " + wholeTerm(depth - 1) + " : " +
               wholeTerm(depth - 1) + ")";
      default:
        return wholeTerm(depth - 1) + " - " + wholeTerm(depth - 1);
    }
  }
  std::string realTerm(int depth) {
    switch (draw_.below(depth > 0 ? 4 : 2)) {
      case 0:
        return draw_.of(names_.real);
      case 1:
        return draw_.of({"0.5", "1.25", "2.0", "1e-1"});
      case 2:
        return realTerm(depth - 1) + draw_.of({" + ", " - ", " * "}) + realTerm(depth - 1);
      default:
        return "(" + realTerm(depth - 1) + ") / 2.0";
    }
  }
  std::string textTerm() {
    return draw_.of({draw_.of(names_.text), "'a'", "'b'", "''", "'ab'", "'x y'", "'a' + 'b'"});
  }
  std::string truthTerm(int depth) {
    const std::string sign = draw_.of({" < ", " > ", " <= ", " >= ", " == ", " != "});
    switch (draw_.below(depth > 0 ? 8 : 4)) {
      case 0:
        return draw_.of({"0", "1", "true", "false"});
      case 1:
        return realTerm(depth - 1) + sign + realTerm(0);
      case 2:
        return textTerm() + sign + textTerm();
      case 4:
        return "(" + truthTerm(depth - 1) + ") && (" + truthTerm(depth - 1) + ")";
      case 5:
        return "(" + truthTerm(depth - 1) + ") || (" + truthTerm(depth - 1) + ")";
      case 6:
        return "!(" + truthTerm(depth - 1) + ")";
      case 7:
        return wholeTerm(0) + sign + wholeTerm(0) + draw_.of({" < ", " == "}) + wholeTerm(0);
      default:
        return wholeTerm(depth - 1) + sign + wholeTerm(0);
    }
  }
  /// Sometimes one that cannot work.
  std::string condition() {
    return draw_.chance(2) ? draw_.of({"unknown == 1", draw_.of(names_.text) + " - 1",
                                       draw_.of(names_.real) + " & 1", "'1' < 2", "-" + textTerm()})
                           : truthTerm(2);
  }
  std::string statement() {
    const std::string sign = draw_.of({" := ", " = "});
    switch (draw_.below(6)) {
      case 0:
        return draw_.of(names_.whole) + sign + wholeTerm(2);
      case 1:
        return draw_.of(names_.whole) + draw_.of({" += ", " -= "}) + wholeTerm(1);
      case 2:
        return draw_.of(names_.real) + sign + realTerm(2);
      case 3:
        return draw_.of(names_.real) + draw_.of({" *= 0.5", " /= 2", " += 0.5", " -= 1.5"});
      case 4:
        return draw_.of(names_.text) + sign + textTerm();
      default:
        return draw_.of(names_.text) + " += 'z'";
    }
  }
  std::string script() {
    const std::string first = statement();
    return draw_.chance(30) ? first + "; " + statement() : first;
  }

  void addConditions(Attributes& to) {
    if (grammar_ == Grammar::Known) {
      return;
    }
    for (const char* name : {"_failureIf", "_successIf", "_skipIf", "_while"}) {
      if (draw_.chance(6)) {
        to.emplace_back(name, condition());
      }
    }
    for (const char* name : {"_onSuccess", "_onFailure", "_post", "_onHalted"}) {
      if (draw_.chance(6)) {
        to.emplace_back(name, script());
      }
    }
  }

  Spec node(int depth, bool isInReactiveSequence) {
    const int kind = draw_.below(10);
    Spec made = depth == 0 || kind < 2   ? leaf()
                : kind < 5               ? decorator(depth)
                : kind == 5 && hasCall() ? call()
                                         : control(depth, isInReactiveSequence);
    addConditions(made.attributes);
    return made;
  }

  std::string leafName() { return "L" + std::to_string(++leaves_); }
  Spec scripted(const char* id, const char* answers) {
    const std::string name = leafName();
    std::string list;
    for (int k = 1 + draw_.below(8); k > 0; --k) {
      list += answers[draw_.below(static_cast<int>(std::string(answers).size()))];
    }
    drawn_.answers[name] = list;
    return {id, {{"name", name}}, {}};
  }
  Spec leaf() {
    const int kind = draw_.below(grammar_ == Grammar::Known  ? 8
                                 : grammar_ == Grammar::Wide ? 14
                                                             : 20);
    if (kind < 4) {
      return scripted("Act", "RRSSF");
    }
    if (kind < 7) {
      return scripted("Ask", "SSF");
    }
    switch (kind) {
      case 7:
        return {draw_.of({"AlwaysSuccess", "AlwaysFailure"}), {}, {}};
      case 8:
      case 9:
        return {"Script", {{"code", script()}}, {}};
      case 10:
        return {"ScriptCondition", {{"code", condition()}}, {}};
      case 11:
        return {"SetBlackboard",
                {{"value", draw_.of({"1", "2.5", "true", "abc"})},
                 {"output_key", draw_.of({"k1", "k2"})}},
                {}};
      case 12:
        return draw_.chance(40) ? Spec{"UnsetBlackboard", {{"key", draw_.of({"k1", "k2"})}}, {}}
                                : Spec{"Sleep", {{"msec", draw_.of({"0", "100", "250"})}}, {}};
      case 13:
        return {"WasEntryUpdated", {{"entry", entryName()}}, {}};
      default:
        return portLeaf(kind);
    }
  }
  std::string entryName() {
    return draw_.of({draw_.of(names_.whole), "{" + names_.whole[0] + "}", "k1"});
  }
  Spec portLeaf(int kind) {
    switch (kind) {
      case 14:
        return {
            "NeedInt", {{"in", draw_.of({"{" + names_.whole[0] + "}", "{p1}", "7", "5abc"})}}, {}};
      case 15:
        return {"NeedReal", {{"in", draw_.of({"{" + names_.real[0] + "}", "{p2}", "0.25"})}}, {}};
      case 16:
        return {"NeedText", {{"in", draw_.of({"{" + names_.text[0] + "}", "{p3}", "x y"})}}, {}};
      case 17:
        return {"PutInt",
                {{"out", draw_.of({"{p1}", "{p1}", "{" + names_.whole[0] + "}", "3"})},
                 {"from", number(0, 9)}},
                {}};
      case 18:
        return draw_.chance(50) ? Spec{"PutReal",
                                       {{"out", draw_.of({"{p2}", "{" + names_.real[0] + "}"})},
                                        {"from", draw_.of({"0.75", "3.5"})}},
                                       {}}
                                : Spec{"PutText",
                                       {{"out", draw_.of({"{p3}", "{" + names_.text[0] + "}"})},
                                        {"from", draw_.of({"hello", "z"})}},
                                       {}};
      default:
        return {"SetBlackboard",
                {{"value", draw_.of({"{" + names_.real[0] + "}", "{p2}", "{p3}"})},
                 {"output_key", "c" + std::to_string(++copies_)}},
                {}};
    }
  }

  std::string count(const std::vector<std::string>& fixed) {
    return grammar_ != Grammar::Known && draw_.chance(25) ? "{" + names_.whole[0] + "}"
                                                          : draw_.of(fixed);
  }
  Spec decorator(int depth) {
    const std::vector<Spec> child = {node(depth - 1, false)};
    switch (draw_.below(grammar_ == Grammar::Known ? 9 : grammar_ == Grammar::Wide ? 13 : 15)) {
      case 0:
        return {"Inverter", {}, child};
      case 1:
        return {draw_.of({"ForceSuccess", "ForceFailure"}), {}, child};
      case 2:
        return {"Repeat", {{"num_cycles", count({"0", "1", "2", "3", "-1"})}}, child};
      case 3:
        return {
            "RetryUntilSuccessful", {{"num_attempts", count({"0", "1", "2", "4", "-1"})}}, child};
      case 4:
        return {"KeepRunningUntilFailure", {}, child};
      case 5:
        return {"RunOnce", {}, child};
      case 6:
        return {"RunOnce", {{"then_skip", draw_.of({"true", "false"})}}, child};
      case 7:
        return {"Delay", {{"delay_msec", draw_.of({"0", "100", "250"})}}, child};
      case 8:
        return {"Timeout", {{"msec", draw_.of({"0", "100", "350"})}}, child};
      case 9:
        return {"Precondition", {{"if", condition()}}, child};
      case 10:
        return {"Precondition",
                {{"if", condition()}, {"else", draw_.of({"SUCCESS", "SKIPPED", "RUNNING"})}},
                child};
      case 11:
        return {"SkipUnlessUpdated", {{"entry", entryName()}}, child};
      case 12:
        return {"WaitValueUpdate", {{"entry", entryName()}}, child};
      case 13:
        return {"LoopInt",
                {{"queue", draw_.of({"1;2;3", "7", "4;5"})},
                 {"if_empty", draw_.of({"SUCCESS", "FAILURE", "SKIPPED"})},
                 {"value", draw_.of({"{p1}", "{" + names_.whole[0] + "}"})}},
                child};
      default:
        return draw_.chance(50)
                   ? Spec{"LoopDouble", {{"queue", "0.5;1.5"}, {"value", "{p2}"}}, child}
                   : Spec{"LoopString", {{"queue", "a;bc;d"}, {"value", "{p3}"}}, child};
    }
  }

  std::vector<Spec> children(int count, int depth, bool isInReactiveSequence = false) {
    std::vector<Spec> all;
    all.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
      all.push_back(node(depth - 1, isInReactiveSequence));
    }
    return all;
  }
  Spec control(int depth, bool isInReactiveSequence) {
    const int many = 1 + draw_.below(4);
    switch (draw_.below(grammar_ == Grammar::Known ? 11 : 13)) {
      case 0:
        return {"Sequence", {}, children(many, depth)};
      case 1:
        return {"Fallback", {}, children(many, depth)};
      case 2:
        return {
            isInReactiveSequence ? "AsyncFallback" : draw_.of({"AsyncSequence", "AsyncFallback"}),
            {},
            children(many, depth)};
      case 3:
        return {"SequenceWithMemory", {}, children(many, depth)};
      case 4:
        return {"ReactiveSequence", {}, children(many, depth, true)};
      case 5:
        return {"ReactiveFallback", {}, children(many, depth)};
      case 6:
      case 7:
        return {"Parallel",
                {{"success_count", number(-many, many + (draw_.chance(5) ? 2 : 1))},
                 {"failure_count", number(-many, many + 1)}},
                children(many, depth)};
      case 8:
        return {"ParallelAll", {{"max_failures", number(-many, many + 1)}}, children(many, depth)};
      case 9:
        return {draw_.of({"IfThenElse", "WhileDoElse"}), {}, children(2 + draw_.below(2), depth)};
      case 10:
        return {"TryCatch",
                {{"catch_on_halt", draw_.of({"true", "false"})}},
                children(2 + draw_.below(2), depth)};
      default:
        return choice(depth);
    }
  }
  Spec choice(int depth) {
    const int cases = 2 + draw_.below(2);
    Attributes attributes = {
        {"variable", draw_.of({"{" + names_.whole.back() + "}", "{" + names_.real.back() + "}",
                               "{" + names_.text.back() + "}", "{zz}", "b"})}};
    for (int k = 1; k <= cases; ++k) {
      attributes.emplace_back("case_" + std::to_string(k),
                              draw_.of({"a", "b", "1", "2", "2.0", "0.5", "1.5", "3", ""}));
    }
    return {"Switch" + std::to_string(cases), attributes, children(cases + 1, depth)};
  }

  bool hasCall() const { return !known_.empty(); }
  Spec call() {
    Attributes attributes = {{"ID", draw_.of(known_)}};
    if (draw_.chance(30)) {
      attributes.emplace_back("_autoremap", "true");
    }
    attributes.emplace_back("pi", draw_.chance(80) ? "{" + draw_.of(names_.whole) + "}" : "3");
    attributes.emplace_back("pd", draw_.chance(80) ? "{" + draw_.of(names_.real) + "}" : "2.5");
    attributes.emplace_back("ps", draw_.chance(80) ? "{" + draw_.of(names_.text) + "}" : "a");
    return {"SubTree", attributes, {}};
  }

  Grammar grammar_;
  Draw draw_;
  Drawn drawn_;
  Names names_;
  std::vector<std::string> known_;  // trees that may be called
  int subTrees_ = 0;
  int leaves_ = 0;
  int copies_ = 0;
};

inline std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return result;
}
inline std::string xmlOf(const Spec& spec, int depth) {
  const std::string indent(static_cast<std::size_t>(depth) * 2, ' ');
  std::string text = indent + "<" + spec.id;
  for (const auto& [name, value] : spec.attributes) {
    text += " " + name + "=\"" + escaped(value) + "\"";
  }
  if (spec.children.empty()) {
    return text + "/>\n";
  }
  text += ">\n";
  for (const Spec& child : spec.children) {
    text += xmlOf(child, depth + 1);
  }
  return text + indent + "</" + spec.id + ">\n";
}
inline std::string xmlOf(const Trees& trees) {
  std::string text = "<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\">\n";
  for (const auto& [id, root] : trees) {
    text += "<BehaviorTree ID=\"" + id + "\">\n" + xmlOf(root, 1) + "</BehaviorTree>\n";
  }
  return text + "</root>\n";
}

}  // namespace page
