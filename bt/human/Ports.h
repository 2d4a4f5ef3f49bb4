#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "bt/engine/NodeLibrary.h"
#include "bt/human/HumanContext.h"
#include "bt/human/Perception.h"

/// What the ports of people's nodes take, and leaves as functions of them.
namespace bt {

/// "2, 3": leading number of each token, empty tokens skipped; nothing when a token has no number.
std::optional<std::vector<int>> parseIds(const std::string& text);
/// "3;1;1": numbers of 0 or more, at least one above 0, with a finite sum. Nothing = it is not
/// that.
std::optional<std::vector<double>> parseWeights(std::string_view text);
/// A port that takes the id of a person, or of several.
bool isPersonPort(std::string_view name);

/// Manifests of HuNavSim's nodes and, marked `own`, of those that the original does not have; see
/// nodesOf(). Ports that many have need no line of their own: agent_id, target_agent_id, time_step,
/// duration of an action, goal_id target_x target_y (a place) and non_main_agent_ids.
NodeCatalogue humanManifests(std::string_view text);

/// What a port gives to a function; nothing = the node fails. A missing port makes the tree faulty.
template <class T>
std::optional<T> argument(LeafContext& leaf, int port) {
  return leaf.require<T>(port);
}
/// Instead of a port: it may be anybody, index -1.
constexpr int kAnybody = -1;
template <>
inline std::optional<Person> argument(LeafContext& leaf, int port) {
  if (port == kAnybody) {
    return Person{-1};
  }
  const std::optional<int> index = humanOf(leaf).person(leaf, port);
  return index ? std::optional<Person>({*index}) : std::nullopt;
}
template <>
inline std::optional<sim2d::GoalItem> argument(LeafContext& leaf, int port) {
  return humanOf(leaf).place(leaf, port);
}

template <class Context>
Context& contextOf(LeafContext& leaf) {
  if constexpr (std::is_same_v<Context, HumanContext>) {
    return humanOf(leaf);
  } else if constexpr (std::is_same_v<Context, const sim2d::WorldView>) {
    return humanOf(leaf).view();
  } else {
    return leaf;
  }
}

template <class Context, class Result, class... Arguments, int... ports>
NodeStatus callWithPorts(LeafContext& leaf, Result (*function)(Context&, Arguments...),
                         std::integer_sequence<int, ports...>) {
  const std::tuple<std::optional<std::decay_t<Arguments>>...> arguments{
      argument<std::decay_t<Arguments>>(leaf, ports)...};
  const auto call = [&leaf, function](const auto&... given) {
    if (!(given && ...)) {
      return NodeStatus::Failure;
    }
    NodeStatus status = NodeStatus::Success;
    if constexpr (std::is_same_v<Result, bool>) {
      status = successIf(function(contextOf<Context>(leaf), *given...));
    } else if constexpr (std::is_same_v<Result, void>) {
      function(contextOf<Context>(leaf), *given...);
    } else {
      status = function(contextOf<Context>(leaf), *given...);
    }
    return status;
  };
  return std::apply(call, arguments);
}

/// A leaf that calls `function` with these ports, read in this order. It takes the HumanContext,
/// its view or the LeafContext before them and gives a status, or true for SUCCESS, or nothing
/// (SUCCESS).
template <auto function, int... ports>
NodeStatus withPorts(LeafContext& leaf) {
  return callWithPorts(leaf, function, std::integer_sequence<int, ports...>());
}

/// What a node does in each step while the person `human` of its memory is in the world.
template <class Memory, NodeStatus (*step)(LeafContext&, HumanContext&, Memory&)>
NodeStatus whilePresent(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  Memory& memory = leaf.memory<Memory>();
  return context.view().isPresent(memory.human) ? step(leaf, context, memory) : NodeStatus::Failure;
}

/// Starts with this memory.
template <class Memory>
NodeStatus begin(LeafContext& leaf, const Memory& memory) {
  leaf.memory<Memory>() = memory;
  return NodeStatus::Running;
}

}  // namespace bt
