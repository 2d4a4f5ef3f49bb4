#include "bt/human/Formation.h"

#include <algorithm>
#include <tuple>

#include "bt/tree/TextValue.h"
#include "sim2d/base/Text.h"

namespace bt {

using base::Vec2;

std::optional<std::vector<int>> parseIds(const std::string& text) {
  std::vector<int> ids;
  for (const std::string& part : base::split(text, ',')) {
    const std::string token = base::trimmed(part);
    if (token.empty()) {
      continue;
    }
    const std::optional<int> id = intFromText(token);
    if (!id) {
      return std::nullopt;
    }
    ids.push_back(*id);
  }
  return ids;
}

std::optional<std::vector<int>> membersOf(LeafContext& leaf, int mainPort, int othersPort) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> main = context.person(leaf, mainPort);
  const std::string text = leaf.text(othersPort).value_or("");
  const std::optional<std::vector<int>> ids = parseIds(text);
  if (!ids) {
    leaf.fault("non_main_agent_ids is no list of ids: '" + text + "'");
    return std::nullopt;
  }
  if (!main) {
    return std::nullopt;
  }
  std::vector<int> members = {*main};
  for (const int id : *ids) {
    const std::optional<int> member = context.personById(leaf, id);
    if (!member) {
      return std::nullopt;
    }
    if (std::find(members.begin(), members.end(), *member) == members.end()) {
      members.push_back(*member);
    }
  }
  return members;
}

std::vector<Spot> circleSpots(const sim2d::WorldView& view, const std::vector<int>& members,
                              const Vec2& centre) {
  struct Pairing {
    double distance;
    std::size_t member, place;
  };
  const std::size_t count = members.size();
  const double radius = 0.5 + 0.2 * static_cast<double>(count - 1);
  const double first = view.pose(members.front()).heading;
  std::vector<Vec2> places;
  std::vector<Pairing> pairings;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count);
    places.emplace_back(centre + radius * base::directionOf(first + 2.0 * base::kPi * share));
    for (std::size_t m = 0; m < count; ++m) {
      pairings.push_back({(places[k] - view.pose(members[m]).position).norm(), m, k});
    }
  }
  std::sort(pairings.begin(), pairings.end(), [](const Pairing& a, const Pairing& b) {
    return std::tie(a.distance, a.member, a.place) < std::tie(b.distance, b.member, b.place);
  });
  std::vector<Spot> spots(count);
  std::vector<char> isTaken(count, 0);
  for (const Pairing& pairing : pairings) {
    Spot& spot = spots[pairing.member];
    if (spot.human < 0 && !isTaken[pairing.place]) {
      spot = {members[pairing.member], places[pairing.place]};
      isTaken[pairing.place] = 1;
    }
  }
  return spots;
}

}  // namespace bt
