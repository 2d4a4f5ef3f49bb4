#include "app/bridge/dds/Graph.h"

#include <algorithm>
#include <iterator>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/DiscoveryMessages.h"

namespace bridge {
namespace {

constexpr std::size_t kHumbleGid = 24, kLaterGid = 16;  // [bytes]

template <std::size_t Size>
rmw_dds_common::Gid<Size> gidOf(const Guid& guid) {
  rmw_dds_common::Gid<Size> gid;
  std::copy(guid.begin(), guid.end(), gid.data.begin());
  return gid;
}

template <std::size_t Size>
std::vector<rmw_dds_common::Gid<Size>> gidsOf(const std::vector<Guid>& guids) {
  std::vector<rmw_dds_common::Gid<Size>> gids;
  std::transform(guids.begin(), guids.end(), std::back_inserter(gids), gidOf<Size>);
  return gids;
}

template <std::size_t Size>
Bytes sampleOf(const Guid& participant, const std::vector<NodeEndpoints>& nodes) {
  rmw_dds_common::ParticipantEntitiesInfo<Size> info;
  info.gid = gidOf<Size>(participant);
  for (const NodeEndpoints& node : nodes) {
    rmw_dds_common::NodeEntitiesInfo<Size>& entry = info.nodeEntitiesInfoSeq.emplace_back();
    entry.nodeNamespace = node.space;
    entry.nodeName = node.name;
    entry.readerGidSeq = gidsOf<Size>(node.readers);
    entry.writerGidSeq = gidsOf<Size>(node.writers);
  }
  return encode(info);
}

}  // namespace

Bytes graphSample(const Guid& participant, const std::vector<NodeEndpoints>& nodes, Distro distro) {
  return distro == Distro::Humble ? sampleOf<kHumbleGid>(participant, nodes)
                                  : sampleOf<kLaterGid>(participant, nodes);
}

}  // namespace bridge
